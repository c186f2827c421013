"""How many equilibria rods have, by brute force with a check between the samples; shares no formula with the solvers.

The tip angles within a whole turn of the clamp are cut into cells. From the middle φ of each the rod is integrated to
the clamp, with the linearised equation's two solutions beside it (doubles, Taylor steps, many rods at once). What θ(0)
does in the rest of the cell is bounded: for a tip at distance ≤ w, h = ∂θ/∂φ is off from the middle's by e with

    e″ = F′(θ_c) e + (F′(θ) − F′(θ_c)) h,  |F′(θ) − F′(θ_c)| ≤ M|θ − θ_c| ≤ M w sup|h|,  M = β + 2η,

so that |e(σ)| ≤ M w ∫|Γ(σ, s)| sup|h|² ds with the middle's own kernel Γ; from step to step this is an inequality for
the past alone (within a step, |F′| ≤ 1 bounds everything by cosh and sinh). A cell where θ(0) keeps away from the clamp
angle holds no equilibrium; one where h(0) keeps its sign holds one if θ(0) crosses at its ends, else none; others are
halved. What is still open at widths of 1e-12 is near a fold: the rod is undecided.

The bounds are those of real numbers; rounding is allowed for by a margin that follows the same kernel, not by
intervals.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from derive.measure.reference import Rod

Array = NDArray[np.float64]
STIFFEST = 9.0  # beyond this ℓ√(β+η), rounding times e^{2ℓ√(β+η)} comes near to what must be told apart
ORDER = 14
LONGEST_STEP = 0.25
CELLS = 96
NARROWEST = 1e-12
BLOCK = 2048  # cells at a time: what is held for them fits a cache
TOGETHER = 64  # rods at a time
MARGIN = 4e-15  # of rounding, for a step
POLISHES = 8


@dataclass(frozen=True)
class Counted:
    """The equilibria of one rod: tip angles (to about 1e-10) ascending, and indices; None where it is undecided."""

    rod: Rod
    tips: tuple[float, ...] | None
    indices: tuple[int, ...] | None

    @property
    def number(self) -> int | None:
        """How many."""
        return None if self.tips is None else len(self.tips)


@dataclass(frozen=True)
class Loads:
    """Scaled rods, one for each cell: β, η, α, length; and the clamp angle."""

    beta: Array
    eta: Array
    field_angle: Array
    length: Array
    clamp: Array

    @classmethod
    def of(cls, rods: Sequence[Rod]) -> Loads:
        """One for each rod."""
        scale = np.array([max(sqrt(rod.beta + rod.eta), 1 / rod.length) for rod in rods])
        beta, eta, field_angle, length, clamp = (
            np.array([getattr(rod, name) for rod in rods], dtype=float)
            for name in ("beta", "eta", "field_angle", "length", "clamp_angle")
        )
        return cls(beta / scale**2, eta / scale**2, field_angle, length * scale, clamp)

    def __getitem__(self, which: NDArray[np.intp] | slice) -> Loads:
        """Those of some cells."""
        return Loads(*(part[which] for part in vars(self).values()))


@dataclass(frozen=True)
class Run:
    """What tips arrive at: θ(0) less the clamp angle, and h1, h2, h1′, h2′ at all steps: (steps + 1, 4, tips)."""

    miss: Array
    waves: Array
    step: Array

    @property
    def slope(self) -> Array:
        """h(0)."""
        return self.waves[-1, 0]


def count(rods: Sequence[Rod]) -> list[Counted]:
    """For every rod. Raises ValueError where ℓ√(β + η) is too large for doubles."""
    for rod in rods:
        if rod.length * sqrt(rod.beta + rod.eta) > STIFFEST:
            raise ValueError(f"counting by brute force is for ℓ√(β+η) ≤ {STIFFEST:g}; this rod has more: {rod}")
    order = sorted(range(len(rods)), key=lambda k: rods[k].length * sqrt(rods[k].beta + rods[k].eta))
    found: dict[int, Counted] = {}
    for first in range(0, len(order), TOGETHER):
        some = order[first : first + TOGETHER]
        found |= zip(some, _counted([rods[k] for k in some]), strict=True)
    return [found[k] for k in range(len(rods))]


def _counted(rods: Sequence[Rod]) -> list[Counted]:
    loads = Loads.of(rods)
    steps = max(2, ceil(float(np.max(loads.length)) / LONGEST_STEP))
    owner = np.repeat(np.arange(len(rods)), CELLS)
    cuts = np.arange(CELLS + 1) / CELLS * 4 * pi - 2 * pi
    low, high = (np.add.outer(loads.clamp, edge).ravel() for edge in (cuts[:-1], cuts[1:]))
    open_rods, kept = np.zeros(len(rods), dtype=bool), []
    while low.size:
        away, steady = _judged(loads[owner], low, high, steps)
        kept.append((owner[steady & ~away], low[steady & ~away], high[steady & ~away]))
        left = ~(away | steady)
        open_rods[owner[left & (high - low < NARROWEST)]] = True
        left &= ~open_rods[owner]
        owner, low, high = owner[left], low[left], high[left]
        middle = (low + high) / 2
        owner = np.concatenate([owner, owner])
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    owner, low, high = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    tips, indices, owner = _crossings(loads, owner, low, high, steps)
    result = []
    for k, rod in enumerate(rods):
        mine = np.flatnonzero(owner == k)
        mine = mine[np.argsort(tips[mine])]
        done = Counted(rod, tuple(tips[mine].tolist()), tuple(indices[mine].tolist()))
        result.append(Counted(rod, None, None) if open_rods[k] else done)
    return result


def _judged(loads: Loads, low: Array, high: Array, steps: int) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Of each cell: does θ(0) keep away from the clamp angle, and does h(0) keep its sign?"""
    away, steady = np.zeros(len(low), dtype=bool), np.zeros(len(low), dtype=bool)
    for first in range(0, len(low), BLOCK):
        some = slice(first, first + BLOCK)
        middle, width = (low[some] + high[some]) / 2, (high[some] - low[some]) / 2 * (1 + 1e-9)
        run = shoot(loads[some], middle, steps)
        spread, margin = bound(loads[some], run, width)
        away[some] = np.abs(run.miss) > width * (np.abs(run.slope) + spread) + margin
        steady[some] = np.abs(run.slope) > spread + margin
    return away, steady


