"""All tips of many rods: the search of ``search`` on arrays, rough at first and then to rounding.

The samples and the first approximations are taken in single precision, where NumPy's functions are many times faster;
the rods of which they cannot tell how many tips there are, are left to the scalar solver.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import (
    abs,
    arange,
    array,
    bincount,
    ceil,
    clip,
    concatenate,
    flatnonzero,
    float32,
    floor,
    full,
    isfinite,
    linspace,
    log,
    maximum,
    minimum,
    nan,
    nonzero,
    repeat,
    sort,
    where,
)

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_atan2, each_sqrt
from derive.emit.kernels.block_records import joined, rounded_to, rows
from derive.emit.kernels.motion_each import motion_at_each
from derive.emit.kernels.pieces_each import slope_each
from derive.emit.kernels.swing_each import lengths_each, phase_of_each

ROUGH_SLOW = 12  # ℓ√(β + η) up to which single precision holds the places of all tips but the most extreme
ROUGH_DEPTH = 28.0  # places up to which squares of offsets are numbers in single precision
SPREAD = 2.0**-6  # distance of the places that tell the slope of a branch in single precision
AROUND = concatenate([-(0.5 ** arange(13)), [0], 0.5 ** arange(12, -1, -1)])  # places about a dip
SAMPLES = 16384  # samples taken at once: arrays that stay in the cache


class Brackets(NamedTuple):
    """Crossings to be found: the range, by its number in the group, the branch, and places on either side."""

    range: Any
    turns: Any
    sign: Any
    left: Any
    right: Any


class Found(NamedTuple):
    """Tips: the range, place and branch, whether it grows with the tip, the motion with its phase and its times."""

    range: Any
    place: Any
    turns: Any
    sign: Any
    rising: Any
    motion: Any
    phase: Any
    swing: Any
    arrival: Any


def tips(group, most):
    """The tips of a group, a list of Found, and the ranges left to the scalar solver."""
    rough = group.rods.slow < ROUGH_SLOW
    found, doubtful = [], []
    for mask, kind in ((rough, float32), (~rough, float)):
        which = flatnonzero(mask)
        if which.size:
            part = rows(group, which)
            brackets, doubts = bracketed(part, kind, most)
            tip, lost = polished(part, brackets, kind)
            found.append(tip._replace(range=which[tip.range]))
            doubtful += [which[doubts], which[lost]]
    return found, concatenate(doubtful)


def rough_times(rods, piece, place):
    """Half-swing and first arrival, to the square of a thousandth or the rounding of the numbers given."""
    motion = motion_at_each(rods.beta, rods.eta, rods.field_angle, piece, place)
    phase = phase_of_each(motion)
    a, b, square, rest = motion.end / 2, motion.middle / 2, phase.square, phase.rest
    more = True
    while more:
        more = (abs(a - b) > 1e-3 * a).any()
        delta = each_sqrt(a * a * rest + b * b * square)
        total, below = a + b, a + delta
        ratio = total / below
        inner = a + (a * a + b * b * square) / (delta + b * square)
        square, rest = ratio * ratio * square, 2 * a / below * rest * (inner / below)
        a, b = total / 2, each_sqrt(a * b)
    mean = (a + b) / 2
    return pi / 2 / mean, each_atan2(each_sqrt(square), each_sqrt(rest)) / mean


def ends(rods, piece):
    """The places of the deepest samples: see ``places.grid``."""
    rounding = -log(epsilon())
    if piece.low_kind == "level":
        first = minimum(-2 * rods.slow - 6, -rounding)
    else:
        first = -rods.slow - 6
    if piece.high_kind == "level":
        last = 2 * rods.slow + rounding
    elif piece.high_kind == "turn":
        last = full(rods.slow.shape, 2 * rounding)
    else:
        moment = abs(slope_each(rods.eta, piece.clamp_rest, piece.clamp_offset)) + epsilon() ** 20
        deeper = 4 + log(2 * piece.width) - log(moment) - 2 * log(rods.length)
        last = where(piece.high_depth == 0, rounding, maximum(rounding, deeper))
    return first, last


def spaced(deepest):
    """Places from 0 to the deepest one, as shares of it."""
    places, step = [0.0], 0.75
    while places[-1] < deepest:
        places.append(places[-1] + step)
        step *= 1.25
    return array(places[:-1] + [deepest]) / deepest


def bracketed(group, kind, most):
    """Brackets of all crossings of a group, and the ranges that are doubtful."""
    first, last = ends(group.rods, group.piece)
    capped = [first < -ROUGH_DEPTH, last > ROUGH_DEPTH] if kind is float32 else [first < -600, last > 600]
    deepest = ROUGH_DEPTH if kind is float32 else 600.0
    first, last = maximum(first, -deepest), minimum(last, deepest)
    below, above = spaced(-first.min()), spaced(last.max())
    more = 0 if group.dip is None else AROUND.size
    size = max(SAMPLES // (len(below) + len(above) + more), 1)
    parts, doubts = [], []
    for start in range(0, first.size, size):
        here = slice(start, start + size)
        some, edge = rounded_to(rows(group, here), kind), (first[here], last[here])
        places = concatenate([edge[0] * below[:0:-1, None], edge[1] * above[:, None]])
        if some.dip is not None:
            closer = clip(some.dip + AROUND[:, None], edge[0], edge[1])
            places = sort(concatenate([places, closer]), axis=0)
        places = places.astype(kind)
        swings, arrivals = rough_times(some.rods, some.piece, places)
        deep = capped[0][here], capped[1][here]
        for sign in (1, -1):
            found, doubt = crossed(some, sign, places, swings, arrivals, deep, most)
            parts.append(found._replace(range=found.range + start))
            doubts.append(doubt + start)
    return joined(parts), concatenate(doubts)


def crossed(group, sign, places, swings, arrivals, capped, most):
    """Brackets of the whole numbers that the count of one branch crosses, and the ranges that are doubtful."""
    length = group.rods.length
    counts = (length - sign * arrivals) / (2 * swings)
    doubt = ~isfinite(counts).all(axis=0) | (capped[0] & (counts[0] >= 1))
    end = end_count(group.piece, sign, length, swings[-1])
    if end is None:
        doubt |= capped[1] & (counts[-1] >= 1)
    else:
        places, counts = concatenate([places, places[-1:] + 1]), concatenate([counts, end[None]])
    low, high = minimum(counts[1:], counts[:-1]), maximum(counts[1:], counts[:-1])
    low, high = maximum(ceil(low), 0), maximum(ceil(high), 0)
    if end is not None:
        # What lies deeper than the samples, towards the end itself.
        doubt |= high[-1] > low[-1]
        low, high = low[:-1], high[:-1]
    row, which = nonzero(high > low)
    number = (high[row, which] - low[row, which]).astype(int)
    lowest = repeat(low[row, which], number)
    turns = lowest + arange(number.sum()) - repeat(number.cumsum() - number, number)
    row, which = repeat(row, number), repeat(which, number)
    found = Brackets(which, turns, full(which.shape, sign), places[row, which], places[row + 1, which])
    beside, hard = extrema(group, sign, places, counts)
    found = joined([found, beside])
    wanted = (found.turns > 0) | (sign > 0)
    wanted &= 2 * found.turns - (sign < 0) <= most
    return rows(found, wanted), concatenate([flatnonzero(doubt), hard])


def end_count(piece, sign, length, swing):
    """The count at the high end itself, where it is known: arrival at once, or after the whole half-swing."""
    if piece.high_kind == "clamp":
        return where((piece.clamp_gap == 0) & (piece.high_depth > 0), length / (2 * swing), nan)
    if piece.high_kind == "turn":
        return (length - sign * swing) / (2 * swing)
    return None


def extrema(group, sign, places, counts):
    """Brackets beside the extrema that reach beyond a whole number, and the ranges where that is not sure."""
    before, here, after = counts[:-2], counts[1:-1], counts[2:]
    top = here > before
    gaps = maximum(places[1:] - places[:-1], 1e-30)
    share = gaps[1:] / gaps[:-1]
    reach = maximum(abs(before - here) * share, abs(after - here) / share)
    goal = where(top, ceil(here), floor(here))
    near = where(top, goal - here, here - goal)
    row, which = nonzero(((before - here) * (after - here) > 0) & (near <= reach) & (goal >= 0))
    goal, top = goal[row, which], top[row, which]
    left, right = places[row, which], places[row + 2, which]
    if not row.size:
        return Brackets(which, goal, full(which.shape, sign), left, right), which
    some = rows(group, which)
    finer = left + (right - left) * linspace(0, 1, 17).astype(left.dtype)[:, None]
    swings, arrivals = rough_times(some.rods, some.piece, finer)
    short = where(top, 1, -1) * (goal - (some.rods.length - sign * arrivals) / (2 * swings))
    # Sure: well beyond, once; or so far from it that a curve that bends one way does not reach it.
    best = short.argmin(axis=0)
    column = arange(which.size)
    inner = clip(best, 1, 15)
    least, beside = short[best, column], maximum(short[inner - 1, column], short[inner + 1, column])
    margin = 1e-4 * (1 + goal)
    changes = ((short[1:] < 0) != (short[:-1] < 0)).sum(axis=0)
    beyond = (least < -margin) & (changes == 2) & (best == inner)
    hard = ~beyond & (2 * least <= beside + margin)
    sure = flatnonzero(beyond)
    found = Brackets(which[sure], goal[sure], full(sure.shape, sign), left[sure], finer[best[sure], sure])
    other = found._replace(left=found.right, right=right[sure])
    return joined([found, other]), which[hard]


def surplus(swing, arrival, brackets, length):
    """The length of a branch less the rod's."""
    return 2 * brackets.turns * swing + brackets.sign * arrival - length


