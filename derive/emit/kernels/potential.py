"""θ″, dθ″/dθ and differences of the potential V(θ) = β cos θ + ½η cos²(θ − α), from where V is stationary."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import cos, sin
from derive.emit.kernels.formulas import rest_fall, rest_moment, stiffness_beside


def moment_from_rest(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment(eta, stiffness, double_cosine, double_sine, sin(offset / 2), cos(offset / 2))


def stiffness_from_rest(eta, stiffness, double_cosine, double_sine, offset):
    """dθ″/dθ at an offset from a direction without moment."""
    return stiffness_beside(eta, stiffness, double_cosine, double_sine, sin(offset / 2), cos(offset / 2))


def fall_from_rest(eta, stiffness, double_cosine, double_sine, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    return rest_fall(
        eta,
        stiffness,
        double_cosine,
        double_sine,
        sin(middle / 2),
        cos(middle / 2),
        sin(half / 2),
        cos(half / 2),
    )
