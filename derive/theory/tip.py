"""The solution expanded at the tip, a = ξ(ℓ): real on the whole rod, and regular at double roots.

With σ = ℓ − s, ξ = ξ(ℓ) + b/(℘(σ) − c), since ℘ has its pole where ξ = a. The values e₊, e₋, e_o of ℘ at the roots 1,
−1 and ξ_o are its three half-period values. The formulas are what solvers evaluate: constants of the tip in
``tip_constants`` and ``tip_clamp``, ℘ at points in ``tip_points``, integrals along the rod in ``tip_arcs``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, cancel

from .claims import Formula, Notebook
from .load_case import LoadCase
from .tip_arcs import write_arcs
from .tip_clamp import write_clamp
from .tip_constants import write_directions, write_tip
from .tip_names import Writer, definitions
from .tip_points import SIGNS, write_points, write_roots
from .weierstrass import Weierstrass


@dataclass(frozen=True)
class Tip:
    """The expansion at the tip of one load case: b, c, the roots less c, and the formulas."""

    b: Expr
    c: Expr
    roots: Mapping[str, Expr]
    formulas: tuple[Formula, ...]


def derive(cases: Mapping[str, LoadCase], functions: Mapping[str, Weierstrass], book: Notebook) -> Mapping[str, Tip]:
    """The formulas of all load cases."""
    return {name: _case(case, functions[name], book) for name, case in cases.items()}


def _case(case: LoadCase, functions: Weierstrass, book: Notebook) -> Tip:
    """All formulas of one load case."""
    book.say(f"Section 3, load case {case.name}: expanded at the tip")
    writer = Writer(case, book, definitions(case))
    write_tip(case, writer)
    b, c = functions.at_tip.b, functions.at_tip.c
    # e_r − c = b/(r − ξ(ℓ)); for a cubic f the fourth root is at infinity, and e_o = c.
    roots = {side: cancel(functions.at_tip.value_at(sign) - c) for side, sign in SIGNS.items()}
    roots["other"] = cancel(functions.at_tip.value_at(case.other_root) - c) if case.other_root is not None else b * 0
    write_roots(case, functions, roots, writer)
    write_points(case, b, roots, writer)
    write_clamp(writer)
    write_directions(case, writer)
    write_arcs(case, functions.at_tip, roots, writer)
    return Tip(b, c, roots, tuple(writer.formulas))


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("tip")


if __name__ == "__main__":
    main()
