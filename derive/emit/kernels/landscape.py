"""Where the potential V(θ) = β cos θ + ½η cos²(θ − α) of the motion along the rod is stationary: hills and wells.

A rod that points along a hill of V is straight and resists; the motion from the tip slows down there. A well is a
direction across which the rod swings. Directions are kept as whole quarter turns and a rest, so that an angle near
them is told from them without loss.
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import any_of, cos, epsilon, larger, less_quarters, pi, pick, sin
from derive.emit.kernels.oblique_rests import astroid_cusp, beside_field, beside_force, couple_beyond, pair_rests
from derive.emit.kernels.rests import Landscape, Rest, mirror_landscape, pick_rest, rest_at, rest_of, rest_turned_back
from derive.emit.kernels.symmetric_landscapes import (
    no_field,
    orthogonal_double,
    orthogonal_single,
    parallel_alone,
    parallel_double,
    parallel_single,
)


def landscape(beta, eta, field_angle):
    """Hills and wells for a field angle in (−π/2, π/2]."""
    if eta == 0:
        return no_field(beta)
    if field_angle == 0:
        if beta == 0:
            return parallel_alone(eta)
        return parallel_double(beta, eta) if eta > beta else parallel_single(beta, eta)
    if field_angle == pi / 2:
        return orthogonal_double(beta, eta) if eta > beta else orthogonal_single(beta, eta)
    if field_angle < 0:
        return mirror_landscape(oblique_landscape(beta, eta, -field_angle))
    return oblique_landscape(beta, eta, field_angle)


def oblique_landscape(beta, eta, field_angle):
    """Hills and wells for a field angle in (0, π/2)."""
    if beta == 0:
        return oblique_alone(eta, field_angle)
    if has_second_pair(beta, eta, field_angle):
        return oblique_double(beta, eta, field_angle)
    scene = oblique_single(beta, eta, field_angle)
    # Of a field all but along the force rounding leaves the shoulder nothing that is right.
    return scene if field_angle < epsilon() ** 2 else with_shoulder(beta, eta, field_angle, scene)


def has_second_pair(beta, eta, field_angle):
    """Whether the field is strong enough for a second hill and well."""
    lean = pick(field_angle > pi / 4, -less_quarters(field_angle, 1), field_angle)
    cusp = astroid_cusp(lean)
    # Beside the force the couple is as small as the sine, and so is its rounding.
    return couple_beyond(beta, eta, lean, cusp) > 4 * epsilon() * (beta + eta) * sin(lean + cusp)


def oblique_alone(eta, field_angle):
    """The field without force, at an angle in (0, π/2)."""
    return Landscape(tuple(rest_at(0 * eta, eta, field_angle, k, field_angle) for k in range(5)), True, True)


def oblique_single(beta, eta, field_angle):
    """A field angle in (0, π/2): a hill between force and field, a well a quarter turn on."""
    # Both lie as the well and the hill do with the field as far from the normal of the force as it is here from it.
    steep = field_angle > pi / 4
    lean = pick(steep, -less_quarters(field_angle, 1), field_angle)
    across = pick(steep, field_angle, pi / 2 - lean)
    hill, well = beside_field(beta, eta, lean), beside_force(beta, eta, lean, across)
    hill, well = pick_rest(steep, rest_turned_back(well), hill), pick_rest(steep, rest_turned_back(hill), well)
    low = rest_of(0, hill)
    return Landscape((low, rest_of(2, well), low._replace(quarters=4, angle=low.angle + 2 * pi)), False, False)


def oblique_double(beta, eta, field_angle):
    """A field angle in (0, π/2), and a second pair: a ridge and a well."""
    hill, well, again = oblique_single(beta, eta, field_angle).rests
    steep = field_angle > pi / 4
    lean = pick(steep, -less_quarters(field_angle, 1), field_angle)
    (low, low_over), (high, high_over) = pair_rests(beta, eta, lean)
    if any_of(steep):
        # The same pair, seen from the force's direction a turn on.
        first = rest_turned_back(high)._replace(extra=field_angle + high_over)
        second = rest_turned_back(low)._replace(extra=field_angle + low_over)
        low, high = pick_rest(steep, first, low), pick_rest(steep, second, high)
    return Landscape((hill, well, rest_of(2, low), rest_of(2, high), again), False, False)


def with_shoulder(beta, eta, field_angle, scene):
    """The landscape with the direction at which the pair would be born."""
    steep = field_angle > pi / 4
    lean = pick(steep, -less_quarters(field_angle, 1), field_angle)
    cusp = astroid_cusp(lean)
    # Of the couple rounding may leave nothing, or less.
    place = lean + cusp
    couple = -larger(-couple_beyond(beta, eta, lean, cusp), epsilon() * (beta + eta) * sin(place))
    stiffness = couple * cos(place) / sin(place)
    shoulder = Rest(2, place, 0, stiffness, cos(2 * cusp), sin(2 * cusp))
    if any_of(steep):
        shoulder = pick_rest(steep, rest_turned_back(shoulder)._replace(quarters=4), shoulder)
    return scene._replace(shoulder=rest_of(shoulder.quarters, shoulder), moment=couple)
