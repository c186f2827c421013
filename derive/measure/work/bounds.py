"""The bounds that errors must keep to, by name; times have none. A run that misses one ends with exit code 1."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from derive.measure.work.cells import OURS

Record = dict[str, Any]


@dataclass(frozen=True)
class Bound:
    """methods: how their names begin. limit: of the worst error, from the number in the setting."""

    name: str
    methods: tuple[str, ...]
    limit: Callable[[float], float]
    reason: str


# The first that fits counts. Wrong signs, terms and formulas are off by more than any of these.
BOUNDS = (
    Bound("doubles", ("emitted, NumPy", "kernels on arrays"), lambda _: 1e-13, "some hundred roundings"),
    Bound("series", ("q-series, NumPy",), lambda _: 1e-13, "some hundred roundings, near zeros of ℘ and ζ too"),
    Bound(
        "twins", ("emitted, mpmath", "q-series, mpmath"), lambda d: 10 ** (3 - d), "three digits less than asked for"
    ),
    Bound("article", ("article",), lambda _: 1e-5, "inverse functions at the end of their domain halve the digits"),
    Bound("tolerance", ("solve_bvp", "shooting"), lambda t: max(300 * t, 1e-9), "a tolerance is not an error"),
    Bound("spectral", ("Chebyshev",), lambda n: max(10 ** (-0.4 * n), 1e-9), "geometric in n down to rounding"),
    Bound("segments", ("discrete rod",), lambda n: 1 / n**2, "second order in the segments"),
    Bound("special", ("SciPy R_F",), lambda _: 1e-11, "a root of R_F, to rounding"),
    Bound("balls", ("FLINT",), lambda d: 10 ** (1 - d), "balls are as narrow as asked for"),
    Bound(
        "others", ("SciPy ellipj", "pyweierstrass", "elliptic-functions"), lambda _: 1e-10, "doubles by theta series"
    ),
)


def bound_of(record: Record) -> Bound:
    """That of a record's method."""
    return next(bound for bound in BOUNDS if record["method"].startswith(bound.methods))


def violations(records: Sequence[Record], *, peers: bool) -> Iterator[str]:
    """One line for each record that misses its bound. peers: theirs are looked at, too."""
    for record in records:
        own, errors = record["group"] == OURS, record["errors"]
        if not (own or peers):
            continue
        if record["whole"] and own and (errors["found"] < errors["of"] or errors["spurious"]):
            yield f"{record['key']}: {errors['found']} of {errors['of']} found, {errors['spurious']} that are none"
        if errors["worst"] is None:
            if record["whole"]:
                yield f"{record['key']}: nothing was found"
            continue
        bound = bound_of(record)
        limit = bound.limit(number_in(record["setting"]))
        if not errors["worst"] <= limit:
            yield f"{record['key']}: error {errors['worst']:.1e} is beyond the bound '{bound.name}', {limit:.0e}"


def number_in(setting: str) -> float:
    """The tolerance, digits or nodes that a setting names; 0 if it names none."""
    for word in setting.split():
        try:
            return float(word)
        except ValueError:
            continue
    return 0.0
