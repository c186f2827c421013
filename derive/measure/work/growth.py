"""How time and memory grow with the work: points, equilibria, digits, rods in a sweep; measured exponents."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from importlib import import_module
from math import log, pi
from typing import Any

import numpy as np

from derive.measure.rods import PAPER
from derive.measure.work.timing import Times, interleaved, peak_memory

GOES = "growth"  # what --only calls it


@dataclass(frozen=True)
class Step:
    """One amount of work of a series; prepare makes the call. The work is the value, but equilibria are counted."""

    series: str
    variable: str
    value: float
    prepare: Callable[[], Callable[[], Any]]

    @property
    def key(self) -> str:
        """Its name among the records."""
        return f"{GOES}/{self.series}/{self.value:g}"


SERIES: tuple[tuple[str, str, tuple[int, ...], str], ...] = (
    ("a shape", "points", (100, 1000, 10_000, 100_000, 1_000_000), "shape"),
    ("all equilibria, field alone", "equilibria", (10, 30, 100, 300, 1000, 3000), "alone"),
    ("all equilibria, mpmath", "digits", (15, 30, 60, 120, 240, 480), "twin"),
    ("kernels on arrays", "rods", (8, 80, 800, 8000), "arrays"),
    ("emitted sweep", "rods", (4, 16, 64, 256), "sweep"),
)


def steps(*, quick: bool) -> Iterator[Step]:
    """All series; a quick run takes the first two amounts of each."""
    makers: dict[str, Callable[[int], Callable[[], Any]]] = {
        "shape": shape,
        "alone": alone,
        "twin": twin,
        "arrays": arrays,
        "sweep": sweep,
    }
    for series, variable, values, maker in SERIES:
        for value in values[: 2 if quick else None]:
            yield Step(series, variable, value, partial(makers[maker], value))


def shape(number: int) -> Callable[[], Any]:
    """θ, y, z of the article's rod, solved before."""
    module = import_module("generated.parallel_numpy")
    found = module.equilibria(PAPER.beta, PAPER.eta, PAPER.length, PAPER.clamp_angle)[0]
    return partial(module.shape, found, np.linspace(0.0, PAPER.length, number))


def alone(scaled: float) -> Callable[[], Any]:
    """A rod in a field alone, with ℓ√η = scaled."""
    module = import_module("generated.field_only_numpy")
    return partial(module.equilibria, 1.0, float(scaled), 3 * pi / 4)


def twin(digits: int) -> Callable[[], Any]:
    """All equilibria of the article's rod."""
    module = import_module("generated.parallel_mpmath")
    return partial(module.equilibria, PAPER.beta, PAPER.eta, PAPER.length, PAPER.clamp_angle, dps=digits)


def loads(number: int) -> tuple[Any, Any]:
    """Rods of the article's second example, the field growing."""
    return np.full(number, PAPER.beta), np.linspace(1e-6, 1e-3, number)


def arrays(number: int) -> Callable[[], Any]:
    """All equilibria of many rods at once."""
    from derive.emit.kernels.blocks import sweep_arrays

    one = np.ones(number)
    return partial(sweep_arrays, *loads(number), PAPER.length * one, PAPER.clamp_angle * one, 0 * one, None)


def sweep(number: int) -> Callable[[], Any]:
    """The same by the emitted module, rod by rod."""
    return partial(import_module("generated.bifurcation_numpy").sweep, *loads(number))


def measure(step: Step, budget: float) -> dict[str, Any]:
    """The record of one amount of work."""
    call = step.prepare()
    found = call()
    amount = len(found) if step.variable == "equilibria" else step.value
    (times,) = interleaved([call], budget)
    return {
        "series": step.series,
        "variable": step.variable,
        "value": step.value,
        "amount": amount,
        "seconds": asdict(Times.of(times)),
        "bytes": peak_memory(call),
    }


def exponents(records: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """For each series the exponents of time and memory, by least squares on logarithms over the upper half."""
    found = []
    for series in dict.fromkeys(record["series"] for record in records):
        rows = sorted((r for r in records if r["series"] == series), key=lambda r: float(r["amount"]))
        upper = rows[-max(2, (len(rows) + 1) // 2) :]
        if len(upper) < 2:
            continue
        amounts = [float(r["amount"]) for r in upper]
        time = slope(amounts, [r["seconds"]["median"] for r in upper])
        memory = slope(amounts, [max(1, r["bytes"]) for r in upper])
        first, last = rows[0], rows[-1]
        found.append(
            {
                "series": series,
                "variable": first["variable"],
                "from": first["amount"],
                "to": last["amount"],
                "fitted_from": upper[0]["amount"],
                "seconds": [first["seconds"]["median"], last["seconds"]["median"]],
                "bytes": [first["bytes"], last["bytes"]],
                "time": time,
                "memory": memory,
            }
        )
    return found


def slope(amounts: Sequence[float], values: Sequence[float]) -> float:
    """Of log values over log amounts."""
    return float(np.polyfit([log(a) for a in amounts], [log(v) for v in values], 1)[0])
