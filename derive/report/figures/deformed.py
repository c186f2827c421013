"""Deformed axes in the laboratory: the second example's, and what a field and a force do each by itself."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from derive.report.figures import style
from derive.report.figures.bifurcation import CLAMP, FORCES, LENGTH
from generated import field_only_numpy, force_only_numpy, parallel_numpy

S = np.linspace(0, LENGTH, 201)
WEAK_FIELD = 0.0002
THREE = (0.00035, 0.00052)
# Each load by itself, at clamp angles on either side of the right angle.
FORCE = "force alone, $\\beta = {:g}$"
SEPARATE = (("$\\vartheta_{\\mathrm{o}} = 3\\pi/4$", 3 * pi / 4), ("$\\vartheta_{\\mathrm{o}} = \\pi/4$", pi / 4))


def axis(axes: Any, module: Any, one: Any, clamp_angle: float, **look: Any) -> None:
    """The axis of an equilibrium, with the undeformed one to the right."""
    curve = module.shape(one, S)
    x, w = style.along(curve.y, curve.z, clamp_angle), style.across(curve.y, curve.z, clamp_angle)
    axes.plot(x, w, ls=style.line_of(one.index), **look)


def base(axes: Any) -> None:
    """The clamp and the undeformed axis."""
    axes.plot([0, LENGTH], [0, 0], color=style.GREY, lw=0.8, ls=":")
    style.clamp(axes, 7)
    style.plane(axes)


def draw(figure: Any) -> None:
    """Left: one field, eight forces. Right: one rod, three equilibria."""
    figure.set_size_inches(7.4, 5.2)
    left, right = figure.subplots(1, 2, sharey=True)
    for number, (beta, colour) in enumerate(zip(FORCES, style.COLOURS, strict=True), start=1):
        for one in parallel_numpy.equilibria(beta, WEAK_FIELD, LENGTH, CLAMP):
            axis(left, parallel_numpy, one, CLAMP, color=colour, label=rf"{number}: $\beta = {beta:g}$")
    found = parallel_numpy.equilibria(*THREE, LENGTH, CLAMP)
    for one, colour in zip(found, style.COLOURS, strict=False):
        name = "stable" if one.index == 0 else "unstable"
        label = rf"$\vartheta(\ell) = {one.tip_angle:.3f}$, {name}"
        axis(right, parallel_numpy, one, CLAMP, color=colour, label=label)
    left.set_title(rf"$\eta = {WEAK_FIELD:g}$", fontsize=10)
    right.set_title(rf"$\beta = {THREE[0]:g}$, $\eta = {THREE[1]:g}$", fontsize=10)
    for axes in (left, right):
        base(axes)
        style.arrow(axes, (14, 64), -3 * pi / 4, 14, r"$\mathbf{F}$")
        style.arrow(axes, (27, 64), -3 * pi / 4, 14, r"$\mathbf{h}_{\mathrm{a}}$")
        axes.set(xlim=(-6, 84), ylim=(-70, 70))
        axes.legend(fontsize=8, loc="upper right")


def draw_separate(figure: Any) -> None:
    """For two clamp angles: the rod in the field alone, and under the force alone, all stable equilibria."""
    figure.set_size_inches(7.4, 5.2)
    for axes, (title, clamp_angle) in zip(figure.subplots(1, 2, sharey=True), SEPARATE, strict=True):
        base(axes)
        loads = ((field_only_numpy, 0.0004, "field alone, $\\eta = {:g}$"), (force_only_numpy, 0.0002, FORCE))
        for (module, load, label), colour in zip(loads, style.COLOURS, strict=False):
            for k, one in enumerate(module.equilibria(load, LENGTH, clamp_angle, max_index=0)):
                axis(axes, module, one, clamp_angle, color=colour, label=None if k else label.format(load))
        style.arrow(axes, (16, 60), -clamp_angle, 14, r"$\mathbf{F}$")
        style.arrow(axes, (36, 60), -clamp_angle, 14, r"$\mathbf{h}_{\mathrm{a}}$")
        axes.set(xlim=(-6, 84), ylim=(-70, 75), title=title)
        axes.legend(fontsize=8, loc="lower left")