@np.errstate(over="ignore", invalid="ignore")
def bound(loads: Loads, run: Run, width: Array) -> tuple[Array, Array]:
    """By how much h(0) may differ within each cell (infinite where that is not bounded), and a margin for rounding."""
    h1, h2, g1, g2 = (run.waves[:, part] for part in range(4))
    steps, most, least = len(h1) - 1, np.cosh(run.step), np.sinh(run.step)
    sup = (np.abs(h1) * most + np.abs(g1) * least)[:-1]  # of |h| during each step
    bend = (loads.beta + 2 * loads.eta) * width
    squares, ahead = np.zeros_like(sup), np.zeros_like(width)
    spread, rate = np.zeros_like(width), np.zeros_like(width)
    kernel = np.zeros_like(sup)
    for j in range(steps):
        before = spread * most + rate * least
        ahead = before + 2 * bend * (most - 1) * (sup[j] + before) ** 2
        proved = before + bend * (most - 1) * (sup[j] + ahead) ** 2 <= ahead
        squares[j] = np.where(proved, (sup[j] + ahead) ** 2, np.inf)
        past = slice(0, j + 1)
        kernel = _kernel(h1[past], h2[past], g1[past], g2[past], h1[j + 1], h2[j + 1], most, least)
        slopes = _kernel(h1[past], h2[past], g1[past], g2[past], g1[j + 1], g2[j + 1], most, least)
        spread = bend * run.step * np.einsum("kn,kn->n", kernel, squares[past])
        rate = bend * run.step * np.einsum("kn,kn->n", slopes, squares[past])
    spread = np.where(np.isfinite(spread), spread, np.inf)
    return spread, MARGIN * (np.sum(kernel, axis=0) + np.max(np.abs(h1), axis=0))


