"""The kernels of ``landscape`` on arrays.

Emitted by `derive emit` from kernels/landscape.py: do not edit, change that file.

Digest of the inputs: sha256 e8378fdbcccf79b91a160677dc42f180bfaafe340e32e569f55dd373f153bfd7
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    each_any_of,
    each_atan2,
    each_cos,
    each_less_quarters,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.landscape import Landscape
from derive.emit.kernels.oblique_rests_each import (
    astroid_cusp_each,
    beside_field_each,
    beside_force_each,
    couple_beyond_each,
    pair_rests_each,
)
from derive.emit.kernels.rests import Rest
from derive.emit.kernels.rests_each import (
    along_each,
    mirror_rest_each,
    pick_rest_each,
    rest_at_each,
    rest_of_each,
    rest_turned_back_each,
)


def landscape_each(beta, eta, field_angle):
    """Hills and wells for a field angle in (−π/2, π/2]."""
    if eta == 0:
        return no_field_each(beta)
    if field_angle == 0:
        if beta == 0:
            return parallel_alone_each(eta)
        return parallel_double_each(beta, eta) if eta > beta else parallel_single_each(beta, eta)
    if field_angle == pi / 2:
        return orthogonal_double_each(beta, eta) if eta > beta else orthogonal_single_each(beta, eta)
    if field_angle < 0:
        return mirror_landscape_each(oblique_landscape_each(beta, eta, -field_angle))
    return oblique_landscape_each(beta, eta, field_angle)


def oblique_landscape_each(beta, eta, field_angle):
    """Hills and wells for a field angle in (0, π/2)."""
    if beta == 0:
        return oblique_alone_each(eta, field_angle)
    if has_second_pair_each(beta, eta, field_angle):
        return oblique_double_each(beta, eta, field_angle)
    scene = oblique_single_each(beta, eta, field_angle)
    # Of a field all but along the force rounding leaves the shoulder nothing that is right.
    return scene if field_angle < epsilon() ** 2 else with_shoulder_each(beta, eta, field_angle, scene)


def has_second_pair_each(beta, eta, field_angle):
    """Whether the field is strong enough for a second hill and well."""
    lean = each_pick(field_angle > pi / 4, -each_less_quarters(field_angle, 1), field_angle)
    return couple_beyond_each(beta, eta, lean, astroid_cusp_each(lean)) > 4 * epsilon() * (beta + eta)


def mirror_landscape_each(scene):
    """The landscape seen from the other side of the y axis."""
    rests = tuple(mirror_rest_each(rest) for rest in scene.rests[::-1])
    if scene.shoulder is None:
        return scene._replace(rests=rests)
    return scene._replace(rests=rests, shoulder=mirror_rest_each(scene.shoulder), moment=-scene.moment)


def no_field_each(beta):
    """The force alone."""
    return Landscape((along_each(beta, 0, 1), along_each(beta, 2, -1), along_each(beta, 4, 1)), False, True)


def parallel_single_each(beta, eta):
    """The field along a force that is not weaker: one hill, at 0."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    return Landscape((top, Rest(2, 0, pi, eta - beta, 1, 0), again), False, True)


def parallel_alone_each(eta):
    """The field without force: hills along and against it, wells across."""
    top, side, again = (Rest(quarters, 0, quarters * (pi / 2), eta, 1, 0) for quarters in (0, 2, 4))
    first, second = (Rest(quarters, 0, quarters * (pi / 2), -eta, -1, 0) for quarters in (1, 3))
    return Landscape((top, first, side, second, again), True, True)


def parallel_double_each(beta, eta):
    """The field along a weaker force: hills at 0 and, lower, at π."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    side = Rest(2, 0, pi, eta - beta, 1, 0)
    lean = each_atan2(beta, each_sqrt((eta - beta) * (eta + beta)))
    softness = (eta - beta) * (eta + beta) / eta
    cosine = 2 * (beta / eta) * (beta / eta) - 1
    sine = -2 * (beta / eta) * each_sqrt((eta - beta) * (eta + beta)) / eta
    first = Rest(1, lean, pi / 2 + lean, -softness, cosine, sine)
    second = Rest(3, -lean, 3 * (pi / 2) - lean, -softness, cosine, -sine)
    return Landscape((top, first, side, second, again), False, True)


def orthogonal_single_each(beta, eta):
    """The field across a force that is not weaker: one hill, at 0."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), beta - eta, -1, 0) for quarters in (0, 4))
    return Landscape((top, Rest(2, 0, pi, -beta - eta, -1, 0), again), False, True)


