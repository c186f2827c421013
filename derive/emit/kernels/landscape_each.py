"""The kernels of ``landscape`` on arrays.

Emitted by `derive emit` from kernels/landscape.py: do not edit, change that file.

Digest of the inputs: sha256 97f19411f4bfa78215e8d65df7ca1501912c208e27b016403861140db423f003
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_any_of, each_cos, each_less_quarters, each_pick, each_sin, larger
from derive.emit.kernels.oblique_rests_each import (
    astroid_cusp_each,
    beside_field_each,
    beside_force_each,
    couple_beyond_each,
    pair_rests_each,
)
from derive.emit.kernels.rests import Landscape, Rest
from derive.emit.kernels.rests_each import (
    mirror_landscape_each,
    pick_rest_each,
    rest_at_each,
    rest_of_each,
    rest_turned_back_each,
)
from derive.emit.kernels.symmetric_landscapes_each import (
    no_field_each,
    orthogonal_double_each,
    orthogonal_single_each,
    parallel_alone_each,
    parallel_double_each,
    parallel_single_each,
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
    cusp = astroid_cusp_each(lean)
    # Beside the force the couple is as small as the sine, and so is its rounding.
    return couple_beyond_each(beta, eta, lean, cusp) > 4 * epsilon() * (beta + eta) * each_sin(lean + cusp)


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
    place = lean + cusp
    couple = -larger(-couple_beyond_each(beta, eta, lean, cusp), epsilon() * (beta + eta) * each_sin(place))
    stiffness = couple * each_cos(place) / each_sin(place)
    shoulder = Rest(2, place, 0, stiffness, each_cos(2 * cusp), each_sin(2 * cusp))
    if each_any_of(steep):
        shoulder = pick_rest_each(steep, rest_turned_back_each(shoulder)._replace(quarters=4), shoulder)
    return scene._replace(shoulder=rest_of_each(shoulder.quarters, shoulder), moment=couple)
