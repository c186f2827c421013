"""What grows: a series of amounts of work, each prepared as a call."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from importlib import import_module
from math import pi
from typing import Any

import numpy as np

from derive.measure.rods import PAPER

RODS = (PAPER.length, PAPER.clamp_angle)
LONG, MOST_INDEX = (0.3, 0.7, 40.0, 2.0, 0.4), 6  # ℓ√(β + η) = 40
SHUFFLE = 7  # the seed of the order of formulas and of points


@dataclass(frozen=True)
class Series:
    """prepare: from an amount to the call. counted: the work that a call's result says it was, where not the amount."""

    name: str
    variable: str
    amounts: Sequence[int]
    prepare: Callable[[int], Callable[[], Any]]
    counted: Callable[[Any], int] | None = None


def shape(number: int) -> Callable[[], Any]:
    """θ, y, z of the article's rod, solved before."""
    module = import_module("generated.parallel_numpy")
    found = module.equilibria(PAPER.beta, PAPER.eta, *RODS)[0]
    return partial(module.shape, found, np.linspace(0.0, PAPER.length, number))


def shuffled(number: int) -> Callable[[], Any]:
    """θ, y, z of a long rod with several half-swings in an inclined field, solved before; its points in no order."""
    module = import_module("generated.oblique_numpy")
    found = max(module.equilibria(*LONG, max_index=MOST_INDEX), key=lambda one: int(one.index))
    return partial(module.shape, found, np.random.default_rng(SHUFFLE).permutation(np.linspace(0.0, LONG[2], number)))


def field_alone(scaled: int) -> Callable[[], Any]:
    """All equilibria of a rod in a field alone, with ℓ√η = scaled."""
    return partial(import_module("generated.field_only_numpy").equilibria, 1.0, float(scaled), 3 * pi / 4)


def twin(digits: int) -> Callable[[], Any]:
    """All equilibria of the article's rod."""
    module = import_module("generated.parallel_mpmath")
    return partial(module.equilibria, PAPER.beta, PAPER.eta, *RODS, dps=digits)


def sweep(number: int) -> Callable[[], Any]:
    """Rods of the article's second example, the field growing."""
    loads = np.full(number, PAPER.beta), np.linspace(1e-6, 1e-3, number)
    return partial(import_module("generated.bifurcation_numpy").sweep, *loads)


def formulas(number: int) -> Callable[[], Any]:
    """Some of the article's displays, judged from nothing but the theory."""
    from sympy.core.cache import clear_cache

    from derive.check.printed import judge_formulas
    from derive.paper.ledger import load_ledger

    ledger = load_ledger()
    names = sorted(ledger)
    order = np.random.default_rng(SHUFFLE).permutation(len(names))[:number]
    chosen = {names[k]: ledger[names[k]] for k in order}
    whole = theory()

    def call() -> Any:
        clear_cache()
        return judge_formulas(whole, chosen)

    return call


@cache
def theory() -> Any:
    """The whole derivation, once."""
    from derive.theory.chain import derive_all

    return derive_all()


SERIES = (
    Series("a shape", "points", (100, 1000, 10_000, 100_000, 1_000_000), shape),
    Series("a long rod's shape, points shuffled", "points", (100, 1000, 10_000, 100_000, 1_000_000), shuffled),
    Series("all equilibria, field alone", "equilibria", (10, 30, 100, 300, 1000, 3000), field_alone, len),
    Series("all equilibria, mpmath", "digits", (15, 30, 60, 120, 240, 480), twin),
    # The last amount is ten blocks, which shows whether memory is bounded by the block.
    Series("a sweep", "rods", (80, 800, 8000, 80_000), sweep),
    Series("formulas judged", "formulas", (4, 8, 16, 32, 64), formulas),
)
