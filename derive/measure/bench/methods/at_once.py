"""One of many rods that are solved at once: what a rod costs who has a thousand of them.

Set up: T1 alone. Around each rod stand a thousand, with loads that differ by a tenth at most, the rod itself in their
midst; its answer is judged, and the time is that of one of the thousand. Ours is `sweep`, with no guesses, for stable
equilibria. Of the others, Chebyshev collocation has NumPy's `solve` for stacks of matrices, so that Newton's method
runs on all rods together, each from the guess that the rod itself gets. `solve_bvp`, `solve_ivp` and the minimisers
take one problem at a time: a thousand rods in one system would give `solve_bvp` blocks of 2,000 × 2,000 at every node,
and a mesh that must suit all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from derive.measure.bench.cells import OURS, PEER, Call, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.methods import chebyshev
from derive.measure.bench.methods.emitted import DOUBLES, generated
from derive.measure.bench.methods.rod_solver import Array, by_number, first_guess
from derive.measure.bench.tasks import SEED
from derive.measure.reference import Rod

MANY = 1000
AROUND = 0.1  # by which share at most their loads differ
NODES = (16, 24, 32, 48)

Answer = tuple[float, float, float]


def loads(rod: Rod) -> tuple[Array, Array]:
    """β and η of the thousand; in their midst is the rod itself."""
    factors = 1 + np.random.default_rng(SEED).uniform(-AROUND, AROUND, (2, MANY))
    factors[:, MANY // 2] = 1.0
    return rod.beta * factors[0], rod.eta * factors[1]


def sweeps(problem: Problem) -> Callable[[], Call]:
    """Ours."""
    sweep = generated("parallel_numpy").sweep

    def prepare() -> Call:
        given = [(*loads(rod), rod.length, rod.clamp_angle) for rod, _ in problem.inputs]
        return lambda: [sweep(*one, max_index=0) for one in given]

    return prepare


def meant(problem: Problem, found: Sequence[Any]) -> list[list[Answer]]:
    """Of each sweep the equilibrium of the rod itself."""
    picked = []
    for sweep, (_, tip) in zip(found, problem.inputs, strict=True):
        own = np.flatnonzero(np.asarray(sweep.case) == MANY // 2)
        best = min(own, key=lambda k: abs(sweep.tip_angle[k] - tip))
        picked.append([(sweep.tip_angle[best], sweep.y[best], sweep.z[best])])
    return picked


def stacked(beta: Array, eta: Array, rod: Rod, tip: float, n: int) -> Array:
    """Tip angles, y and z of all rods by collocation, in three rows; nan where Newton's method does not settle."""
    x, first, second, coefficients = chebyshev.matrices(n)
    share, inner = (rod.length / 2) ** 2, np.arange(1, n)
    theta = np.tile(first_guess(rod, tip, (x + 1) / 2), (len(beta), 1))
    jacobian = np.tile(second, (len(beta), 1, 1))
    jacobian[:, 0], jacobian[:, -1] = np.eye(n + 1)[0], first[-1]
    before = np.inf
    for _ in range(chebyshev.MOST_ROUNDS):
        force, field = beta[:, None], eta[:, None]
        residual = theta @ second.T - share * (force * np.sin(theta) + field / 2 * np.sin(2 * theta))
        residual[:, 0], residual[:, -1] = theta[:, 0] - rod.clamp_angle, theta @ first[-1]
        stiff = force * np.cos(theta[:, 1:-1]) + field * np.cos(2 * theta[:, 1:-1])
        jacobian[:, inner, inner] = second[inner, inner] - share * stiff
        step = np.linalg.solve(jacobian, residual[..., None])[..., 0]
        theta -= step
        size = float(np.max(np.abs(step)))
        if size < chebyshev.SETTLED or (before < chebyshev.UNSETTLED and size > before / 2):
            break
        before = size
    else:
        theta[np.max(np.abs(step), axis=1) > chebyshev.UNSETTLED] = np.nan
    weights = coefficients.T @ integrals(n) * rod.length / 2
    return np.array([theta[:, -1], np.cos(theta) @ weights, np.sin(theta) @ weights])


def integrals(n: int) -> Array:
    """∫T_k over [−1, 1]."""
    k = np.arange(n + 1)
    return np.where(k % 2 == 0, 2.0 / (1.0 - np.where(k % 2 == 0, k, 0) ** 2), 0.0)


def batches(problem: Problem, n: int) -> Callable[[], Call]:
    """Chebyshev collocation."""

    def prepare() -> Call:
        given = [(*loads(rod), rod, tip, n) for rod, tip in problem.inputs]
        return lambda: [stacked(*one) for one in given]

    return prepare


def in_the_midst(found: Sequence[Array]) -> list[list[Answer]]:
    """Of each batch the rod itself."""
    return [[tuple(one[:, MANY // 2].tolist())] for one in found]


def sweep_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """All stable equilibria of all rods."""
    if problem.task == "T1":
        setting, answers = f"{MANY:,} rods at once, stable ones", partial(meant, problem)
        yield Cell(setting, sweeps(problem), DOUBLES, answers, MANY, all_found=True)


def batch_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """The settings of the other."""
    if problem.task == "T1":
        for n in NODES[:1] if plan.quick else NODES:
            limit = chebyshev.SOLVER.limit(n)
            yield Cell(f"{by_number(n)}, {MANY:,} rods at once", batches(problem, n), limit, in_the_midst, MANY)


METHODS = (
    Method("emitted, NumPy, in a sweep", OURS, sweep_cells),
    Method("Chebyshev, in a batch", PEER, batch_cells),
)
