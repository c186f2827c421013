"""How V falls along angles told from a direction of equilibrium, and where it has fallen by an amount."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import any_of, asin, cos, epsilon, larger, pi, pick, sin, spacing, sqrt
from derive.emit.kernels.formulas import rest_fall, rest_moment
from derive.emit.kernels.potential import fall_from_rest, moment_from_rest
from derive.emit.kernels.rests import pick_rest


def turn_to(start, end):
    """The angle from one direction without moment to another, however near they are to each other."""
    return (end.quarters - start.quarters) * (pi / 2) + (end.extra - start.extra)


def fall(eta, rest, start, change):
    """V(start) − V(start + change), from a start measured from a direction without moment."""
    half = change / 2
    return fall_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, start + half, half)


def slope(eta, rest, offset):
    """θ″ at an offset from a direction without moment."""
    return moment_from_rest(eta, rest.stiffness, rest.double_cosine, rest.double_sine, offset)


def reach(eta, rest, amount, most, side):
    """The distance from a hill (or a well) at which V is lower (or higher) by ``amount``, to one side.

    most: the distance of the next well (or hill). Halley's method for the square root of the difference, which is
    nearly linear, from the pendulum's value.
    """
    amount = larger(amount, 0)  # of a hill and a well that nearly meet, rounding may give less
    share = amount / larger(abs(fall(eta, rest, 0, side * most)), epsilon() ** 20)
    near = most * asin(sqrt(pick(share < 1, share, 1))) * (2 / pi)
    goal = sqrt(amount)
    for _ in range(40):
        step, bent = step_to(eta, rest, side * near, goal)
        safe = abs(bent) < 0.5
        trial = near - step / pick(safe, 1 - bent, 1)
        trial = pick(trial > most, (near + most) / 2, pick(trial < 0, near / 2, trial))
        # The method cubes the error, and Newton's squares it: after steps this small the next would change nothing.
        small = pick(safe, spacing(trial) ** 0.45, spacing(trial) ** 0.6)
        moving, near = abs(trial - near) > small * near, trial
        if not any_of(moving):
            break
    return near


def step_to(eta, rest, offset, goal):
    """Newton's step to where the square root of the change of V from a direction without moment is ``goal``, and by
    how much its slope changes half way there, as a share of it."""
    small, large = sin(offset / 4), cos(offset / 4)
    sine, cosine = 2 * small * large, 1 - 2 * small * small
    level = rest_fall(eta, rest.stiffness, rest.double_cosine, rest.double_sine, small, large, small, large)
    force = abs(rest_moment(eta, rest.stiffness, rest.double_cosine, rest.double_sine, sine, cosine))
    here, force = sqrt(abs(level)), larger(force, epsilon() ** 20)
    whole_sine, whole_cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    # dθ″/dθ, by β and α as the direction has them.
    turned = rest.double_cosine * (2 * whole_cosine * whole_cosine - 1 - whole_cosine)
    turned = turned - rest.double_sine * whole_sine * (2 * whole_cosine - 0.5)
    bend = (rest.stiffness * whole_cosine + eta * turned) * (here / force) * (here / force)
    share = (here - goal) / larger(here, epsilon() ** 20)
    return 2 * here * (here - goal) / force, share * (pick(level < 0, -bend, bend) - 0.5)


def onward(eta, rest, start, amount, rough, wanted, moment=0):
    """How far beyond ``start``, an offset from a direction of that moment, V has fallen by ``amount``.

    The rough value is good to rounding of the angles; where little of it is left, the slope of V at the start gives a
    better one. Newton's method does the rest, until all that are wanted are found.
    """
    steep = slope(eta, rest, start) + moment * cos(start)
    told = (abs(rough) > 1e-3 * abs(start)) | (steep == 0)
    distance = pick(told, rough, amount / pick(told, 1, steep))
    for _ in range(40):
        force = slope(eta, rest, start + distance) + moment * cos(start + distance)
        fallen = fall(eta, rest, start, distance) + 2 * moment * cos(start + distance / 2) * sin(distance / 2)
        step = (fallen - amount) / pick(force == 0, 1, force)
        away = abs(distance - step) > pi
        stuck = away & (distance == rough)
        distance = pick(away, rough, distance - step)
        if not any_of(wanted & (stuck == 0) & (abs(step) > spacing(distance) ** 0.6 * abs(distance))):
            break
    return distance


def further(eta, rest, start, amount, rough, far, moment=0):
    """How far beyond ``start`` V has risen by ``amount``: ``onward`` where the rough value is not told well enough."""
    better = onward(eta, rest, start, -amount, rough, far == 0, moment)
    # Newton's method leaves a place where V is nearly level for one far away.
    return pick(far | (abs(better - rough) > 0.01), rough, better)


def tip_fall(eta, piece, change, rise, drop):
    """V(tip) − V(tip + change), for a tip that is told from the low and the high end of its range."""
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    upper = from_hill < depth
    return fall(eta, pick_rest(upper, piece.basin.hill, piece.basin.well), pick(upper, from_hill, -depth), change)


def ridge_fall(beta, eta, field_angle, hill, ridge):
    """V(hill) − V(ridge): the sine of half their distance times the slope of V between, as if it were a circle."""
    half, middle = (ridge.extra - hill.extra) / 2, pi / 2 + (hill.extra + ridge.extra) / 2
    return cos(half) * (2 * beta * sin(middle) - eta * sin(half) * sin(2 * (middle - field_angle)))