def _kernel(h1: Array, h2: Array, g1: Array, g2: Array, end1: Array, end2: Array, most: Array, least: Array) -> Array:
    """The greatest |h1(s)·end2 − h2(s)·end1| during each step."""
    return np.abs(h1 * end2 - h2 * end1) * most + np.abs(g1 * end2 - g2 * end1) * least


def _crossings(
    loads: Loads, owner: NDArray[np.intp], low: Array, high: Array, steps: int
) -> tuple[Array, NDArray[np.intp], NDArray[np.intp]]:
    """Tip angles, indices and rods of the crossings in cells where θ(0) is monotone.

    The ends that two cells share are integrated once, so that both see the same sign.
    """
    ends, places = np.unique(np.stack([np.tile(owner, 2), np.concatenate([low, high])]), axis=1, return_inverse=True)
    signs = np.signbit(_in_blocks(loads, ends[0].astype(int), ends[1], steps)[0])[places.ravel()]
    first, last = signs[: len(low)], signs[len(low) :]
    crossing = first != last
    owner, low, high, falling = owner[crossing], low[crossing], high[crossing], last[crossing]
    tip = (low + high) / 2
    for _ in range(POLISHES):
        miss, slope, _ = _in_blocks(loads, owner, tip, steps)
        beyond = (miss > 0) != falling
        low, high = np.where(beyond, low, tip), np.where(beyond, tip, high)
        tip = np.clip(tip - miss / slope, low, high)
    return tip, _in_blocks(loads, owner, tip, steps)[2].astype(int), owner


def _in_blocks(loads: Loads, owner: NDArray[np.intp], tips: Array, steps: int) -> tuple[Array, Array, Array]:
    """Miss, slope and index of many tips."""
    found = np.zeros((3, len(tips)))
    for first in range(0, len(tips), BLOCK):
        some = slice(first, first + BLOCK)
        run = shoot(loads[owner[some]], tips[some], steps)
        negative = np.signbit(run.waves[:, 0])
        found[:, some] = run.miss, run.slope, np.sum(negative[1:] != negative[:-1], axis=0)
    return found[0], found[1], found[2]


def shoot(loads: Loads, tips: Array, steps: int) -> Run:
    """From tip angles to the clamp; zeros of h are at least π apart in scaled length, so its signs show them all."""
    step, none, one = loads.length / steps, np.zeros_like(tips), np.ones_like(tips)
    phi = tips - loads.field_angle
    state = np.stack([phi, none, np.cos(phi), np.sin(phi), one, none, none, one])
    waves = np.empty((steps + 1, 4, len(tips)))
    waves[0] = state[4:]
    ca, sa = np.cos(loads.field_angle), np.sin(loads.field_angle)
    series = np.empty((ORDER + 1, 8, len(tips)))  # φ, φ′, cos φ, sin φ, h1, h2, h1′, h2′
    stiffness = np.empty((ORDER, len(tips)))
    for j in range(steps):
        series[0] = state
        for k in range(ORDER):
            now, turned = series[k], series[k::-1]
            with_cos = np.einsum("kn,kcn->cn", turned[:, 2], series[: k + 1, 1:4])
            sine_turn = np.einsum("kn,kn->n", turned[:, 3], series[: k + 1, 1])
            moment = loads.beta * (now[3] * ca + now[2] * sa) + loads.eta * with_cos[2]
            stiffness[k] = loads.beta * (now[2] * ca - now[3] * sa) + loads.eta * (2 * with_cos[1] - (k == 0))
            after = series[k + 1]
            after[0], after[1], after[2], after[3] = now[1], moment, -sine_turn, with_cos[0]
            after[4:6] = now[6:8]
            after[6:8] = np.einsum("kn,kcn->cn", stiffness[k::-1], series[: k + 1, 4:6])
            after /= k + 1
        state = series[ORDER].copy()
        for k in range(ORDER - 1, -1, -1):
            state *= step
            state += series[k]
        waves[j + 1] = state[4:]
    return Run(state[0] + loads.field_angle - loads.clamp, waves, step)
