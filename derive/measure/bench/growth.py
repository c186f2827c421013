"""The family of records of growing work: time and memory, and the exponents that they show."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from math import log

import numpy as np

from derive.measure.bench import tables
from derive.measure.bench.families import Job, Plan, Record
from derive.measure.bench.series import SERIES, Series
from derive.measure.bench.timing import Times, alone, peak_memory

PARTS = {"growth": "time and memory as work grows"}
HEAD = ("what", "work", "from … to", "time", "grows as", "memory", "grows as")


def jobs(plan: Plan) -> Iterator[Job]:
    """A job for each amount of each series; a quick run takes the first two."""
    for series in SERIES:
        for amount in series.amounts[: 2 if plan.quick else None]:
            key = f"growth/{series.name}/{amount:g}"
            yield Job(key, partial(measure, series, amount, plan.budget))


def measure(series: Series, amount: int, budget: float) -> Record:
    """The record of one amount of work."""
    call = series.prepare(amount)
    found, seconds = alone(call, budget)
    counted = series.counted(found) if series.counted else amount
    return {
        "series": series.name,
        "variable": series.variable,
        "value": amount,
        "amount": counted,
        "seconds": asdict(Times.of(seconds)),
        "bytes": peak_memory(call),
    }


@dataclass(frozen=True)
class Grown:
    """What a series shows: exponents by least squares on logarithms, over the upper half of its amounts."""

    series: str
    variable: str
    amounts: Sequence[float]
    seconds: Sequence[float]
    time: float
    bytes: Sequence[int]
    memory: float


def exponents(records: Sequence[Record]) -> list[Grown]:
    """For each series with at least two amounts."""
    found = []
    for name in dict.fromkeys(record["series"] for record in records):
        rows = sorted((r for r in records if r["series"] == name), key=lambda r: float(r["amount"]))
        if len(rows) > 1:
            found.append(grown(rows))
    return found


def grown(rows: Sequence[Record]) -> Grown:
    """What one series shows, from the least amount to the largest."""
    upper, ends = rows[-max(2, (len(rows) + 1) // 2) :], (rows[0], rows[-1])
    return Grown(
        rows[0]["series"],
        rows[0]["variable"],
        [row["amount"] for row in ends],
        [row["seconds"]["median"] for row in ends],
        slope(upper, lambda row: float(row["seconds"]["median"])),
        [row["bytes"] for row in ends],
        slope(upper, lambda row: max(1.0, row["bytes"])),
    )


def slope(records: Sequence[Record], value: Callable[[Record], float]) -> float:
    """Of logarithms over those of the amounts."""
    amounts = [log(float(record["amount"])) for record in records]
    return float(np.polyfit(amounts, [log(value(record)) for record in records], 1)[0])


def document(records: Sequence[Record]) -> list[str]:
    """The measured exponents, and what they are."""
    text = "Exponents are of least squares on logarithms, over the upper half of each series."
    return ["## Time and memory as work grows", "", *tables.markdown(HEAD, rows(records)), "", text]


def rows(records: Sequence[Record]) -> list[list[str]]:
    """The cells of HEAD for each series."""
    found = []
    for row in exponents(records):
        cells = [
            row.series,
            row.variable,
            f"{row.amounts[0]:g} … {row.amounts[1]:g}",
            " … ".join(tables.seconds(value) for value in row.seconds),
            f"{row.variable}^{row.time:.2f}",
            " … ".join(f"{number / 1e6:.2g} MB" for number in row.bytes),
            f"{row.variable}^{row.memory:.2f}",
        ]
        found.append(cells)
    return found


def wrong(records: Sequence[Record]) -> Iterator[str]:
    """Times have no bounds; a series that does no work is broken."""
    for record in records:
        if not record["amount"] > 0:
            yield f"{record['key']}: nothing was done"
