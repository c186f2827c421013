"""Zeros and least values of a function of one variable between places where it is known."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, sqrt


def bracketed_root(function, places, values, blur):
    """A sign change of the function between the first two places, to rounding, by Chandrupatla's method (1997).

    If there is a third place, it has a value, too. blur: a value that rounding may have made of zero.
    """
    (a, b, *third), (value_a, value_b, *value_third) = places, values
    fraction = interpolated(a, b, third[0], value_a, value_b, value_third[0]) if third else 0.5
    while True:
        trial = a + fraction * (b - a)
        value = function(trial)
        if (value > 0) == (value_a > 0):
            c, value_c = a, value_a
        else:
            c, value_c, b, value_b = b, value_b, a, value_a
        a, value_a = trial, value
        best, value_best = (a, value_a) if abs(value_a) < abs(value_b) else (b, value_b)
        least = 2 * epsilon() * (1 + abs(best)) / abs(b - a)
        if least > 0.5 or abs(value_best) <= blur:
            return best
        fraction = min(1 - least, max(least, interpolated(a, b, c, value_a, value_b, value_c)))


def interpolated(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    if value_c in (value_a, value_b):
        return 0.5
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    if x <= 0 or y * y >= x or (1 - y) * (1 - y) >= 1 - x:
        return 0.5
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    share = share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
    return share if 0 < share < 1 else 0.5


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
