"""The tips of rods that are shorter than any two half-swings, all at once: by where motions are after their length.

On a rod with ℓ√(β + η) < 2π, which no two half-swings fit, that is a function of the tip (``block_arrivals``), whose
slope is nowhere more than cosh(ℓ√(β + η)). What bounds its second derivative (``theory/swing_shots``) tells how many
zeros lie between two samples.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import (
    abs,
    arange,
    argsort,
    concatenate,
    cosh,
    flatnonzero,
    float32,
    full,
    inf,
    isin,
    linspace,
    maximum,
    sinh,
    sqrt,
    unique,
    where,
    zeros,
)

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_sin
from derive.emit.kernels.block_arrivals import load_of, miss
from derive.emit.kernels.block_records import joined, rounded_to, rows
from derive.emit.kernels.block_roots import approached
from derive.emit.kernels.formulas_each import shot_bend_each

SHOT_SLOW = 1.49 * pi  # ℓ√(β + η) up to which the index is known (``block_short``); soon samples are too many
SHOTS = 512  # rods at once
EVEN = 3.0  # step between tips, over the steepest slope
FEWEST_SPANS = 16
ROUGH_HALVINGS = 2  # of spans in single precision
SPAN_HALVINGS = 18  # of the rest
ROUGH_BLUR = 5e-4  # what is missed is right to half of that in single precision (docs/solver.md)
ROUGH_SHOT = 1.2 * pi  # ℓ√(β + η) from which only to
WIDER = 16.0  # times as much
BLUR = 1.5e-11  # the same in double precision, on all
STRAIGHT = 1e-9  # a couple at the clamp times the length squared from which rods are not nearly straight
BLURRED = 4  # roundings of the clamp angle within which directions are taken for it
AIMS = 4  # steps towards a zero
AGAIN = 4  # as often for those that are still far
AIM_SPREAD = 1e-6  # distance of two shares from which they tell a slope
SETTLINGS = 8  # steps to rounding; of most tips the first two suffice
SETTLED = 2.0**-43  # as a share of the reach, what is missed where two more steps leave nothing but rounding
SECANT_SPREAD = 1e-9  # distance of two shares from which they tell a slope better than it is known already


class Shots(NamedTuple):
    """Tips of short rods.

    rod: the number among those given; offset: tip less clamp angle; slope: ∂θ(0)/∂θ(ℓ), nearly; rising: whether that
    is positive.
    """

    rod: Any
    offset: Any
    slope: Any
    rising: Any


class Spans(NamedTuple):
    """Of tips: the rod, the share of its reach at one end, that to the other end, what is missed at both."""

    rod: Any
    first: Any
    width: Any
    before: Any
    after: Any


def is_shot(rods):
    """Which rods are short, and not nearly straight."""
    lean = rods.clamp_angle - rods.field_angle
    couple = rods.beta * each_sin(rods.clamp_angle) + rods.eta / 2 * each_sin(2 * lean)
    # No angle within rounding of the clamp's may be a direction without couple.
    blur = BLURRED * epsilon() * (abs(rods.clamp_angle) + 2) * (rods.beta + rods.eta)
    return (rods.slow < SHOT_SLOW) & (abs(couple) * rods.length * rods.length > STRAIGHT) & (abs(couple) > blur)


def shots_of(rods):
    """All tips of short rods, and the numbers among these of the rods of which they are not sure: they have none."""
    load, sag, blur = load_of(rods), sag_of(rods), ROUGH_BLUR * where(rods.slow < ROUGH_SHOT, 1.0, WIDER)
    spans, unsure = told_apart(load, sag, blur, *sampled_spans(load, sag, blur, rods.slow))
    if unsure.size:
        spans = rows(spans, ~isin(spans.rod, unsure))
    which, ends = spans.rod, (spans.first, spans.first + spans.width, spans.before, spans.after)
    some = rows(load, which)
    share, slope = approached(miss, some, *ends, AIMS, AIM_SPREAD, AGAIN)
    share, slope, lost = settled_shares(some, share, slope)
    found = Shots(which, share * some.reach, slope / some.reach, spans.after > 0)
    # A secant may lead to the tip of another span.
    lost = concatenate([lost, flatnonzero(~((share > ends[0]) & (share < ends[1])))])
    if lost.size:
        unsure = concatenate([unsure, which[lost]])
        found = rows(found, ~isin(which, unsure))
    return found, unique(unsure)


def settled_shares(load, share, slope):
    """The zeros of what is missed, all but to rounding, by secants from nearly there; the slopes; and the numbers of
    those not found so."""
    todo, before, value_before = arange(share.size), share, full(share.shape, inf)
    for _ in range(SETTLINGS):
        here = rows(load, todo) if todo.size < share.size else load
        at = share[todo]
        value, change = miss(here, at), at - before
        told = abs(change) > SECANT_SPREAD
        steep = where(told, (value - value_before) / where(told, change, 1), slope[todo])
        slope[todo], share[todo] = steep, at - value / steep
        left = flatnonzero(~(abs(value) <= SETTLED * here.reach))
        todo, before, value_before = todo[left], at[left], value[left]
        if not left.size:
            break
    return share, slope, todo


def sag_of(rods):
    """By how much |∂²θ(0)/∂θ(ℓ)²| may bend what is missed over a span of 1, for tips measured in radians."""
    half = sinh(rods.slow / 2)
    return shot_bend_each(rods.beta, rods.eta, 2 * half * half) / 2


def no_spans():
    """None."""
    none = zeros(0)
    return Spans(zeros(0, dtype=int), none, none, none, none)


def sampled_spans(load, sag, blur, slow):
    """The load in single precision, and the spans between samples over which what is missed changes its sign, or may
    have zeros without."""
    rough, parts = rounded_to(load, float32), [no_spans()]
    steps = 2 / EVEN * load.reach * cosh(slow)
    order = argsort(steps)
    for start in range(0, slow.size, SHOTS):
        here = order[start : start + SHOTS]
        number = FEWEST_SPANS + int(steps[here[-1]])
        shares = linspace(-1, 1, number + 1)
        values = miss(rows(rough, here), shares.astype(float32)[:, None])
        above, size = values > 0, abs(values)
        size[size <= blur[here].astype(float32)] = -inf
        step = 2 / number * load.reach[here]
        needed = (sag[here] * step * step + 2 * blur[here]).astype(float32)
        # What is not a number is not sure either.
        held = (above[1:] != above[:-1]) | ~(size[1:] + size[:-1] > needed)
        row, which = divmod(flatnonzero(held), held.shape[1])
        before, after = (values[row + k, which].astype(float) for k in (0, 1))
        parts.append(Spans(here[which], shares[row], full(row.size, 2 / number), before, after))
    return rough, joined(parts)


def told_apart(load, sag, blur, rough, spans):
    """The spans with one tip each, and the rods of which a span as small as any leaves a doubt."""
    first, spans = parted(rough, sag, blur, spans, ROUGH_HALVINGS)
    some = rows(load, spans.rod)
    before, after = miss(some, spans.first), miss(some, spans.first + spans.width)
    spans = spans._replace(before=before, after=after)
    second, spans = parted(load, sag, full(sag.size, BLUR), spans, SPAN_HALVINGS)
    return joined([first, second]), spans.rod


def parted(load, sag, blur, spans, times):
    """The spans that hold one tip, of these and of those that come of the others by halving, and what is left of them.

    blur: by how much what is missed may be wrong. Over a span it departs from its chord by no more than sag·width²/4.
    Where it has one sign at both ends, and the sum of their roots is more than the width times √sag, it has no zero
    between; where the sum of what is missed is more than sag·width², it has one if the signs differ, and else none.
    """
    found = []
    for turn in range(times + 1):
        before, after = (maximum(abs(end) - blur[spans.rod], 0) for end in (spans.before, spans.after))
        crossed = (spans.before > 0) != (spans.after > 0)
        width = spans.width * load.reach[spans.rod]
        sum_, both = before + after, before * after
        sure = (sum_ + where(crossed, 0, 2 * sqrt(both)) > sag[spans.rod] * width * width) & (both > 0)
        found.append(rows(spans, sure & crossed))
        spans = rows(spans, ~sure)
        if turn == times or not spans.rod.size:
            break
        spans = halved(load, spans)
    return joined(found), spans


def halved(load, spans):
    """The halves of spans."""
    width, some = spans.width / 2, rows(load, spans.rod)
    middle = spans.first + width
    value = miss(some, middle.astype(some.reach.dtype)).astype(float)
    first = spans._replace(width=width, after=value)
    return joined([first, spans._replace(first=middle, width=width, before=value)])
