"""Where the branches of many rods are sampled: ``sampling.places`` on arrays, and which ranges need no look."""

from __future__ import annotations

from numpy import abs, arange, array, clip, concatenate, exp, log, maximum, minimum, sort, where

from derive.emit.kernels.arithmetic import epsilon
from derive.emit.kernels.arrivals_each import least_arrival_each
from derive.emit.kernels.levels_each import slope_each

ROUGH_DEPTH = 28.0  # places up to which squares of offsets are numbers in single precision
LATEST = 12.0  # places beyond which a count is its limit, but for the doubts of a hundred thousandth of all ranges
SMALLEST = 1e-30  # instead of less, where it is divided by
SURELY = 1e-5  # bounds count where they hold by this much more than they must
HALVINGS = 4  # of the stretch at the low end in which no motion arrives in time
AROUND = concatenate([-(0.5 ** arange(13)), [0], 0.5 ** arange(12, -1, -1)])  # places about a dip


def in_time(rods, piece):
    """Which ranges have a motion that may arrive in time."""
    first = least_arrival_each(rods.beta, rods.eta, piece, piece.low_offset + piece.width, piece.clamp_gap)
    return first <= (1 + SURELY) * rods.length


def ends(rods, piece):
    """The places of the deepest samples: see ``places.grid``."""
    rounding = -log(epsilon())
    first = minimum(-2 * rods.slow - 6, -rounding) if piece.low_kind == "level" else -rods.slow - 6
    late = first
    for k in range(1, HALVINGS + 1):
        trial = late - first * 0.5**k
        offset = piece.low_offset + piece.width / (1 + exp(-trial))
        left = piece.clamp_gap + piece.width / (1 + exp(trial))
        least = least_arrival_each(rods.beta, rods.eta, piece, offset, left)
        late = where(least > (1 + SURELY) * rods.length, trial, late)
    if piece.high_kind == "level":
        last = 2 * rods.slow + rounding
    elif piece.high_kind == "turn":
        last = LATEST + 0 * rods.slow
    else:
        moment = abs(slope_each(rods.eta, piece.clamp_rest, piece.clamp_offset)) + SMALLEST
        deeper = 4 + log(2 * piece.width) - log(moment) - 2 * log(rods.length)
        last = where(piece.high_depth == 0, rounding, maximum(LATEST, deeper))
    return late, last


def places_of(dip, first, last, step):
    """The places of samples, a column for each range: from the lowest up, and closer around dips."""
    below, above = spaced(-first.min(), step), spaced(last.max(), step)
    places = concatenate([first * below[:0:-1, None], last * above[:, None]])
    if dip is None:
        return places
    return sort(concatenate([places, clip(dip + AROUND[:, None], first, last)]), axis=0)


def spaced(deepest, step):
    """Places from 0 to the deepest one, as shares of it."""
    places, growth = [0.0], 1 + step / 3
    while places[-1] < deepest:
        places.append(places[-1] + step)
        step *= growth
    return array([*places[:-1], deepest]) / max(deepest, 1e-30)
