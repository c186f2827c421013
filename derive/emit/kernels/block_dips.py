"""Where a ridge is nearly there, on arrays: ranges whose motions it slows down, and tips that scalars tell better."""

from __future__ import annotations

from numpy import abs, full, inf, log, where, zeros

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.levels_each import fall_each, reach_each, turn_to_each
from derive.emit.kernels.oblique_rests_each import astroid_cusp_each, ridge_couple_each

NEARLY = 0.3  # how far η may be below the value at which a ridge appears, and still slow motions down, over β + η
SHARP = 0.01  # the same from which on the dips are too narrow for the samples here
ASIDE = 0.7  # how far from a shoulder the end of a motion may be and be told better from there
RESTING = 0.07  # θ″ over β + η up to which a motion that ends there loses more than a few roundings without that


def by_dips(group, wanted):
    """The ranges that are wanted, without and with a dip, and the cases left to the scalar solver, for their dip is
    too sharp."""
    missing, dip = nearly_ridge(group.rods, group.piece)
    plain, wide = wanted & (missing > NEARLY), wanted & (missing <= NEARLY) & (missing >= SHARP)
    parts = [rows(group, plain)] if plain.any() else []
    if wide.any():
        parts.append(rows(group._replace(dip=dip), wide))
    return parts, group.rods.case[wanted & ~plain & ~wide]


def nearly_ridge(rods, piece):
    """How far η is below the value at which a ridge would appear, and the place at which the motion would meet it:
    see ``places.places``. No number where that is not on the range."""
    if has_no_shoulder(piece):
        return full(rods.case.shape, inf), rods.slow
    eta, basin = rods.eta, piece.basin
    missing, cusp = missing_ridge(rods)
    down = turn_to_each(basin.hill, basin.well)
    rise = reach_each(eta, basin.hill, fall_each(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
    inside = (rise > 0) & (rise < piece.width)
    return where(inside, missing, inf), log(rise / (piece.width - rise))


def has_no_shoulder(piece):
    """Whether V has two hills a turn, or is symmetric."""
    basin = piece.basin
    return basin.even or basin.passes or piece.low_kind == "level" or not basin.whole


def missing_ridge(rods):
    """How far η is below the value at which a ridge would appear, over β + η, and where it would."""
    beta, eta, angle = rods.beta, rods.eta, abs(rods.field_angle)
    side = astroid_cusp_each(angle)
    missing = -ridge_couple_each(beta, eta, angle, side) / (beta + eta)
    return missing, where(rods.field_angle > 0, angle + pi + side, pi - angle - side)


def beside_shoulders(group, found):
    """The cases that have a tip from which the motion nearly rests beside a shoulder: arrays know no shoulders."""
    if has_no_shoulder(group.piece):
        return zeros(0, dtype=int)
    rods, motion = rows(group.rods, found.range), found.motion
    most, (_, cusp) = RESTING * (rods.beta + rods.eta), missing_ridge(rods)
    tip, far = motion.tip - cusp, motion.tip + 2 * motion.half_width - cusp
    rests = (abs(tip) < ASIDE) & (motion.near_moment < most) | (abs(far) < ASIDE) & (motion.far_moment < most)
    return rods.case[rests]
