"""T2: all equilibria of the moderate rods on which every emitted module is run, in four load cases."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from derive.measure.bench import judged, known
from derive.measure.bench.cells import Problem
from derive.measure.bench.families import Plan
from derive.measure.reference import DIGITS
from derive.measure.rods import rods

TITLE = "all equilibria"
NOTE = "Ours needs no guess; the others get nine, up to three radians to both sides of the clamp angle."
CASES = {
    "parallel": "force and field",
    "field_only": "no force",
    "force_only": "no field",
    "oblique": "field at any angle",
}


def problems(plan: Plan) -> Iterator[Problem]:
    """A problem for each load case; inputs are the case and its rods."""
    for case, title in CASES.items():
        chosen = rods(case)[:4:3] if plan.quick else rods(case)
        wanted = [known.equilibria(plan.cache, rod, DIGITS) for rod in chosen]
        judge = partial(judged.of_equilibria, rods=chosen, wanted=wanted, digits=DIGITS)
        name = f"T2-{case}"
        yield Problem(name, "T2", f"{TITLE}: {title}", "rod", len(chosen), (case, chosen), judge, case != "parallel")
