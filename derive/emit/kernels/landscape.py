"""Where the potential V(θ) = β cos θ + ½η cos²(θ − α) of the motion along the rod is stationary: hills and wells.

A rod that points along a hill of V is straight and resists; the motion from the tip slows down there. A well is a
direction across which the rod swings. Directions are kept as whole quarter turns and a rest, so that an angle near
them is told from them without loss.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, atan, atan2, cos, epsilon, larger, less_quarters, pi, pick, sin, sqrt
from derive.emit.kernels.formulas import cusp_couple, force_balance, force_stiffness, pair_couple, pair_stiffness


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
    return with_shoulder(beta, eta, field_angle, oblique_single(beta, eta, field_angle))


def has_second_pair(beta, eta, field_angle):
    """Whether the field is strong enough for a second hill and well."""
    lean = pick(field_angle > pi / 4, -less_quarters(field_angle, 1), field_angle)
    return couple_beyond(beta, eta, lean, astroid_cusp(lean)) > 4 * epsilon() * (beta + eta)


def mirror_landscape(scene):
    """The landscape seen from the other side of the y axis."""
    rests = tuple(mirror_rest(rest) for rest in scene.rests[::-1])
    if scene.shoulder is None:
        return scene._replace(rests=rests)
    return scene._replace(rests=rests, shoulder=mirror_rest(scene.shoulder), moment=-scene.moment)


def along(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def mirror_rest(rest):
    """The direction seen from the other side of the y axis, a turn on."""
    return rest._replace(
        quarters=4 - rest.quarters, extra=-rest.extra, angle=2 * pi - rest.angle, double_sine=-rest.double_sine
    )


def no_field(beta):
    """The force alone."""
    return Landscape((along(beta, 0, 1), along(beta, 2, -1), along(beta, 4, 1)), False, True)


def parallel_single(beta, eta):
    """The field along a force that is not weaker: one hill, at 0."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    return Landscape((top, Rest(2, 0, pi, eta - beta, 1, 0), again), False, True)


def parallel_alone(eta):
    """The field without force: hills along and against it, wells across."""
    top, side, again = (Rest(quarters, 0, quarters * (pi / 2), eta, 1, 0) for quarters in (0, 2, 4))
    first, second = (Rest(quarters, 0, quarters * (pi / 2), -eta, -1, 0) for quarters in (1, 3))
    return Landscape((top, first, side, second, again), True, True)


def parallel_double(beta, eta):
    """The field along a weaker force: hills at 0 and, lower, at π."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    side = Rest(2, 0, pi, eta - beta, 1, 0)
    lean = atan2(beta, sqrt((eta - beta) * (eta + beta)))
    softness = (eta - beta) * (eta + beta) / eta
    cosine = 2 * (beta / eta) * (beta / eta) - 1
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    first = Rest(1, lean, pi / 2 + lean, -softness, cosine, sine)
    second = Rest(3, -lean, 3 * (pi / 2) - lean, -softness, cosine, -sine)
    return Landscape((top, first, side, second, again), False, True)


def orthogonal_single(beta, eta):
    """The field across a force that is not weaker: one hill, at 0."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), beta - eta, -1, 0) for quarters in (0, 4))
    return Landscape((top, Rest(2, 0, pi, -beta - eta, -1, 0), again), False, True)


def orthogonal_double(beta, eta):
    """The field across a weaker force: two hills of the same height beside 0."""
    lean = atan2(sqrt((eta - beta) * (eta + beta)), beta)
    stiffness = (eta - beta) * (eta + beta) / eta
    cosine = 1 - 2 * (beta / eta) * (beta / eta)
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    low = Rest(0, -lean, -lean, stiffness, cosine, -sine)
    high, again = Rest(0, lean, lean, stiffness, cosine, sine), low._replace(quarters=4, angle=2 * pi - lean)
    top, bottom = Rest(0, 0, 0, beta - eta, -1, 0), Rest(2, 0, pi, -beta - eta, -1, 0)
    return Landscape((low, top, high, bottom, again), True, True)


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


def rest_turned_back(rest):
    """What is a hill beside 0 with one field is a well beside π with the other, and the reverse."""
    return rest._replace(
        extra=-rest.extra, stiffness=-rest.stiffness, double_cosine=-rest.double_cosine, double_sine=rest.double_sine
    )


def rest_of(quarters, rest):
    """The direction with its angle, from a number of quarter turns on."""
    return rest._replace(quarters=quarters, angle=quarters * (pi / 2) + rest.extra)


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


def with_shoulder(beta, eta, field_angle, scene):
    """The landscape with the direction at which the pair would be born."""
    steep = field_angle > pi / 4
    lean = pick(steep, -less_quarters(field_angle, 1), field_angle)
    cusp = astroid_cusp(lean)
    place, couple = lean + cusp, couple_beyond(beta, eta, lean, cusp)
    stiffness = couple * cos(place) / sin(place)
    shoulder = Rest(2, place, 0, stiffness, cos(2 * cusp), sin(2 * cusp))
    if any_of(steep):
        back = rest_turned_back(shoulder)
        shoulder = pick_rest(steep, back._replace(extra=back.extra + pi), shoulder)
    return scene._replace(shoulder=rest_of(2, shoulder), moment=couple)


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


def pick_rest(condition, yes, no):
    """One or the other direction, number by number."""
    return Rest(*(pick(condition, *pair) for pair in zip(yes, no, strict=True)))


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
        if any_of(settled & moving):
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
