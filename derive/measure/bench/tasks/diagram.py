"""T4: the diagram of the article's second example, all equilibria for 8 forces × 1,000 fields.

Methods that go rod by rod get some of the rods, and their times are scaled to the whole.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from derive.measure.bench import judged, known
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.tasks import SEED
from derive.measure.reference import DIGITS, Rod
from derive.measure.rods import PAPER

TITLE = "the article's second diagram"
NOTE = "All equilibria of each rod; what goes rod by rod does a few rods from nine guesses, and its time is scaled."
BETAS = (0.0, 1e-4, 2e-4, 2.5e-4, 3e-4, 3.5e-4, 4e-4, 5e-4)
ETAS = np.arange(1, 1001) * 1e-6
EACH = 3  # rods of each β have references


@dataclass(frozen=True)
class Diagram:
    """β and η of all rods, and the numbers of those that have references."""

    beta: Any
    eta: Any
    sample: Sequence[int]

    def rod(self, number: int) -> Rod:
        """One of its rods."""
        return replace(PAPER, beta=float(self.beta[number]), eta=float(self.eta[number]))

    @property
    def rods(self) -> list[Rod]:
        """Those that have references."""
        return [self.rod(number) for number in self.sample]


def problems(plan: Plan) -> Iterator[Problem]:
    """The whole diagram, or a thin one."""
    etas = ETAS[49::50] if plan.quick else ETAS
    beta, eta = (part.ravel() for part in np.meshgrid(BETAS, etas, indexing="ij"))
    rng = np.random.default_rng(SEED)
    each = [k * len(etas) + np.sort(rng.choice(len(etas), EACH, replace=False)) for k in range(len(BETAS))]
    sample = np.concatenate(each)[:: 6 if plan.quick else 1].tolist()
    given = Diagram(beta, eta, sample)
    wanted = [known.equilibria(plan.cache, rod, DIGITS) for rod in given.rods]
    judge = partial(judged.of_equilibria, rods=given.rods, wanted=wanted, digits=DIGITS)
    title = f"{TITLE}, {len(BETAS)} × {len(etas):,} rods"
    yield Problem("T4", "T4", title, "diagram", 1, given, judge, brief=True)
