"""The kernels of ``potential`` on arrays.

Emitted by `derive emit` from kernels/potential.py: do not edit, change that file.

Digest of the inputs: sha256 289ea609df9f2927dcff1493905d58bf7856207011825aa5433a3c0d2870b204
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_cos, each_sin
from derive.emit.kernels.formulas_each import rest_fall_each, rest_moment_each


def moment_from_rest_each(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    return rest_moment_each(eta, stiffness, double_cosine, double_sine, each_sin(offset / 2), each_cos(offset / 2))


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
