"""The kernels of ``potential`` on arrays.

Emitted by `derive emit` from kernels/potential.py: do not edit, change that file.

Digest of the inputs: sha256 c0da6effe2e4dc16ec79255b317d7740ed7eb210496722df7a5ab9c18c41bd14
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_cos, each_sin
from derive.emit.kernels.formulas_each import rest_fall_each, rest_moment_each, stiffness_beside_each


def moment_from_rest_each(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment_each(eta, stiffness, double_cosine, double_sine, each_sin(offset / 2), each_cos(offset / 2))


def stiffness_from_rest_each(eta, stiffness, double_cosine, double_sine, offset):
    """dθ″/dθ at an offset from a direction without moment."""
    return stiffness_beside_each(eta, stiffness, double_cosine, double_sine, each_sin(offset / 2), each_cos(offset / 2))


def fall_from_rest_each(eta, stiffness, double_cosine, double_sine, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    return rest_fall_each(
        eta,
        stiffness,
        double_cosine,
        double_sine,
        each_sin(middle / 2),
        each_cos(middle / 2),
        each_sin(half / 2),
        each_cos(half / 2),
    )
