"""Error against time as a picture for each problem: a line for each method through its settings, and the front."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from derive.diagrams.plotting import COLOURS, figure, saved, settings
from derive.measure.bench.cells import ARTICLE, OURS
from derive.measure.bench.families import Record
from derive.measure.bench.fronts import at_once, comparable, complete, front, point

LEAST, MOST = 1e-36, 1.0  # errors beyond are in the tables: twins go on to hundreds of digits
LEAST_SPANS = {"x": 100.0, "y": 1e4}  # of times and errors: what differs by less is noise, or the last rounding
OWN_MARKS, MARKS = "os^", "sD^vPX<>*d8"
FRONT, QUIET = "#cccccc", "#777777"


def pictures(records: Sequence[Record], kind: str) -> Iterator[tuple[str, bytes]]:
    """Names and bytes: one for each problem; a method looks the same in all of them."""
    looks = styles(records)
    for problem in dict.fromkeys(record["problem"] for record in records):
        with settings(**{"font.size": 11}):
            drawing = figure(figsize=(7.6, 4.8))
            draw(drawing.add_subplot(), [record for record in records if record["problem"] == problem], looks)
            yield problem, saved(drawing, kind, bbox_inches="tight")


def draw(axes: Any, records: Sequence[Record], looks: Mapping[str, tuple[str, str]]) -> None:
    """One problem. Hollow marks: what does a part of the task, or misses some; half-filled ones: many at once."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    shown = [record for record in records if in_sight(record)]
    if best := [(seconds, max(error, LEAST)) for seconds, error in map(point, front(shown))]:
        axes.step(*zip(*best, strict=True), where="post", color=FRONT, lw=7, zorder=0, label="front")
        axes.plot(*zip(*best, strict=True), "o", color=FRONT, ms=14, zorder=0)
    for method, look in looks.items():
        lines(axes, [record for record in shown if record["method"] == method], method, *look)
    for record in records:
        if record["errors"]["worst"] is None and not record["whole"]:
            label = f"{record['method']}, {record['setting']}"
            axes.axvline(record["seconds"]["median"], color=QUIET, lw=1.2, ls=":", label=label)
    first = records[0]
    axes.set_xlabel(f"seconds a {first['unit']}")
    axes.set_ylabel("worst error")
    axes.set_title(f"{first['problem']}: {first['title']}", loc="left", fontsize=12)
    widen(axes)
    axes.grid(True, which="major", color="#e9e9e9", lw=0.6, zorder=-1)
    if not all(comparable(record) or at_once(record) for record in shown):
        axes.plot([], [], "o", color=QUIET, mfc="white", label="hollow: in part, or not all found")
    if any(map(at_once, shown)):
        axes.plot([], [], "o", color=QUIET, mfcalt="white", fillstyle="left", label="half: one of many solved at once")
    axes.legend(fontsize=9, loc="upper left", bbox_to_anchor=(1.01, 1.0))


def widen(axes: Any) -> None:
    """Give each axis its least span, and no labels between powers of ten, which may overlap."""
    for name, span in LEAST_SPANS.items():
        low, high = getattr(axes, f"get_{name}lim")()
        more = max(1.0, span * low / high) ** 0.5
        getattr(axes, f"set_{name}lim")(low / more, high * more)
        getattr(axes, f"{name}axis").set_minor_formatter("")


def in_sight(record: Record) -> bool:
    """Whether it has a place in the picture."""
    worst = record["errors"]["worst"]
    return worst is not None and (worst == 0 or LEAST <= worst <= MOST)


def styles(records: Sequence[Record]) -> dict[str, tuple[str, str]]:
    """Colour and mark of each method, in the order of the tables; ours and the article's have colours of their own."""
    found: dict[str, tuple[str, str]] = {}
    number = 0
    for method, group in dict.fromkeys((record["method"], record["group"]) for record in records):
        if group in (OURS, ARTICLE):
            same = sum(colour == COLOURS[group == ARTICLE] for colour, _ in found.values())
            found[method] = COLOURS[group == ARTICLE], OWN_MARKS[same % len(OWN_MARKS)]
        else:
            found[method] = COLOURS[2 + number % (len(COLOURS) - 2)], MARKS[number % len(MARKS)]
            number += 1
    return found


def lines(axes: Any, rows: Sequence[Record], method: str, colour: str, mark: str) -> None:
    """A method through its settings."""
    if rows:
        own = rows[0]["group"] == OURS
        points = [(point(record)[0], max(point(record)[1], LEAST)) for record in rows]
        axes.plot(*zip(*points, strict=True), "-", color=colour, lw=1.6 if own else 0.9, alpha=0.6, zorder=2)
        axes.plot([], [], f"-{mark}", color=colour, label=method)
        for record, at in zip(rows, points, strict=True):
            filled = complete(record) and record["whole"]
            style = {"mfc": colour if filled else "white", "mfcalt": "white"}
            style["fillstyle"] = "left" if at_once(record) else "full"
            axes.plot(*at, mark, color=colour, ms=8 if own else 6, mew=1.3, zorder=3, **style)
