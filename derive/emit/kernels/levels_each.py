"""The kernels of ``levels`` on arrays.

Emitted by `derive emit` from kernels/levels.py: do not edit, change that file.

Digest of the inputs: sha256 1ca98a659525eb0d8306adcc063ab4a9a8a3898ab520a69b39b0e1a80c8d89eb
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_asin,
    each_cos,
    each_pick,
    each_sin,
    each_spacing,
    each_sqrt,
    larger,
)
from derive.emit.kernels.formulas_each import rest_fall_each, rest_moment_each
from derive.emit.kernels.potential_each import fall_from_rest_each, moment_from_rest_each
from derive.emit.kernels.rests_each import pick_rest_each


def turn_to_each(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


def fall_each(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def slope_each(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def reach_each(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = larger(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(each_abs(fall_each(eta, rest, 0, side * most)), epsilon() ** 20)
    near = most * each_asin(each_sqrt(each_pick(share < 1, share, 1))) * (2 / pi)
    goal = each_sqrt(amount)
    for _ in range(40):
        step, bent = step_to_each(eta, rest, side * near, goal)
        safe = each_abs(bent) < 0.5
        trial = near - step / each_pick(safe, 1 - bent, 1)
        trial = each_pick(trial > most, (near + most) / 2, each_pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = each_pick(safe, each_spacing(trial) ** 0.45, each_spacing(trial) ** 0.6)
        moving, near = each_abs(trial - near) > small * near, trial
        if not each_any_of(moving):
            break
    return near


def step_to_each(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = each_sin(offset / 4), each_cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = each_abs(rest_moment_each(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = each_sqrt(each_abs(level)), larger(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / larger(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (each_pick(level < 0, -bend, bend) - 0.5)


def onward_each(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope_each(eta, rest, start) + moment * each_cos(start)
    told = (each_abs(rough) > 0.001 * each_abs(start)) | (steep == 0)
    distance = each_pick(told, rough, amount / each_pick(told, 1, steep))
    for _ in range(40):
        force = slope_each(eta, rest, start + distance) + moment * each_cos(start + distance)
        fallen = (
            fall_each(eta, rest, start, distance)
            + 2 * moment * each_cos(start + distance / 2) * each_sin(distance / 2)
        )
        step = (fallen - amount) / each_pick(force == 0, 1, force)
        away = each_abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = each_pick(away, rough, distance - step)
        if not each_any_of(
            wanted & (stuck == 0) & (each_abs(step) > each_spacing(distance) ** 0.6 * each_abs(distance))
        ):
            break
    return distance


def further_each(eta, rest, start, amount, rough, far, moment=0):
    """How far beyond ``start`` V has risen by ``amount``: ``onward`` where the rough value is not told well enough."""
    better = onward_each(eta, rest, start, -amount, rough, far == 0, moment)
    # Newton's method leaves a place where V is nearly level for one far away.
    return each_pick(far | (each_abs(better - rough) > 0.01), rough, better)


def tip_fall_each(eta, piece, change, rise, drop):
    """V(tip) − V(tip + change), for a tip that is told from the low and the high end of its range."""
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    return fall_each(
        eta, pick_rest_each(upper, piece.basin.hill, piece.basin.well), each_pick(upper, from_hill, -depth), change
    )


def ridge_fall_each(beta, eta, field_angle, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return each_cos(half) * (2 * beta * each_sin(middle) - eta * each_sin(half) * each_sin(2 * (middle - field_angle)))
