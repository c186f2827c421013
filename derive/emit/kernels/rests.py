"""Directions of equilibrium, told as whole quarter turns and a rest, so that angles near them are told without loss."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, cos, epsilon, larger, less_quarters, pi, pick, sin, sqrt


class Rest(NamedTuple):
    """A direction without moment: angle = quarters·π/2 + extra.

    stiffness: dθ″/dθ there, positive on a hill. double_cosine, double_sine: of 2(angle − α).
    """

    quarters: int
    extra: float
    angle: float
    stiffness: float
    double_cosine: float
    double_sine: float


class Landscape(NamedTuple):
    """The directions of one turn, from the highest hill to the same hill a turn on: hill, well(, ridge, well), hill.

    level: the ridge is as high as the hill. even: V is symmetric about every hill and well. shoulder: where a ridge is
    nearly there, the direction at which the couple, ``moment``, is nearest to zero; None where that is not asked for.
    """

    rests: tuple[Rest, ...]
    level: bool
    even: bool
    shoulder: Rest | None = None
    moment: float = 0.0


def along(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def mirror_rest(rest):
    """The direction seen from the other side of the y axis, a turn on."""
    return rest._replace(
        quarters=4 - rest.quarters, extra=-rest.extra, angle=2 * pi - rest.angle, double_sine=-rest.double_sine
    )


def mirror_landscape(scene):
    """The landscape seen from the other side of the y axis."""
    rests = tuple(mirror_rest(rest) for rest in scene.rests[::-1])
    if scene.shoulder is None:
        return scene._replace(rests=rests)
    return scene._replace(rests=rests, shoulder=mirror_rest(scene.shoulder), moment=-scene.moment)


def rest_turned_back(rest):
    """What is a hill beside 0 with one field is a well beside π with the other, and the reverse."""
    return rest._replace(
        extra=-rest.extra, stiffness=-rest.stiffness, double_cosine=-rest.double_cosine, double_sine=rest.double_sine
    )


def rest_of(quarters, rest):
    """The direction with its angle, from a number of quarter turns on."""
    return rest._replace(quarters=quarters, angle=quarters * (pi / 2) + rest.extra)


def pick_rest(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(*(pick(condition, *pair) for pair in zip(yes, no, strict=True)))


def rest_at(beta, eta, field_angle, quarters, extra):
    """The direction at this angle."""
    angle = quarters * (pi / 2) + extra
    double = 2 * (angle - field_angle)
    return Rest(quarters, extra, angle, beta * cos(angle) + eta * cos(double), cos(double), sin(double))


def rising_root(function, low, high):
    """The root between low, where the function is negative, and high, where it is positive, by Ridders' method."""
    value_low, value_high = function(low), function(high)
    last, moving = high, value_high > 0
    for _ in range(60):
        middle = (low + high) / 2
        value = function(middle)
        size = sqrt(larger(value * value - value_low * value_high, 0))
        exact = (value == 0) | (size == 0)
        size = pick(exact, 1, size)
        # By the distance from the low end, which may be far less than the interval.
        share = pick(value > 0, -value_low * value_high / (size * (size + larger(value, 0))), 1 - value / size)
        trial = pick(exact, middle, low + (middle - low) * share)
        value_trial = function(trial)
        settled, last = abs(trial - last) <= 4 * epsilon() * abs(trial), pick(moving, trial, last)
        low, high, value_low, value_high = narrowed(low, high, value_low, value_high, middle, value)
        low, high, value_low, value_high = narrowed(low, high, value_low, value_high, trial, value_trial)
        moving = moving & (abs(high - low) > 2 * epsilon() * abs(trial)) & (value_trial != 0) & (exact == 0)
        if any_of(moving) and not any_of(moving & (settled == 0)):
            # The trials stay on one side of the root: is it between them and the next few numbers?
            beside = trial + pick((value_trial > 0) == (high > low), -2, 2) * epsilon() * abs(trial)
            beside = pick(settled, beside, trial)
            low, high, value_low, value_high = narrowed(low, high, value_low, value_high, beside, function(beside))
            moving = moving & (abs(high - low) > 2 * epsilon() * abs(trial))
        if not any_of(moving):
            break
    return last


def narrowed(low, high, value_low, value_high, place, value):
    """The interval about a root, with a place in it as its new end."""
    inside = (abs(place - low) < abs(high - low)) & (abs(high - place) < abs(high - low))
    rises, falls = inside & (value > 0), inside & (value <= 0)
    high, value_high = pick(rises, place, high), pick(rises, value, value_high)
    return pick(falls, place, low), high, pick(falls, value, value_low), value_high


def offset_from(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this tells them apart."""
    offset = less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = epsilon() * (abs(angle) + abs(rest.extra))
    return pick((abs(offset) <= blur) | (abs(offset) < epsilon() ** 9), 0, offset)
