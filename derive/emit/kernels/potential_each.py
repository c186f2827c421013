"""The kernels of ``potential`` on arrays.

Emitted by `derive emit` from kernels/potential.py: do not edit, change that file.

Digest of the inputs: sha256 59e02ccf732e9bfdf2b90ef5e5f25d31823276f108c4d99bfac7576c8c2c9027
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_cos, each_sin


def moment_from_rest_each(eta, stiffness, double_cosine, double_sine, offset):
    """θ″ = −V′ at an offset from a direction without moment."""
    half = each_sin(offset / 2)
    return (
        each_sin(offset) * (stiffness - 2 * eta * double_cosine * half * half)
        - eta * double_sine * half * each_sin(1.5 * offset)
    )


def fall_from_rest_each(eta, stiffness, double_cosine, double_sine, middle, half):
    """V(middle − half) − V(middle + half), with both angles measured from a direction without moment."""
    wide, narrow = each_sin(middle / 2), each_sin(half / 2)
    even = wide * wide + each_cos(middle) * narrow * narrow
    odd = wide * each_sin(1.5 * middle) + each_cos(2 * middle) * narrow * narrow
    return (
        2
        * each_sin(half)
        * (each_sin(middle) * (stiffness - 2 * eta * double_cosine * even) - eta * double_sine * odd)
    )
