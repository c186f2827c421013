"""The kernels as a module like those emitted, of any load case: what the hard suites are run on."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.shapes import angle_and_position


def equilibria(beta: float, eta: float, length: float, clamp_angle: float, field_angle: float) -> list[Any]:
    """All of them, without limit to the index."""
    found: list[Any] = all_equilibria(beta, eta, length, clamp_angle, field_angle, None)
    return found


def shape(equilibrium: Any, s: Any) -> SimpleNamespace:
    """θ, θ′, y and z at arc lengths, one by one."""
    at = np.asarray(s, dtype=float)
    rows = [angle_and_position(equilibrium, float(part)) for part in at.ravel()]
    theta, curvature, y, z = (np.array(column).reshape(at.shape)[()] for column in zip(*rows, strict=True))
    return SimpleNamespace(theta=theta, curvature=curvature, y=y, z=z)
