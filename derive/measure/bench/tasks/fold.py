"""T6: the fold of the article's second diagram, for three forces. Inputs are rods, with η and tip angle to two digits.

What is judged is η: at a fold a tip angle is known to half the digits only, whatever finds it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from derive.measure.bench import judged, known
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.reference import DIGITS
from derive.measure.rods import PAPER

TITLE = "a fold"
NOTE = "Ours is given a range of η and finds all folds in it; the others start from the fold itself, to two digits."
BETAS = (3.5e-4, 3e-4, 2.5e-4)
RANGE = (1e-4, 1.2e-3)  # of η


def problems(plan: Plan) -> Iterator[Problem]:
    """One fold for each force."""
    chosen = [replace(PAPER, beta=beta) for beta in BETAS[: 1 if plan.quick else None]]
    wanted = [known.fold(plan.cache, rod, *RANGE, DIGITS) for rod in chosen]
    guesses = [(float(f"{float(eta):.1e}"), round(float(tip), 1)) for eta, tip in wanted]
    judge = partial(judged.of_folds, wanted=wanted, digits=DIGITS)
    yield Problem("T6", "T6", TITLE, "fold", len(chosen), list(zip(chosen, guesses, strict=True)), judge)
