"""The kernels of ``arrivals`` on arrays.

Emitted by `derive emit` from kernels/arrivals.py: do not edit, change that file.

Digest of the inputs: sha256 1b96874bb345013534309573f8b0bf79f11b826ecca7571734277347db824522
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_log, each_max, each_min, each_pick, each_sqrt
from derive.emit.kernels.arrivals import TINIEST


def least_arrival_each(beta, eta, piece, offset, left):
    """A length before which no motion from an offset from the hill, or from a lower one, arrives.

    θ″ is nowhere more than β + η/2, and at an offset from the hill no more than β + η times that, or than its stiffness
    times that where the field is along it: a motion that has the lesser of these two gets ahead of it. left: from
    there to the clamp.
    """
    hill = piece.basin.hill
    # β + η cos u and η cos u − β by sin u: both are largest at u = 0.
    steep, most = each_pick(hill.double_cosine == 1, hill.stiffness, beta + eta), beta + eta / 2
    clamp = piece.low_offset + piece.width + piece.clamp_gap
    rest = each_min(left, each_max(clamp - each_min(clamp, most / steep), 0))
    # Up to the offset from which on the other bound is the lesser: by the share that is left of the way there.
    share = (left - rest) / each_max(offset, TINIEST)
    away, steepness = each_sqrt(share) * each_sqrt(2 + share), each_sqrt(steep)
    growth = share + away
    # Neither is more than ln(1 + x).
    logarithm = each_pick(growth < 0.001, 2 * growth / (2 + growth), each_log(1 + growth))
    speed = steepness * away * offset
    return logarithm / steepness + 2 * rest / (speed + each_sqrt(speed * speed + 2 * most * rest) + TINIEST)
