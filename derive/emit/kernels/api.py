"""What an emitted module offers: equilibria, shape, sweep, folds, exchanges, literal."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.arguments import (
    Given,
    all_not_negative,
    all_positive,
    all_real,
    all_within_turns,
    common_shape,
    index_limit,
    not_negative,
    positive,
    refuse,
)
from derive.emit.kernels.block_bounds import all_must_have_answers
from derive.emit.kernels.blocks import sweep_arrays
from derive.emit.kernels.bounds import (
    EXCHANGES_SLOWEST,
    FOLDS_SLOWEST,
    must_be_searchable,
    must_have_answer,
    within_turns,
)
from derive.emit.kernels.dense import shape_at
from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.exchanges import Exchange, all_exchanges
from derive.emit.kernels.folds import Fold, all_folds
from derive.emit.kernels.literal import angle_and_position_literally
from derive.emit.kernels.rods import Equilibrium, length_of
from derive.emit.kernels.spans import span


class Shape(NamedTuple):
    """A rod at the arc lengths asked for: theta (from y to the tangent), curvature θ′, and the position y, z."""

    theta: Any
    curvature: Any
    y: Any
    z: Any


class Sweep(NamedTuple):
    """The equilibria of many rods, flat: case[k] is the index of the rod (in the order of the broadcast arrays)."""

    case: Any
    tip_angle: Any
    clamp_curvature: Any
    gamma: Any
    y: Any
    z: Any
    energy: Any
    index: Any


def equilibria(beta, eta, length, clamp_angle, field_angle, *, max_index=None) -> list[Equilibrium]:
    """All equilibria of one rod, sorted by tip angle.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    eta: magnetic modulus over bending stiffness, η̃/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    field_angle: α, the angle from the y axis to the field, in radians.
    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    beta, eta, length = not_negative("beta", beta), not_negative("eta", eta), positive("length", length)
    clamp_angle, field_angle = within_turns("clamp_angle", clamp_angle), within_turns("field_angle", field_angle)
    limit = index_limit(max_index)
    must_have_answer(beta, eta, length, limit)
    return all_equilibria(beta, eta, length, clamp_angle, field_angle, limit)


def shape(equilibrium: Equilibrium, s, *, position=True) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or an array within [0, length].

    position: whether y and z are wanted; without them they are None, and θ takes a fraction of the time.

    theta, curvature, y and z have the shape of s. Raises TypeError or ValueError where an s is not on the rod.
    """
    found = shape_at(equilibrium, on_rod(equilibrium, s), position)
    return Shape(*(part if part is None else part[()] for part in found))


def literal(equilibrium: Equilibrium, s) -> Shape:
    """The same as ``shape`` by the article's own formulas, to be compared with it.

    Of the equilibrium it takes gamma and the tip angle, and its rod. It loses digits where the solver loses none: half
    of those of theta and z where the rod is straight up or down or its curvature vanishes, as at the tip, and ever
    more where two roots of f come near. Raises ValueError where the formulas have no value: two of the roots meet to
    rounding (so for a straight rod), or a load by which they divide is 0; and where an s is not on the rod.
    """
    return Shape(*angle_and_position_literally(equilibrium, on_rod(equilibrium, s)))


def on_rod(equilibrium, s):
    """The arc lengths as doubles; TypeError or ValueError if the first is no equilibrium, or an s not on its rod."""
    if not isinstance(equilibrium, Equilibrium):
        raise TypeError(f"equilibrium must be one that equilibria gives, got {equilibrium!r}")
    places, length = all_real("s", s), length_of(equilibrium.rod)
    # Two numbers tell of all: arrays of truth values cost as much as some of the work.
    if places.size and not 0 <= np.min(places) <= np.max(places) <= length:
        refuse("s", places, (places < 0) | (places > length), f"must lie in [0, {length!r}], the rod")
    return places


def sweep(beta, eta, length, clamp_angle, field_angle, *, max_index=None) -> Sweep:
    """All equilibria of many rods: the arguments are numbers or arrays, broadcast against one another.

    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    Raises TypeError or ValueError, naming the argument and the flat index of a bad value, before any work.
    """
    beta, eta, length = all_not_negative("beta", beta), all_not_negative("eta", eta), all_positive("length", length)
    clamp_angle, field_angle = (
        all_within_turns("clamp_angle", clamp_angle),
        all_within_turns("field_angle", field_angle),
    )
    grid, limit = common_shape(Given(beta, eta, length, clamp_angle, field_angle)), index_limit(max_index)
    all_must_have_answers(beta, eta, length, grid, limit)
    found = sweep_arrays(beta, eta, length, clamp_angle, field_angle, grid, limit)
    return Sweep(
        found.case,
        found.tip_angle,
        found.clamp_curvature,
        found.gamma,
        found.y,
        found.z,
        found.energy,
        found.index,
    )


def folds(beta, length, clamp_angle, field_angle, *, eta) -> list[Fold]:
    """Where equilibria of a rod meet and vanish as the field grows: every fold with η in a range, sorted by η.

    beta: terminal force over bending stiffness, F/(EI) ≥ 0.
    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    field_angle: α, the angle from the y axis to the field, in radians.
    ``eta``: the range (low, high) of the magnetic modulus over bending stiffness, 0 ≤ low < high.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    beta, length = not_negative("beta", beta), positive("length", length)
    clamp_angle, field_angle = within_turns("clamp_angle", clamp_angle), within_turns("field_angle", field_angle)
    low, high = span("eta", eta)
    must_be_searchable(beta, high, length, FOLDS_SLOWEST)
    return all_folds(beta, length, clamp_angle, field_angle, low, high)


def exchanges(length, clamp_angle, field_angle, *, beta, eta) -> list[Exchange]:
    """Where two folds meet as the force grows: the diagram over η changes there. Those in a range, sorted by β and η.

    length: length of the rod, > 0.
    clamp_angle: θ(0), the angle from the y axis to the tangent at the clamp, in radians.
    field_angle: α, the angle from the y axis to the field, in radians.
    ``beta``, ``eta``: the ranges (low, high) of terminal force and magnetic modulus over bending stiffness,
    0 ≤ low < high.

    All in one unit of length. Raises TypeError or ValueError, naming the argument, before any work.
    """
    length = positive("length", length)
    clamp_angle, field_angle = within_turns("clamp_angle", clamp_angle), within_turns("field_angle", field_angle)
    (low_beta, high_beta), (low, high) = span("beta", beta), span("eta", eta)
    must_be_searchable(high_beta, high, length, EXCHANGES_SLOWEST)
    return all_exchanges(length, clamp_angle, field_angle, low_beta, high_beta, low, high)
