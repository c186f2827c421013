"""FLINT's ball arithmetic through python-flint: `acb.elliptic_p`, `elliptic_zeta`, `elliptic_sigma`.

Set up: the lattice is scaled to 1 and τ once, in advance; each value costs one call at a working precision of some
bits more than the digits asked for. There are no arrays, so that points are done one by one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from math import ceil, log2
from typing import Any

from mpmath import mp, mpf

from derive.measure.bench.cells import PEER, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.methods.emitted import DIGITS, ready

GUARD = 20  # bits beyond the digits


def values(kind: str, u: Sequence[float], half_periods: tuple[str, str], digits: int) -> list[Any]:
    """℘, ζ or σ at real u; half_periods ω₁ and ω₃/i as decimal text."""
    from flint import acb, arb, ctx

    before, ctx.prec = ctx.prec, ceil(digits * log2(10)) + GUARD
    try:
        first, second = (arb(text) for text in half_periods)
        period, tau = acb(2 * first), acb(0, second / first)
        scale = {"p": 1 / period**2, "zeta": 1 / period, "sigma": period}[kind]
        return [scale * getattr(acb(x) / period, f"elliptic_{kind}")(tau) for x in u]
    finally:
        ctx.prec = before


def as_numbers(digits: int, found: Sequence[Any]) -> list[Any]:
    """The middles of the real parts as numbers of mpmath; outside the time."""
    with mp.workdps(digits + 10):
        return [mpf(one.real.mid().str(digits + 5, radius=False)) for one in found]


def cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """At the points that have references: the time for each is what counts."""
    if problem.task == "T5":
        given, share = problem.inputs, len(problem.inputs.sample) / problem.units
        for digits in DIGITS[:2] if plan.quick else DIGITS:
            call = partial(values, given.kind, given.u[given.sample].tolist(), given.exact, digits)
            limit = 10.0 ** (1 - digits)  # balls are as narrow as asked for
            yield Cell(f"{digits} digits", ready(call), limit, partial(as_numbers, digits), share)


METHODS = (Method("FLINT (Arb)", PEER, cells, ("flint",)),)
