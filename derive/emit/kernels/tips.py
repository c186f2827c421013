"""The free end: the numbers from which a whole rod follows without loss, and the ranges in which it can lie."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import asin, atan2, cos, epsilon, exp, floor, pi, sin, sqrt
from derive.emit.kernels.formulas import (
    drive_between,
    drop_at_level,
    drop_from_gaps,
    gap_below,
    gap_from_side,
    level_above_gap,
    moment_from_side,
    moment_from_top,
    rising_level,
    side_moment,
    tip_gap,
)


class Clamp(NamedTuple):
    """The clamp angle θ(0) in [0, 2π), and what stays precise near the special angles."""

    angle: float
    rest: float  # π − θ(0)
    fold: float  # the smaller of θ(0) and 2π − θ(0)
    one_plus: float  # 1 + cos θ(0)
    one_minus: float  # 1 − cos θ(0)
    drive: float  # β + η cos θ(0)
    gap: float  # η(1 − cos θ(0)) − 2β


class Piece(NamedTuple):
    """A range of tip angles below the clamp angle in which the rod's motion is of one kind.

    Seen from the tip, θ starts at rest at an angle between low and low + width, and rises to the clamp angle;
    ``passes`` tells whether it goes on through π. The kinds name the ends: 'top' (θ = 0, the direction of the
    force), 'side' (θ = π), 'level' (the orbit that just reaches π), 'clamp' (the clamp angle itself), 'turn' (the
    angle whose orbit turns at the clamp), 'rest' (the clamp, where that is an equilibrium direction).
    """

    low: float
    width: float
    high_rest: float  # π − high
    low_kind: str
    high_kind: str
    passes: bool


class Tip(NamedTuple):
    """The free end, by what stays precise when it is near an equilibrium direction or a separatrix."""

    half_sine: float  # sin(θ_ℓ/2)
    half_cosine: float  # cos(θ_ℓ/2)
    gap: float  # η(1 − ξ_ℓ) − 2β
    drop: float  # ξ_ℓ − cos θ(0)
    level: float  # 2β + η(cos θ(0) + ξ_ℓ)
    drive: float  # β + ηξ_ℓ
    angle: float  # θ_ℓ in [0, 2π)
    passes: bool


def clamp_of(beta, eta, clamp_angle):
    """Whole turns and the clamp within [0, 2π); an angle that rounds to a multiple of π is that multiple."""
    half_turns = floor(clamp_angle / pi + 0.5)
    rest = half_turns * pi - clamp_angle
    # Also an angle whose square would be lost: it bends the rod by less than any number here can tell.
    if abs(rest) <= max(epsilon() * abs(clamp_angle), epsilon() ** 3):
        rest = 0
    if half_turns % 2:
        return (half_turns - 1) / 2, clamp_at(beta, eta, pi - rest, rest, abs(rest), True)
    if rest <= 0:
        return half_turns / 2, clamp_at(beta, eta, -rest, pi + rest, -rest, False)
    return half_turns / 2 - 1, clamp_at(beta, eta, 2 * pi - rest, rest - pi, rest, False)


def clamp_at(beta, eta, angle, rest, offset, from_side):
    """The clamp at an offset from π (from_side) or from 0."""
    small, large = 2 * sin(offset / 2) ** 2, 2 * cos(offset / 2) ** 2
    if from_side:
        side = side_moment(beta, eta)
        drive, gap = moment_from_side(eta, side, small), gap_from_side(eta, side, small)
        return Clamp(angle, rest, pi - offset, small, large, settled(drive, eta, offset), settled(gap, eta, offset))
    drive, gap = moment_from_top(beta, eta, small), tip_gap(beta, eta, small)
    return Clamp(angle, rest, offset, large, small, settled(drive, eta, offset), settled(gap, eta, offset))


def settled(value, eta, offset):
    """A value that changes with η cos θ(0), or 0 where no angle within rounding of the clamp angle tells it from 0."""
    return 0 if abs(value) <= 4 * epsilon() * eta * abs(sin(offset)) else value


def mirror_image(clamp):
    """The clamp of the rod seen from the other side of the y axis."""
    return clamp._replace(angle=2 * pi - clamp.angle, rest=-clamp.rest)


def pieces(beta, eta, clamp):
    """All ranges of tip angles below the clamp angle from which the rod can rise to it.

    With V(θ) = β cos θ + ½η cos²θ, a tip at rest at φ reaches the clamp only if V(φ) is not below V anywhere
    between; those φ fill the ranges below. There is one well of V when η ≤ β and there are two, parted by θ = π,
    when η > β.
    """
    kind = "clamp" if clamp.rest > 0 else "turn" if clamp.rest < 0 else "rest"
    whole = Piece(0, clamp.fold, abs(clamp.rest), "top", kind, True)
    if eta <= beta or clamp.gap <= 0:
        return [whole]
    return double_well(beta, eta, clamp)


def double_well(beta, eta, clamp):
    """The ranges when V has two wells and the clamp lies in one of them: over the ridge at π, and within the well."""
    level = 2 * atan2(sqrt(beta), sqrt(eta - beta))
    # A force far below rounding parts off tips from which only a rod of length 150/√η or more comes back.
    outer: list[Piece] = []
    if beta > 0 and beta > epsilon() ** 9 * eta:
        outer = [Piece(0, level, 2 * atan2(sqrt(eta - beta), sqrt(beta)), "top", "level", True)]
    if clamp.rest == 0:
        return outer
    turn = 2 * atan2(sqrt(2 * beta + eta * clamp.one_plus), sqrt(clamp.gap))
    turn_rest = 2 * atan2(sqrt(clamp.gap), sqrt(2 * beta + eta * clamp.one_plus))
    if clamp.rest < 0 and clamp.drive <= 0:
        kind = "clamp" if clamp.drive < 0 else "rest"
        return [*outer, Piece(pi, -clamp.rest, clamp.rest, "side", kind, False)]
    if clamp.rest < 0:
        return [*outer, Piece(pi, turn_rest, -turn_rest, "side", "turn", False)]
    if clamp.drive >= 0:
        kind = "clamp" if clamp.drive > 0 else "rest"
        width = 2 * asin(clamp.gap / (2 * eta * sin((clamp.fold + level) / 2)))
        return [*outer, Piece(level, width, clamp.rest, "level", kind, False)]
    width = 2 * asin(clamp.one_plus / (2 * sin((turn + level) / 2)))
    return [*outer, Piece(level, width, turn_rest, "level", "turn", False)]


def tip_at(beta, eta, clamp, piece, place):
    """The tip at a place of a piece: −∞ is its low end, +∞ its high end, and offsets from both are exact."""
    rise, fall = piece.width / (1 + exp(-place)), piece.width / (1 + exp(place))
    high = pi - piece.high_rest
    angle = piece.low + rise if rise < fall else high - fall
    if eta > beta and piece.low_kind == "side":
        half_sine, half_cosine = cos(rise / 2), -sin(rise / 2)
        gap = gap_from_side(eta, side_moment(beta, eta), 2 * half_cosine * half_cosine)
        drop, level = within_right_well(eta, clamp, piece, rise, fall)
    else:
        half_sine, half_cosine = sin(angle / 2), sin((piece.high_rest + fall) / 2)
        gap, drop, level = left_of_side(beta, eta, clamp, piece, rise, fall)
    return Tip(half_sine, half_cosine, gap, drop, level, drive_between(eta, drop, level), angle, piece.passes)


def within_right_well(eta, clamp, piece, rise, fall):
    """drop and level of a tip between π and the clamp; both are negative there."""
    if piece.high_kind != "turn":
        drop = -2 * sin(piece.width - fall / 2) * sin(fall / 2)
        return drop, rising_level(eta, clamp.drive, drop)
    level = -2 * eta * sin(piece.width - fall / 2) * sin(fall / 2)
    return drop_at_level(eta, clamp.drive, level), level


def left_of_side(beta, eta, clamp, piece, rise, fall):
    """gap, drop and level of a tip below π, each a sum of terms of one sign or a product of exact offsets."""
    # 2 sin(high − fall/2) sin(fall/2) is the difference of the cosines of the tip angle and of the high end.
    below_high = 2 * sin(piece.high_rest + fall / 2) * sin(fall / 2)
    if eta <= beta or piece.passes:
        if eta > beta and piece.high_kind == "level":
            gap = -eta * below_high
            drop = drop_from_gaps(eta, clamp.gap, gap)
        else:
            drop = below_high
            gap = gap_below(eta, clamp.gap, drop)
        return gap, drop, level_above_gap(eta, clamp.one_plus, gap)
    gap = 2 * eta * sin(piece.high_rest + piece.width - rise / 2) * sin(rise / 2)
    if piece.high_kind != "turn":
        drop = below_high
        return gap, drop, rising_level(eta, clamp.drive, drop)
    level = eta * below_high
    return gap, drop_at_level(eta, clamp.drive, level), level
