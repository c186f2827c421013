"""Directions of equilibrium where the field is inclined to the force: hill, well, and a second pair of these.

Where two of them all but merge they are told by their distance from the cusp of Stoner and Wohlfarth's astroid.
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import atan, cos, epsilon, larger, pi, pick, sin
from derive.emit.kernels.formulas import cusp_couple, force_balance, force_stiffness, pair_couple, pair_stiffness
from derive.emit.kernels.rests import Rest, rising_root


def beside_field(beta, eta, lean):
    """The hill between force and field, for a field at ``lean`` in (0, π/4]."""
    back = rising_root(lambda y: twist(eta, y) - beta * sin(lean - y), 0 * lean, lean)
    return Rest(0, lean - back, 0, beta * cos(lean - back) + eta * cos(2 * back), cos(2 * back), -sin(2 * back))


def beside_force(beta, eta, lean, most):
    """The well between the normal of the field and the opposite of the force, for the same: by what it is from the
    nearer one of these. most: what they are apart."""
    on = side_couple(beta, eta, lean, most / 2) < 0  # whether it is nearer to the normal
    # Under a force no weaker than the field it is no further from its opposite than where both would be level.
    level = pick(on | (beta < eta), most, 2 * lean ** (1 / 3))
    part = rising_root(
        lambda x: pick(on, twist(eta, x) - beta * cos(lean + x), side_couple(beta, eta, lean, x)),
        0 * lean,
        pick(level < most, level, most),
    )
    gap, double = pick(on, most - part, part), 2 * pick(on, part, lean + part)
    along, across = pick(on, sin(part), cos(lean + part)), pick(on, cos(part), sin(lean + part))
    weak = 2 * eta < beta  # then it is next to the force, and nothing cancels
    stiffness = force_stiffness(
        eta, sin(lean), cos(lean), along, across, pick(weak, 1, larger(sin(gap), epsilon() ** 19))
    )
    stiffness = pick(weak, beta * cos(gap) - eta * cos(double), stiffness)
    return Rest(2, -gap, 0, -stiffness, cos(double) * pick(on, -1, 1), -sin(double))


def side_couple(beta, eta, lean, gap):
    """The couple on a rod at π − gap."""
    turn = lean + gap
    return force_balance(beta, eta, sin(gap), sin(lean / 2), cos(gap + lean / 2), sin(turn), sin(turn / 2))


def pair_rests(beta, eta, lean):
    """The pair at π + lean + x, x to either side of the cusp, each with π/2 − x: by what x is from the cusp, or from
    the nearer end of the quarter."""
    cusp = astroid_cusp(lean)
    place, couple = lean + cusp, couple_beyond(beta, eta, lean, cusp)
    stiffness = couple * cos(place) / sin(place)

    def beside(u):
        first, second = sin(2 * cusp + u / 4), sin(2 * cusp + 3 * u / 4)
        force_sine, third = sin(place + u / 4), sin(3 * u / 4)
        return cusp_couple(beta, eta, couple, stiffness, sin(u / 2), sin(u / 4), third, first, second, force_sine)

    near = couple_beyond(beta, eta, lean, cusp / 2) > 0
    first = rising_root(
        lambda x: pick(near, couple_beyond(beta, eta, lean, x), beside(-x)), pick(near, 0, cusp), pick(near, cusp, 0)
    )
    turn = pick(near, first, cusp - first)
    low = pair_rest(eta, lean, cusp, turn, pick(near, first - cusp, -first)), pi / 2 - turn
    most = pi / 2 - cusp
    far = couple_beyond(beta, eta, lean, cusp + most / 2) > 0
    last = rising_root(
        lambda x: pick(far, twist(eta, x) - beta * cos(lean - x), beside(x)), pick(far, 0, most), pick(far, most, 0)
    )
    beyond = pick(far, most - last, last)
    high = pair_rest(eta, lean, cusp, cusp + beyond, beyond), pick(far, last, pi / 2 - (cusp + beyond))
    return low, high


def pair_rest(eta, lean, cusp, turn, beside):
    """The direction at π + lean + turn, turn = cusp + beside."""
    along, across = cos(cusp) * sin(turn), sin(cusp) * cos(turn)
    stiffness = pair_stiffness(eta, cos(lean), cos(cusp), sin(beside), along, across, sin(lean + turn))
    return Rest(2, lean + turn, 0, stiffness, cos(2 * turn), sin(2 * turn))


def couple_beyond(beta, eta, lean, turn):
    """The couple on a rod at π + lean + turn, greatest at the cusp; of a weak force as it stands."""
    across = sin(lean + turn)
    couple = pair_couple(beta, eta, across, sin(lean / 2), cos(turn + lean / 2), sin(turn), sin(turn / 2))
    return pick(2 * beta < eta, twist(eta, turn) - beta * across, couple)


def astroid_cusp(field_angle):
    """Where the second pair is born: tan³x = tan α (Stoner and Wohlfarth's astroid).

    The pair lies at α + π + x with sin α/sin x + cos α/cos x = η/β: it is there when η/β is beyond the least value of
    the left side, taken at this x.
    """
    return atan((sin(field_angle) / larger(cos(field_angle), epsilon())) ** (1 / 3))


def ridge_couple(beta, eta, field_angle, x):
    """The couple on a rod that points along α + π + x."""
    return twist(eta, x) - beta * sin(field_angle + x)


def twist(eta, x):
    """The couple of the field on a rod turned by x from it."""
    return eta * sin(x) * cos(x)
