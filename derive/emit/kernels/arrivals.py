"""A bound on the length after which a motion arrives, so that tips from which none arrives in time need no look."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import log, pick, sqrt

TINIEST = 1e-300  # instead of less, where it is divided by


def least_arrival(beta, eta, piece, offset, left):
    """A length before which no motion from an offset from the hill, or from a lower one, arrives.

    θ″ is nowhere more than β + η/2, and at an offset from the hill no more than β + η times that, or than its stiffness
    times that where the field is along it: a motion that has the lesser of these two gets ahead of it. left: from
    there to the clamp.
    """
    hill = piece.basin.hill
    # β + η cos u and η cos u − β by sin u: both are largest at u = 0.
    steep, most = pick(hill.double_cosine == 1, hill.stiffness, beta + eta), beta + eta / 2
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    rest = min(left, max(clamp - min(clamp, most / steep), 0))
    # Up to the offset from which on the other bound is the lesser: by the share that is left of the way there.
    share = (left - rest) / max(offset, TINIEST)
    away, steepness = sqrt(share) * sqrt(2 + share), sqrt(steep)
    growth = share + away
    # Neither is more than ln(1 + x).
    logarithm = pick(growth < 1e-3, 2 * growth / (2 + growth), log(1 + growth))
    speed = steepness * away * offset
    return logarithm / steepness + 2 * rest / (speed + sqrt(speed * speed + 2 * most * rest) + TINIEST)
