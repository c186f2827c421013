"""Zeros and least values of a function of one variable between places where it is known."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, sqrt


def bracketed_root(function, places, values, blur):
    """A sign change of the function between the first two places, to rounding.

    By the zero of the polynomial through the last five places at which the function is known, or by halving where that
    gains little. More places may be known than two. blur: a value that rounding may have made of zero.
    """
    nodes: list[float] = []
    parts: list[float] = []
    for k in range(len(places) - 1, -1, -1):
        nodes, parts = with_node(nodes, parts, places[k], values[k])
    (a, b, *_), (value_a, value_b, *_) = places, values
    halve = False
    while True:
        if abs(value_b) < abs(value_a):
            a, b, value_a, value_b = b, a, value_b, value_a
        least, width = 2 * epsilon() * (1 + abs(a)), abs(b - a)
        if 2 * least > width or abs(value_a) <= blur:
            return a
        share = 0.5 if halve else (zero_near(nodes, parts) - a) / (b - a)
        if 2 * abs(share) * width < least and abs(value_a) < 16 * blur:
            return a
        if -0.05 < share < 0:  # rounding of the values puts the zero on the wrong side
            share = -2 * share
        share = max(least / width, share) if 0 <= share < 1 else 0.5
        trial = a + min(1 - least / width, share) * (b - a)
        value = function(trial)
        nodes, parts = with_node(nodes, parts, trial, value)
        little = 4 * abs(value) > abs(value_a)
        if (value > 0) == (value_a > 0):
            a, value_a = trial, value
        else:
            b, value_b = trial, value
        halve = little and 2 * abs(b - a) > width


def smooth_root(function, places, values, sag, blur):
    """A zero of a function that rises or falls all the way between the first two places, and its slope there.

    By the zero of the parabola through the last three; where the function is cheap and all but straight that takes less
    time than ``bracketed_root``. sag: half of what |f″| is nowhere more than. blur: a value that rounding may have made
    of zero, or a chord too, so that a look would tell nothing.
    """
    (place, before, third), (value, value_before, value_third) = places, values
    low, high = (place, before) if place < before else (before, place)
    rising = (value > 0) == (place == high)
    while True:
        chord = (value - value_before) / (place - before)
        twist = ((value_before - value_third) / (before - third) - chord) / (third - place)
        slope = chord - twist * (before - place)
        bent = slope * slope - twist * value
        step = value * slope / bent if bent != 0 else high - low
        trial = place - step
        if not low < trial < high:
            if abs(value) <= blur:
                return place, slope
            trial = (low + high) / 2
            if not low < trial < high:
                return place, slope
        elif abs(value) <= blur or sag * abs(step * (trial - before)) <= blur:
            return trial, slope
        third, value_third, before, value_before = before, value_before, place, value
        place, value = trial, function(trial)
        if (value > 0) == rising:
            high = place
        else:
            low = place


def with_node(nodes, parts, place, value):
    """The places of a polynomial and its divided differences, with one more place in front, and no more than five."""
    found = [value]
    for k in range(min(len(nodes), 4)):
        value = (value - parts[k]) / (place - nodes[k])
        found.append(value)
    return [place, *nodes[:4]], found


def zero_near(nodes, parts):
    """A zero of a polynomial near its first place; any number where there is none."""
    last, before, third, fourth = (nodes + 2 * nodes[-1:])[:4]
    value, slope, bend, twist, rest = (*parts, 0, 0, 0)[:5]
    zero = last
    for _ in range(3):
        steep = slope + (zero - before) * (bend + (zero - third) * (twist + (zero - fourth) * rest))
        if steep == 0:
            break
        zero = last - value / steep
    return zero


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
