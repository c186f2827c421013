"""The six tasks: what is asked, of which rods, and against which references the answers are judged.

A guess is what a user knows: the tip angle to one decimal, η at a fold to a tenth of it. Methods that need none are
given none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from derive.cache import Cache
from derive.measure.reference import DIGITS, Rod
from derive.measure.rods import PAPER, rods
from derive.measure.work import judged, known
from derive.measure.work.judged import Errors

TASKS = {
    "T1": "one equilibrium with its tip",
    "T2": "all equilibria",
    "T3": "a whole shape",
    "T4": "the article's second diagram",
    "T5": "Weierstrass's functions on a real lattice",
    "T6": "a fold",
}
# T1's references have more digits than the twin is asked for.
MOST_DIGITS = 210
SEED = 5
ONE_EACH = (0, 2, 3, 4, 5)  # rods of T1: short to ℓ√(β+η) = 5, each with a stable equilibrium that is no straight rod
SHAPE_POINTS = (100, 10_000, 1_000_000)
SHAPE_SAMPLE = 48
# The article's second example, and the field strengths over which it is drawn.
BETAS = (0.0, 1e-4, 2e-4, 2.5e-4, 3e-4, 3.5e-4, 4e-4, 5e-4)
ETAS = np.arange(1, 1001) * 1e-6
EVERY = 20  # of the field strengths: what methods are given that solve rod by rod
SAMPLE_EACH = 3  # rods of each β that have references, and that peers are given
LATTICE = (1.3, 0.1)  # g₂, g₃: half-periods 1.67 and 1.84i
POINTS = 1000
FOLD_BETAS = (2.5e-4, 3e-4, 3.5e-4)
FOLD_RANGE = (1e-4, 1.2e-3)


@dataclass(frozen=True)
class Problem:
    """What a method is given, and how its answers are judged. units: rods, points or folds; times are for each."""

    id: str
    task: str
    title: str
    unit: str
    units: int
    inputs: Any
    judge: Callable[[Any], Errors]


@dataclass(frozen=True)
class Diagram:
    """All rods of T4, those that methods get which go rod by rod, and those that have references, as numbers."""

    beta: Any
    eta: Any
    some: Sequence[int]
    sample: Sequence[int]

    def rod(self, number: int) -> Rod:
        """One of its rods."""
        return replace(PAPER, beta=float(self.beta[number]), eta=float(self.eta[number]))


@dataclass(frozen=True)
class Lattice:
    """T5: points, invariants, half-period values e₁ > e₂ > e₃ and half-periods ω₁, ω₃/i; ``exact`` as texts."""

    kind: str
    u: Sequence[float]
    g2: float
    g3: float
    values: tuple[float, float, float]
    half_periods: tuple[float, float]
    exact: tuple[str, str]


def problems(cache: Cache, only: Sequence[str], *, quick: bool) -> Iterator[Problem]:
    """The problems of some tasks, or of all; references are computed on the way if they are not kept."""
    makers: dict[str, Callable[[Cache, bool], Iterator[Problem]]] = {
        "T1": one_equilibrium,
        "T2": all_equilibria,
        "T3": whole_shapes,
        "T4": diagram,
        "T5": functions,
        "T6": fold,
    }
    for task, maker in makers.items():
        if not only or task in only:
            yield from maker(cache, quick)


def one_equilibrium(cache: Cache, quick: bool) -> Iterator[Problem]:
    """T1."""
    digits = DIGITS if quick else MOST_DIGITS
    chosen = [rods("parallel")[k] for k in (ONE_EACH[:3] if quick else ONE_EACH)]
    first = [known.equilibria(cache, rod, digits, stable=True) for rod in chosen]
    wanted = [{"length": rod.length, "equilibria": rows} for rod, rows in zip(chosen, first, strict=True)]
    inputs = [(rod, round(float(rows[0][0]), 1)) for rod, rows in zip(chosen, first, strict=True)]
    judge = partial(judged.of_equilibria, wanted=wanted, digits=digits)
    yield Problem("T1", "T1", TASKS["T1"], "rod", len(chosen), inputs, judge)


def all_equilibria(cache: Cache, quick: bool) -> Iterator[Problem]:
    """T2: the moderate rods on which every emitted module is run."""
    chosen = rods("parallel")[:5:2] if quick else rods("parallel")
    wanted = [{"length": rod.length, "equilibria": known.equilibria(cache, rod, DIGITS)} for rod in chosen]
    judge = partial(judged.of_equilibria, wanted=wanted, digits=DIGITS)
    yield Problem("T2", "T2", TASKS["T2"], "rod", len(chosen), chosen, judge)


def whole_shapes(cache: Cache, quick: bool) -> Iterator[Problem]:
    """T3: θ, y and z of the article's rod in its first stable equilibrium, solving included."""
    tip = known.equilibria(cache, PAPER, DIGITS, stable=True)[0][0]
    for number in SHAPE_POINTS[: 1 if quick else None]:
        s = np.linspace(0.0, PAPER.length, number)
        sample = np.sort(np.random.default_rng(SEED).choice(number, SHAPE_SAMPLE, replace=False))
        wanted = known.shape(cache, PAPER, tip, s[sample].tolist(), DIGITS)
        judge = partial(judged.of_shape, wanted=wanted, length=PAPER.length, digits=DIGITS)
        name = f"T3-1e{len(str(number)) - 1}"
        inputs = (PAPER, round(float(tip), 1), s, sample)
        yield Problem(name, "T3", f"{TASKS['T3']} at {number:,} points", "point", number, inputs, judge)


