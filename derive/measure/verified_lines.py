"""The families of motions through a clamp angle, each along a line, and beyond which places none is an equilibrium.

Below the lower hill, or where hills are level, a motion swings in one well, and κ = κ_top tanh y; between the two hills it
passes the lower one, the ridge, and E goes from one to the other by a logistic curve, for κ of either sign.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, tau
from typing import Any

from flint import arb, arb_series

from derive.measure.reference import Rod
from derive.measure.verified_means import UndecidedError, carlson, first_order
from derive.measure.verified_motion import ORDER, Path, Potential, Well, forms, quotients, ratios

SHARES = (0.9, 0.5, 0.2, 0.05, 0.01)  # of the room beside a hill in which a motion's time there is bounded
START = 0.1234  # where a turn begins that is looked through for directions without moment
NARROWEST = 1e-9  # parts of it that are cut no more
CUT = 0.4871  # not half, so that no special angle is met
STEP = 0.5  # of the place, by which an end is looked for
FAR = 400  # steps, and as many for each unit of length


@dataclass(frozen=True)
class Line:
    """A family of motions in a well, and the places between which all equilibria of it lie."""

    well: Well
    path: Path
    low: float
    high: float


def scaled(rod: Rod) -> tuple[Potential, arb]:
    """V about the clamp angle in units in which β + η = 1, and the length. Angles that are whole quarter turns but for
    rounding are meant to be those.
    """
    softness = arb(rod.beta) + arb(rod.eta)
    clamp, field = half_turns(rod.clamp_angle), half_turns(rod.field_angle)
    lean = arb(0) if rod.clamp_angle == rod.field_angle else 2 * (clamp - field)
    force, quarter = arb(rod.beta) / softness, arb(rod.eta) / (4 * softness)
    potential = Potential(
        force * clamp.cos_pi(), -force * clamp.sin_pi(), quarter * lean.cos_pi(), -quarter * lean.sin_pi()
    )
    return potential, arb(rod.length) * softness.sqrt()


def half_turns(angle: float) -> arb:
    """An angle over π."""
    quarters = round(angle / (pi / 2))
    return arb(quarters) / 2 if quarters * (pi / 2) == angle else arb(angle) / arb.pi()


def rests(potential: Potential) -> list[tuple[arb, bool]]:
    """Directions without moment over two turns either way, ascending, and whether each is a hill."""
    found, parts = [], [(arb(START), arb(START) + 2 * arb.pi())]
    while parts:
        low, high = parts.pop()
        ball, middle = low.union(high), (low + CUT * (high - low)).mid()
        curve = potential.curve(ball)
        slope = potential.slope(middle) + curve * (ball - middle)
        if slope > 0 or slope < 0:
            continue
        if curve > 0 or curve < 0:
            first, last = (potential.slope(end) for end in (low, high))
            if not all(end > 0 or end < 0 for end in (first, last)):
                raise UndecidedError("a direction without moment is not told")
            if (first > 0) != (last > 0):
                found.append((settled(potential, ball), bool(curve < 0)))
            continue
        if ball.rad() < NARROWEST:
            raise UndecidedError("two directions without moment all but meet")
        parts += [(low, middle), (middle, high)]
    turns = [(angle + 2 * turn * arb.pi(), hill) for turn in (-2, -1, 0, 1) for angle, hill in found]
    return sorted(turns, key=lambda rest: float(rest[0].mid()))


def settled(potential: Potential, ball: arb) -> arb:
    """The one zero of V′ in a ball, by Newton's method of intervals."""
    for _ in range(200):
        middle = ball.mid()
        closer = (middle - potential.slope(middle) / potential.curve(ball)).intersection(ball)
        if not closer.rad() < 0.9 * ball.rad():
            return closer
        ball = closer
    return ball