def orthogonal_double_each(beta, eta):
    """The field across a weaker force: two hills of the same height beside 0."""
    lean = each_atan2(each_sqrt((eta - beta) * (eta + beta)), beta)
    stiffness = (eta - beta) * (eta + beta) / eta
    cosine = 1 - 2 * (beta / eta) * (beta / eta)
    sine = -2 * (beta / eta) * each_sqrt((eta - beta) * (eta + beta)) / eta
    low = Rest(0, -lean, -lean, stiffness, cosine, -sine)
    high, again = Rest(0, lean, lean, stiffness, cosine, sine), low._replace(quarters=4, angle=2 * pi - lean)
    top, bottom = Rest(0, 0, 0, beta - eta, -1, 0), Rest(2, 0, pi, -beta - eta, -1, 0)
    return Landscape((low, top, high, bottom, again), True, True)


def oblique_alone_each(eta, field_angle):
    """The field without force, at an angle in (0, π/2)."""
    return Landscape(tuple(rest_at_each(0 * eta, eta, field_angle, k, field_angle) for k in range(5)), True, True)


def oblique_single_each(beta, eta, field_angle):
    """A field angle in (0, π/2): a hill between force and field, a well a quarter turn on."""
    # Both lie as the well and the hill do with the field as far from the normal of the force as it is here from it.
    steep = field_angle > pi / 4
    lean = each_pick(steep, -each_less_quarters(field_angle, 1), field_angle)
    across = each_pick(steep, field_angle, pi / 2 - lean)
    hill, well = beside_field_each(beta, eta, lean), beside_force_each(beta, eta, lean, across)
    hill, well = (
        pick_rest_each(steep, rest_turned_back_each(well), hill),
        pick_rest_each(steep, rest_turned_back_each(hill), well),
    )
    low = rest_of_each(0, hill)
    return Landscape((low, rest_of_each(2, well), low._replace(quarters=4, angle=low.angle + 2 * pi)), False, False)


def oblique_double_each(beta, eta, field_angle):
    """A field angle in (0, π/2), and a second pair: a ridge and a well."""
    hill, well, again = oblique_single_each(beta, eta, field_angle).rests
    steep = field_angle > pi / 4
    lean = each_pick(steep, -each_less_quarters(field_angle, 1), field_angle)
    (low, low_over), (high, high_over) = pair_rests_each(beta, eta, lean)
    if each_any_of(steep):
        # The same pair, seen from the force's direction a turn on.
        first = rest_turned_back_each(high)._replace(extra=field_angle + high_over)
        second = rest_turned_back_each(low)._replace(extra=field_angle + low_over)
        low, high = pick_rest_each(steep, first, low), pick_rest_each(steep, second, high)
    return Landscape((hill, well, rest_of_each(2, low), rest_of_each(2, high), again), False, False)


def with_shoulder_each(beta, eta, field_angle, scene):
    """The landscape with the direction at which the pair would be born."""
    steep = field_angle > pi / 4
    lean = each_pick(steep, -each_less_quarters(field_angle, 1), field_angle)
    cusp = astroid_cusp_each(lean)
    # Of the couple rounding may leave nothing, or less.
    place, couple = lean + cusp, -larger(-couple_beyond_each(beta, eta, lean, cusp), epsilon() * (beta + eta))
    stiffness = couple * each_cos(place) / each_sin(place)
    shoulder = Rest(2, place, 0, stiffness, each_cos(2 * cusp), each_sin(2 * cusp))
    if each_any_of(steep):
        shoulder = pick_rest_each(steep, rest_turned_back_each(shoulder)._replace(quarters=4), shoulder)
    return scene._replace(shoulder=rest_of_each(shoulder.quarters, shoulder), moment=couple)
