"""Where the second example gains or loses two equilibria, in the plane of β and η, and where its diagrams change."""

from __future__ import annotations

from itertools import groupby
from typing import Any

import numpy as np

from derive.emit.kernels.exchanges import Exchange, all_exchanges
from derive.emit.kernels.folds import Fold, all_folds
from derive.report.figures import style
from derive.report.figures.bifurcation import CLAMP, FORCES, LENGTH

HIGHEST = (0.0005, 0.0017)
# Between these the set turns back at a cusp, and again where branches exchange.
BEFORE, AFTER = 0.0003, 0.0004


def folds_at(beta: float) -> list[Fold]:
    """The folds for one force."""
    return all_folds(beta, LENGTH, CLAMP, 0.0, 0.0, HIGHEST[1])


def cusp(low: float, high: float) -> float:
    """The least β in the range at which a diagram has more folds than at its lower end, to 1e-6 of β."""
    few = len(folds_at(low))
    while high - low > 1e-6 * high:
        middle = (low + high) / 2
        low, high = (middle, high) if len(folds_at(middle)) == few else (low, middle)
    return high


def folds_by_tip(exchange: Exchange) -> list[tuple[float, Fold]]:
    """(β, fold) along the set: for this rod it is one curve, on which the tip angle rises. Closer where it turns."""
    start, near = cusp(BEFORE, exchange.beta * (1 - 1e-6)), np.linspace(0.005, 1, 25) ** 2
    half = (exchange.beta - start) / 2
    betas: Any = [np.linspace(0, HIGHEST[0], 31), start + half * near, exchange.beta - half * near, [start]]
    found = [(float(beta), one) for beta in np.concatenate(betas) for one in folds_at(float(beta))]
    return sorted(found, key=lambda item: item[1].tip_angle)


def draw(figure: Any) -> None:
    """The whole set, and the surroundings of the organising point enlarged."""
    figure.set_size_inches(8.6, 4.4)
    left, right = figure.subplots(1, 2)
    (point,) = all_exchanges(LENGTH, CLAMP, 0.0, BEFORE, AFTER, 0.0, HIGHEST[1])
    curve = folds_by_tip(point)
    for axes in (left, right):
        draw_set(axes, curve)
        label = rf"branches exchange: $\beta^* = {point.beta:.9f}$"
        axes.plot(point.beta, point.eta, "D", ms=6, color=style.COLOURS[1], label=label, zorder=4)
    for number, beta in enumerate(FORCES, start=1):
        left.axvline(beta, color=style.GREY, lw=0.5, ls=":")
        left.text(beta, 1.01, str(number), transform=left.get_xaxis_transform(), ha="center", color=style.GREY)
    left.text(0.00008, 0.0006, "1 equilibrium")
    left.text(0.000315, 0.0012, "3 equilibria")
    left.set(xlim=(-0.00001, HIGHEST[0] + 0.00001), ylim=(0, HIGHEST[1]))
    right.set(xlim=(0.0003, 0.00031), ylim=(0.00031, 0.00054))
    right.ticklabel_format(style="sci", axis="both", scilimits=(-4, -4))
    right.legend(fontsize=8, loc="lower right")
    for axes in (left, right):
        axes.set(xlabel=r"$\beta$", ylabel=r"$\eta$")


def draw_set(axes: Any, curve: list[tuple[float, Fold]]) -> None:
    """One line for each stretch: two equilibria appear there as η grows, or two vanish."""
    named: set[int] = set()
    last: tuple[float, Fold] | None = None
    for change, items in groupby(curve, key=lambda item: item[1].change):
        stretch = list(items)
        joined = stretch if last is None else [last, *stretch]
        label = None if change in named else ("two appear with η" if change > 0 else "two vanish with η")
        colour, look = (style.COLOURS[0], "-") if change > 0 else (style.COLOURS[2], "-.")
        axes.plot([beta for beta, _ in joined], [one.eta for _, one in joined], ls=look, color=colour, label=label)
        named.add(change)
        last = stretch[-1]
