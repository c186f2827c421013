"""T3: the whole shape, θ, y and z, of the article's rod in its first stable equilibrium; solving is part of it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from derive.measure.bench import judged, known
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.tasks import SEED
from derive.measure.reference import DIGITS
from derive.measure.rods import PAPER

TITLE = "a whole shape"
NOTE = "Solving is part of the time; all but ours start from the tip angle to one decimal."
POINTS = (100, 1000, 10_000, 100_000, 1_000_000)
SAMPLE = 48  # of the points have references


def problems(plan: Plan) -> Iterator[Problem]:
    """One for each number of points; inputs are the rod, its tip angle to one decimal, s, and which points count."""
    tip = known.equilibria(plan.cache, PAPER, DIGITS, stable=True)[0][0]
    for number in POINTS[:1] if plan.quick else POINTS:
        s = np.linspace(0.0, PAPER.length, number)
        sample = np.sort(np.random.default_rng(SEED).choice(number, SAMPLE, replace=False))
        wanted = known.shape(plan.cache, PAPER, tip, s[sample].tolist(), DIGITS)
        judge = partial(judged.of_shape, wanted=wanted, length=PAPER.length, digits=DIGITS)
        name, inputs = f"T3-1e{len(str(number)) - 1}", (PAPER, round(float(tip), 1), s, sample)
        yield Problem(name, "T3", f"{TITLE} at {number:,} points", "shape", 1, inputs, judge)
