"""All tips of many rods: the search of ``search`` on arrays, rough at first and then to rounding.

The samples and the first approximations are taken in single precision, where NumPy's functions are many times faster.
The ranges of which they cannot tell how many tips there are, are searched again by more samples in double precision;
the rods of which those cannot tell it either are left to the scalar solver.
"""

from __future__ import annotations

from numpy import (
    abs,
    arange,
    ceil,
    clip,
    concatenate,
    flatnonzero,
    float32,
    floor,
    full,
    isfinite,
    isin,
    linspace,
    maximum,
    minimum,
    nan,
    nonzero,
    repeat,
    unique,
    where,
    zeros,
)

from derive.emit.kernels.arithmetic import pi
from derive.emit.kernels.block_places import ROUGH_DEPTH, ends, places_of
from derive.emit.kernels.block_records import joined, rounded_to, rows
from derive.emit.kernels.block_roots import Brackets, polished, rough_times, roughly_at, surplus

ROUGH_SLOW = 12  # ℓ√(β + η) up to which single precision holds the places of all tips but the most extreme
WIDE = 0.75  # first step between samples
CLOSER = 0.25  # the same where those leave a doubt
FINER = linspace(0, 1, 17)  # shares of the way from one sample to the next but one
RANGES = 1024  # ranges at once: arrays that stay in the cache


def tips(group, most):
    """The tips of a group, a list of Found, and the ranges left to the scalar solver."""
    rough = group.rods.slow < ROUGH_SLOW
    found, again = [], [zeros(0, dtype=int)]
    for mask, kind in ((rough, float32), (~rough, float)):
        which = flatnonzero(mask)
        if which.size:
            sure, doubtful = searched(group, which, kind, WIDE, most)
            found += sure
            again.append(doubtful)
    left = unique(concatenate(again))
    if left.size:
        sure, left = searched(group, left, float, CLOSER, most)
        found += sure
    return found, left


def searched(group, which, kind, step, most):
    """The tips of some ranges, and the ranges of which there may be more or fewer."""
    part = moved(rows(group, which) if which.size < group.rods.case.size else group)
    brackets, doubts = bracketed(part, kind, step, most)
    if not brackets.range.size:
        return [], which[doubts]
    some = rows(part, brackets.range)
    place, slope = roughly_at(some, brackets, brackets.left.dtype)
    sure, lost = polished(some, brackets, place, slope)
    doubtful = concatenate([doubts, lost])
    if doubtful.size:
        sure = rows(sure, ~isin(sure.range, doubtful))
    return [sure._replace(range=which[sure.range])], which[doubtful]


def moved(group):
    """The group without what motions do not depend on."""
    rods = group.rods._replace(case=0, side=0, scale=0, clamp_angle=0)
    return group._replace(rods=rods, turns=0, rank=0)


def bracketed(group, kind, step, most):
    """Brackets of all crossings of a group, and the ranges that are doubtful."""
    rounded = rounded_to(group, kind)
    first, last = ends(rounded.rods, rounded.piece)
    deepest = ROUGH_DEPTH if kind is float32 else 600.0
    capped = first < -deepest, last > deepest
    first, last = maximum(first, -deepest), minimum(last, deepest)
    parts, doubts = [], []
    for start in range(0, first.size, RANGES):
        here = slice(start, start + RANGES)
        some, low, high, *deep = rows((rounded, first, last, *capped), here)
        places = places_of(some.dip, low, high, step).astype(kind)
        swings, arrivals = rough_times(some.rods, some.piece, places)
        for sign in (1, -1) if some.rods.slow.max() >= pi else (1,):
            found, doubt = crossed(some, sign, places, swings, arrivals, deep, most)
            parts.append(found._replace(range=found.range + start))
            doubts.append(doubt + start)
    return joined(parts), concatenate(doubts)


