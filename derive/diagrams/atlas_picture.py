"""Heat maps of the atlas: for every map the solvers beside one another on one colour scale, failures marked.

Colours are those of cividis, which colour-blind readers see as others do; failures are told by signs, not by colour.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from derive.diagrams.plotting import COLOURS, figure, library, saved, settings
from derive.measure.atlas_points import OURS, TITLES
from derive.measure.bench.families import Record

LOWEST, HIGHEST = -1.0, 16.0  # powers of ten of the error in bounds
# Kind of failure, its sign, and what the legend says; the first that applies is drawn. Others are a diamond.
SIGNS = (
    ("no value", "x", "no value"),
    ("raises", "x", "no value"),
    ("nan", "x", "no value"),
    ("wrong digits", "v", "half of the digits lost"),
    ("wrong number", "s", "wrong number of equilibria"),
    ("missed", "s", "wrong number of equilibria"),
)
OTHER = ("D", "other failure")
BEYOND = ("+", "beyond the bound (of ours alone)")
MOST_LABELS = 8
CELLS: dict[str, Any] = {"edgecolors": "white", "lw": 0.2}


def pictures(records: Sequence[Record], kind: str) -> Iterator[tuple[str, bytes]]:
    """Names and bytes, a picture for each map."""
    for name in dict.fromkeys(record["map"] for record in records):
        here = [record for record in records if record["map"] == name]
        with settings(**{"font.size": 9}):
            drawn = (draw_line if here[0]["shape"][0] == 1 else draw_map)(here)
            yield f"atlas-{name}", saved(drawn, kind, bbox_inches="tight")


def of(records: Sequence[Record], solver: str) -> list[tuple[Record, dict[str, Any]]]:
    """What one solver does on each rod."""
    return [(record, one) for record in records for one in record["solvers"] if one["solver"] == solver]


def draw_map(records: Sequence[Record]) -> Any:
    """Error of every solver in bounds, then our condition number and the forms that were used."""
    solvers = [one["solver"] for one in records[0]["solvers"]]
    panels = len(solvers) + 2
    drawing = figure(figsize=(1.8 + 2.6 * panels, 4.2), layout="constrained")
    axes, shown = drawing.subplots(1, panels, sharey=True), dict[str, str]()
    for axis, solver in zip(axes, solvers, strict=False):
        known = of(records, solver)
        image = axis.pcolormesh(grid(known, "bounds", LOWEST), cmap="cividis", vmin=LOWEST, vmax=HIGHEST, **CELLS)
        mark(axis, known, shown)
        label(axis, records, TITLES[solver])
    bar = drawing.colorbar(image, ax=list(axes[: len(solvers)]), shrink=0.8, pad=0.01)
    bar.ax.set_title("error in\nbounds,\nlog₁₀", fontsize=7)  # beside the bar it would be taken for the next panel's
    image = axes[-2].pcolormesh(grid(of(records, OURS), "condition", -3.0), cmap="cividis", **CELLS)
    label(axes[-2], records, "condition number, log₁₀")
    drawing.colorbar(image, ax=axes[-2], shrink=0.8, pad=0.02)
    forms(axes[-1], records)
    axes[0].set_ylabel(records[0]["labels"][1])
    drawing.suptitle(records[0]["title"])
    if shown:
        drawing.legend(handles=signs(shown), loc="outside lower left", ncols=len(shown))
    return drawing


def grid(known: Sequence[tuple[Record, dict[str, Any]]], name: str, least: float) -> Any:
    """log₁₀ of a number, no less than ``least``; masked where there is none."""
    values = np.ma.masked_all(known[0][0]["shape"])
    for record, one in known:
        if one[name] is not None:
            values[record["row"], record["column"]] = max(least, np.log10(max(one[name], 1e-300)))
    return values


def mark(axis: Any, known: Sequence[tuple[Record, dict[str, Any]]], shown: dict[str, str]) -> None:
    """Signs where a solver fails, or ours is beyond its bound."""
    for record, one in known:
        kinds = {failure.split(":")[0] for failure in one["failures"]}
        beyond = one["solver"] == OURS and (one["bounds"] or 0) > 1
        if not kinds and not beyond:
            continue
        fitting = [(sign, text) for kind, sign, text in SIGNS if kind in kinds]
        sign, text = fitting[0] if fitting else OTHER if kinds else BEYOND
        shown[text] = sign
        style = {"color": "white", "ms": 6, "mew": 1.4} if sign == "+" else {"color": "black", "ms": 4, "mew": 0.8}
        axis.plot(record["column"] + 0.5, record["row"] + 0.5, marker=sign, mfc="white", **style)


def signs(shown: dict[str, str]) -> list[Any]:
    """The legend of failures."""
    library()
    from matplotlib.lines import Line2D

    return [Line2D([], [], color="black", marker=sign, mfc="white", ls="", label=text) for text, sign in shown.items()]


def forms(axis: Any, records: Sequence[Record]) -> None:
    """Which forms our module used: a colour for each set of them."""
    colormaps = library().colormaps
    from matplotlib.patches import Patch

    named = [(record, ", ".join(one["formulas"]) or "none") for record, one in of(records, OURS)]
    used = sorted({name for _, name in named})
    values = np.ma.masked_all(records[0]["shape"])
    for record, name in named:
        values[record["row"], record["column"]] = used.index(name)
    many = max(2, len(used))
    colours = colormaps["cividis"].resampled(many)
    axis.pcolormesh(values, cmap=colours, vmin=-0.5, vmax=many - 0.5, **CELLS)
    label(axis, records, "forms used by ours")
    handles = [Patch(color=colours(k), label=name) for k, name in enumerate(used)]
    axis.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=7)


def label(axis: Any, records: Sequence[Record], title: str) -> None:
    """Title, and some labels at the middles of the cells."""
    axis.set_title(title, fontsize=9)
    axis.set_xlabel(records[0]["labels"][0])
    axis.set_facecolor("0.85")
    columns = {record["column"]: record["at"][0] for record in records}
    rows = {record["row"]: record["at"][1] for record in records}
    for set_ticks, names, turn in ((axis.set_xticks, columns, 90), (axis.set_yticks, rows, 0)):
        chosen = list(names)[:: -(-len(names) // MOST_LABELS)]
        set_ticks([k + 0.5 for k in chosen], [names[k] for k in chosen], fontsize=7, rotation=turn)


def draw_line(records: Sequence[Record]) -> Any:
    """A map of one row: error in bounds, and time, of every solver."""
    drawing = figure(figsize=(10, 4), layout="constrained")
    left, right = drawing.subplots(1, 2)
    for axis in (left, right):
        axis.set(xscale="log", yscale="log", xlabel=records[0]["labels"][0])
        axis.grid(alpha=0.3)
    solvers = [one["solver"] for one in records[0]["solvers"]]
    for sign, colour, solver in zip("osv^Dx", COLOURS, solvers, strict=False):
        known = [(float(r["at"][0]), one) for r, one in of(records, solver) if one["bounds"] is not None]
        for axis, name, least in ((left, "bounds", 0.1), (right, "seconds", 0.0)):
            values = [max(one[name], least) for _, one in known]
            style = {"color": colour, "marker": sign, "ms": 5, "mfc": "white", "label": TITLES[solver]}
            axis.plot([at for at, _ in known], values, **style)
    left.axhline(1, color="0.5", lw=0.8)
    left.set_ylabel("worst error in bounds")
    right.set_ylabel("seconds")
    drawing.legend(*right.get_legend_handles_labels(), loc="outside lower center", ncols=len(solvers), fontsize=8)
    drawing.suptitle(records[0]["title"] + "; a line that ends has no values beyond")
    return drawing
