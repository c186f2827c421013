"""Heat maps of the atlas: for every map the solvers beside one another on one colour scale, failures marked.

Colours are those of cividis, which colour-blind readers see as others do; failures are told by signs, not by colour.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from derive.measure.atlas_points import OURS
from derive.measure.atlas_stiff import ALL_PEERS

TITLES = {OURS: "ours", **{name: peer.title for name, peer in ALL_PEERS.items()}}
LOWEST, HIGHEST = -1.0, 16.0  # powers of ten of the error in bounds
SIGNS = (
    ("no value", "x", "no value"),
    ("raises", "x", "no value"),
    ("nan", "x", "no value"),
    ("wrong digits", "v", "half of the digits lost"),
    ("wrong number", "s", "wrong number of equilibria"),
    ("missed", "s", "wrong number of equilibria"),
)
"""Kind of failure, its sign, and what the legend says; the first that applies is drawn. Others are a diamond."""
OTHER = ("D", "other failure")
MOST_LABELS = 8
# Told apart without colour vision (Okabe and Ito).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")


def plotting() -> Any:
    """matplotlib without a screen; ImportError in one line if it is missing."""
    try:
        import matplotlib
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install 'magnetic-rods[pictures]'") from error
    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot


def draw_atlas(data: dict[str, Any], folder: Path) -> list[Path]:
    """All pictures of an atlas, SVG and PNG, in a folder; their paths."""
    pyplot, files = plotting(), {}
    for chart in data["maps"]:
        records = [record for record in data["records"] if record["map"] == chart["name"]]
        draw = draw_line if len(chart["ys"]) == 1 else draw_map
        with pyplot.rc_context({"svg.hashsalt": "atlas", "font.size": 9}):
            figure = draw(pyplot, chart, records)
            for kind, extra in (("svg", {"metadata": {"Date": None}}), ("png", {"dpi": 110})):
                files[folder / f"atlas_{chart['name']}.{kind}"] = _bytes(figure, kind, extra)
            pyplot.close(figure)
    for path, content in files.items():
        write_whole(path, content)
    return sorted(files)


def _bytes(figure: Any, kind: str, extra: dict[str, Any]) -> bytes:
    stream = BytesIO()
    figure.savefig(stream, format=kind, **extra)
    return stream.getvalue()


def write_whole(path: Path, content: bytes) -> None:
    """Write a file under another name first, then move it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def draw_map(pyplot: Any, chart: dict[str, Any], records: Sequence[dict[str, Any]]) -> Any:
    """Error of every solver in bounds, then our condition number and the forms that were used."""
    solvers = [OURS, *chart["peers"]]
    panels = len(solvers) + 2
    figure, axes = pyplot.subplots(1, panels, figsize=(1.2 + 2.6 * panels, 4.2), sharey=True, layout="constrained")
    shown: dict[str, str] = {}
    for axis, solver in zip(axes, solvers, strict=False):
        of = [record for record in records if record["solver"] == solver]
        image = axis.pcolormesh(
            grid(chart, of, "bounds", LOWEST), cmap="cividis", vmin=LOWEST, vmax=HIGHEST, edgecolors="white", lw=0.2
        )
        mark(axis, of, shown)
        label_axes(axis, chart, TITLES[solver])
    bar = figure.colorbar(image, ax=list(axes[: len(solvers)]), shrink=0.8, pad=0.01)
    bar.set_label("log₁₀ of the worst error in bounds")
    ours = [record for record in records if record["solver"] == OURS]
    image = axes[-2].pcolormesh(grid(chart, ours, "condition", -3.0), cmap="cividis", edgecolors="white", lw=0.2)
    label_axes(axes[-2], chart, "condition number, log₁₀")
    figure.colorbar(image, ax=axes[-2], shrink=0.8, pad=0.02)
    forms(pyplot, axes[-1], chart, ours)
    axes[0].set_ylabel(chart["y_label"])
    figure.suptitle(chart["title"])
    handles = [
        pyplot.Line2D([], [], color="black", marker=sign, mfc="white", ls="", label=text)
        for text, sign in shown.items()
    ]
    if handles:
        figure.legend(handles=handles, loc="outside lower left", ncols=len(handles), frameon=False)
    return figure


