"""Numbers as a table on the terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rich.console import Console
from rich.markup import escape
from rich.table import Table


def table(console: Console, names: Sequence[str], lines: Iterable[Sequence[str]]) -> None:
    """Print a table of numbers."""
    found = Table(show_edge=False)
    for name in ("no.", *names, "index", ""):
        found.add_column(escape(name), justify="right", no_wrap=True)
    for line in lines:
        found.add_row(*line)
    console.print(found)
