"""Rods of any length to 40 digits, from an approximate shape: Newton's method on shooting along the first integral.

How that loses no digits is in `chains`. Of θ(0) as a function of ln E (or of the tip's δ) the derivative comes with the
shot, so a step costs one integration: a second at 24 digits for ℓ√(β + η) = 1000, some seconds at 40.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import ceil, log10
from typing import Any

from mpmath import mp, mpf

from derive.measure.chains import Chain, Guess, Node, Shot
from derive.measure.reference import (
    DIGITS,
    FRACTIONS,
    MOST_ROUNDS,
    NoEquilibriumError,
    Reference,
    Rod,
    along,
    couple_of,
)

GUARD_DIGITS = 10
FIRST_DIGITS = 24
# From here on a Newton step is the power SUPERLINEAR of the one before, or less (2 but for its factor).
CLOSE = 1e-9
SUPERLINEAR = 1.4
# Relative change of an input for its derivatives, in the digits of FIRST_DIGITS.
NUDGE = 1e-12
MOST_EXTRA = 24


@dataclass(frozen=True)
class Refined:
    """One equilibrium to 40 digits, of a rod of any length.

    rest, offset: the tip angle is rest + offset, where rest is the direction of rest nearest to the tip (the clamp
    angle where ℓ√(β + η) ≤ 1), and offset is good to 40 digits of its own size. fold: ∂θ(0)/∂θ(ℓ), 0 at a fold.
    residual: by how much the pieces miss the first integral, over the size of the state there. steps: those of
    Newton's method. arc, theta, curvature, y, z: at all nodes, from the clamp.
    """

    reference: Reference
    rest: Any
    offset: Any
    fold: Any
    residual: float
    steps: tuple[float, ...]
    arc: tuple[Any, ...]
    theta: tuple[Any, ...]
    curvature: tuple[Any, ...]
    y: tuple[Any, ...]
    z: tuple[Any, ...]


def refine(rod: Rod, guess: Guess, digits: int = DIGITS) -> Refined:
    """The equilibrium near an approximate shape. Raises NoEquilibriumError where Newton's method does not settle."""
    with mp.workdps(digits + GUARD_DIGITS + ceil(log10(2 + rod.length * (rod.beta + rod.eta) ** 0.5))):
        chain, sizes = Chain.of(rod, guess), []
        for carried, goal in ((FIRST_DIGITS, CLOSE), (mp.dps, 10.0 ** -(digits + 2))):
            for round_ in range(MOST_ROUNDS):
                shot = chain.shoot(carried, 9 * (round_ % 2))
                step, size = chain.step(shot)
                sizes.append(size)
                if size < goal and carried > FIRST_DIGITS:
                    break
                chain = chain.moved(step)
                if size < goal:
                    break
            else:
                raise NoEquilibriumError(f"Newton's method does not settle (last step {size:.1e}) for {rod}")
        check(rod, sizes, shot.correction, digits)
        return result(chain, shot, sizes)


def check(rod: Rod, sizes: Sequence[float], residual: float, digits: int) -> None:
    """Convergence was fast enough to be Newton's, and the pieces keep to the first integral."""
    if sizes[-1] > max(sizes[-2] ** SUPERLINEAR, 10.0 ** -(digits + 2)):
        raise ArithmeticError(f"Newton's steps {', '.join(f'{size:.1e}' for size in sizes)} are too slow for {rod}")
    if residual > 10.0**-digits:
        raise ArithmeticError(f"pieces miss the first integral by {residual:.1e} for {rod}")


def result(chain: Chain, shot: Shot, sizes: Sequence[float]) -> Refined:
    """All that is known of the equilibrium."""
    tip = shot.nodes[0]
    fold = shot.slope if chain.direct else -shot.slope * chain.moment(tip)
    drawn = profile(chain, shot)
    reference = Reference(chain.rod, shot.index, quantities(chain.rod, drawn), sensitivities(chain, shot, fold))
    arc, theta, curvature, y, z, _ = (tuple(column) for column in zip(*drawn, strict=True))
    rest = +chain.rests[tip.base].angle
    return Refined(reference, rest, tip.delta, fold, shot.correction, tuple(sizes), arc, theta, curvature, y, z)


def profile(chain: Chain, shot: Shot) -> list[tuple[Any, ...]]:
    """s, θ, θ′, y, z and the energy from the clamp to there, at all nodes from the clamp."""
    scale, step = chain.load.scale, mpf(chain.rod.length) / chain.count
    rows, y, z, energy = [], mpf(0), mpf(0), mpf(0)
    for j, node in enumerate(reversed(shot.nodes)):
        if j:
            part = shot.places[chain.count - j]
            y, z, energy = y + part[0] / scale, z + part[1] / scale, energy + part[2] * scale
        theta = chain.rests[node.base].angle + node.delta
        rows.append((j * step, theta, -node.rate * scale, y, z, energy))
    return rows


