"""The shape of a rod at an array of points, by the way that is fastest for them."""

from __future__ import annotations

import numpy as np

from derive.emit.kernels.expansion import bins_of, period_of
from derive.emit.kernels.lookup import by_lookup
from derive.emit.kernels.runs import by_runs, cells_for
from derive.emit.kernels.shapes import angle_and_position

FEW = 64  # points up to which each is computed by itself
SHORTEST = 2  # bins in a unit of a rod's own length, at least: of a long rod with few points most would have none


def shape_at(equilibrium, s, position=True):
    """θ, θ′, y and z at an array of arc lengths, each in the shape of s; y and z are None without ``position``."""
    flat = np.ravel(s)
    if equilibrium.swing is None:
        values = angle_and_position(equilibrium, flat)
    elif flat.size <= max(FEW, SHORTEST * (period_of(equilibrium)[0] or equilibrium.rod.length)):
        values = np.array([angle_and_position(equilibrium, place) for place in flat.tolist()]).reshape(-1, 4).T
    else:
        values = by_series(equilibrium, flat, position)
    theta, curvature, y, z = (None if part is None else np.reshape(part, np.shape(s)) for part in values)
    return (theta, curvature, y, z) if position else (theta, curvature, None, None)


def by_series(equilibrium, s, position):
    """``shape_at`` by power series in bins along the rod."""
    bins = bins_of(equilibrium, position)
    cells = cells_for(equilibrium, bins, s.size)
    if cells and np.all(s[1:] >= s[:-1]):
        return by_runs(equilibrium, bins, cells, s, position)
    return by_lookup(equilibrium, bins, s, position)