def crossed(group, sign, places, swings, arrivals, capped, most):
    """Brackets of the whole numbers that the count of one branch crosses, and the ranges that are doubtful."""
    length, end = group.rods.length, end_arrival(group.piece, swings[-1])
    counts = (length - sign * arrivals) / (2 * swings)
    doubt = ~isfinite(counts.sum(axis=0)) | (capped[0] & (counts[0] >= 1))
    beside, hard = extrema(group, sign, places, swings, arrivals, counts)
    if end is None:
        doubt |= capped[1] & (counts[-1] >= 1)
    else:
        # What lies deeper than the samples, towards the end itself.
        beyond = (length - sign * end) / (2 * swings[-1])
        doubt |= isfinite(beyond) & (ceil(maximum(beyond, 0)) != ceil(maximum(counts[-1], 0)))
        turn = isfinite(beyond) & ((counts[-1] > counts[-2]) != (beyond > counts[-1]))
        doubt |= turn & (abs(counts[-1] - floor(counts[-1] + 0.5)) < 2 * abs(beyond - counts[-2]))
    levels = maximum(ceil(counts), 0)
    row, which = nonzero(abs(levels[1:] - levels[:-1]) > 0)
    one, other = levels[row, which], levels[row + 1, which]
    number = abs(other - one).astype(int)
    lowest, row, which = repeat(minimum(one, other), number), repeat(row, number), repeat(which, number)
    turns = lowest + arange(number.sum(), dtype=lowest.dtype) - repeat(number.cumsum() - number, number)
    turns = turns.astype(lowest.dtype)
    ahead = [surplus(swings[k, which], arrivals[k, which], turns, sign, length[which]) for k in (row, row + 1)]
    near, far = places[row, which], places[row + 1, which]
    found = joined([Brackets(which, turns, full(which.shape, sign), near, far, ahead[0], ahead[1]), beside])
    wanted = (found.turns > 0) | (sign > 0)
    wanted &= 2 * found.turns - (sign < 0) <= most
    return found if wanted.all() else rows(found, wanted), concatenate([flatnonzero(doubt), hard])


def end_arrival(piece, swing):
    """The first arrival at the high end itself, where it is known: at once, or after the whole half-swing."""
    if piece.high_kind == "clamp":
        return where((piece.clamp_gap == 0) & (piece.high_depth > 0), 0 * swing, nan)
    return swing if piece.high_kind == "turn" else None


def extrema(group, sign, places, swings, arrivals, counts):
    """Brackets beside the extrema that reach beyond a whole number, and the ranges where that is not sure."""
    grows = counts[1:] > counts[:-1]
    row, which = nonzero(grows[1:] != grows[:-1])
    before, here, after = (counts[row + k, which] for k in range(3))
    left, middle, right = (places[row + k, which] for k in range(3))
    top = here > before
    share = maximum(right - middle, 1e-30) / maximum(middle - left, 1e-30)
    reach = maximum(abs(before - here) * share, abs(after - here) / share)
    goal = where(top, ceil(here), floor(here))
    near = where(top, goal - here, here - goal)
    close = flatnonzero(((before - here) * (after - here) > 0) & (near <= reach) & (goal >= 0))
    which, goal, top, left, right = which[close], goal[close], top[close], left[close], right[close]
    if not close.size:
        return Brackets(which, goal, full(which.shape, sign), left, right, left, right), which
    some = rows(group, which)
    length = some.rods.length
    finer = left + (right - left) * FINER.astype(left.dtype)[:, None]
    swings, arrivals = rough_times(some.rods, some.piece, finer)
    short = where(top, 1, -1).astype(left.dtype) * (goal - (length - sign * arrivals) / (2 * swings))
    # Sure: well beyond, once; or so far from it that a curve that bends one way does not reach it.
    best = short.argmin(axis=0)
    column = arange(which.size)
    inner = clip(best, 1, 15)
    least, beside = short[best, column], maximum(short[inner - 1, column], short[inner + 1, column])
    margin = (1e-4 if left.dtype == float32 else 1e-9) * (1 + goal)
    changes = ((short[1:] < 0) != (short[:-1] < 0)).sum(axis=0)
    beyond = (least < -margin) & (changes == 2) & (best == inner)
    hard = ~beyond & (2 * least <= beside + margin)
    sure = flatnonzero(beyond)
    value = surplus(swings[:, sure], arrivals[:, sure], goal[sure], sign, length[sure])
    middle, column = finer[best[sure], sure], arange(sure.size)
    center = value[best[sure], column]
    found = Brackets(which[sure], goal[sure], full(sure.shape, sign), left[sure], middle, value[0], center)
    other = found._replace(left=middle, right=right[sure], value_left=center, value_right=value[-1])
    return joined([found, other]), which[hard]
