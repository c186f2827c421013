"""What the search for equilibria leaves out: bounds on first arrivals, and where they are convex in the energy."""

from __future__ import annotations

import math
from itertools import pairwise

from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from derive.emit.kernels.arrivals import least_arrival
from derive.emit.kernels.ground import clamp_in, ground_of, ridge_of
from derive.emit.kernels.landscape import landscape
from derive.emit.kernels.pieces import pieces
from derive.emit.kernels.places import about, grid
from derive.emit.kernels.sampling import arrives_convexly, fall_between, valley
from derive.emit.kernels.search import crossings
from derive.emit.kernels.time_map import delays, sample_at

ALONG, ACROSS = 0.0, math.pi / 2
shares = st.floats(0, 1) | st.sampled_from([0.0, 0.3, 0.5, 0.5 + 1e-6, 1.0])
angles = st.floats(-6.5, 6.5)


def sampled(share, clamp_angle, field_angle, length=2.0):
    """Every piece of a rod with β + η = 1, with places and what samples it."""
    beta, eta = share, 1 - share
    scene = landscape(beta, eta, field_angle)
    ridge, clamp = ridge_of(beta, eta, field_angle, scene), clamp_in(scene.rests, clamp_angle)
    for piece in pieces(eta, field_angle, ground_of(eta, scene, clamp, ridge)):
        if piece.width > 1e-6:
            ends = delays(piece)
            places = [place for place in grid(beta, eta, length, piece) if abs(place) < 40]
            yield piece, places, lambda place, p=piece, e=ends: sample_at(beta, eta, field_angle, p, e, place)


@given(shares, angles, st.sampled_from([ALONG, ACROSS]) | st.floats(-1.5, 1.5))
@example(0.0, 0.0, -0.875)  # a tip within rounding of the clamp angle
@settings(max_examples=60, deadline=None)
def test_no_motion_arrives_before_the_bound(share, clamp_angle, field_angle):
    """Nor does a lower tip have a lower bound."""
    for piece, places, sample in sampled(share, clamp_angle, field_angle):
        bounds = [least_arrival(share, 1 - share, piece, *about(piece, place)) for place in [*places, math.inf]]
        assert all(bound <= sample(place).arrival * (1 + 1e-9) for place, bound in zip(places, bounds, strict=False))
        assert bounds == sorted(bounds, reverse=True)


@given(shares, angles, st.sampled_from([ALONG, ACROSS]))
@settings(max_examples=60, deadline=None)
def test_arrivals_are_convex_in_the_energy(share, clamp_angle, field_angle):
    """Each sample lies on or below the chord of its neighbours, to rounding, where the search relies on it."""
    for piece, _, sample in sampled(share, clamp_angle, field_angle):
        if not arrives_convexly(field_angle, piece):
            continue
        found = [sample(-9 + 0.6 * k) for k in range(31)]
        falls = [fall_between(1 - share, piece, one.place, other.place) for one, other in pairwise(found)]
        for k, (before, after) in enumerate(pairwise(falls), 1):
            chord = (found[k - 1].arrival * after + found[k + 1].arrival * before) / (before + after)
            assert found[k].arrival <= chord * (1 + 1e-12)


def sign_changes(samples, length):
    """Neighbouring places of which the motion arrives in time from one only."""
    return [(a.place, b.place) for a, b in pairwise(samples) if (a.arrival > length) != (b.arrival > length)]


@given(shares, angles, st.sampled_from([ALONG, ACROSS]), st.floats(0.2, 3.1))
@settings(max_examples=100, deadline=None)
def test_few_samples_bracket_what_many_do(share, clamp_angle, field_angle, length):
    """Every sign change of the arrival less the length between many samples lies between two of the few."""
    for piece, places, sample in sampled(share, clamp_angle, field_angle, length):
        if not arrives_convexly(field_angle, piece):
            continue
        many = [sample(places[0] + (places[-1] - places[0]) * k / 300) for k in range(301)]
        assume(all(abs(item.arrival - length) > 1e-6 for item in many))
        few = valley(sample, places, lambda a, b, p=piece: fall_between(1 - share, p, a, b), length)
        changes, found = sign_changes(many, length), sign_changes(few, length)
        assert len(found) >= len(changes)
        assert all(any(a < high and low < b for a, b in found) for low, high in changes)


def test_a_rod_at_a_fold_has_both_tips_or_none():
    """Where the least arrival is the rod's length to few roundings, with few samples as with many."""
    share, clamp_angle = 0.4, 2.4
    piece, places, sample = next(
        item for item in sampled(share, clamp_angle, ALONG) if arrives_convexly(ALONG, item[0])
    )
    least = min(sample(places[0] + (places[-1] - places[0]) * k / 20000).arrival for k in range(20001))
    assert least < math.pi
    for shift, numbers in ((-1e-3, (0,)), (-1e-12, (0, 2)), (1e-9, (0, 2)), (1e-3, (2,))):
        found = crossings(share, 1 - share, ALONG, least * (1 + shift), piece, math.inf)
        assert len(found) in numbers
