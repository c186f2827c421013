"""T1: one equilibrium with the place of its tip. Methods other than ours are given its tip angle to one decimal."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from derive.measure.bench import judged, known
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.tasks import MOST_DIGITS
from derive.measure.reference import DIGITS
from derive.measure.rods import rods

TITLE = "one equilibrium with its tip"
NOTE = (
    "Ours finds all stable equilibria without a guess; the others start from the tip angle to one decimal. Rods at "
    "once: a thousand around each rod, with loads that differ by a tenth at most; its own answer is judged, and the "
    "time is that of one of the thousand. solve_bvp, solve_ivp and the minimisers take one rod at a time."
)
RODS = (0, 2, 3, 4, 5)  # of the moderate ones: ℓ√(β+η) from 2.4 to 6, each with a stable equilibrium that is bent


def problems(plan: Plan) -> Iterator[Problem]:
    """The first stable equilibrium of a few rods."""
    digits = DIGITS if plan.quick else MOST_DIGITS
    chosen = [rods("parallel")[k] for k in (RODS[:3] if plan.quick else RODS)]
    rows = [known.equilibria(plan.cache, rod, digits, stable=True) for rod in chosen]
    inputs = [(rod, round(float(row[0][0]), 1)) for rod, row in zip(chosen, rows, strict=True)]
    judge = partial(judged.of_equilibria, rods=chosen, wanted=rows, digits=digits)
    yield Problem("T1", "T1", TITLE, "rod", len(chosen), inputs, judge)
