"""The places of a piece at which its branches are sampled to begin with, and which of them need no look."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import ceil, deepest, epsilon, exp, log, pi, sqrt
from derive.emit.kernels.levels import fall, reach, slope, turn_to
from derive.emit.kernels.oblique_rests import astroid_cusp, ridge_couple
from derive.emit.kernels.shoulders import beside_level


def places(beta, eta, field_angle, length, piece):
    """Places to begin with, closer around the level at which the motion meets a ridge that is not quite there."""
    found, basin = grid(beta, eta, length, piece), piece.basin
    divided = "shoulder" in (piece.low_kind, piece.high_kind)
    if basin.even or basin.passes or piece.low_kind == "level" or not basin.whole or divided:
        return found
    angle = abs(field_angle)
    cusp = angle + pi + astroid_cusp(angle)
    # How far η is below the value at which the ridge would appear.
    missing = max(-ridge_couple(beta, eta, angle, astroid_cusp(angle)) / (beta + eta), epsilon())
    cusp = cusp if field_angle > 0 else 2 * pi - cusp
    down = turn_to(basin.hill, basin.well)
    rise = reach(eta, basin.hill, fall(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
    if missing > 0.3 or not 0 < rise < piece.width:
        return found
    middle = log(rise / (piece.width - rise))
    # The range of tips that it slows down shrinks with the power 3/2.
    steps = [0.25**k for k in range(ceil(1.1 * log(1 / missing)) + 3)]
    around = [middle, *(middle - step for step in steps), *(middle + step for step in steps)]
    return sorted([*found, *(place for place in around if found[0] < place < found[-1])])


def grid(beta, eta, length, piece):
    """Places to begin with: near enough where the branches bend, and to where none of them is as short as the rod."""
    rounding = -log(epsilon())
    slow = (1 + 16 * epsilon()) * length * sqrt(beta + eta)  # of a very long rod rounding is more than the 6 below
    first = -2 * slow - 6 if piece.low_kind == "level" else -slow - 6
    first = min(first, -rounding) if piece.low_kind == "level" else first
    if piece.high_kind == "level":
        last = 2 * slow + rounding
    elif piece.high_kind != "clamp":
        last = 2 * rounding
    elif piece.high_depth == 0:
        last = rounding
    else:
        # The tip of a stiff rod departs from the clamp angle by half the moment there times the length squared.
        moment = abs(slope(eta, piece.clamp_rest, piece.clamp_offset)) + epsilon() ** 20
        last = max(rounding, 4 + log(2 * piece.width) - log(moment) - 2 * log(length))
        last = min(last, 2 * deepest(piece.width))
    inner = [0.0]
    for side, end, kind in ((-1, -first, piece.low_kind), (1, last, piece.high_kind)):
        if kind == "shoulder":
            inner += [side * place for place in beside_level(eta, piece)]
            continue
        inner += [side * place for place in (1.25, 2.5, 5.0, 10.0) if place < end]
        inner.append(side * end)
    return sorted(inner)


def about(piece, place):
    """How far a place of a piece is from the hill and from the clamp."""
    place = max(place, -deepest(piece.width))
    from_hill = piece.low_offset + piece.width / (1 + exp(-place))
    return from_hill, piece.clamp_gap + (piece.width / (1 + exp(place)) if place < deepest(piece.width) else 0)