def well_between(potential: Potential, all_rests: list[tuple[arb, bool]], heights: Callable[[arb], bool]) -> Well:
    """The well about the clamp between the nearest hills of some heights."""
    hills = [angle for angle, hill in all_rests if hill and heights(potential.value(angle))]
    low = max((angle for angle in hills if angle < 0), key=float)
    high = min((angle for angle in hills if angle > 0), key=float)
    inner = [angle for angle, hill in all_rests if not hill and low < angle < high]
    return Well(potential, (low, high), (inner[0], inner[-1]))


def swinging(start: arb, top: arb) -> Path:
    """Motions from the clamp's V to a hill's, of either sense: E = top − rise/cosh²y, κ = √(2 rise) tanh y."""
    rise = top - start
    most = (2 * rise).sqrt()

    def at(low: float, high: float) -> tuple[Any, Any]:
        tangent = arb(low).tanh().union(arb(high).tanh())
        square = (arb(low).sech() ** 2).union(arb(high).sech() ** 2)
        square = square.union(arb(1)) if low < 0 < high else square
        below = rise * square
        energy = [top - below, 2 * tangent * below, (square - 2 * tangent * tangent) * below]
        return arb_series(energy, ORDER), arb_series([most * tangent, most * square, -most * tangent * square], ORDER)

    return Path(at, True, True)


def passing(start: arb, ridge: arb, top: arb, *, up: bool) -> Path:
    """Motions of one sense between the heights of two hills: E = ridge + rise/(1 + e^(−y))."""
    rise = top - ridge

    def at(low: float, high: float) -> tuple[Any, Any]:
        share = logistic(low).union(logistic(high))
        rest = logistic(-low).union(logistic(-high))
        rate = rise * share * rest
        energy = arb_series([ridge + rise * share, rate, rate * (rest - share) / 2], ORDER)
        return energy, (2 * (energy - start)).sqrt()

    return Path(at, False, up)


def logistic(place: float) -> arb:
    """1/(1 + e^(−y))."""
    return 1 / (1 + (-arb(place)).exp())


def lines(potential: Potential, length: arb, *, level: bool) -> list[Line]:
    """All families of a rod whose clamp is no direction without moment, or a ridge. level: all hills are as high."""
    around, start = rests(potential), potential.value(arb(0))
    heights = [potential.value(angle) for angle, hill in around if hill]
    top = max(heights, key=float)
    if level or 2 * len(heights) == len(around) == 8:  # one hill and one well in a turn
        well = well_between(potential, around, lambda height: True)
        return [Line(well, swinging(start, top), *within(well, start, top, length))]
    ridge = min(heights, key=float)
    if not ridge < top:
        raise UndecidedError("which hill is higher is not told")
    high = well_between(potential, around, lambda height: not height < top)
    at_ridge = potential.slope(arb(0)) == 0
    if start > ridge and not at_ridge:
        return [Line(high, swinging(start, top), *within(high, start, top, length))]
    found = []
    for up in (False, True):
        path = passing(start, ridge, top, up=up)
        found.append(Line(high, path, *above(high, path, start, ridge, top, around, length)))
    if not at_ridge:
        if not start < ridge:
            raise UndecidedError("whether the clamp is above the ridge is not told")
        well = well_between(potential, around, lambda height: True)
        found.append(Line(well, swinging(start, ridge), *within(well, start, ridge, length)))
    return found


def first_place(quiet: Callable[[float], bool], length: arb) -> float:
    """The first of even places from which on, as far as one is asked about, all is quiet."""
    for step in range(FAR + int(FAR * float(length.mid()))):
        if quiet(STEP * (step + 1)):
            return STEP * (step + 1)
    raise UndecidedError("a motion beside a hill is not told")


def within(well: Well, start: arb, top: arb, length: arb) -> tuple[float, float]:
    """Between which places the motions in a well can be of a length."""
    rise, hills = top - start, well.hills
    near = [not well.potential.value(hill) > top for hill in hills]  # as high as the motion gets

    def quiet(place: float, side: int) -> bool:
        below = rise * arb(place).sech() ** 2
        if near[side]:
            return bool(stays(well.potential, hills[side], abs(hills[side]), below) > length)
        if not stays(well.potential, hills[1 - side], abs(hills[1 - side]), below) > length:
            return False
        return told(well, (top - below).union(top), start, length, side, near)

    return tuple(sign * first_place(lambda place: quiet(place, side), length) for side, sign in enumerate((-1, 1)))


