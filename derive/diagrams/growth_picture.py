"""Time and memory as work grows, as a picture: a line for each series, named with its measured exponent."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from derive.diagrams.plotting import COLOURS, figure, saved, settings
from derive.measure.bench.families import Record
from derive.measure.bench.growth import exponents

MARKS = "osD^vP"


def pictures(records: Sequence[Record], kind: str) -> Iterator[tuple[str, bytes]]:
    """Names and bytes."""
    with settings(**{"font.size": 11}):
        drawing = figure(figsize=(11.5, 5.8))
        left, right = drawing.subplots(1, 2)
        draw(left, records, "seconds", lambda record: record["seconds"]["median"], "time")
        draw(right, records, "megabytes", lambda record: max(1, record["bytes"]) / 1e6, "memory")
        drawing.tight_layout()
        yield "growth", saved(drawing, kind, bbox_inches="tight")


def draw(axes: Any, records: Sequence[Record], unit: str, value: Callable[[Record], float], exponent: str) -> None:
    """A line for each series; its colour and mark are the same in both panels."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    for number, row in enumerate(exponents(records)):
        mine = [record for record in records if record["series"] == row.series]
        label = f"{row.series}: {row.variable}$^{{{getattr(row, exponent):.2f}}}$"
        places = [record["amount"] for record in mine], [value(record) for record in mine]
        axes.plot(*places, f"-{MARKS[number]}", color=COLOURS[number], ms=5, lw=1.4, label=label)
    axes.set_xlabel("amount: points, equilibria, digits, rods, formulas")
    axes.set_ylabel(unit)
    axes.grid(True, which="major", color="#e9e9e9", lw=0.6, zorder=-1)
    axes.legend(fontsize=9, loc="upper left", bbox_to_anchor=(0.0, -0.18))
