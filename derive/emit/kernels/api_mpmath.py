"""The interface of the mpmath twin, where arrays are lists: what differs from ``api``."""

from __future__ import annotations

from collections.abc import Iterable

from derive.emit.kernels.api import Shape, Sweep, equilibria
from derive.emit.kernels.arguments import Given, check
from derive.emit.kernels.arithmetic import real
from derive.emit.kernels.equilibria import Equilibrium
from derive.emit.kernels.literal import angle_and_position_literally
from derive.emit.kernels.shapes import angle_and_position


def shape(equilibrium: Equilibrium, s) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or a sequence of them within [0, length].

    theta, curvature, y and z are numbers, or lists as long as s. Raises ValueError where an s is not on the rod.
    """
    places = [real("s", place) for place in s] if isinstance(s, Iterable) else [real("s", s)]
    if not all(0 <= place <= equilibrium.rod.length for place in places):
        raise ValueError(f"s must lie in [0, {equilibrium.rod.length!r}], the rod")
    rows = [angle_and_position(equilibrium, place) for place in places]
    if not isinstance(s, Iterable):
        return Shape(*rows[0])
    return Shape(*([row[k] for row in rows] for k in range(4)))


def literal(equilibrium: Equilibrium, s) -> Shape:
    """The same as ``shape`` by the article's own formulas, to be compared with it.

    Of the equilibrium it takes gamma and the tip angle, and its rod. It loses digits where the solver loses none: half
    of those of theta and z where the rod is straight up or down or its curvature vanishes, as at the tip, and ever
    more where two roots of f come near. Raises ValueError where the formulas have no value: two of the roots meet to
    rounding (so for a straight rod), or a load by which they divide is 0; and where an s is not on the rod.
    """
    places = [real("s", place) for place in s] if isinstance(s, Iterable) else [real("s", s)]
    if not all(0 <= place <= equilibrium.rod.length for place in places):
        raise ValueError(f"s must lie in [0, {equilibrium.rod.length!r}], the rod")
    rows = [angle_and_position_literally(equilibrium, place) for place in places]
    if not isinstance(s, Iterable):
        return Shape(*rows[0])
    return Shape(*([row[k] for row in rows] for k in range(4)))


def sweep(beta, eta, length, clamp_angle) -> Sweep:
    """All equilibria of many rods: the arguments are numbers, or sequences of one length.

    Raises ValueError where the lengths differ, and as ``equilibria`` does for each value, before any work.
    """
    given = Given(beta, eta, length, clamp_angle)
    rods = list(zip(*broadcast(given), strict=True))
    for rod in rods:
        check(*rod)
    found = [(case, item) for case, rod in enumerate(rods) for item in equilibria(*rod)]
    return Sweep(
        [case for case, _ in found],
        [item.tip_angle for _, item in found],
        [item.clamp_curvature for _, item in found],
        [item.gamma for _, item in found],
        [item.y for _, item in found],
        [item.z for _, item in found],
        [item.energy for _, item in found],
        [item.index for _, item in found],
    )


def broadcast(values):
    """Each value as a list of the common length: numbers are repeated."""
    columns = [
        list(value) if isinstance(value, Iterable) and not isinstance(value, str) else [value] for value in values
    ]
    rows = max(len(column) for column in columns)
    if any(len(column) not in (1, rows) for column in columns):
        raise ValueError(f"arguments have lengths {[len(column) for column in columns]}: give numbers or one length")
    return [column * rows if len(column) == 1 else column for column in columns]
