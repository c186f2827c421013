"""Error against time as a picture: a line for each method through its settings, labelled at its end."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from derive.diagrams.plotting import COLOURS, canvas, save
from derive.measure.work.cells import ARTICLE, OURS
from derive.measure.work.fronts import Record, comparable, front, point

LEAST, MOST = 1e-18, 1.0  # errors beyond are in the tables: twins go on to hundreds of digits
INK = "#222222"
PEER_MARKS = "sD^vPX*hd<>p"
APART = 11.0  # points between the lines of labels


def draw(records: Sequence[Record], paths: Sequence[Path]) -> None:
    """One problem. Hollow marks: what does a part of the task, or misses some of what there is."""
    shown = [r for r in records if r["errors"]["worst"] is not None and r["errors"]["worst"] <= MOST]
    shown = [r for r in shown if r["errors"]["worst"] >= LEAST or r["errors"]["worst"] == 0]
    for path in paths:
        figure, axes = canvas(path, 8.4, 5.2)
        axes.set_xscale("log")
        axes.set_yscale("log")
        labels = lines(axes, shown)
        best = [point(r) for r in front(shown)]
        if best:
            axes.step(*zip(*best, strict=True), where="post", color="#bbbbbb", lw=6, zorder=0, solid_capstyle="round")
        finish(axes, records, shown)
        place(figure, axes, labels)
        save(figure, path)


def lines(axes: Any, shown: Sequence[Record]) -> list[tuple[str, str, tuple[float, float]]]:
    """A line for each method; gives labels with colours and where they belong."""
    labels, number = [], 0
    for method in dict.fromkeys(record["method"] for record in shown):
        rows = [record for record in shown if record["method"] == method]
        colour, mark = {OURS: (COLOURS[0], "o"), ARTICLE: (COLOURS[1], "o")}.get(rows[0]["group"], ("", ""))
        if not colour:
            colour, mark = COLOURS[2 + number % (len(COLOURS) - 2)], PEER_MARKS[number % len(PEER_MARKS)]
            number += 1
        own = rows[0]["group"] == OURS
        points = [(point(r)[0], max(point(r)[1], LEAST)) for r in rows]
        axes.plot(*zip(*points, strict=True), "-", color=colour, lw=1.8 if own else 1.0, alpha=0.7, zorder=2)
        for record, at in zip(rows, points, strict=True):
            face = colour if comparable(record) else "white"
            size = 8 if own else 6
            axes.plot(*at, mark, color=colour, mfc=face, ms=size, mew=1.3, zorder=3)
        labels.append((method, colour, points[-1]))
    return labels


def finish(axes: Any, records: Sequence[Record], shown: Sequence[Record]) -> None:
    """Names of the axes, floors, room for labels."""
    first = records[0]
    axes.set_xlabel(f"seconds a {first['unit']}")
    axes.set_ylabel("worst error")
    axes.set_title(f"{first['task']}: {first['title']}", loc="left", fontsize=12)
    axes.grid(True, which="major", color="#e6e6e6", lw=0.6, zorder=-1)
    if shown:
        low, high = axes.get_xlim()
        axes.set_xlim(low / 1.3, high * (high / low) ** 0.3)
    for record in records:
        if record["errors"]["worst"] is None and not record["whole"]:
            axes.axvline(record["seconds"]["median"], color="#777777", lw=1, ls=":")
            label = f" {record['method']}"
            at = (record["seconds"]["median"], 0.99)
            axes.text(*at, label, transform=axes.get_xaxis_transform(), fontsize=9, color="#555555", va="top")


def place(figure: Any, axes: Any, labels: Sequence[tuple[str, str, tuple[float, float]]]) -> None:
    """Each label right of its mark, moved up or down until no two overlap, with a thin line where it was moved far."""
    figure.canvas.draw()
    scale = 72 / figure.dpi
    spots = [(text, colour, at, axes.transData.transform(at) * scale) for text, colour, at in labels]
    taken: list[tuple[float, float, float]] = []
    for text, colour, at, spot in sorted(spots, key=lambda one: one[3][1]):
        x, y = spot[0] + 9, spot[1] - 4
        width = 6.0 * len(text)
        while any(abs(y - other) < APART and x < right and x + width > left for left, right, other in taken):
            y += 2
        taken.append((x, x + width, y))
        arrow = (
            {"arrowstyle": "-", "color": colour, "lw": 0.6, "shrinkA": 0, "shrinkB": 3} if y > spot[1] + 10 else None
        )
        offset = (x - spot[0], y - spot[1])
        ink = colour if colour != "#e69f00" else "#a06e00"
        axes.annotate(text, at, offset, textcoords="offset points", color=ink, fontsize=9.5, arrowprops=arrow)
