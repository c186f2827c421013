"""The kernels of ``landscape`` on arrays.

Emitted by `derive emit` from kernels/landscape.py: do not edit, change that file.

Digest of the inputs: sha256 39029ea274728f7960a034bb514c4aa07749506e55be3660970086d967174f35
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import (
    any_of,
    each_abs,
    each_atan,
    each_atan2,
    each_cos,
    each_less_quarters,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.formulas_each import (
    cusp_couple_each,
    force_balance_each,
    force_stiffness_each,
    pair_couple_each,
    pair_stiffness_each,
)
from derive.emit.kernels.landscape import Landscape, Rest


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
    return with_shoulder_each(beta, eta, field_angle, oblique_single_each(beta, eta, field_angle))


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


def along_each(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def mirror_rest_each(rest):
    """The direction seen from the other side of the y axis, a turn on."""
    return rest._replace(
        quarters=4 - rest.quarters, extra=-rest.extra, angle=2 * pi - rest.angle, double_sine=-rest.double_sine
    )


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


def rest_turned_back_each(rest):
    """What is a hill beside 0 with one field is a well beside π with the other, and the reverse."""
    return rest._replace(
        extra=-rest.extra, stiffness=-rest.stiffness, double_cosine=-rest.double_cosine, double_sine=rest.double_sine
    )


def rest_of_each(quarters, rest):
    """The direction with its angle, from a number of quarter turns on."""
    return rest._replace(quarters=quarters, angle=quarters * (pi / 2) + rest.extra)


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


def oblique_double_each(beta, eta, field_angle):
    """A field angle in (0, π/2), and a second pair: a ridge and a well."""
    hill, well, again = oblique_single_each(beta, eta, field_angle).rests
    steep = field_angle > pi / 4
    lean = each_pick(steep, -each_less_quarters(field_angle, 1), field_angle)
    (low, low_over), (high, high_over) = pair_rests_each(beta, eta, lean)
    if any_of(steep):
        # The same pair, seen from the force's direction a turn on.
        first = rest_turned_back_each(high)._replace(extra=field_angle + high_over)
        second = rest_turned_back_each(low)._replace(extra=field_angle + low_over)
        low, high = pick_rest_each(steep, first, low), pick_rest_each(steep, second, high)
    return Landscape((hill, well, rest_of_each(2, low), rest_of_each(2, high), again), False, False)


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


def with_shoulder_each(beta, eta, field_angle, scene):
    """The landscape with the direction at which the pair would be born."""
    steep = field_angle > pi / 4
    lean = each_pick(steep, -each_less_quarters(field_angle, 1), field_angle)
    cusp = astroid_cusp_each(lean)
    place, couple = lean + cusp, couple_beyond_each(beta, eta, lean, cusp)
    stiffness = couple * each_cos(place) / each_sin(place)
    shoulder = Rest(2, place, 0, stiffness, each_cos(2 * cusp), each_sin(2 * cusp))
    if any_of(steep):
        back = rest_turned_back_each(shoulder)
        shoulder = pick_rest_each(steep, back._replace(extra=back.extra + pi), shoulder)
    return scene._replace(shoulder=rest_of_each(2, shoulder), moment=couple)


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


def pick_rest_each(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(*(each_pick(condition, *pair) for pair in zip(yes, no, strict=True)))


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
        if any_of(settled & moving):
            # The trials stay on one side of the root: is it between them and the next few numbers?
            beside = trial + each_pick((value_trial > 0) == (high > low), -2, 2) * epsilon() * each_abs(trial)
            beside = each_pick(settled, beside, trial)
            low, high, value_low, value_high = narrowed_each(low, high, value_low, value_high, beside, function(beside))
            moving = moving & (each_abs(high - low) > 2 * epsilon() * each_abs(trial))
        if not any_of(moving):
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
