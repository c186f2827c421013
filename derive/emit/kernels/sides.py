"""A rod seen from either side of the y axis: tips above the clamp angle are below it on the other side."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, floor, less_quarters, pi
from derive.emit.kernels.ground import Clamp, clamp_in
from derive.emit.kernels.landscape import landscape
from derive.emit.kernels.rests import mirror_landscape


def principal(field_angle):
    """The field angle less half turns, in (−π/2, π/2]; one within rounding of a quarter turn is that."""
    if field_angle == 0 or field_angle == pi / 2:
        return field_angle
    half_turns = floor(field_angle / pi + 0.5)
    angle = less_quarters(field_angle, 2 * half_turns)
    blur = 2 * epsilon() * abs(field_angle)
    if abs(angle) <= (blur if half_turns else epsilon() ** 3):
        return 0 * angle
    return pi / 2 if pi / 2 - abs(angle) <= blur else angle


def reflected(field_angle):
    """The field angle seen from the other side of the y axis."""
    if field_angle == 0 or field_angle == pi / 2:
        return field_angle
    return -field_angle


def landscapes(beta, eta, field_angle):
    """The landscape of a rod, and that of its mirror image."""
    if reflected(field_angle) == field_angle:
        scene = landscape(beta, eta, field_angle)
        return scene, scene
    scene = landscape(beta, eta, abs(field_angle))
    mirrored = mirror_landscape(scene)
    return (scene, mirrored) if field_angle > 0 else (mirrored, scene)


def mirrored_clamp(scene, other, clamp, mirrored):
    """The clamp seen from the other side of the y axis, in the landscape there; mirrored: the clamp angle there."""
    if clamp.offsets[0] > 0 and other.rests[0].angle == -scene.rests[0].angle:  # number by number the same
        return Clamp(-1 - clamp.turns, tuple([-offset for offset in clamp.offsets[::-1]]))
    return clamp_in(other.rests, mirrored)
