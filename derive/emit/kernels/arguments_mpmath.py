"""The arguments of the mpmath twin, where arrays are lists: what differs from ``arguments``."""

from __future__ import annotations

from collections.abc import Iterable

from mpmath import mp

from derive.emit.kernels.arguments import integer, not_negative, positive
from derive.emit.kernels.arithmetic import real
from derive.emit.kernels.bounds import within_turns

FEWEST = 15  # decimal digits
MOST = 1000


def digits(dps):
    """The decimal digits to work with: those that are asked for, else the caller's; from 15 to 1000."""
    wanted = mp.dps if dps is None else integer("dps", dps)
    if not FEWEST <= wanted <= MOST:
        whose = "dps" if dps is not None else "the precision of the caller, mp.dps,"
        raise ValueError(f"{whose} must be from {FEWEST} to {MOST} digits, got {wanted}")
    return wanted


def of_one_length(given):
    """The rods, a tuple of parameters for each; numbers are repeated. ValueError where sequences differ in length."""
    lengths = {len(part) for part in given if isinstance(part, list)}
    if len(lengths - {1}) > 1:
        sizes = [
            f"{name} {len(part)}" for name, part in zip(given._fields, given, strict=True) if isinstance(part, list)
        ]
        raise ValueError(f"sequences must have one length: their lengths are {', '.join(sizes)}")
    rows = 1 if not lengths or lengths == {1} else max(lengths - {1})
    columns = [part if isinstance(part, list) else [part] for part in given]
    return list(zip(*(column * rows if len(column) == 1 else column for column in columns), strict=True))


def element(case, values):
    """A parameter of one rod, of a number or a list; what is folded stays as it is."""
    if not isinstance(values, list):
        return values
    return values[case % len(values)]


def all_not_negative(name, values):
    """Real numbers ≥ 0, or an error that names the argument and the index of the first that is none."""
    return each_of(not_negative, name, values)


def all_positive(name, values):
    """Real numbers > 0, or an error that names the argument and the index of the first that is none."""
    return each_of(positive, name, values)


def all_within_turns(name, values):
    """Real numbers that tell angles, or an error that names the argument and the index of the first that is none."""
    return each_of(within_turns, name, values)


def all_real(name, values):
    """A number, or a sequence of them as a list; TypeError or ValueError names the argument and the place."""
    return each_of(real, name, values)


def each_of(convert, name, values):
    """A number or a list, each converted under its own name."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        return convert(name, values)
    return [convert(f"{name}[{place}]", value) for place, value in enumerate(values)]