def grid(chart: dict[str, Any], records: Sequence[dict[str, Any]], name: str, least: float) -> Any:
    """log₁₀ of a number of the records, no less than ``least``; masked where there is none."""
    values = np.ma.masked_all((len(chart["ys"]), len(chart["xs"])))
    for record in records:
        if record[name] is not None:
            values[record["row"], record["column"]] = max(least, np.log10(max(record[name], 1e-300)))
    return values


def mark(axis: Any, records: Sequence[dict[str, Any]], shown: dict[str, str]) -> None:
    """Signs where a solver fails."""
    for record in records:
        kinds = {failure.split(":")[0] for failure in record["failures"]}
        if not kinds:
            continue
        known = [(sign, text) for kind, sign, text in SIGNS if kind in kinds]
        sign, text = known[0] if known else OTHER
        shown[text] = sign
        place = (record["column"] + 0.5, record["row"] + 0.5)
        axis.plot(*place, marker=sign, color="black", mfc="white", ms=4, mew=0.8)


def forms(pyplot: Any, axis: Any, chart: dict[str, Any], records: Sequence[dict[str, Any]]) -> None:
    """Which forms our module used: a colour for each set of them."""
    used = sorted({", ".join(record["formulas"]) for record in records})
    values = np.ma.masked_all((len(chart["ys"]), len(chart["xs"])))
    for record in records:
        values[record["row"], record["column"]] = used.index(", ".join(record["formulas"]))
    colours = pyplot.get_cmap("cividis", max(2, len(used)))
    axis.pcolormesh(values, cmap=colours, vmin=-0.5, vmax=max(2, len(used)) - 0.5, edgecolors="white", lw=0.2)
    label_axes(axis, chart, "forms used by ours")
    handles = [pyplot.Rectangle((0, 0), 1, 1, color=colours(k), label=name or "none") for k, name in enumerate(used)]
    axis.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=7, frameon=False)


def label_axes(axis: Any, chart: dict[str, Any], title: str) -> None:
    """Title, and some labels at the middles of the cells."""
    axis.set_title(title, fontsize=9)
    axis.set_xlabel(chart["x_label"])
    axis.set_facecolor("0.85")
    for set_ticks, names in ((axis.set_xticks, chart["xs"]), (axis.set_yticks, chart["ys"])):
        step = -(-len(names) // MOST_LABELS)
        places = range(0, len(names), step)
        turn = {"rotation": 90} if set_ticks == axis.set_xticks else {}
        set_ticks([k + 0.5 for k in places], [names[k] for k in places], fontsize=7, **turn)


def draw_line(pyplot: Any, chart: dict[str, Any], records: Sequence[dict[str, Any]]) -> Any:
    """A map of one row: error in bounds, and time, of every solver."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    at, solvers = [float(x) for x in chart["xs"]], [OURS, *chart["peers"]]
    for sign, colour, solver in zip("osv^Dx", COLOURS, solvers, strict=False):
        of = {record["column"]: record for record in records if record["solver"] == solver}
        for axis, name in ((left, "bounds"), (right, "seconds")):
            known = [k for k in of if of[k][name] is not None and (name == "bounds" or of[k]["bounds"] is not None)]
            values = [max(of[k][name], 0.1 if name == "bounds" else 0) for k in known]
            axis.plot(
                [at[k] for k in known], values, color=colour, marker=sign, ms=5, mfc="white", label=TITLES[solver]
            )
    left.axhline(1, color="0.5", lw=0.8)
    left.set_ylabel("worst error in bounds")
    right.set_ylabel("seconds")
    for axis in (left, right):
        axis.set(xscale="log", yscale="log", xlabel=chart["x_label"])
        axis.grid(alpha=0.3)
    right.legend(fontsize=7)
    figure.suptitle(chart["title"] + "; a line that ends has no values beyond")
    return figure
