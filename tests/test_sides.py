"""What is found once for both sides of a rod is what each side would find."""

from __future__ import annotations

from math import isclose, pi

from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from derive.emit.kernels.ground import clamp_in, ridge_along, ridge_at, ridge_of
from derive.emit.kernels.sides import landscapes, mirrored_clamp, reflected

shares = st.floats(0, 1) | st.sampled_from([0.0, 0.3, 0.5 - 1e-9, 0.5, 1.0])
fields = st.sampled_from([0.0, pi / 2]) | st.floats(-1.57, 1.57)


@given(shares, fields, st.floats(-20, 20), st.integers(-3, 3) | st.none())
@example(0.3, 0.0, 0.0, 1)
@settings(max_examples=300, deadline=None)
def test_the_clamp_seen_from_the_other_side(share, field_angle, clamp_angle, turns):
    """Number by number; also at a direction itself, and whole turns from it."""
    scene, other = landscapes(share, 1 - share, field_angle)
    angles = [clamp_angle] if turns is None else [rest.angle + 2 * pi * turns for rest in scene.rests]
    for angle in angles:
        clamp = clamp_in(scene.rests, angle)
        assert mirrored_clamp(scene, other, clamp, -angle) == clamp_in(other.rests, -angle)


@given(shares, fields)
@settings(max_examples=100, deadline=None)
def test_one_landscape_has_one_ridge(share, field_angle):
    scene, other = landscapes(share, 1 - share, field_angle)
    if other is scene:
        loads = share, 1 - share
        assert ridge_of(*loads, field_angle, scene) == ridge_of(*loads, reflected(field_angle), other)


@given(st.floats(1e-12, 0.5, exclude_max=True))
@settings(max_examples=200, deadline=None)
def test_a_ridge_along_the_force_is_that_for_any_field(share):
    """In closed form and by its level: the ends are as far from the hill and from the well."""
    scene, _ = landscapes(share, 1 - share, 0.0)
    assume(len(scene.rests) == 5)
    ridge, drop = ridge_of(share, 1 - share, 0.0, scene), 2 * share
    known = ridge_at(share, 1 - share, 1.0, scene.rests, drop)  # by the rests alone
    assert ridge == ridge_along(share, 1 - share, ridge.drop)
    assert isclose(ridge.drop, drop, rel_tol=1e-15)
    assert isclose(ridge.level, known.level, rel_tol=1e-14)
    assert isclose(ridge.depth, known.depth, rel_tol=1e-14)
