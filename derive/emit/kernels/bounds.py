"""What is refused before any work: rods whose answer is no double, or has more equilibria than anybody waits for."""

from __future__ import annotations

from typing import Any, NamedTuple

from derive.emit.kernels.arithmetic import epsilon, pi, real, sqrt

# Of β + η, of that times the length, and of the length: γ, the energy and places, at most thrice as large, are doubles.
LARGEST = 2.0**1020
MANY = 100_000  # equilibria of one rod: half a minute, and half a gigabyte
FOLDS_SLOWEST = 1000  # ℓ√(β + η) to which folds are searched for: hundreds of them, in minutes
EXCHANGES_SLOWEST = 100  # the same for exchanges, a search for folds at each of many forces


class Loads(NamedTuple):
    """What tells how long a rod is for its stiffness."""

    beta: Any
    eta: Any
    length: Any


def within_turns(name, value):
    """A real number that tells an angle to half the digits that there are, or an error that names the argument."""
    number, widest = real(name, value), 1 / sqrt(epsilon())
    if abs(number) > widest:
        turns = "fewer than half of the digits tell where in its turn an angle lies; leave out whole turns"
        raise ValueError(f"{name} must lie within ±{briefly(widest)}, got {value!r}: beyond, {turns}")
    return number


def must_have_answer(beta, eta, length, most):
    """ValueError where numbers of the answer would be too large, or there are too many equilibria to find them all.

    most: the largest index that is wanted, or None for all.
    """
    must_be_finite(beta, eta, length)
    if too_many(beta, eta, length, most):
        slow = length * sqrt(beta + eta)
        why = f"ℓ√(β + η) = {briefly(slow)}, so some {briefly(2 * slow / pi)} equilibria have indices up to half that"
        raise ValueError(f"max_index must be given here, and be less than {MANY // 2}: {why}")


def must_be_finite(beta, eta, length):
    """ValueError where γ, the energy or a place would be too large for a number."""
    if too_large(beta, eta, length):
        why = "γ, the energy or a place is too large for a double; choose another unit of length"
        raise refused(Loads(beta, eta, length), why)


def must_be_searchable(beta, eta, length, slowest):
    """ValueError where β + η at the high ends of their ranges is more than is searched."""
    must_be_finite(beta, eta, length)
    slow = length * sqrt(beta + eta)
    if slow > slowest:
        raise refused(
            Loads(beta, eta, length),
            f"ℓ√(β + η) = {briefly(slow)} at the high end; the limit is {slowest}; choose a lower end or a shorter rod",
        )


def refused(loads, why):
    """The error of a rod that is refused."""
    given = ", ".join(f"{name} = {briefly(value)}" for name, value in zip(loads._fields, loads, strict=True))
    return ValueError(f"{given}: {why}")


def too_large(beta, eta, length):
    """Whether γ, the energy or a place is too large: of numbers or of arrays."""
    load = beta + eta
    return (load > LARGEST) | (load * length > LARGEST) | (length / LARGEST > 1)


def too_many(beta, eta, length, most):
    """Whether more equilibria are wanted than are found at once: of numbers or of arrays.

    No index is more than ℓ√(β + η)/π by more than one (Sturm), and about two equilibria have the same.
    """
    half, least = MANY / 2, pi * MANY / 2
    return ((beta + eta) * length * length > least * least) & (most is None or most >= half)


def briefly(number):
    """A number in a few digits."""
    return f"{float(number):.3g}"
