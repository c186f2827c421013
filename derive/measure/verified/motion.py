"""The motions through a clamp angle: half-swing and arrival, enclosed with their derivatives.

Seen along the rod, θ moves in the `potential` V of two harmonics, angles measured from the clamp, at the energy
E = ½θ′² + V, between two turning points. With u and w the sines of half the distances from the lower and to the upper
one, and D half the width of the swing, θ′² = 4uw(Aw² + Buw + Cu²)/sin²D: then s = w/u has ds/√(s(C + Bs + As²)) = dσ.
A and C are |V′| over sin D at the two, and B = −2v₁ cos D − 4v₂(1 + cos²D), v₁ and v₂ the harmonics of V in the middle.
Half a swing is π over the mean of √√(AC) and ½√(B + 2√(AC)); the way from θ′ = κ at the clamp to the upper one takes
κ sin D/(u²C√(YZ)) R_F(1, Y, Z), Y + Z = 2 + Bs/C and YZ = 1 + Bs/C + As²/C.
"""

from __future__ import annotations

from flint import arb, arb_series

from derive.measure.verified.means import Series, UndecidedError, carlson, first_order, gauss_mean, positive
from derive.measure.verified.potential import Potential
from derive.measure.verified.wells import Path, Well

ORDER = 3  # Taylor coefficients of what the times are made of


def times(well: Well, path: Path, low: float, high: float) -> tuple[Series, Series]:
    """Arrival and half-swing for all places between two, with their derivatives."""
    middle = (low + high) / 2
    aside = arb(low).union(arb(high)) - middle
    here, there = path.at(low, high), path.at(middle, middle)
    balls, points = turnings(well, path, low, high)
    centres = [point.mid() for point in points]
    wide, thin = ends(well, here[0], balls, centres), ends(well, there[0], points, centres)
    wide, speed = sharper(wide, thin, aside), sharper([here[1]], [there[1]], aside)[0]
    wide, thin = forms(well.potential, wide), forms(well.potential, thin)
    wide = sharper(wide, thin, aside)
    swung, swung_thin = halves(wide), halves(thin)
    swung = sharper(swung, swung_thin, aside)
    wide, thin = ratios(wide, path.up), ratios(thin, path.up)
    wide = sharper(wide, thin, aside)
    wide, thin = quotients(wide, speed), quotients(thin, there[1])
    wide = sharper(wide, thin, aside)
    arrival, swing = both([*swung, *wide], speed)
    if low == high:
        return arrival, swing
    return tuple(
        first_order((point[0] + ball[1] * aside).intersection(ball[0]), ball[1])
        for ball, point in zip((arrival, swing), both([*swung_thin, *thin], there[1]), strict=True)
    )


def turnings(well: Well, path: Path, low: float, high: float) -> tuple[list[arb], list[arb]]:
    """Both turning points for all places between two, which are monotone in the energy, and in the middle."""
    balls, points = [], []
    for side in (0, 1):
        places = (low, high, (low + high) / 2, 0.0) if path.turns and low < 0 < high else (low, high, (low + high) / 2)
        ball, *others = (well.turning(path, place, side) for place in places)
        points.append(others[1])
        for other in others:
            ball = ball.union(other)
        balls.append(ball)
    return balls, points


def sharper(wide: list[Series], thin: list[Series], aside: arb) -> list[Series]:
    """Values and derivatives over a ball by those in its middle and the derivatives over it."""
    found = []
    for ball, point in zip(wide, thin, strict=True):
        slope = (point[1] + 2 * ball[2] * aside).intersection(ball[1])
        found.append(arb_series([(point[0] + slope * aside).intersection(ball[0]), slope, ball[2]], ORDER))
    return found


def ends(well: Well, energy: Series, balls: list[arb], centres: list[arb]) -> list[Series]:
    """The turning points, and |V′| there."""
    places, slopes, potential = [], [], well.potential
    for sign, ball, centre in zip((-1, 1), balls, centres, strict=True):
        curve = potential.curve(ball)
        slope = potential.slope(centre) + curve * (ball - centre)
        if not sign * slope > 0:
            raise UndecidedError("a motion all but rests where it turns")
        rate = energy[1] / slope
        place = arb_series([ball, rate, (energy[2] - curve * rate * rate / 2) / slope], ORDER)
        along = potential.slope(place)
        places.append(place)
        slopes.append(sign * arb_series([slope, along[1], along[2]], ORDER))
    return [*places, *slopes]


def forms(potential: Potential, parts: list[Series]) -> list[Series]:
    """A, B, C, sin D, u and w of the clamp, and AC.

    |V′| over sin D is (A + C)/2 ± v₂′ sin D too, without a quotient, and (A + C)/2 M′ = v₂′ sin D D′, for V is the same
    at both turning points. These tell more of a motion of all but a turn.
    """
    low, high, first, last = parts
    half, middle = (high - low) / 2, (high + low) / 2
    sine, cosine = half.sin_cos()
    positive(sine)
    mean, lean = _ends(potential, middle, cosine)
    positive(mean)
    rate = lean * sine * half.derivative() / mean
    middle = met(middle, arb_series([middle[0], rate[0], rate[1] / 2], ORDER))
    mean, lean = _ends(potential, middle, cosine)
    one, two = potential.harmonics(middle)
    between = -2 * one * cosine - 4 * two * (1 + cosine * cosine)
    first, last = met(first / sine, mean + lean * sine), met(last / sine, mean - lean * sine)
    product = met(first * last, mean**2 - (lean * sine) ** 2)
    return [first, between, last, sine, (-low / 2).sin(), (high / 2).sin(), product]


def _ends(potential: Potential, middle: Series, cosine: Series) -> tuple[Series, Series]:
    """(A + C)/2, and v₂′ in the middle."""
    one, two = potential.harmonics(middle)
    return -one - 4 * two * cosine, 2 * potential.turned.harmonics(middle)[1]


def met(one: Series, other: Series) -> Series:
    """What two enclosures of the same have in common."""
    return arb_series([one[k].intersection(other[k]) for k in range(ORDER)], ORDER)


def halves(parts: list[Series]) -> list[Series]:
    """√(AC) and B + 2√(AC)."""
    *_, product = parts
    positive(product)
    return [product.sqrt(), parts[1] + 2 * product.sqrt()]


def ratios(parts: list[Series], up: bool) -> list[Series]:
    """The factor of R_F without κ/√(YZ), Bs/C, As²/C and s/C."""
    first, between, last, sine, behind, ahead, _ = parts
    if not up:
        first, last, behind, ahead = last, first, ahead, behind
    positive(last, behind)
    share = ahead / behind
    return [sine / behind / behind / last, between * share / last, first * share**2 / last, share / last]


def quotients(parts: list[Series], speed: Series) -> list[Series]:
    """The factor, Y + Z + 2√(YZ) and YZ, the last once more by κ² = 4uw(Aw² + Buw + Cu²)/sin²D."""
    factor, linear, square, share = parts
    product = 1 + linear + square
    if share[0] > 0:
        product = met(product, (factor * speed) ** 2 / (4 * share))
    positive(product)
    return [factor, 2 + linear + 2 * product.sqrt(), product]


def both(parts: list[Series], speed: Series) -> tuple[Series, Series]:
    """Arrival and half-swing."""
    root, gap, factor, pair, product = (first_order(part[0], part[1]) for part in parts)
    positive(root, gap, product)
    swing = first_order(arb.pi()) / gauss_mean(root.sqrt(), gap.sqrt() / 2)
    return first_order(speed[0], speed[1]) * factor / product.sqrt() * carlson(pair, product), swing