def above(
    well: Well, path: Path, start: arb, ridge: arb, top: arb, around: list[tuple[arb, bool]], length: arb
) -> tuple[float, float]:
    """The same for motions that pass the ridge, of one sense."""
    side, potential = int(path.up), well.potential
    (place,) = (angle for angle, hill in around if hill and well.hills[0] < angle < well.hills[1])
    room = max((abs(angle - place) for angle in (arb(0), *well.wells)), key=float)

    def quiet_below(far: float) -> bool:
        over = (top - ridge) * logistic(-far)
        if not crosses(potential, place, room, over) > length:
            return False
        ahead = place > 0 if path.up else place < 0
        behind = place < 0 if path.up else place > 0
        return bool(ahead or not behind) or told(well, ridge.union(ridge + over), start, length, side, [False, False])

    def quiet_above(far: float) -> bool:
        hill = well.hills[side]
        return bool(stays(potential, hill, abs(hill), (top - ridge) * logistic(-far)) > length)

    return -first_place(quiet_below, length), first_place(quiet_above, length)


def stays(potential: Potential, hill: arb, room: arb, below: arb) -> arb:
    """How long at least a motion to or from a hill that turns so far below it is beside it, on that side; more for less.

    With μ² ≤ −V″ ≤ λ² up to an offset X, it turns before √(2·below)/μ, and is no faster than √(λ²x² − 2·below).
    """
    best, inward = arb(0), -1 if hill > 0 else 1
    for share in SHARES:
        offset = share * room
        bends = -potential.curve(hill.union(hill + inward * offset))
        least, most = bends.lower(), bends.upper()
        if least > 0 and most * offset * offset > 2 * below:
            rate = most.sqrt()
            time = ((rate * offset / (2 * below).sqrt()).acosh() - (rate / least.sqrt()).acosh()) / rate
            best = max(best, time.lower())
    return best


def crosses(potential: Potential, ridge: arb, room: arb, over: arb) -> arb:
    """How long at least a motion is over the room beside a ridge that it passes so far above; more for less.

    It is no faster than √(2·over + λ²x²).
    """
    best = arb(0)
    for share in SHARES:
        offset = share * room
        bends = [-potential.curve(ridge.union(ridge + sign * offset)) for sign in (-1, 1)]
        rate = max(max(bend.upper() for bend in bends), arb(1e-6)).sqrt()
        best = max(best, ((rate * offset / (2 * over).sqrt()).asinh() / rate).lower())
    return best


def told(well: Well, energies: arb, start: arb, length: arb, side: int, near: list[bool]) -> bool:
    """Whether, at all energies of a ball, the turning point ahead is reached before a length, or at all of them after."""
    balls = []
    for other in (0, 1):
        ends = [energies.lower()] if near[other] else [energies.lower(), energies.upper()]
        turns = [well.found(energy, other) for energy in ends] + ([well.hills[other]] if near[other] else [])
        balls.append(turns[0].union(turns[1]))
    potential = well.potential
    slopes = [sign * potential.slope(ball) for sign, ball in zip((-1, 1), balls, strict=True)]
    try:
        parts = ratios(forms(potential, [arb_series([ball], ORDER) for ball in (*balls, *slopes)]), side == 1)
        speed = arb_series([(2 * (energies - start)).sqrt()], ORDER)
        _, _, factor, pair, product = (first_order(part[0]) for part in quotients(parts, speed))
        arrival = (first_order(speed[0]) * factor / product.sqrt() * carlson(pair, product))[0]
    except UndecidedError:
        return False
    return bool(arrival < length or arrival > length)
