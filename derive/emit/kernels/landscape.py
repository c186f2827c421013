"""Where the potential V(θ) = β cos θ + ½η cos²(θ − α) of the motion along the rod is stationary: hills and wells.

A rod that points along a hill of V is straight and resists; the motion from the tip slows down there. A well is a
direction across which the rod swings. Directions are kept as whole quarter turns and a rest, so that an angle near
them is told from them without loss.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import atan, atan2, cos, epsilon, less_quarters, pi, sin, sqrt


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

    level: the ridge is as high as the hill.
    """

    rests: tuple[Rest, ...]
    level: bool


def landscape(beta, eta, field_angle):
    """Hills and wells for a field angle in (−π/2, π/2]."""
    if eta == 0:
        return Landscape((along(beta, 0, 1), along(beta, 2, -1), along(beta, 4, 1)), False)
    if field_angle == 0:
        return parallel_landscape(beta, eta)
    if field_angle == pi / 2:
        return orthogonal_landscape(beta, eta)
    if field_angle < 0:
        image = oblique_landscape(beta, eta, -field_angle)
        return Landscape(tuple(mirror_rest(rest) for rest in image.rests[::-1]), image.level)
    return oblique_landscape(beta, eta, field_angle)


def along(beta, quarters, sign):
    """A direction along or against the force, no field: what it is about the field is not asked."""
    return Rest(quarters, 0, quarters * (pi / 2), sign * beta, 1, 0)


def mirror_rest(rest):
    """The direction seen from the other side of the y axis, a turn on."""
    return rest._replace(
        quarters=4 - rest.quarters, extra=-rest.extra, angle=2 * pi - rest.angle, double_sine=-rest.double_sine
    )


def parallel_landscape(beta, eta):
    """The field along the force: hills at 0 and, when η > β, at π."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    side = Rest(2, 0, pi, eta - beta, 1, 0)
    if beta == 0:
        wells = (Rest(quarters, 0, quarters * (pi / 2), -eta, -1, 0) for quarters in (1, 3))
    elif eta > beta:
        lean = atan2(beta, sqrt((eta - beta) * (eta + beta)))
        softness = (eta - beta) * (eta + beta) / eta
        cosine = 2 * (beta / eta) ** 2 - 1
        sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
        wells = (
            Rest(quarters, side_lean, quarters * (pi / 2) + side_lean, -softness, cosine, side_sine)
            for quarters, side_lean, side_sine in ((1, lean, sine), (3, -lean, -sine))
        )
    else:
        return Landscape((top, side, again), False)
    first, second = wells
    return Landscape((top, first, side, second, again), beta == 0)


def orthogonal_landscape(beta, eta):
    """The field across the force: one hill at 0, or when η > β two of the same height beside it."""
    bottom = Rest(2, 0, pi, -beta - eta, -1, 0)
    if eta <= beta:
        top, again = (Rest(quarters, 0, quarters * (pi / 2), beta - eta, -1, 0) for quarters in (0, 4))
        return Landscape((top, bottom, again), False)
    lean = atan2(sqrt((eta - beta) * (eta + beta)), beta)
    stiffness = (eta - beta) * (eta + beta) / eta
    cosine = 1 - 2 * (beta / eta) ** 2
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    low, high, again = (
        Rest(quarters, side * lean, quarters * (pi / 2) + side * lean, stiffness, cosine, side * sine)
        for quarters, side in ((0, -1), (0, 1), (4, -1))
    )
    return Landscape((low, Rest(0, 0, 0, beta - eta, -1, 0), high, bottom, again), True)


def oblique_landscape(beta, eta, field_angle):
    """A field angle in (0, π/2): a hill between force and field, a well a quarter turn on, and perhaps a second pair.

    The second pair lies at α + π + x with sin α/sin x + cos α/cos x = η/β: it is there when η is beyond the least
    value of the left side, taken where tan³x = tan α (Stoner and Wohlfarth's astroid).
    """
    if beta == 0:
        rests = [rest_at(beta, eta, field_angle, k, field_angle) for k in range(5)]
        return Landscape(tuple(rests), True)
    sine, cosine = sin(field_angle), cos(field_angle)
    back = rising_root(lambda y: twist(eta, y) - beta * sin(field_angle - y), 0, field_angle)
    on = rising_root(lambda w: twist(eta, w) - beta * cos(field_angle + w), 0, pi / 2 - field_angle)
    hill = rest_at(beta, eta, field_angle, 0, field_angle - back)
    well = rest_at(beta, eta, field_angle, 1, field_angle + on)
    again = hill._replace(quarters=4, angle=hill.angle + 2 * pi)
    cusp = atan((sine / cosine) ** (1 / 3))

    def lift(x):
        return twist(eta, x) - beta * sin(field_angle + x)

    if lift(cusp) <= 4 * epsilon() * (beta + eta):
        return Landscape((hill, well, again), False)
    ridge = rest_at(beta, eta, field_angle, 2, field_angle + rising_root(lift, 0, cusp))
    second = rest_at(beta, eta, field_angle, 2, field_angle + rising_root(lift, pi / 2, cusp))
    return Landscape((hill, well, ridge, second, again), False)


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
    if value_high <= 0:
        return high
    while True:
        middle = (low + high) / 2
        value = function(middle)
        size = sqrt(value * value - value_low * value_high)
        if value == 0 or size == 0:
            return middle
        trial = middle + (middle - low) * (-value / size)
        value_trial = function(trial)
        if value_trial == 0:
            return trial
        if value > 0:
            high, value_high = middle, value
        else:
            low, value_low = middle, value
        if value_trial > 0 and abs(trial - low) < abs(high - low):
            high, value_high = trial, value_trial
        elif value_trial < 0 and abs(high - trial) < abs(high - low):
            low, value_low = trial, value_trial
        if abs(high - low) <= 2 * epsilon() * abs(trial):
            return trial


def offset_from(rest, angle, turns):
    """angle − (rest + turns·2π), without cancellation; 0 where no angle within rounding of this one tells them apart."""
    offset = less_quarters(angle, 4 * turns + rest.quarters) - rest.extra
    blur = epsilon() * (abs(angle) + abs(rest.extra))
    return 0 if abs(offset) <= blur or abs(offset) < epsilon() ** 9 else offset
