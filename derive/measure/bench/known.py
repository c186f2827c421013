"""The references of the tasks, by Taylor integration; kept under a hash of what they depend on, for they cost most.

Weierstrass's functions come from their Laurent series near 0 and duplication formulas, so that neither shares a theta
series, a Jacobi function or Carlson's integrals with what is measured.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict
from math import ceil
from pathlib import Path
from typing import Any

from mpmath import mp, mpf

from derive.cache import Cache, digest
from derive.measure import folds
from derive.measure.reference import Rod, refine, walk
from derive.measure.scan import brute_force
from derive.measure.taylor import integrate, working_digits

HERE = Path(__file__).resolve().parent
SOURCES = (HERE / "known.py", *(HERE.parent / f"{name}.py" for name in ("taylor", "reference", "scan", "folds")))
TERMS = 2.2  # of the Laurent series, for a digit, at an eighth of the least period


def kept(cache: Cache, name: str, inputs: Any, compute: Callable[[], Any], sources: Sequence[Path] = SOURCES) -> Any:
    """A result of texts and lists of them from the cache, or computed now from these sources."""
    key = digest(f"measured {name}", sources, inputs)
    found = cache.get(key)
    if found is None:
        found = compute()
        cache.put(key, found)
    return found


def text(value: Any, digits: int) -> str:
    """A number to its digits."""
    return str(mp.nstr(value, digits + 8, strip_zeros=False))


def numbers(found: Any, digits: int) -> Any:
    """Texts to numbers, however deep."""
    if isinstance(found, str):
        with mp.workdps(digits + 10):
            return mpf(found)
    return [numbers(one, digits) for one in found]


def equilibria(cache: Cache, rod: Rod, digits: int, *, stable: bool = False) -> list[Any]:
    """(tip angle, y, z) of all equilibria of a moderate rod, or of the first stable one alone."""

    def compute() -> list[list[str]]:
        rows = []
        for tip in brute_force(rod):
            if stable and walk(rod, tip, 20, interior=False).index != 0:
                continue
            exact = refine(rod, tip, digits, 1e-3)
            with mp.workdps(working_digits(rod.beta, rod.eta, rod.length, digits)):
                clamp = walk(rod, exact, digits, interior=False).clamp
                rows.append([text(value, digits) for value in (exact, clamp.y, clamp.z)])
            if stable:
                break
        return rows

    return list(numbers(kept(cache, "equilibria", [asdict(rod), digits, stable], compute), digits))


def shape(cache: Cache, rod: Rod, tip: Any, places: Sequence[float], digits: int) -> list[Any]:
    """θ, y and z at arc lengths from the clamp."""

    def compute() -> list[list[str]]:
        loads = (rod.beta, rod.eta, rod.field_angle, rod.length)
        path = integrate(tip, *loads, digits, stops=[mpf(s) for s in places])
        by_place = {float(point.s): point for point in path.points}
        end, points = path.clamp, [by_place[float(s)] for s in places]
        with mp.workdps(digits + 10):
            columns = ([p.theta for p in points], [end.y - p.y for p in points], [end.z - p.z for p in points])
            return [[text(value, digits) for value in column] for column in columns]

    inputs = [asdict(rod), text(tip, digits), list(places), digits]
    return list(numbers(kept(cache, "shape", inputs, compute), digits))


def fold(cache: Cache, rod: Rod, low: float, high: float, digits: int) -> list[Any]:
    """η and the tip angle of the fold between two field strengths."""

    def compute() -> list[str]:
        near = folds.fold_between(rod, "eta", low, high)
        if near is None:
            raise folds.NoFoldError(f"no fold between η = {low:g} and {high:g} for {rod}")
        exact = folds.fold(rod, "eta", float(near.value), float(near.tip_angle), digits)
        return [text(exact.value, digits), text(exact.tip_angle, digits)]

    return list(numbers(kept(cache, "fold", [asdict(rod), low, high, digits], compute), digits))


def function_values(cache: Cache, kind: str, u: Sequence[float], g2: float, g3: float, digits: int) -> list[Any]:
    """℘ ("p"), ζ ("zeta") or σ ("sigma") at real u that are no periods."""

    def compute() -> list[str]:
        return [text(x, digits) for x in weierstrass(kind, u, g2, g3, digits)]

    return list(numbers(kept(cache, "weierstrass", [kind, list(u), g2, g3, digits], compute), digits))


def weierstrass(kind: str, u: Sequence[float], g2: float, g3: float, digits: int) -> list[Any]:
    """℘ ("p"), ζ ("zeta") or σ ("sigma") at real u that are no periods."""
    with mp.workdps(2 * digits + 30):
        return [_duplicated(kind, mpf(x), mpf(g2), mpf(g3), digits) for x in u]


def _duplicated(kind: str, u: Any, g2: Any, g3: Any, digits: int) -> Any:
    """DLMF 23.9.2–23.9.5 at u/2ⁿ and 23.10.10–12 n times; every doubling costs some digits, and there are as many over.

    A root of 4x³ − g₂x − g₃ is at most √|g₂| + ∛|g₃|, so that a period is at least some 1/√(√|g₂| + ∛|g₃|).
    """
    size = mp.sqrt(mp.sqrt(abs(g2)) + mp.cbrt(abs(g3)))
    halvings = max(0, ceil(mp.log(abs(u) * size * 8, 2)))
    x, terms = u / mpf(2) ** halvings, ceil(TERMS * digits / 2) + 8
    c = [mpf(0), mpf(0), g2 / 20, g3 / 28]
    for n in range(4, terms):
        c.append(3 * sum(c[m] * c[n - m] for m in range(2, n - 1)) / ((2 * n + 1) * (n - 3)))
    square = x * x
    powers = [square**n for n in range(terms)]
    p = 1 / square + sum(c[n] * powers[n - 1] for n in range(2, terms))
    slope = -2 / (square * x) + sum(c[n] * (2 * n - 2) * powers[n - 1] / x for n in range(2, terms))
    zeta = 1 / x - sum(c[n] * powers[n - 1] * x / (2 * n - 1) for n in range(2, terms))
    sigma = x * mp.exp(-sum(c[n] * powers[n] / (2 * n * (2 * n - 1)) for n in range(2, terms)))
    for _ in range(halvings):
        second = 6 * p * p - g2 / 2
        half = second / (2 * slope)
        zeta, sigma = 2 * zeta + half, -slope * sigma**4
        p, slope = half * half - 2 * p, _slope(p, slope, second)
    return {"p": p, "zeta": zeta, "sigma": sigma}[kind]


def _slope(p: Any, slope: Any, second: Any) -> Any:
    """℘′(2u): half the derivative of ℘(2u) = (℘″/2℘′)² − 2℘."""
    half = second / (2 * slope)
    third = 12 * p * slope
    return half * (third / (2 * slope) - second * second / (2 * slope * slope)) - slope
