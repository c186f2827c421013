"""Differences of the potential V(θ) = β cos θ + ½η cos²(θ − α), measured from a direction where V is stationary."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import cos, sin


def moment_from_rest(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    half = sin(offset / 2)
    return sin(offset) * (stiffness - 2 * eta * double_cosine * half * half) - eta * double_sine * half * sin(
        1.5 * offset
    )


def fall_from_rest(eta, stiffness, double_cosine, double_sine, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    wide, narrow = sin(middle / 2), sin(half / 2)
    even = wide * wide + cos(middle) * narrow * narrow
    odd = wide * sin(1.5 * middle) + cos(2 * middle) * narrow * narrow
    return 2 * sin(half) * (sin(middle) * (stiffness - 2 * eta * double_cosine * even) - eta * double_sine * odd)
