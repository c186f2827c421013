"""What an emitted module offers: equilibria, shape, sweep, literal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from derive.emit.kernels.arguments import Given, check
from derive.emit.kernels.arithmetic import real
from derive.emit.kernels.equilibria import Equilibrium, all_equilibria
from derive.emit.kernels.literal import angle_and_position_literally
from derive.emit.kernels.shapes import angle_and_position


@dataclass(frozen=True, slots=True)
class Shape:
    """A rod at the arc lengths asked for: theta (from y to the tangent), curvature θ′, and the position y, z."""

    theta: Any
    curvature: Any
    y: Any
    z: Any


@dataclass(frozen=True, slots=True)
class Sweep:
    """The equilibria of many rods, flat: case[k] is the index of the rod (in the order of the broadcast arrays)."""

    case: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


def equilibria(beta, eta, length, clamp_angle) -> list[Equilibrium]:
    """All equilibria of one rod, sorted by tip angle.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    eta: magnetic modulus over bending stiffness, η̃/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    check(beta, eta, length, clamp_angle)
    return all_equilibria(
        real("beta", beta), real("eta", eta), real("length", length), real("clamp_angle", clamp_angle)
    )


def shape(equilibrium: Equilibrium, s) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or an array within [0, length].

    theta, curvature, y and z have the shape of s. Raises ValueError where an s is not on the rod.
    """
    s = np.asarray(s, dtype=float)
    if not np.all((s >= 0) & (s <= equilibrium.rod.length)):
        raise ValueError(f"s must lie in [0, {equilibrium.rod.length!r}], the rod")
    return Shape(*angle_and_position(equilibrium, s))


def literal(equilibrium: Equilibrium, s) -> Shape:
    """The same as ``shape`` by the article's own formulas, to be compared with it.

    Of the equilibrium it takes gamma and the tip angle, and its rod. It loses digits where the solver loses none: half
    of those of theta and z where the rod is straight up or down or its curvature vanishes, as at the tip, and ever
    more where two roots of f come near. Raises ValueError where the formulas have no value: two of the roots meet to
    rounding (so for a straight rod), or a load by which they divide is 0; and where an s is not on the rod.
    """
    s = np.asarray(s, dtype=float)
    if not np.all((s >= 0) & (s <= equilibrium.rod.length)):
        raise ValueError(f"s must lie in [0, {equilibrium.rod.length!r}], the rod")
    return Shape(*angle_and_position_literally(equilibrium, s))


def sweep(beta, eta, length, clamp_angle) -> Sweep:
    """All equilibria of many rods: the arguments are numbers or arrays, broadcast against one another.

    Raises ValueError where they do not broadcast, and as ``equilibria`` does for each value, before any work.
    """
    given = Given(beta, eta, length, clamp_angle)
    rods = list(zip(*(part.ravel().tolist() for part in np.broadcast_arrays(*given)), strict=True))
    for rod in rods:
        check(*rod)
    found = [(case, item) for case, rod in enumerate(rods) for item in equilibria(*rod)]
    return Sweep(
        np.array([case for case, _ in found], dtype=int),
        np.array([item.tip_angle for _, item in found], dtype=float),
        np.array([item.clamp_curvature for _, item in found], dtype=float),
        np.array([item.gamma for _, item in found], dtype=float),
        np.array([item.y for _, item in found], dtype=float),
        np.array([item.z for _, item in found], dtype=float),
        np.array([item.energy for _, item in found], dtype=float),
        np.array([item.index for _, item in found], dtype=int),
    )
