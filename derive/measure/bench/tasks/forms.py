"""V: two quantities of the theory that have several forms: f(ξ) along a rod, and a gap between half-period values.

References are the same expressions at many digits: all forms are equal there, and what is told is what doubles lose.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
from mpmath import mp, mpf

from derive.measure.bench import judged
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.reference import DIGITS
from derive.measure.rods import PAPER

TITLE = "forms of one formula"
NOTE = "All forms are equal in exact arithmetic; what is told is what doubles lose."
POINTS, QUICK_POINTS = 10_000, 100
SAMPLE = 40
TIP, CLAMP = 0.67, -0.7  # cos θ, as far as the article's rod goes
NEAREST = 1e-14  # to a root: the drop from ξ(ℓ) to ξ, and 1 − ξ(ℓ)


def problems(plan: Plan) -> Iterator[Problem]:
    """Inputs are β, η, and arrays: ξ(ℓ) and ξ, or 1 − ξ(ℓ)."""
    number = QUICK_POINTS if plan.quick else POINTS
    sample = list(range(0, number, number // SAMPLE))
    beta, eta = PAPER.beta, PAPER.eta
    xi = TIP - np.geomspace(NEAREST, TIP - CLAMP, number)
    with mp.workdps(DIGITS):
        values = [quartic(mpf(beta), mpf(eta), mpf(TIP), mpf(xi[k])) for k in sample]
    judge = partial(at_some, sample, values)
    yield Problem("V-quartic", "V", "f(ξ) from a tip to the clamp", "point", number, (beta, eta, TIP, xi), judge)
    minus = np.geomspace(NEAREST, 0.5, number)
    with mp.workdps(DIGITS):
        gaps = [mpf(minus[k]) / 4 * abs(eta * mpf(minus[k]) - 2 * mpf(beta)) for k in sample]
    judge = partial(at_some, sample, gaps)
    title = "the gap of ℘'s values that closes as a rod becomes straight"
    yield Problem("V-gap", "V", title, "point", number, (beta, eta, minus), judge)


def quartic(beta: Any, eta: Any, tip: Any, xi: Any) -> Any:
    """f(ξ) = (1 − ξ²)(γ − 2βξ − ηξ²), which vanishes at the tip."""
    return (1 - xi * xi) * (eta * tip**2 + 2 * beta * tip - 2 * beta * xi - eta * xi**2)


def at_some(sample: list[int], wanted: list[Any], found: Any) -> judged.Errors:
    """Errors at some of the points."""
    return judged.of_values([found[k] for k in sample], wanted, DIGITS)
