"""How far answers are from the references: errors in the natural sizes, at as many digits as the answers have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from typing import Any

from mpmath import mp, mpf

from derive.measure.reference import Rod

NEAR = 1e-2  # an answer whose tip angle is farther than this from a reference is another equilibrium, or none
EXTRA = 5


@dataclass(frozen=True)
class Errors:
    """Worst and median error over what was found; how much of what there is was found; what matches nothing."""

    worst: float | None
    median: float | None
    found: int
    of: int
    spurious: int = 0


def collected(errors: Sequence[Any], of: int, spurious: int = 0) -> Errors:
    """Over single errors; those that are no number count as not found."""
    good = [float(error) for error in errors if mp.isfinite(error)]
    if not good:
        return Errors(None, None, 0, of, spurious)
    return Errors(max(good), median(good), len(good), of, spurious)


def largest(errors: Sequence[Any]) -> Any:
    """The largest, or nan where one is nan, which `max` would pass over."""
    return mp.nan if any(mp.isnan(error) for error in errors) else max(errors)


def of_equilibria(
    answers: Sequence[Sequence[Any]], rods: Sequence[Rod], wanted: Sequence[Sequence[Any]], digits: int
) -> Errors:
    """Answers are, for each rod, (tip angle, y, z), None for what a method does not give; y and z over the length."""
    errors, spurious, total = [], 0, 0
    with mp.workdps(digits + EXTRA):
        for found, rod, rows in zip(answers, rods, wanted, strict=True):
            total += len(rows)
            sizes, rest = (1, mpf(rod.length), mpf(rod.length)), list(found)
            for known in rows:
                nearest = min(rest, key=lambda one: abs(one[0] - known[0]), default=None)
                if nearest is None or not abs(nearest[0] - known[0]) < NEAR:
                    continue
                rest.remove(nearest)
                triples = zip(nearest, known, sizes, strict=True)
                errors.append(largest([abs(mpf(a) - b) / size for a, b, size in triples if a is not None]))
            spurious += len(rest)
        return collected(errors, total, spurious)


def of_values(answers: Sequence[Any], wanted: Sequence[Any], digits: int) -> Errors:
    """Single values, each relative to itself; None where there is none."""
    with mp.workdps(digits + EXTRA):
        rows = zip(answers, wanted, strict=True)
        return collected([abs((mpf(a) - b) / b) for a, b in rows if a is not None], len(wanted))


def of_shape(answers: Sequence[Any], wanted: Sequence[Sequence[Any]], length: float, digits: int) -> Errors:
    """θ, y, z at some places: one error for each place, y and z over the length."""
    if all(found is None for found in answers):
        return Errors(None, None, 0, len(wanted[0]))
    with mp.workdps(digits + EXTRA):
        errors = [mpf(0)] * len(wanted[0])
        for number, (found, known) in enumerate(zip(answers, wanted, strict=True)):
            if found is None:
                continue
            size = mpf(length) if number else mpf(1)
            errors = [largest([e, abs(mpf(a) - b) / size]) for e, a, b in zip(errors, found, known, strict=True)]
        return collected(errors, len(wanted[0]))


def of_folds(answers: Sequence[Any], wanted: Sequence[Sequence[Any]], digits: int) -> Errors:
    """(η, tip angle) of a fold for each rod: the share by which η is off. A tip angle is known to half the digits."""
    with mp.workdps(digits + EXTRA):
        errors = []
        for found, known in zip(answers, wanted, strict=True):
            if found is not None and abs(mpf(found[0]) / known[0] - 1) < NEAR and abs(found[1] - known[1]) < 1:
                errors.append(abs(mpf(found[0]) / known[0] - 1))
        return collected(errors, len(wanted))
