"""Beyond which places of a line of motions none is an equilibrium."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, arb_series

from derive.measure.verified.means import UndecidedError, carlson, first_order
from derive.measure.verified.motion import ORDER, forms, quotients, ratios
from derive.measure.verified.potential import Potential, Rest
from derive.measure.verified.wells import Path, Well

# Of the room beside a hill: shares in which a motion's time there is bounded.
SHARES = (0.9, 0.5, 0.2, 0.05, 1e-2, 1e-3, 1e-4, 1e-5)
STEP = 0.5  # of the place, by which an end is looked for
LEAST = 1e-6  # place
FAR = 400  # steps, and as many for each unit of length


def first_place(quiet: Callable[[float], bool], length: arb) -> float:
    """The first of even places from which on, as far as one is asked about, all is quiet."""
    for step in range(FAR + int(FAR * float(length.mid()))):
        if quiet(STEP * (step + 1)):
            return STEP * (step + 1)
    raise UndecidedError("a motion beside a hill is not told")


def logistic(place: float) -> arb:
    """1/(1 + e^(−y))."""
    return 1 / (1 + (-arb(place)).exp())


def first_below(well: Well, start: arb, top: arb, length: arb) -> float:
    """A place up to which no motion about a well at the clamp itself, about which V is even, is of the length.

    The arrival is half a half-swing H, and π/√M ≤ H ≤ π/√m if m ≤ V″ ≤ M over the motion (Sturm).
    """
    place = STEP
    while place > LEAST:
        turn = well.found(top - (top - start) * arb(place).sech() ** 2, 1)
        bend = well.potential.curve(turn.union(-turn))
        if bend > 0 and not (length * bend.sqrt() / arb.pi() - arb(1) / 2).contains_integer():
            return place
        place /= 2
    raise UndecidedError("a straight rod all but buckles")


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

    low, high = (first_place(lambda place, side=side: quiet(place, side), length) for side in (0, 1))  # type: ignore[misc]
    return -low, high


def above(
    well: Well, path: Path, start: arb, heights: tuple[arb, arb], around: list[Rest], length: arb
) -> tuple[float, float]:
    """The same for motions that pass the ridge, of one sense. heights: of the ridge and of the hills."""
    side, potential, (ridge, top) = int(path.up), well.potential, heights
    (place,) = (rest.angle for rest in around if rest.hill and well.hills[0] < rest.angle < well.hills[1])
    ahead = not (place < 0 if path.up else place > 0)  # or the clamp itself is the ridge
    passed = (arb(0), well.wells[side]) if ahead else well.wells
    room = max((abs(angle - place) for angle in passed), key=float)

    def quiet_below(far: float) -> bool:
        over = (top - ridge) * logistic(-far)
        if not crosses(potential, place, room, over) > length:
            return False
        return ahead or told(well, ridge.union(ridge + over), start, length, side, [False, False])

    def quiet_above(far: float) -> bool:
        hill = well.hills[side]
        return bool(stays(potential, hill, abs(hill), (top - ridge) * logistic(-far)) > length)

    return -first_place(quiet_below, length), first_place(quiet_above, length)


def stays(potential: Potential, hill: arb, room: arb, below: arb) -> arb:
    """How long at least a motion that turns so far below a hill stays beside it, on one side; longer for less.

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
    """Whether the turning point ahead is reached before a length at all energies of a ball, or at all of them after."""
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
        factor, pair, product = (first_order(part[0]) for part in quotients(parts, speed))
        arrival = (first_order(speed[0]) * factor / product.sqrt() * carlson(pair, product))[0]
    except UndecidedError:
        return False
    return bool(arrival < length or arrival > length)
