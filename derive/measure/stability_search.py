"""The worst input of a formula: at random first, then climbing in the exponents; once as called, once by itself."""

from __future__ import annotations

import random
from dataclasses import dataclass
from math import copysign, inf, isfinite, log10

from derive.measure.reference import Rod
from derive.measure.stability_formulas import Examined, Finding, examine
from derive.measure.stability_rods import Arguments, Genes, beside, drawn, heard_on

FREE = 600  # inputs of the search over arguments by themselves
WIDEST = 60.0  # powers of ten: squares of squares of arguments stay within doubles
NOTHING = Finding(0.0, 0.0, 0.0, ())


@dataclass(frozen=True)
class Found:
    """One formula: how many inputs were heard, the worst where the kernels call it and on which rod, and by itself."""

    heard: int
    called: Finding
    rod: Rod | None
    apart: Finding


class Boxes:
    """Signs and exponents of each argument that were heard."""

    def __init__(self, count: int) -> None:
        self.heard = 0
        self.low, self.high = [inf] * count, [-inf] * count
        self.signs: list[set[float]] = [set() for _ in range(count)]

    def enter(self, arguments: Arguments) -> None:
        """Widen the boxes."""
        self.heard += 1
        for k, value in enumerate(arguments):
            self.signs[k].add(copysign(1.0, value) if value else 0.0)
            if value and isfinite(value):
                place = max(-WIDEST, min(WIDEST, log10(abs(value))))
                self.low[k], self.high[k] = min(self.low[k], place), max(self.high[k], place)

    def draw(self, rng: random.Random) -> list[tuple[float, float]]:
        """A sign and an exponent for each argument."""
        return [
            (rng.choice(sorted(signs)), rng.uniform(low, high) if low <= high else 0.0)
            for signs, low, high in zip(self.signs, self.low, self.high, strict=True)
        ]

    def beside(self, at: list[tuple[float, float]], rng: random.Random, size: float) -> list[tuple[float, float]]:
        """One exponent moved, within its box."""
        k, moved = rng.randrange(len(at)), list(at)
        sign, place = at[k]
        if self.low[k] <= self.high[k]:
            moved[k] = sign, min(self.high[k], max(self.low[k], place + rng.gauss(0, size)))
        return moved


def searched(formula: Examined, seed: int, rods: int) -> Found:
    """Both searches; the same seed gives the same inputs."""
    rng, boxes = random.Random(f"{formula.name} {seed}"), Boxes(len(formula.arguments))
    called, rod = over_rods(formula, rng, rods, boxes)
    return Found(boxes.heard, called, rod, over_arguments(formula, rng, boxes) if boxes.heard else NOTHING)


def over_rods(formula: Examined, rng: random.Random, rods: int, boxes: Boxes) -> tuple[Finding, Rod | None]:
    """The worst where the kernels call it: half of the rods at random, the others beside the worst one so far."""
    best, where, at = NOTHING, None, drawn(rng)
    for k in range(rods):
        climbing = k >= rods // 2 and where is not None
        genes = beside(at, rng, narrowing(k, rods)) if climbing else drawn(rng)
        found = worst_on(formula, genes, boxes)
        if found.excess > best.excess:
            best, at, where = found, genes, genes.rod()
    return best, where


def narrowing(k: int, count: int) -> float:
    """The width of a step in exponents, from 4 at half of the way to 1/16 at its end."""
    return float(2.0 ** (2 - 6 * (2 * k / count - 1)))


def worst_on(formula: Examined, genes: Genes, boxes: Boxes) -> Finding:
    """The worst on one rod."""
    worst = NOTHING
    for arguments in heard_on(genes.rod(), formula.name):
        boxes.enter(arguments)
        found = examine(formula, arguments, worst.excess)
        if found is not None and found.excess > worst.excess:
            worst = found
    return worst


def over_arguments(formula: Examined, rng: random.Random, boxes: Boxes) -> Finding:
    """The worst of arguments that nothing ties together."""
    best, at = NOTHING, boxes.draw(rng)
    for k in range(FREE):
        climbing = k >= FREE // 2 and best.excess > 0
        trial = boxes.beside(at, rng, narrowing(k, FREE)) if climbing else boxes.draw(rng)
        arguments = tuple(sign * 10**place for sign, place in trial)
        found = examine(formula, arguments, best.excess)
        if found is not None and isfinite(found.excess) and found.excess > best.excess:
            best, at = found, trial
    return best
