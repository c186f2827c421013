"""The same quantities by what stays precise: offsets from straight directions, and differences to the clamp.

β + ηξ(ℓ), η(1 − ξ(ℓ)) − 2β and 2β + η(ξ + ξ(ℓ)) each vanish somewhere. Written through a quantity that is known there
to full relative precision, as a sum of terms of one sign, they lose nothing. The point ξ is the clamp in this script.
"""

from __future__ import annotations

from sympy import Expr, Symbol, cos, diff, expand, sin

from .claims import Equal
from .load_case import xi_tip
from .symbols import beta, eta, theta, xi
from .tip_names import Writer, drive, drop, gap, level, minus, one_plus, plus

side = Symbol("side", real=True)  # β − η: β + ηξ at ξ = −1
clamp_drive = Symbol("clamp_drive", real=True)  # β + ηξ at the clamp
clamp_gap = Symbol("clamp_gap", real=True)  # η(1 − ξ) − 2β at the clamp


def write_clamp(writer: Writer) -> None:
    """The formulas that start from a straight direction, and those that start from the clamp."""
    meaning = writer.meaning
    # All three are affine in ξ and in ξ(ℓ), with the stiffness H of f̂ as slope.
    stiffness = diff(meaning[level], xi)
    meaning[side] = meaning[drive].subs(xi_tip, -1)
    meaning[clamp_drive] = meaning[drive].subs(xi_tip, xi)
    meaning[clamp_gap] = meaning[gap].subs(xi_tip, xi)
    # What holds at the tip holds at the clamp by another name.
    writer.proved[clamp_drive], writer.proved[clamp_gap] = writer.proved[drive], writer.proved[gap]
    _write_offsets(writer, stiffness)
    _write_differences(writer, stiffness)


def _write_offsets(writer: Writer, stiffness: Expr) -> None:
    """β + ηξ and η(1 − ξ) − 2β by the offset of ξ from −1 or from 1."""
    case, meaning = writer.case, writer.meaning
    where = case.domain(theta=(0, 3))

    def turns(value: Expr) -> Equal:
        """It is θ″/sin θ at the tip."""
        return Equal(value.subs(meaning).subs(xi_tip, cos(theta)), case.angular_acceleration / sin(theta))

    writer.add(
        "side_moment",
        (beta, eta),
        expand(meaning[side]),
        "θ″/sin θ towards θ = π",
        lambda value: Equal(2 * value, -diff(case.at_tip, xi).subs(xi, -1)),
        steps=("tip.tip_drive", "quartic.levels"),
        source="moment",
        gives=side,
    )
    writer.add(
        "moment_from_side",
        (eta, side, plus),
        side + stiffness * plus,
        "θ″/sin θ at the angle with offset 1 + cos θ",
        turns,
        where,
        steps=("plane.moment", "tip.tip_drive"),
        source="moment",
    )
    writer.add(
        "moment_from_top",
        (beta, eta, minus),
        expand(meaning[drive].subs(xi_tip, 1)) - stiffness * minus,
        "θ″/sin θ at the angle with offset 1 − cos θ",
        turns,
        where,
        steps=("plane.moment", "tip.tip_drive"),
        source="moment",
    )
    writer.add(
        "gap_from_side",
        (eta, side, plus),
        -2 * side - stiffness * plus,
        "−f̂(−1)/(1 + ξ(ℓ)) from the offset 1 + ξ(ℓ)",
        lambda value: Equal(value * (1 + xi_tip), -case.at_tip.subs(xi, -1)),
        steps=("quartic.levels", "quartic.free_end"),
        source="quartic",
    )


def _write_differences(writer: Writer, stiffness: Expr) -> None:
    """drive, level, drop and gap from one another and from their values at the clamp."""
    at_tip = writer.case.at_tip
    writer.add(
        "drive_between",
        (eta, drop, level),
        (level + stiffness * drop) / 2,
        "β + Hξ(ℓ) from f̂ at the clamp: the slope of f̂ at the tip is −2 times it",
        lambda value: Equal(-2 * value, diff(at_tip, xi).subs(xi, xi_tip)),
        steps=("quartic.levels", "quartic.free_end"),
        source="quartic",
    )
    writer.add(
        "level_above_gap",
        (eta, one_plus, gap),
        stiffness * one_plus - gap,
        "f̂(ξ)/(ξ(ℓ) − ξ) of an orbit that passes −1",
        lambda value: Equal(value * (xi_tip - xi), at_tip),
        steps=("tip.point_level",),
        source="quartic",
    )
    writer.add(
        "rising_level",
        (eta, clamp_drive, drop),
        2 * clamp_drive + stiffness * drop,
        "f̂(ξ)/(ξ(ℓ) − ξ) of a tip near the clamp angle",
        lambda value: Equal(value * (xi_tip - xi), at_tip),
        steps=("tip.point_level",),
        source="quartic",
    )
    writer.add(
        "gap_below",
        (eta, clamp_gap, drop),
        clamp_gap - stiffness * drop,
        "−f̂(−1)/(1 + ξ(ℓ)) of an orbit that passes −1",
        lambda value: Equal(value * (1 + xi_tip), -at_tip.subs(xi, -1)),
        steps=("quartic.levels", "quartic.free_end"),
        source="quartic",
    )
    if stiffness != 0:
        writer.add(
            "drop_from_gaps",
            (eta, clamp_gap, gap),
            (clamp_gap - gap) / stiffness,
            "ξ(ℓ) − ξ of an orbit that just passes −1",
            lambda value: Equal(value * writer.meaning[level], at_tip),
            steps=("tip.point_level",),
            source="quartic",
        )
        writer.add(
            "drop_at_level",
            (eta, clamp_drive, level),
            (level - 2 * clamp_drive) / stiffness,
            "ξ(ℓ) − ξ of an orbit that turns near the clamp",
            lambda value: Equal(value * writer.meaning[level], at_tip),
            steps=("tip.point_level",),
            source="quartic",
        )
