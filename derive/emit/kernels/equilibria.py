"""All equilibria of one rod."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, frexp, inf, ldexp, sqrt
from derive.emit.kernels.bent_rods import bent_rod
from derive.emit.kernels.ground import clamp_in, ground_of, ridge_of
from derive.emit.kernels.hits import hits
from derive.emit.kernels.pieces import pieces
from derive.emit.kernels.rods import Rod
from derive.emit.kernels.search import crossings
from derive.emit.kernels.shots import mirror_shots, tip_shots
from derive.emit.kernels.sides import landscapes, mirrored_clamp, principal, reflected
from derive.emit.kernels.straight_rods import straight_rod, weak_rod


def all_equilibria(beta, eta, length, clamp_angle, field_angle, max_index):
    """Every equilibrium, sorted by tip angle: from the tips below the clamp angle, above it, and the straight rod."""
    if length * sqrt(beta + eta) <= epsilon():
        return [weak_rod(beta, eta, length, clamp_angle, field_angle)]
    most = inf if max_index is None else max_index
    scale = frexp(beta + eta)[1] // 2
    field = principal(field_angle)
    rod = Rod(ldexp(beta, -2 * scale), ldexp(eta, -2 * scale), ldexp(length, scale), clamp_angle, field, 1, scale)
    mirrored = Rod(rod.beta, rod.eta, rod.length, -clamp_angle, reflected(field), -1, scale)
    scene, other = landscapes(rod.beta, rod.eta, rod.field_angle)
    clamp = clamp_in(scene.rests, rod.clamp_angle)
    beyond = mirrored_clamp(scene, other, clamp, mirrored.clamp_angle)
    ridge = ridge_of(rod.beta, rod.eta, rod.field_angle, scene) if other is scene else None
    shots = tip_shots(rod.beta, rod.eta, rod.field_angle, rod.length, rod.clamp_angle)
    lower = below(rod, scene, clamp, ridge, most, shots)
    upper = below(mirrored, other, beyond, ridge, most, None if shots is None else mirror_shots(shots))
    return in_order([*lower, *straight(rod, scene, clamp, most), *upper[::-1]])


def in_order(found):
    """The list with tips that are nearer than rounding given as equal, where rounding would exchange them."""
    for k in range(1, len(found)):
        if found[k].tip_angle < found[k - 1].tip_angle:
            found[k] = found[k]._replace(tip_angle=found[k - 1].tip_angle)
    return found


def below(rod, scene, clamp, ridge, most, shots):
    """The equilibria with tips below the clamp angle, from the lowest up; tips may be nearer than rounding.

    ridge: that of the landscape, or None where it is not known yet. shots: all tips, roughly, or None.
    """
    tips = None if shots is None else [shot for shot in shots if shot.offset < 0]
    if tips == []:
        return []
    beta, eta, field_angle, length = rod.beta, rod.eta, rod.field_angle, rod.length
    ground = ground_of(eta, scene, clamp, ridge_of(beta, eta, field_angle, scene) if ridge is None else ridge)
    found = None
    if tips is not None:
        found = hits(beta, eta, field_angle, length, pieces(eta, field_angle, ground), tips)
    if found is None:
        found = []
        for piece in pieces(eta, field_angle, ground):
            if piece.width > 0:  # else the clamp angle is at the level of the ridge, to rounding
                here = crossings(beta, eta, field_angle, length, piece, most)
                found += [(piece, crossing) for crossing in sorted(here, key=lambda item: item.sample.place)]
    indexed = [(piece, crossing, index_of(crossing)) for piece, crossing in found]
    return [bent_rod(rod, clamp.turns, *item) for item in indexed if item[2] <= most]


def straight(rod, scene, clamp, most):
    """The straight equilibrium, if the clamp angle is a direction without moment."""
    if 0 not in clamp.offsets:
        return []
    found = [straight_rod(rod, rest) for rest, offset in zip(scene.rests, clamp.offsets, strict=True) if offset == 0]
    return [item for item in found if item.index <= most]


def index_of(crossing):
    """Number of conjugate points of the free end on the rod (Sturm: one in each half-swing, and a last one or none).

    h = ∂θ/∂θ_ℓ solves the second variation with h = 1, h′ = 0 at the tip; θ′ solves it too and vanishes once a
    half-swing, so h vanishes once in each. Whether it has vanished in the last, unfinished one is told by the sign
    of h at the clamp, which is against that of dθ/dσ times the slope of the branch.
    """
    swings = 2 * crossing.turns - (1 if crossing.sign < 0 else 0)
    positive = crossing.rising != (crossing.sign > 0)
    return swings if positive == (swings % 2 == 0) else swings + 1
