"""A fan of shapes: one rod, one force, a field of one strength that turns."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from derive.report.figures import style
from derive.report.figures.deformed import base
from generated.oblique_numpy import equilibria, shape

BETA, ETA, LENGTH, CLAMP = 0.0001, 0.001, 80.0, pi / 2
TURNS = 12


def draw(figure: Any) -> None:
    """All equilibria for each direction of the field: a cyclic colour, since half a turn of the field is no change."""
    import matplotlib
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    figure.set_size_inches(5.6, 5.2)
    axes = figure.add_subplot()
    s, colours = np.linspace(0, LENGTH, 161), matplotlib.colormaps["twilight_shifted"]
    for field_angle in np.arange(TURNS) * pi / TURNS:
        for one in equilibria(BETA, ETA, LENGTH, CLAMP, float(field_angle)):
            curve = shape(one, s)
            x, w = style.along(curve.y, curve.z, CLAMP), style.across(curve.y, curve.z, CLAMP)
            axes.plot(x, w, ls=style.line_of(one.index), lw=1.4, color=colours(field_angle / pi))
    base(axes)
    style.arrow(axes, (10, 40), -pi / 2, 14, r"$\mathbf{F}$")
    bar = figure.colorbar(ScalarMappable(Normalize(0, 180), colours), ax=axes, shrink=0.7)
    bar.set_label("angle from the force to the field, degrees")
    axes.set_title(
        rf"$\ell = 80$, $\vartheta_{{\mathrm{{o}}}} = \pi/2$, $\beta = {BETA:g}$, $\eta = {ETA:g}$", fontsize=10
    )
