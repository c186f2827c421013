"""The kernels of ``oblique_rests`` on arrays.

Emitted by `derive emit` from kernels/oblique_rests.py: do not edit, change that file.

Digest of the inputs: sha256 6861966ff5e04635ff0fa85e9db8e9049426db6273d55abe32805a0c57606286
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_atan, each_cos, each_pick, each_sin, larger
from derive.emit.kernels.formulas_each import (
    cusp_couple_each,
    force_balance_each,
    force_stiffness_each,
    pair_couple_each,
    pair_stiffness_each,
)
from derive.emit.kernels.rests import Rest
from derive.emit.kernels.rests_each import rising_root_each


def beside_field_each(beta, eta, lean):
    """The hill between force and field, for a field at ``lean`` in (0, π/4]."""
    back = rising_root_each(lambda y: twist_each(eta, y) - beta * each_sin(lean - y), 0 * lean, lean)
    return Rest(
        0,
        lean - back,
        0,
        beta * each_cos(lean - back) + eta * each_cos(2 * back),
        each_cos(2 * back),
        -each_sin(2 * back),
    )


def beside_force_each(beta, eta, lean, most):
    """The well between the normal of the field and the opposite of the force, for the same: by what it is from the
    nearer one of these. most: what they are apart."""
    on = side_couple_each(beta, eta, lean, most / 2) < 0  # whether it is nearer to the normal
    # Under a force no weaker than the field it is no further from its opposite than where both would be level.
    level = each_pick(on | (beta < eta), most, 2 * lean ** (1 / 3))
    part = rising_root_each(
        lambda x: each_pick(on, twist_each(eta, x) - beta * each_cos(lean + x), side_couple_each(beta, eta, lean, x)),
        0 * lean,
        each_pick(level < most, level, most),
    )
    gap, double = each_pick(on, most - part, part), 2 * each_pick(on, part, lean + part)
    along, across = (
        each_pick(on, each_sin(part), each_cos(lean + part)),
        each_pick(on, each_cos(part), each_sin(lean + part)),
    )
    weak = 2 * eta < beta  # then it is next to the force, and nothing cancels
    stiffness = force_stiffness_each(
        eta, each_sin(lean), each_cos(lean), along, across, each_pick(weak, 1, larger(each_sin(gap), epsilon() ** 19))
    )
    stiffness = each_pick(weak, beta * each_cos(gap) - eta * each_cos(double), stiffness)
    return Rest(2, -gap, 0, -stiffness, each_cos(double) * each_pick(on, -1, 1), -each_sin(double))


def side_couple_each(beta, eta, lean, gap):
    """The couple on a rod at π − gap."""
    turn = lean + gap
    return force_balance_each(
        beta, eta, each_sin(gap), each_sin(lean / 2), each_cos(gap + lean / 2), each_sin(turn), each_sin(turn / 2)
    )


def pair_rests_each(beta, eta, lean):
    """The pair at π + lean + x, x to either side of the cusp, each with π/2 − x: by what x is from the cusp, or from
    the nearer end of the quarter."""
    cusp = astroid_cusp_each(lean)
    place, couple = lean + cusp, couple_beyond_each(beta, eta, lean, cusp)
    stiffness = couple * each_cos(place) / each_sin(place)

    def beside(u):
        first, second = each_sin(2 * cusp + u / 4), each_sin(2 * cusp + 3 * u / 4)
        force_sine, third = each_sin(place + u / 4), each_sin(3 * u / 4)
        return cusp_couple_each(
            beta, eta, couple, stiffness, each_sin(u / 2), each_sin(u / 4), third, first, second, force_sine
        )

    near = couple_beyond_each(beta, eta, lean, cusp / 2) > 0
    first = rising_root_each(
        lambda x: each_pick(near, couple_beyond_each(beta, eta, lean, x), beside(-x)),
        each_pick(near, 0, cusp),
        each_pick(near, cusp, 0),
    )
    turn = each_pick(near, first, cusp - first)
    low = pair_rest_each(eta, lean, cusp, turn, each_pick(near, first - cusp, -first)), pi / 2 - turn
    most = pi / 2 - cusp
    far = couple_beyond_each(beta, eta, lean, cusp + most / 2) > 0
    last = rising_root_each(
        lambda x: each_pick(far, twist_each(eta, x) - beta * each_cos(lean - x), beside(x)),
        each_pick(far, 0, most),
        each_pick(far, most, 0),
    )
    beyond = each_pick(far, most - last, last)
    high = pair_rest_each(eta, lean, cusp, cusp + beyond, beyond), each_pick(far, last, pi / 2 - (cusp + beyond))
    return low, high


def pair_rest_each(eta, lean, cusp, turn, beside):
    """The direction at π + lean + turn, turn = cusp + beside."""
    along, across = each_cos(cusp) * each_sin(turn), each_sin(cusp) * each_cos(turn)
    stiffness = pair_stiffness_each(
        eta, each_cos(lean), each_cos(cusp), each_sin(beside), along, across, each_sin(lean + turn)
    )
    return Rest(2, lean + turn, 0, stiffness, each_cos(2 * turn), each_sin(2 * turn))


def couple_beyond_each(beta, eta, lean, turn):
    """The couple on a rod at π + lean + turn, greatest at the cusp; of a weak force as it stands."""
    across = each_sin(lean + turn)
    couple = pair_couple_each(
        beta, eta, across, each_sin(lean / 2), each_cos(turn + lean / 2), each_sin(turn), each_sin(turn / 2)
    )
    return each_pick(2 * beta < eta, twist_each(eta, turn) - beta * across, couple)


def astroid_cusp_each(field_angle):
    """Where the second pair is born: tan³x = tan α (Stoner and Wohlfarth's astroid).

    The pair lies at α + π + x with sin α/sin x + cos α/cos x = η/β: it is there when η/β is beyond the least value of
    the left side, taken at this x.
    """
    return each_atan((each_sin(field_angle) / larger(each_cos(field_angle), epsilon())) ** (1 / 3))


def ridge_couple_each(beta, eta, field_angle, x):
    """The couple on a rod that points along α + π + x."""
    return twist_each(eta, x) - beta * each_sin(field_angle + x)


def twist_each(eta, x):
    """The couple of the field on a rod turned by x from it."""
    return eta * each_sin(x) * each_cos(x)
