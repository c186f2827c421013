"""From a tip to the equilibrium: position of the tip, energy, curvature at the clamp, stability."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import floor, pi, sqrt
from derive.emit.kernels.formulas import arc_length, arc_square, arc_y, arc_z, straight_stiffness
from derive.emit.kernels.timing import Point, clamp_point, roots_of


class Arc(NamedTuple):
    """A stretch of rod that starts at the tip: its length, ∫cos θ, ∫sin θ and η∫cos²θ."""

    extent: float
    y: float
    z: float
    square: float


def arc_to(beta, eta, tip, point):
    """The arc from the tip to a point within the first half-period."""
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    xi_tip = (tip.half_cosine - tip.half_sine) * (tip.half_cosine + tip.half_sine)
    drive = tip.drive
    arc = arc_length(point.plus, point.minus, point.other)
    y = arc_y(eta, plus, minus, drive, xi_tip, arc, point.plus, point.minus, point.other)
    z = arc_z(eta, plus, minus, 2 * tip.half_sine * tip.half_cosine, point.other)
    square = 0
    if eta > 0:
        square = arc_square(beta, eta, plus, minus, drive, tip.gap, xi_tip, arc, point.plus, point.minus, point.other)
    return Arc(arc, y, z, square)


def half_period_point(beta, eta, tip):
    """℘ − e₊, ℘ − e₋, ℘ − e_o at the half-period, where ℘ = e₁."""
    roots = roots_of(beta, eta, tip)
    values = {roots.order[0]: 0, roots.order[1]: roots.short_gap, roots.order[2]: roots.long_gap}
    return Point(values["+"], values["-"], values["o"])


def swing_of(beta, eta, tip, half):
    """The arc of a half-swing, from the arc of a half-period: through π it is two of them, mirror images in z."""
    if eta <= beta or tip.passes:
        return Arc(2 * half.extent, 2 * half.y, 0 * half.z, 2 * half.square)
    return half


def arrival_of(beta, eta, tip, clamp, half, direct):
    """The arc to the first arrival, from the arc to the point of ℘: beyond π it comes back to the same ℘."""
    if (eta <= beta or tip.passes) and clamp.rest < 0:
        return Arc(2 * half.extent - direct.extent, 2 * half.y - direct.y, direct.z, 2 * half.square - direct.square)
    return direct


def whole_rod(beta, eta, length, clamp, tip, crossing):
    """∫cos θ, ∫sin θ and η∫cos²θ over the rod that meets the clamp on the crossing's branch."""
    half = arc_to(beta, eta, tip, half_period_point(beta, eta, tip))
    direct = arc_to(beta, eta, tip, clamp_point(clamp, tip))
    swing, arrival = swing_of(beta, eta, tip, half), arrival_of(beta, eta, tip, clamp, half, direct)
    turns, sign = 2 * crossing.turns, crossing.sign
    return Arc(
        length,
        float(turns * swing.y + sign * arrival.y),
        float(turns * swing.z + sign * arrival.z),
        float(turns * swing.square + sign * arrival.square),
    )


def index_of(crossing):
    """Number of conjugate points of the free end on the rod (Sturm: one in each half-swing, and a last one or none).

    h = ∂θ/∂θ_ℓ solves the second variation with h = 1, h′ = 0 at the tip; θ′ solves it too and vanishes once a
    half-swing, so h vanishes once in each. Whether it has vanished in the last, unfinished one is told by the sign
    of h at the clamp, which is against that of dθ/dσ times the slope of the branch.
    """
    swings = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    positive = crossing.rising != (crossing.sign > 0)
    return swings if positive == (swings % 2 == 0) else swings + 1


def straight_index(beta, eta, xi, length):
    """Number of conjugate points on a straight rod: zeros of cos(√k σ) on it, for h″ + kh = 0."""
    stiffness = straight_stiffness(beta, eta, xi)
    if stiffness <= 0:
        return 0
    return floor(length * sqrt(stiffness) / pi + 0.5)