def approached(group, brackets):
    """Rough crossings by Chandrupatla's method (1997): places, the slope of the branch there, whether there is one."""
    kind = brackets.left.dtype
    brackets = brackets._replace(turns=brackets.turns.astype(kind), sign=brackets.sign.astype(kind))
    length = group.rods.length

    def function(place):
        swing, arrival = rough_times(group.rods, group.piece, place)
        return surplus(swing, arrival, brackets, length)

    a, b = brackets.left, brackets.right
    value_a, value_b = function(a), function(b)
    good = (value_a > 0) != (value_b > 0)
    rising = value_b > value_a
    fraction = full(a.shape, 0.5, dtype=kind)
    secant = value_a / (value_a - value_b)
    inside = (secant > 0.05) & (secant < 0.95)
    fraction[inside] = secant[inside]
    for _ in range(6):
        trial = a + fraction * (b - a)
        value = function(trial)
        same = (value > 0) == (value_a > 0)
        c, value_c = where(same, a, b), where(same, value_a, value_b)
        b, value_b = where(same, b, a), where(same, value_b, value_a)
        a, value_a = trial, value
        fraction = inverse_quadratic(a, b, c, value_a, value_b, value_c)
    place = where(abs(value_a) < abs(value_b), a, b)
    # Points nearer than this would tell the slope by their rounding.
    slope = (function(place + SPREAD) - function(place - SPREAD)) / (2 * SPREAD)
    return place, slope, good, rising


