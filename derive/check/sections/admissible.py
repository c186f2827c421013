"""Readings for ξ ∈ […]: the values that ξ takes on rods, inside, at the free end, and on the straight rods θ ≡ 0, π."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sympy import Integer

from derive.check.on_rod import OnRod
from derive.check.sample import Sampler
from derive.check.sections.letters import constants, named
from derive.theory.claims import Domain
from derive.theory.load_case import COSINES, LoadCase, xi_tip
from derive.theory.symbols import xi
from derive.theory.weierstrass import Weierstrass


def readings(case: LoadCase, functions: Weierstrass) -> Iterator[OnRod]:
    """Inside the rod, where f > 0; at its end; and where a straight rod is."""
    inside = case.domain(**{case.constant.name: case.ends, "xi": COSINES})
    base = OnRod(
        title=f"{case.name}, along a rod",
        values={**constants(case, functions, functions.at_one), "xi": xi},
        domain=replace(inside, conditions=(case.f_hat,)),
        polynomials={"f": case.f, "f_hat": case.f_hat},
        hypotheses=named(case, functions, functions.at_one),
    )
    yield base
    assert case.other_root is not None
    for one in functions.uo_cases:
        yield _at_root(case, base, f"at the free end, {one.condition}", one.domain, None, one.value == "xi_a")
    for side in map(Integer, (1, -1)):
        other = case.other_root.subs(xi_tip, side)
        for first, gap in ((True, other - side), (False, side - other)):
            domain = replace(case.domain(), conditions=(gap,))
            if next(Sampler([gap], domain).points(1), None) is not None:
                yield _at_root(case, base, f"on the straight rod ξ = {side}", domain, side, first)


def _at_root(case: LoadCase, base: OnRod, title: str, domain: Domain, value: Integer | None, is_first: bool) -> OnRod:
    """ξ at a root of f̂: the smaller one if is_first; value: ±1, or any ξ(ℓ)."""
    here = xi_tip if value is None else value

    def put(expression):  # type: ignore[no-untyped-def]  # values of any kind
        return expression.subs(case.constant, case.tip_constant).subs(xi_tip, here)

    assert case.other_root is not None
    pair = (here, put(case.other_root)) if is_first else (put(case.other_root), here)
    values = {name: put(one) for name, one in base.values.items()}
    return replace(
        base,
        title=f"{case.name}, {title}",
        values=values | {"xi": here, "xi_a": pair[0], "xi_b": pair[1]},
        domain=domain,
        polynomials={name: put(one) for name, one in base.polynomials.items()},
        hypotheses=tuple((old, put(new)) for old, new in base.hypotheses),
    )
