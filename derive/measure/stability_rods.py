"""Which arguments the solver hands to its formulas: rods of all exponents, and a listener in the kernels.

A formula's claim holds under hypotheses that tie its arguments to one another. A rod fulfils them all, so the search is
over rods: what the kernels pass is the domain, to rounding.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from math import copysign, pi
from types import ModuleType

from derive.emit.kernels import formulas as emitted
from derive.emit.kernels.equilibria import all_equilibria
from derive.emit.kernels.shapes import angle_and_position
from derive.measure.reference import Rod

KERNELS = emitted.__name__.rpartition(".")[0] + "."
MOST_INDEX = 2
MOST_SHAPES = 3
PLACES = (0.0, 0.03, 0.31, 0.5, 0.77, 0.999)
KEPT = 60  # arguments of one formula that are examined on one rod

Arguments = tuple[float, ...]


@dataclass(frozen=True)
class Genes:
    """A rod by exponents: β, η and ℓ, and how far clamp and field are from an angle; field_sign 0: not at all."""

    beta: float
    eta: float
    length: float
    clamp_at: float
    clamp_off: float
    clamp_sign: float
    field_at: float
    field_off: float
    field_sign: float

    def rod(self) -> Rod:
        """The rod itself."""
        clamp = self.clamp_at + copysign(10**self.clamp_off, self.clamp_sign)
        angle = self.field_at + (copysign(10**self.field_off, self.field_sign) if self.field_sign else 0.0)
        return Rod(10**self.beta, 10**self.eta, 10**self.length, clamp, angle)


def drawn(rng: random.Random) -> Genes:
    """Any rod: one load is 1, the other of any exponent; angles at, near or far from a quarter turn."""
    weaker = -(10 ** rng.uniform(-1, 1.5)) if rng.random() < 0.7 else 0.0
    loads = (0.0, weaker) if rng.random() < 0.5 else (weaker, 0.0)
    return Genes(
        *loads,
        rng.uniform(-2, 1.5),
        rng.choice((0.0, pi / 2, pi, -pi / 2)),
        rng.uniform(-12, 0.2),
        rng.choice((-1.0, 1.0)),
        rng.choice((0.0, pi / 2)),
        rng.uniform(-12, -0.1),
        rng.choice((-1.0, 0.0, 1.0)),
    )


def beside(genes: Genes, rng: random.Random, size: float) -> Genes:
    """Genes with one or two exponents moved."""
    names = rng.sample(("beta", "eta", "length", "clamp_off", "field_off"), rng.choice((1, 2)))
    moved = {name: getattr(genes, name) + rng.gauss(0, size) for name in names}
    moved = {name: max(-40.0, min(value, 1.7 if name == "length" else 0.4)) for name, value in moved.items()}
    return replace(genes, **moved)


def kernels() -> list[ModuleType]:
    """All kernels that are at work, but for the formulas themselves."""
    return [module for name, module in sys.modules.items() if name.startswith(KERNELS) and module is not emitted]


@contextmanager
def listening(names: Sequence[str], heard: dict[str, list[Arguments]]) -> Iterator[None]:
    """While it lasts, what the kernels hand to these formulas is heard."""
    put_back = []

    def ear(name: str) -> object:
        function = getattr(emitted, name)

        def called(*arguments: float) -> float:
            heard.setdefault(name, []).append(tuple(float(argument) for argument in arguments))
            return float(function(*arguments))

        return called

    try:
        for module in kernels():
            for name in names:
                if vars(module).get(name) is getattr(emitted, name):
                    put_back.append((module, name))
                    setattr(module, name, ear(name))
        yield
    finally:
        for module, name in put_back:
            setattr(module, name, getattr(emitted, name))


def heard_on(rod: Rod, name: str) -> list[Arguments]:
    """Arguments that the kernels hand to a formula for a rod's equilibria and shapes: KEPT at most, evenly chosen."""
    heard: dict[str, list[Arguments]] = {}
    # A rod on which the solver fails is the atlas's matter; what was heard before counts.
    with listening([name], heard), suppress(ArithmeticError):
        found = all_equilibria(rod.beta, rod.eta, rod.length, rod.clamp_angle, rod.field_angle, MOST_INDEX)
        for one in found[:MOST_SHAPES]:
            for place in PLACES:
                angle_and_position(one, place * rod.length)
    every = list(dict.fromkeys(heard.get(name, [])))
    return every[:: -(-len(every) // KEPT) or 1]