def inverse_quadratic(a, b, c, value_a, value_b, value_c):
    """Where on the way from a to b inverse quadratic interpolation puts the zero, or half way where it is unsafe."""
    x, y = (a - b) / (c - b), (value_a - value_b) / (value_c - value_b)
    share = value_a / (value_b - value_a) * value_c / (value_b - value_c)
    share = share + (c - a) / (b - a) * value_a / (value_c - value_a) * value_b / (value_c - value_b)
    return where((y * y < x) & ((1 - y) * (1 - y) < 1 - x) & (share > 0) & (share < 1), share, a.dtype.type(0.5))


def polished(group, brackets, kind):
    """The crossings to rounding, by secants from the rough ones, and the ranges in which one is not found so."""
    rough = rounded_to(rows(group, brackets.range), kind)
    place, slope, good, rising = approached(rough, brackets)
    some = rows(group, brackets.range)
    place, slope, length = place.astype(float), slope.astype(float), some.rods.length
    least, most = minimum(brackets.left, brackets.right) - 0.01, maximum(brackets.left, brackets.right) + 0.01
    todo = flatnonzero(good)
    value, before = full(place.shape, nan), place.copy()
    parts = []
    for turn in range(8):
        here = rows(some, todo)
        motion = motion_at_each(here.rods.beta, here.rods.eta, here.rods.field_angle, here.piece, place[todo])
        phase = phase_of_each(motion)
        swing, arrival = lengths_each(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
        now = surplus(swing, arrival, rows(brackets, todo), length[todo])
        if turn:
            change = place[todo] - before[todo]
            slope[todo] = where(change == 0, slope[todo], (now - value[todo]) / where(change == 0, 1, change))
        step = now / slope[todo]
        close = abs(step) <= 4 * epsilon() * (1 + abs(place[todo]))
        close |= abs(now) <= 4 * epsilon() * length[todo]
        done = todo[close]
        state = rows((motion, phase, swing, arrival), close)
        branch = rows(brackets, done)
        parts.append(
            Found(
                branch.range,
                place[done],
                branch.turns,
                branch.sign,
                rising[done],
                state[0],
                state[1],
                state[2],
                state[3],
            )
        )
        value[todo], before[todo] = now, place[todo]
        place[todo] -= step
        todo = todo[~close & (place[todo] >= least[todo]) & (place[todo] <= most[todo])]
        if not todo.size:
            break
    return joined(parts), lost_ranges(brackets, parts)


def lost_ranges(brackets, parts):
    """The ranges of which not every crossing has been found."""
    wanted = bincount(brackets.range)
    return flatnonzero(wanted != bincount(concatenate([part.range for part in parts]), minlength=wanted.size))
