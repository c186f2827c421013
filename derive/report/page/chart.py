"""Error against time as SVG inside the page: a line and a mark for each method, on logarithmic axes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from markupsafe import Markup

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 660, 320, 64, 12, 26, 40
LEGEND = 18  # height of a line
LEAST = 1e-20  # smaller errors are drawn here
COLOURS = 6  # in the style sheet, told apart by colour-blind readers
# Marks around (0, 0); a method is told by its mark even without colour.
MARKS = (
    "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z", "M-4,-4h8v8h-8z", "M0,-5L5,4H-5z", "M0,-5.5L5,0L0,5.5L-5,0z",
    "M-4,-4L4,4M-4,4L4,-4", "M0,-5V5M-5,0H5", "M0,5L5,-4H-5z",
)  # fmt: skip


class Point(NamedTuple):
    """One way of solving a problem: time in seconds, error in its own unit."""

    method: str
    seconds: float
    error: float
    label: str
    ours: bool


def chart(points: Sequence[Point], across: str, up: str) -> Markup:
    """The picture; empty without points."""
    if not points:
        return Markup("")
    methods = list(dict.fromkeys(one.method for one in points))
    at_x = axis([one.seconds for one in points], LEFT, WIDTH - RIGHT)
    at_y = axis([max(one.error, LEAST) for one in points], HEIGHT - BOTTOM, TOP)
    parts = [*grid(points, at_x, at_y), text(WIDTH / 2, HEIGHT - 4, across, "middle"), text(4, 14, up)]
    for number, method in enumerate(methods):
        own = [one for one in points if one.method == method]
        parts += series(own, number, at_x, at_y)
        y = HEIGHT + LEGEND * (number // 2) + 12
        x = LEFT + (number % 2) * (WIDTH - LEFT) / 2
        parts += [mark(number, x, y - 4, own[0].ours, method), text(x + 12, y, method)]
    whole = HEIGHT + LEGEND * ((len(methods) + 1) // 2) + 8
    shape = Markup('<svg viewBox="0 0 {} {}" role="img" aria-label="{} against {}">{}</svg>')
    return shape.format(WIDTH, whole, up, across, Markup("").join(parts))


def axis(values: Sequence[float], start: float, end: float) -> Callable[[float], float]:
    """Where a value stands on a logarithmic axis of whole decades."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    high = max(high, low + 1)
    return lambda value: round(start + (end - start) * (math.log10(value) - low) / (high - low), 1)


def grid(points: Sequence[Point], at_x: Callable[[float], float], at_y: Callable[[float], float]) -> list[Markup]:
    """Lines at decades, with the powers of ten."""
    found = []
    for power in decades([one.seconds for one in points], 1):
        x = at_x(10.0**power)
        found += [line(x, TOP, x, HEIGHT - BOTTOM), text(x, HEIGHT - BOTTOM + 15, f"1e{power}", "middle")]
    for power in decades([max(one.error, LEAST) for one in points], 2):
        y = at_y(10.0**power)
        found += [line(LEFT, y, WIDTH - RIGHT, y), text(LEFT - 6, y + 4, f"1e{power}", "end")]
    return found


def decades(values: Sequence[float], step: int) -> range:
    """The powers of ten that are marked."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return range(low, max(high, low + 1) + 1, step)


def series(
    points: Sequence[Point], number: int, at_x: Callable[[float], float], at_y: Callable[[float], float]
) -> list[Markup]:
    """A method through its settings."""
    places = [(at_x(one.seconds), at_y(max(one.error, LEAST))) for one in points]
    path = " ".join(f"{x},{y}" for x, y in places)
    drawn = Markup('<polyline class="c{}" points="{}"/>').format(number % COLOURS, path)
    return [drawn, *(mark(number, *place, one.ours, one.label) for place, one in zip(places, points, strict=True))]


def mark(number: int, x: float, y: float, full: bool, title: str) -> Markup:
    """A mark with what it stands for; ours are full."""
    kind = f"c{number % COLOURS}{' full' if full else ''}"
    shape = Markup('<path class="{}" transform="translate({} {})" d="{}"><title>{}</title></path>')
    return shape.format(kind, x, y, MARKS[number % len(MARKS)], title)


def line(x: float, y: float, to_x: float, to_y: float) -> Markup:
    """A line of the grid."""
    return Markup('<line x1="{}" y1="{}" x2="{}" y2="{}"/>').format(x, y, to_x, to_y)


def text(x: float, y: float, said: str, anchor: str = "start") -> Markup:
    """Words."""
    return Markup('<text x="{}" y="{}" text-anchor="{}">{}</text>').format(x, y, anchor, said)
