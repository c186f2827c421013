"""T5: ℘, ζ and σ on the real axis, within two periods, no nearer to a pole than a hundredth of a half-period."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from mpmath import mp, mpf

from derive.emit.kernels.weierstrass import half_period_values, half_periods
from derive.measure.bench import judged, known
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.judged import Errors
from derive.measure.bench.tasks import MOST_DIGITS, SEED
from derive.measure.reference import DIGITS

TITLE = "on a real lattice"
NOTE = "On the real axis, within two periods; what goes point by point does some of the points."
FUNCTIONS = {"p": "℘", "zeta": "ζ", "sigma": "σ"}
INVARIANTS = (1.3, 0.1)  # g₂, g₃: half-periods 1.67 and 1.84i
POINTS, QUICK_POINTS = 1000, 48
SAMPLE = 24  # of the points have references


@dataclass(frozen=True)
class Lattice:
    """What methods may start from: g₂, g₃, e₁ > e₂ > e₃, and the half-periods ω₁, ω₃/i; ``exact`` as decimal text.

    kind: which function is wanted, at the points u; first: the numbers of the points that have references.
    """

    kind: str
    u: Any
    sample: Sequence[int]
    g2: float
    g3: float
    values: tuple[float, float, float]
    half_periods: tuple[float, float]
    exact: tuple[str, str]


def problems(plan: Plan) -> Iterator[Problem]:
    """One for each function."""
    number, digits = (QUICK_POINTS, DIGITS) if plan.quick else (POINTS, MOST_DIGITS)
    g2, g3 = INVARIANTS
    first, second = half_periods(g2, g3)
    e1, e2, e3 = (float(value) for value in half_period_values(g2, g3)[0])
    exact = exact_half_periods(g2, g3, digits + 10)
    u = np.random.default_rng(SEED).uniform(0.01, 1.99, number) * first
    u[1::2] += 2 * first
    sample = list(range(0, number, number // SAMPLE))[:SAMPLE]
    for kind, letter in FUNCTIONS.items():
        inputs = Lattice(kind, u, sample, g2, g3, (e1, e2, e3), (first, second), exact)
        wanted = known.function_values(plan.cache, kind, u[sample].tolist(), g2, g3, digits)
        judge = partial(judge_sample, sample, wanted, digits)
        title = f"{letter} {TITLE}, {number:,} points"
        yield Problem(f"T5-{kind}", "T5", title, "point", number, inputs, judge)


def exact_half_periods(g2: float, g3: float, digits: int) -> tuple[str, str]:
    """ω₁ and ω₃/i to many digits, by mpmath's own complete integral; what a peer is given, never a reference."""
    with mp.workdps(digits + 15):
        roots = sorted((mp.re(x) for x in mp.polyroots([4, 0, -mpf(g2), -mpf(g3)], maxsteps=500)), reverse=True)
        scale, m = mp.sqrt(roots[0] - roots[2]), (roots[1] - roots[2]) / (roots[0] - roots[2])
        return str(mp.ellipk(m) / scale), str(mp.ellipk(1 - m) / scale)


def judge_sample(sample: Sequence[int], wanted: Sequence[Any], digits: int, answers: Sequence[Any]) -> Errors:
    """Errors at the points that have references; answers are for all points, or for these alone."""
    some = answers if len(answers) == len(sample) else [answers[k] for k in sample]
    return judged.of_values(some, wanted, digits)
