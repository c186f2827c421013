"""Which readings the displays of Section 3 about u, v, y(s), z(s) and the admissible ξ have."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from sympy import Integer

from derive.check.on_rod import OnRod
from derive.check.sections import admissible, elliptic, heights
from derive.paper import tree as t
from derive.theory.weierstrass import Weierstrass, expansion

_KEPT: dict[tuple[str, int], tuple[Weierstrass, tuple[OnRod, ...]]] = {}
OF_RODS = {"omega_1", "omega_2", "omega_3", "omega_bar", "u_bar"}
LOGARITHMIC = {"wzeta", "wsigma"}
OF_LINES = {"v", "ln", *LOGARITHMIC}
OF_HEIGHTS = {"z", "asin", "acosh"}


def readings(
    theory: Any, scope: str, sides: tuple[t.Node, ...], names: set[str], at_one: bool
) -> Iterator[OnRod] | None:
    """The readings, or None if the sides are not about these things."""
    case, functions = theory.cases[scope], theory.weierstrass[scope]
    nodes = [node for side in sides for node in side.walk()]
    kinds, calls = {type(node) for node in nodes}, {node.name for node in nodes if isinstance(node, t.Call)}
    if t.Interval in kinds and names <= {"xi", "xi_a", "xi_b"}:
        return kept("admissible", functions, lambda: admissible.readings(case, functions))
    if names <= elliptic.ANY_LATTICE and "v" in names:
        return kept("any lattice", functions, lambda: iter([elliptic.any_lattice()]))
    turns = case.bends == -1 and "v" in names and not names & LOGARITHMIC  # the side of v depends on the rod
    if names & OF_RODS or t.At in kinds or turns:
        return kept("rods", functions, lambda: elliptic.on_rods(case, functions))
    if names & OF_LINES or "y" in calls:
        alone = at_one or not names & {"a", "b", "c"}
        return kept(f"lines, {alone}", functions, lambda: _lines(case, functions, alone))
    if calls & OF_HEIGHTS or t.Integral in kinds:
        return kept("heights", functions, lambda: heights.readings(case, functions))
    return None


def kept(kind: str, functions: Weierstrass, make: Callable[[], Iterator[OnRod]]) -> Iterator[OnRod]:
    """The readings of a kind, made once for a load case of a theory, so that their points can be kept with them."""
    key = (kind, id(functions))
    if key not in _KEPT:
        _KEPT[key] = (functions, tuple(make()))  # holds the functions, so that no others have their id
    return iter(_KEPT[key][1])


def _lines(case: Any, functions: Any, at_one: bool) -> Iterator[OnRod]:
    """On a line, at the root 1 of f, or at each of its roots."""
    yield elliptic.on_line(case, functions, functions.at_one, ", a = 1")
    if not at_one:
        yield elliptic.on_line(case, functions, expansion(case.f, Integer(-1)), ", a = -1")
