"""What the printed symbols of a section mean, section by section.

Each module has ``readings(theory, sides, given)``: every reading (a ``Components`` with its domain) in which a plain
statement with these sides must hold, under the hypotheses that the text gives. ``BY_SCOPE`` names the module for each
scope of the conventions; the sections on load cases are read in ``derive.check.readings``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from derive.check.meaning import Components
from derive.check.sections import cantilever, couple, line_energy, magnetization, planarity, rod, variation
from derive.paper import tree as t

Readings = Callable[[Any, tuple[t.Node, ...], tuple[t.Statement, ...]], Iterator[Components]]

BY_SCOPE: dict[str, Readings] = {
    "kirchhoff": rod.readings,
    "magnetization": magnetization.readings,
    "line_energy": line_energy.readings,
    "variation": variation.readings,
    "couple": couple.readings,
    "cantilever": cantilever.readings,
    "planarity": planarity.readings,
}
