"""At which places of a piece half-swing and first arrival are sampled.

A sample has a place, a swing and an arrival.
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, exp, floor, inf, pi, sqrt
from derive.emit.kernels.arrivals import least_arrival
from derive.emit.kernels.levels import fall
from derive.emit.kernels.places import about, places

SAFE = 1e-9  # bounds count where they hold by this much more than they must
NEAREST = 0.3  # about the least distance of places between which a branch may have two extrema, 0.6 seen


def samples_on(beta, eta, field_angle, length, piece, sample, short, last):
    """Samples of a piece, near enough for all crossings of whole numbers up to the last.

    short: the rod is shorter than any half-swing.
    """

    def too_low(place):
        return least_arrival(beta, eta, piece, *about(piece, place)) > (1 + SAFE) * length

    def fallen(one, other):
        return fall_between(eta, piece, one, other)

    if too_low(inf):
        return []
    wanted = places(beta, eta, field_angle, length, piece)
    first = 0
    while first + 2 < len(wanted) and too_low(wanted[first + 1]):
        first += 1
    if short and arrives_convexly(field_angle, piece):
        return valley(sample, wanted[first:], fallen, length)
    # A motion that arrives before the stiffest pendulum is down arrives the sooner, the nearer its tip (Sturm).
    quarter = pi / 2 / sqrt(beta + eta)
    soon = (1 - SAFE) * min(quarter, length) if short and piece.high_kind == "clamp" else 0
    samples = refined(sample, sampled(sample, wanted, first, soon), length, last)
    end = end_sample(piece, samples[-1])
    return samples if end is None else [*samples, end]


def sampled(sample, places, first, soon):
    """Samples from the first place on to one from which the motion arrives soon.

    Nothing before and after is as long as the rod. One more is taken where the branches do not fall from there, or to
    there.
    """
    found = [sample(place) for place in places[first : first + 2]]
    for place in places[first + 2 :]:
        if found[-1].arrival < soon and found[-1].arrival < found[-2].arrival:
            break
        found.append(sample(place))
    while first > 0 and not falls(*found[:2]):
        first -= 1
        found.insert(0, sample(places[first]))
    return found


def falls(one, other):
    """Whether no branch is longer at the second one."""
    less, apart = one.swing - other.swing, one.arrival - other.arrival
    return apart >= 0 and 2 * less >= apart


def refined(sample, samples, length, last):
    """More samples where half-swing or arrival bend between neighbours, as far as the rod's length is sensitive."""
    done, todo = [samples[0]], samples[:0:-1]
    while todo:
        before, after = done[-1], todo[-1]
        apart = after.place - before.place > max(NEAREST, 8 * epsilon() * abs(before.place))
        beside = [(done[-2], before, after)] if len(done) > 1 else []
        beside += [(before, after, todo[-2])] if len(todo) > 1 else []
        if apart and any(bends(one, two, three, length, last) for one, two, three in beside):
            todo.append(sample((before.place + after.place) / 2))
        else:
            done.append(todo.pop())
    return done


def bends(first, second, third, length, last):
    """Whether the curves bend so much at the second sample that a count may reach a whole number unseen beside it.

    Those beyond the last are not wanted. By how far the straight line through two samples misses the third.
    """
    share = (third.place - second.place) / (second.place - first.place)
    swing = third.swing - second.swing - share * (second.swing - first.swing)
    arrival = third.arrival - second.arrival - share * (second.arrival - first.arrival)
    least = min(first.swing, second.swing, third.swing)
    reach = (abs(arrival) + (length / least * abs(swing) if length > least else 0)) / (2 * least)
    for sign in (1, -1):
        for item in (first, second, third):
            count = (length - sign * item.arrival) / (2 * item.swing)
            whole = min(floor(count + 0.5), last)
            if abs(count - whole) < reach and (whole > 0 or (whole == 0 and sign > 0)):
                return True
    return False


def end_sample(piece, last):
    """The high end itself, where its times are known: arrival at once, or after the whole half-swing."""
    if piece.high_kind == "clamp" and piece.clamp_gap == 0 and piece.high_depth > 0:
        return last._replace(place=last.place + 1e3, arrival=0 * last.swing)
    if piece.high_kind == "turn":
        return last._replace(place=last.place + 1e3, arrival=last.swing)
    return None


def arrives_convexly(field_angle, piece):
    """Whether the first arrival is a convex function of the energy V(tip): see docs/solver.md."""
    basin = piece.basin
    known = basin.even or (field_angle == 0 and basin.far_rise == 0)
    return known and piece.clamp_gap > piece.high_depth


def fall_between(eta, piece, one, other):
    """How far V falls from the tip at a place to that at a higher one."""
    rise, drop = piece.width / (1 + exp(-one)), piece.width / (1 + exp(one))
    further = piece.width / (1 + exp(-other)) - rise if one < 0 else drop - piece.width / (1 + exp(other))
    from_hill, depth = piece.low_offset + rise, piece.high_depth + drop
    if from_hill < depth:
        return fall(eta, piece.basin.hill, from_hill, further)
    return fall(eta, piece.basin.well, -depth, further)


def valley(sample, places, fallen, length):
    """Samples on both sides of every crossing of a length that is shorter than a half-swing, for a convex arrival.

    Without a crossing there may be none. fallen(low, high): how far V falls between the tips at two places.
    """
    last = len(places) - 1
    found = [sample(places[k]) for k in sorted({last // 4, last // 2, last - last // 4})]
    while min(item.arrival for item in found) > length:
        gap = open_gap(found, places, fallen, length)
        if gap is None:
            return []
        found.insert(gap, sample(inside(places, *ends_of(found, places, gap))))
    while found[0].arrival <= length and found[0].place > places[0]:
        found.insert(0, sample(max(place for place in places if place < found[0].place)))
    while found[-1].arrival <= length and found[-1].place < places[-1]:
        found.append(sample(min(place for place in places if place > found[-1].place)))
    return found


def ends_of(found, places, gap):
    """The places between which a gap lies: before the sample of its number, or behind the last."""
    return found[gap - 1].place if gap > 0 else places[0], found[gap].place if gap < len(found) else places[-1]


def inside(places, low, high):
    """The middle one of the places in a gap; where there is none, half way, or its end if that is one of all."""
    within = [place for place in places if low < place < high]
    if within:
        return within[len(within) // 2]
    return (low + high) / 2


def open_gap(found, places, fallen, length):
    """The gap beside the least sample in which a convex arrival may be least and no longer than the length, or None."""
    least = min(range(len(found)), key=lambda k: found[k].arrival)
    best, bound = None, (1 + SAFE) * length
    for gap in (least, least + 1):
        low, high = ends_of(found, places, gap)
        if high - low > 2 * sqrt(epsilon()) * (1 + abs(found[least].place)):
            lowest = convex_bound(found, gap, fallen(low, high), fallen)
            if lowest <= bound:
                best, bound = gap, lowest
    return best


def convex_bound(found, gap, width, fallen):
    """What a convex arrival is nowhere less than in a gap before a sample: the chords beside it, carried on.

    width: how far V falls from one end of the gap to the other.
    """
    bound = -inf
    for near, far in ((gap - 1, gap - 2), (gap, gap + 1)):
        if min(near, far) >= 0 and max(near, far) < len(found):
            beside = abs(fallen(found[near].place, found[far].place))
            if beside > 0:
                steep = (found[far].arrival - found[near].arrival) / beside
                bound = max(bound, found[near].arrival - max(steep * width, 0))
    return bound