def quantities(rod: Rod, drawn: Sequence[tuple[Any, ...]]) -> dict[str, Any]:
    """By name, as `reference.quantities` has them."""
    beta, eta, field_angle = mpf(rod.beta), mpf(rod.eta), mpf(rod.field_angle)
    _, clamp, curvature, *_ = drawn[0]
    _, tip, _, y, z, energy = drawn[-1]
    gamma = curvature**2 + 2 * beta * mp.cos(clamp) + eta * mp.cos(clamp - field_angle) ** 2
    values = {"tip_angle": tip, "clamp_curvature": curvature, "gamma": gamma, "y": y, "z": z, "energy": energy}
    for fraction in FRACTIONS:
        _, theta, curvature, y, z, _ = drawn[int(fraction * (len(drawn) - 1))]
        values |= {f"theta({fraction}ℓ)": theta, f"curvature({fraction}ℓ)": curvature}
        values |= {f"y({fraction}ℓ)": y, f"z({fraction}ℓ)": z}
    return values


def sensitivities(chain: Chain, shot: Shot, fold: Any) -> dict[str, float]:
    """Σ|p ∂quantity/∂p| over the inputs, by differences at a fixed unknown, which then follows so that θ(0) is kept.

    At fixed s/ℓ the length does what β and η do together: ℓ∂_ℓ = 2(β∂_β + η∂_η) for angles; lengths are scaled besides.
    The arc length s of a point is an input by itself, so what it does is taken off again, and counted apart.
    """
    extra = height_digits(chain, shot.nodes)
    # A rod that is next to straight moves as little as its tip or θ(0) does, and must show it.
    move = float(abs(chain.unknown if chain.direct else shot.slope * chain.unknown))
    little = ceil(min(MOST_EXTRA, max(0.0, -log10(move or 1e-300))))
    nudge, digits = mpf(NUDGE) * mpf(10) ** -extra, FIRST_DIGITS + extra + little
    base = responses(chain, digits)
    push = nudge * abs(chain.unknown or 1 / max(1, abs(fold))) if chain.direct else nudge
    freely = responses(chain.moved(push), digits)
    by_unknown = {name: (freely[name] - base[name]) / push for name in base}
    parts: dict[str, dict[str, Any]] = {}
    for name in ("beta", "eta", "field_angle"):
        value = mpf(getattr(chain.rod, name))
        moved: Rod = replace(chain.rod, **{name: value * (1 + nudge)})
        try:
            there = responses(chain.loaded(moved), digits) if value else base
        except NoEquilibriumError:  # the least change of the input takes it away
            return dict.fromkeys((key for key in base if key != "clamp"), float("inf"))
        parts[name] = {key: (there[key] - base[key]) / nudge for key in base}
    units = {"y": 1, "z": 1, "clamp_curvature": -1, "curvature": -1, "energy": -1, "gamma": -2}
    parts["s"] = along(base, chain.rod.length, couple_of(chain.rod))
    parts["length"] = {
        key: 2 * (parts["beta"][key] + parts["eta"][key]) + units.get(key.split("(")[0], 0) * base[key] - own
        for key, own in parts["s"].items()
    }
    parts["clamp_angle"] = dict.fromkeys(base, mpf(0)) | {"clamp": -mpf(chain.rod.clamp_angle)}
    totals = dict.fromkeys(base, mpf(0))
    for part in parts.values():
        follow = -part["clamp"] / by_unknown["clamp"] if by_unknown["clamp"] else mpf(0)
        for key in totals:
            totals[key] += abs(part[key] + follow * by_unknown[key])
    return {key: float(total) for key, total in totals.items() if key != "clamp"}


def height_digits(chain: Chain, nodes: Sequence[Node]) -> int:
    """Digits to add where the rod lingers at directions whose heights move apart with the field's angle.

    E over the others then moves by the nudge itself, which must stay small beside E. Beyond MOST_EXTRA digits the
    condition number is greater than what any arithmetic in doubles could bear, and comes out merely as large.
    """
    if chain.direct or not chain.rod.field_angle:
        return 0
    level = chain.rests[chain.level].angle
    turns = {base: (chain.rests[base].angle - level) / (2 * mp.pi) for base in {node.base for node in nodes}}
    others = [abs(chain.energy(base)) for base, turn in turns.items() if abs(turn - mp.nint(turn)) > 1e-6]
    least = min([*others, mpf(1)])
    return int(min(MOST_EXTRA, max(0, ceil(-log10(float(least) or 1e-300)))))


def responses(chain: Chain, digits: int) -> dict[str, Any]:
    """All quantities and θ(0), of a chain as it stands, with few digits."""
    drawn = profile(chain, chain.shoot(digits))
    return {**quantities(chain.rod, drawn), "clamp": drawn[0][1]}