def diagram(cache: Cache, quick: bool) -> Iterator[Problem]:
    """T4: 8 values of β × 1,000 of η, all solutions."""
    beta, eta = (part.ravel() for part in np.meshgrid(BETAS, ETAS, indexing="ij"))
    rng = np.random.default_rng(SEED)
    each = [k * len(ETAS) + EVERY * rng.choice(len(ETAS) // EVERY, SAMPLE_EACH, replace=False) for k in range(8)]
    sample = [int(number) for part in each for number in np.sort(part)][:: 6 if quick else 1]
    given = Diagram(beta, eta, range(0, len(beta), EVERY), sample)
    chosen = [given.rod(number) for number in sample]
    wanted = [{"length": rod.length, "equilibria": known.equilibria(cache, rod, DIGITS)} for rod in chosen]
    judge = partial(judged.of_equilibria, wanted=wanted, digits=DIGITS)
    yield Problem("T4", "T4", TASKS["T4"], "rod", len(sample), given, judge)


def functions(cache: Cache, quick: bool) -> Iterator[Problem]:
    """T5: ℘, ζ and σ on the real axis, within two periods, no nearer to a pole than a hundredth of a half-period."""
    from derive.emit.kernels.weierstrass import half_period_values, half_periods

    number, digits = (40, DIGITS) if quick else (POINTS, MOST_DIGITS)
    g2, g3 = LATTICE
    first, second = half_periods(g2, g3)
    exact = exact_half_periods(g2, g3, digits + 10)
    u = np.random.default_rng(SEED).uniform(0.01, 1.99, number) * first
    u[1::2] += 2 * first
    sample = list(range(0, number, max(1, number // 24)))
    for kind, name in (("p", "℘"), ("zeta", "ζ"), ("sigma", "σ")):
        values = tuple(float(x) for x in half_period_values(g2, g3)[0])
        inputs = Lattice(kind, u.tolist(), g2, g3, values, (first, second), exact)  # type: ignore[arg-type]
        lazily = partial(known_functions, cache, kind, [u.tolist()[k] for k in sample], digits)
        judge = partial(judge_functions, lazily, sample, digits)
        yield Problem(
            f"T5-{kind}", "T5", f"{name} on a real lattice, {number:,} points", "point", number, inputs, judge
        )


def exact_half_periods(g2: float, g3: float, digits: int) -> tuple[str, str]:
    """ω₁ and ω₃/i to many digits, by mpmath's own complete integral; what a peer is given, never a reference."""
    from mpmath import mp, mpf

    with mp.workdps(digits + 15):
        roots = sorted((mp.re(x) for x in mp.polyroots([4, 0, -mpf(g2), -mpf(g3)], maxsteps=500)), reverse=True)
        scale, m = mp.sqrt(roots[0] - roots[2]), (roots[1] - roots[2]) / (roots[0] - roots[2])
        return str(mp.ellipk(m) / scale), str(mp.ellipk(1 - m) / scale)


def known_functions(cache: Cache, kind: str, u: list[float], digits: int) -> list[Any]:
    """References of T5 at some of the points."""

    def compute() -> list[str]:
        return [known.text(x, digits) for x in known.weierstrass(kind, u, *LATTICE, digits)]

    return list(known.numbers(known.kept(cache, "weierstrass", [kind, u, *LATTICE, digits], compute), digits))


def judge_functions(lazily: Callable[[], list[Any]], sample: list[int], digits: int, answers: Sequence[Any]) -> Errors:
    """Errors at the points that have references."""
    return judged.of_values([answers[k] for k in sample], lazily(), digits)


def fold(cache: Cache, quick: bool) -> Iterator[Problem]:
    """T6: the fold of the article's second diagram, for three forces."""
    chosen = [replace(PAPER, beta=beta) for beta in FOLD_BETAS[-1 if quick else 0 :]]
    wanted = [known.fold(cache, rod, *FOLD_RANGE, DIGITS) for rod in chosen]
    guesses = [(float(f"{float(eta):.1e}"), round(float(tip), 1)) for eta, tip in wanted]
    judge = partial(judged.of_folds, wanted=wanted, digits=DIGITS)
    inputs = list(zip(chosen, guesses, strict=True))
    yield Problem("T6", "T6", TASKS["T6"], "fold", len(chosen), inputs, judge)
