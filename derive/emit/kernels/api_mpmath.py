"""The interface of the mpmath twin, where arrays are lists: what differs from ``api``."""

from __future__ import annotations

from derive.emit.kernels.api import Shape, Sweep, equilibria
from derive.emit.kernels.arguments import (
    Given,
    all_not_negative,
    all_positive,
    all_real,
    all_within_turns,
    index_limit,
)
from derive.emit.kernels.arguments_mpmath import element, of_one_length
from derive.emit.kernels.bounds import must_have_answer
from derive.emit.kernels.literal import angle_and_position_literally
from derive.emit.kernels.rods import Equilibrium, length_of
from derive.emit.kernels.shapes import angle_and_position


def shape(equilibrium: Equilibrium, s, *, position=True) -> Shape:
    """The shape of an equilibrium at arc lengths s from the clamp, a number or a sequence of them within [0, length].

    position: whether y and z are wanted; without them they are None.

    theta, curvature, y and z are numbers, or lists as long as s. Raises TypeError or ValueError where an s is not on
    the rod.
    """
    found = shape_by(angle_and_position, equilibrium, on_rod(equilibrium, s))
    return found if position else Shape(found.theta, found.curvature, None, None)


def literal(equilibrium: Equilibrium, s) -> Shape:
    """The same as ``shape`` by the article's own formulas, to be compared with it.

    Of the equilibrium it takes gamma and the tip angle, and its rod. It loses digits where the solver loses none: half
    of those of theta and z where the rod is straight up or down or its curvature vanishes, as at the tip, and ever
    more where two roots of f come near. Raises ValueError where the formulas have no value: two of the roots meet to
    rounding (so for a straight rod), or a load by which they divide is 0; and where an s is not on the rod.
    """
    return shape_by(angle_and_position_literally, equilibrium, on_rod(equilibrium, s))


def shape_by(at, equilibrium, places):
    """The shape at one place, or at each of a list, by a function of an equilibrium and a place."""
    if not isinstance(places, list):
        return Shape(*at(equilibrium, places))
    rows = [at(equilibrium, place) for place in places]
    return Shape(*([row[k] for row in rows] for k in range(4)))


def on_rod(equilibrium, s):
    """The arc lengths; TypeError or ValueError if the first is no equilibrium, or an s not on its rod."""
    if not isinstance(equilibrium, Equilibrium):
        raise TypeError(f"equilibrium must be one that equilibria gives, got {equilibrium!r}")
    places, length = all_real("s", s), length_of(equilibrium.rod)
    for place, number in enumerate(places if isinstance(places, list) else [places]):
        if not 0 <= number <= length:
            where = f"s[{place}]" if isinstance(places, list) else "s"
            raise ValueError(f"{where} must lie in [0, {length}], the rod, got {number}")
    return places


def sweep(beta, eta, length, clamp_angle, field_angle, *, max_index=None) -> Sweep:
    """All equilibria of many rods: the arguments are numbers, or sequences of one length.

    max_index: the largest index that is wanted, 0 for stable equilibria only; None for all.

    Raises TypeError or ValueError, naming the argument and the index of a bad value, before any work.
    """
    beta, eta, length = all_not_negative("beta", beta), all_not_negative("eta", eta), all_positive("length", length)
    clamp_angle, field_angle = (
        all_within_turns("clamp_angle", clamp_angle),
        all_within_turns("field_angle", field_angle),
    )
    rods, limit = of_one_length(Given(beta, eta, length, clamp_angle, field_angle)), index_limit(max_index)
    for case in range(len(rods)):
        must_have_answer(element(case, beta), element(case, eta), element(case, length), limit)
    found = [(case, item) for case, rod in enumerate(rods) for item in equilibria(*rod, max_index=limit)]
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
