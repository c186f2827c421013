"""FLINT's ball arithmetic through python-flint: `acb.elliptic_p`, `elliptic_zeta`, `elliptic_sigma`.

Set up: the lattice is scaled to 1 and τ once, in advance; each value costs one call at a working precision of some
bits more than the digits asked for. There are no arrays, so that points are done one by one.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log2
from typing import Any

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


def as_numbers(found: Sequence[Any], digits: int) -> list[Any]:
    """The real parts as numbers of mpmath; outside the time."""
    from mpmath import mpf

    return [mpf(one.real.mid().str(digits + 5, radius=False)) for one in found]
