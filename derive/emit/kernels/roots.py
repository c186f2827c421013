"""Zeros and least values of a function of one variable between places where it is known."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, sqrt

FARTHEST = 5  # known places through which a curve is laid, at most


def bracketed_root(function, places, values, blur):
    """A sign change of the function between the first two places, to rounding.

    By Chandrupatla's method (1997), with a curve through more of the known places where it settles. Further places,
    nearest first, have values, too. blur: a value that rounding may have made of zero.
    """
    (a, b, *others), (value_a, value_b, *known) = places, values
    points = list(zip(others, known, strict=True))
    fraction = interpolated(a, b, value_a, value_b, points)
    while True:
        trial = a + fraction * (b - a)
        value = function(trial)
        if (value > 0) == (value_a > 0):
            points.insert(0, (a, value_a))
        else:
            points.insert(0, (b, value_b))
            b, value_b = a, value_a
        a, value_a = trial, value
        best, value_best = (a, value_a) if abs(value_a) < abs(value_b) else (b, value_b)
        least = 2 * epsilon() * (1 + abs(best)) / abs(b - a)
        if least > 0.5 or abs(value_best) <= blur:
            return best
        fraction = min(1 - least, max(least, interpolated(a, b, value_a, value_b, points)))


def interpolated(a, b, value_a, value_b, points):
    """Where on the way from a to b the zero lies, by inverse interpolation, or half way where that is unsafe.

    The third point decides whether it is. Further ones are taken as long as each changes less than the one before.
    """
    if not points:
        return 0.5
    c, value_c = points[0]
    if value_c in (value_a, value_b):
        return 0.5
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    if x <= 0 or y * y >= x or (1 - y) * (1 - y) >= 1 - x:
        return 0.5
    share = value_a / (value_a - value_b)
    slope, weight = 1 / (value_b - value_a), -value_a * -value_b
    change = weight * (((c - a) / (b - a)) / (value_c - value_a) - slope) / (value_c - value_b)
    share += change
    nodes, steps = [value_a, value_b, value_c], [0.0, slope, change / weight]
    for place, value in points[1 : FARTHEST - 2]:
        if value in nodes:
            break
        step, weight = (place - a) / (b - a), weight * -nodes[-1]
        for node, known in zip(nodes, steps, strict=True):  # divided differences of the place by the value
            step = (step - known) / (value - node)
        if abs(step * weight) > abs(change) / 2 or not 0 < share + step * weight < 1:
            break
        change = step * weight
        share += change
        nodes.append(value)
        steps.append(step)
    return share


def dip(sample, short, left, middle, right):
    """The sample at which ``short`` is least between left and right by golden sections, or the first below zero."""
    golden = (3 - sqrt(5)) / 2
    value = short(middle)
    while right.place - left.place > 2 * sqrt(epsilon()) * (1 + abs(middle.place)):
        wide = right.place - middle.place > middle.place - left.place
        end = right if wide else left
        trial = sample(middle.place + golden * (end.place - middle.place))
        new = short(trial)
        if new < 0:
            return trial
        if new < value:
            left, right = (middle, right) if wide else (left, middle)
            middle, value = trial, new
        elif wide:
            right = trial
        else:
            left = trial
    return middle
