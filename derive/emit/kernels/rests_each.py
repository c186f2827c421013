"""The kernels of ``rests`` on arrays.

Emitted by `derive emit` from kernels/rests.py: do not edit, change that file.

Digest of the inputs: sha256 331effb07d2d6cfd61b048fd495e67aacac739b6d6e124b985ebdefd3e2deb66
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_cos,
    each_less_quarters,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.rests import Rest


def along_each(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def mirror_rest_each(rest):
    """The direction seen from the other side of the y axis, a turn on."""
    return rest._replace(
        quarters=4 - rest.quarters, extra=-rest.extra, angle=2 * pi - rest.angle, double_sine=-rest.double_sine
    )


def mirror_landscape_each(scene):
    """The landscape seen from the other side of the y axis."""
    rests = tuple(mirror_rest_each(rest) for rest in scene.rests[::-1])
    if scene.shoulder is None:
        return scene._replace(rests=rests)
    return scene._replace(rests=rests, shoulder=mirror_rest_each(scene.shoulder), moment=-scene.moment)


def rest_turned_back_each(rest):
    """What is a hill beside 0 with one field is a well beside π with the other, and the reverse."""
    return rest._replace(
        extra=-rest.extra, stiffness=-rest.stiffness, double_cosine=-rest.double_cosine, double_sine=rest.double_sine
    )


def rest_of_each(quarters, rest):
    """The direction with its angle, from a number of quarter turns on."""
    return rest._replace(quarters=quarters, angle=quarters * (pi / 2) + rest.extra)


def pick_rest_each(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(*(each_pick(condition, *pair) for pair in zip(yes, no, strict=True)))


def rest_at_each(beta, eta, field_angle, quarters, extra):
    """The direction at this angle."""
    angle = quarters * (pi / 2) + extra
    double = 2 * (angle - field_angle)
    return Rest(
        quarters, extra, angle, beta * each_cos(angle) + eta * each_cos(double), each_cos(double), each_sin(double)
    )


def rising_root_each(function, low, high):
    """The root between low, where the function is negative, and high, where it is positive, by Ridders' method."""
    value_low, value_high = function(low), function(high)
    last, moving = high, value_high > 0
    for _ in range(60):
        middle = (low + high) / 2
        value = function(middle)
        size = each_sqrt(larger(value * value - value_low * value_high, 0))
        exact = (value == 0) | (size == 0)
        size = each_pick(exact, 1, size)
        # By the distance from the low end, which may be far less than the interval.
        share = each_pick(value > 0, -value_low * value_high / (size * (size + larger(value, 0))), 1 - value / size)
        trial = each_pick(exact, middle, low + (middle - low) * share)
        value_trial = function(trial)
        settled, last = each_abs(trial - last) <= 4 * epsilon() * each_abs(trial), each_pick(moving, trial, last)
        low, high, value_low, value_high = narrowed_each(low, high, value_low, value_high, middle, value)
        low, high, value_low, value_high = narrowed_each(low, high, value_low, value_high, trial, value_trial)
        moving = moving & (each_abs(high - low) > 2 * epsilon() * each_abs(trial)) & (value_trial != 0) & (exact == 0)
        if each_any_of(moving) and (not each_any_of(moving & (settled == 0))):
            # The trials stay on one side of the root: is it between them and the next few numbers?
            beside = trial + each_pick((value_trial > 0) == (high > low), -2, 2) * epsilon() * each_abs(trial)
            beside = each_pick(settled, beside, trial)
            low, high, value_low, value_high = narrowed_each(low, high, value_low, value_high, beside, function(beside))
            moving = moving & (each_abs(high - low) > 2 * epsilon() * each_abs(trial))
        if not each_any_of(moving):
            break
    return last


def narrowed_each(low, high, value_low, value_high, place, value):
    """The interval about a root, with a place in it as its new end."""
    inside = (each_abs(place - low) < each_abs(high - low)) & (each_abs(high - place) < each_abs(high - low))
    rises, falls = inside & (value > 0), inside & (value <= 0)
    high, value_high = each_pick(rises, place, high), each_pick(rises, value, value_high)
    return each_pick(falls, place, low), high, each_pick(falls, value, value_low), value_high


def offset_from_each(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = each_less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = epsilon() * (each_abs(angle) + each_abs(rest.extra))
    return each_pick((each_abs(offset) <= blur) | (each_abs(offset) < epsilon() ** 9), 0, offset)
