"""Diagrams as CSV, NPZ and JSON."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from derive.diagrams.branches import Diagram
from derive.diagrams.jumps import jumps
from derive.diagrams.states import FIELDS

COLUMNS = ("curve", "parameter", "value", "branch", "index", *FIELDS[:-1])


def points(found: Sequence[Diagram]) -> Iterator[list[Any]]:
    """A row for each point of each branch; ``curve`` counts the diagrams of a family."""
    for number, one in enumerate(found, 1):
        for branch in one.branches:
            for value, state in zip(branch.values, branch.states, strict=True):
                yield [number, one.parameter, value, branch.number, branch.index, *state.numbers()]


def csv_text(found: Sequence[Diagram]) -> str:
    """One line for each point of each branch. The fixed loads of each curve are columns of their own."""
    names = sorted({name for one in found for name in one.fixed})
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([*COLUMNS, *names])
    for row in points(found):
        fixed = found[row[0] - 1].fixed
        writer.writerow([*(repr(part) if isinstance(part, float) else part for part in row), *map(fixed.get, names)])
    return stream.getvalue()


def data(found: Sequence[Diagram]) -> dict[str, Any]:
    """Branches, events and jumps of every curve."""
    return {
        "curves": [
            {
                "parameter": one.parameter,
                "fixed": one.fixed,
                "branches": [asdict(branch) for branch in one.branches],
                "events": [asdict(event) for event in one.events],
                "jumps": [asdict(jump) for jump in jumps(one)],
            }
            for one in found
        ]
    }


def npz_bytes(found: Sequence[Diagram]) -> bytes:
    """The points as arrays, a column each, and the events."""
    listed = list(points(found))
    columns = {name: np.array([row[k] for row in listed]) for k, name in enumerate(COLUMNS) if name != "parameter"}
    events = [(number, event) for number, one in enumerate(found, 1) for event in one.events]
    columns |= {
        "event_curve": np.array([number for number, _ in events], dtype=int),
        "event_value": np.array([event.value for _, event in events], dtype=float),
        "event_kind": np.array([event.kind for _, event in events], dtype="U9"),
        "event_tip_angle": np.array([event.state.tip_angle for _, event in events], dtype=float),
    }
    stream = io.BytesIO()
    np.savez_compressed(stream, allow_pickle=False, **columns)
    return stream.getvalue()
