"""What a rod may be: the arguments of the public functions, checked before any work."""

from __future__ import annotations

from typing import Any, NamedTuple

from derive.emit.kernels.arithmetic import real


class Given(NamedTuple):
    """The arguments of a sweep."""

    beta: Any
    eta: Any
    length: Any
    clamp_angle: Any


def not_negative(name: str, value: object) -> float:
    """A real number ≥ 0, or an error that names the argument."""
    number = real(name, value)
    if number < 0:
        raise ValueError(f"{name} must not be negative, got {value!r}")
    return number


def positive(name: str, value: object) -> float:
    """A real number > 0, or an error that names the argument."""
    number = real(name, value)
    if number <= 0:
        raise ValueError(f"{name} must be positive, got {value!r}")
    return number


def check(beta, eta, length, clamp_angle):
    """Raise TypeError or ValueError, naming the argument, unless the numbers make a rod."""
    not_negative("beta", beta)
    not_negative("eta", eta)
    positive("length", length)
    real("clamp_angle", clamp_angle)
