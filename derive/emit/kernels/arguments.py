"""What a rod may be: the arguments of the public functions, checked before any work."""

from __future__ import annotations

from operator import index
from typing import Any, NamedTuple

import numpy as np

from derive.emit.kernels.arithmetic import epsilon, in_a_line, real, sqrt
from derive.emit.kernels.bounds import within_turns

COUNTED = 2**53  # an index beyond is none that a rod has, and no double


class Given(NamedTuple):
    """The parameters of many rods: numbers or arrays."""

    beta: Any
    eta: Any
    length: Any
    clamp_angle: Any
    field_angle: Any


def common_shape(given):
    """The shape to which all parameters broadcast; ValueError if there is none."""
    try:
        return np.broadcast_shapes(*(part.shape for part in given))
    except ValueError:
        shapes = ", ".join(f"{name} {part.shape}" for name, part in zip(given._fields, given, strict=True))
        raise ValueError(f"the arguments do not broadcast against one another: their shapes are {shapes}") from None


def index_limit(max_index):
    """The largest index of equilibria that are wanted: None for no limit, or an integer ≥ 0."""
    if max_index is None:
        return None
    limit = integer("max_index", max_index)
    if limit < 0:
        raise ValueError(f"max_index must not be negative, got {max_index!r}")
    return min(limit, COUNTED)


def integer(name: str, value: Any) -> int:
    """An integer that is no truth value, or an error that names the argument."""
    try:
        number = None if isinstance(value, bool) else index(value)
    except TypeError:
        number = None
    if number is None:
        raise TypeError(f"{name} must be None or an integer, got {value!r}")
    return number


def not_negative(name: str, value: object) -> float:
    """A real number ≥ 0, or an error that names the argument."""
    number = real(name, value)
    if number < 0:
        raise ValueError(f"{name} must not be negative, got {value!r}")
    return abs(number)  # no negative zero


def positive(name: str, value: object) -> float:
    """A real number > 0, or an error that names the argument."""
    number = real(name, value)
    if number <= 0:
        raise ValueError(f"{name} must be positive, got {value!r}")
    return number


def all_not_negative(name, values):
    """Real numbers ≥ 0, or an error that names the argument and the flat index of the first that is none."""
    numbers = all_real(name, values)
    refuse(name, numbers, numbers < 0, "must not be negative")
    return np.abs(numbers)  # no negative zero


def all_positive(name, values):
    """Real numbers > 0, or an error that names the argument and the flat index of the first that is none."""
    numbers = all_real(name, values)
    refuse(name, numbers, numbers <= 0, "must be positive")
    return numbers


def all_within_turns(name, values):
    """Real numbers that tell angles, or an error that names argument and flat index of the first that does not."""
    numbers = all_real(name, values)
    for place in np.flatnonzero(np.abs(numbers) > 1 / sqrt(epsilon()))[:1].tolist():
        within_turns(f"{name}[{place}]" if numbers.ndim else name, float(numbers.flat[place]))
    return numbers


def all_real(name, values):
    """A number or an array of them as finite doubles; TypeError or ValueError names the argument and the place."""
    if hasattr(values, "mask"):
        raise TypeError(f"{name} must be a number or an array without a mask, got {in_a_line(values)}")
    kind = getattr(getattr(values, "dtype", None), "kind", "")
    if kind and kind in "fiu":
        numbers = np.asarray(values, dtype=float)
        finite = np.isfinite(numbers)
        if not np.all(finite):
            refuse(name, numbers, ~finite, "must be finite")
        return numbers
    # What is no array of numbers by its type is looked at one by one: lists, fractions, and what must be refused.
    try:
        items = np.asarray(values, dtype=object)
    except ValueError:
        raise ValueError(f"{name} must be a number or an array: its rows have different lengths") from None
    if not items.ndim:
        return np.asarray(real(name, values))
    flat = [real(f"{name}[{place}]", item) for place, item in enumerate(items.ravel().tolist())]
    return np.asarray(flat, dtype=float).reshape(items.shape)


def refuse(name, numbers, bad, why):
    """Raise ValueError at the first number that is bad."""
    if np.any(bad):
        place = int(np.argmax(bad))
        where = f"{name}[{place}]" if np.ndim(numbers) else name
        raise ValueError(f"{where} {why}, got {float(np.ravel(numbers)[place])!r}")
