"""Claims on the range of the constant of a load case, and on the roots of f̂ there (exsl24-exsl27, exhpf8-exhpf10)."""

from __future__ import annotations

from sympy import Expr, diff, factor, sympify

from .claims import Domain, Equal, Limit, Notebook, Positive
from .load_case import COSINES, LoadCase, linear_root, xi_tip
from .symbols import xi

ENDS = ("end_lower", "end_upper")
KINDS = ("double root", "straight rod")  # what f̂ has at an end of the range


def claim_range(case: LoadCase, book: Notebook) -> None:
    """The range of the constant, the roots at its ends, and the roots against ±1."""
    book.show(f"range of {case.constant}", case.ends)
    _claim_ends(case, book)
    _claim_order(case, book)
    _claim_limits(case, book)
    if case.bends:
        _claim_positions(case, book)


def _claim(
    book: Notebook,
    case: LoadCase,
    key: str,
    title: str,
    positive: Expr,
    domain: Domain,
    *rests: str,
    what: str = "order",
) -> None:
    """Assert a sign; rests: the claims on this quartic that it uses."""
    name, steps = f"quartic.{case.name}.", case.ids(*(f"quartic.{one}" for one in rests))
    book.claim(name + key, title, Positive(positive), domain=domain, steps=steps, source=case.source(what))


def kinds(case: LoadCase) -> dict[str, str]:
    """What f̂ has at the lower and at the upper end of the range; without a field it is a straight rod at both."""
    kinds = KINDS[:: case.sense] if case.bends else KINDS[1:] * 2
    return dict(zip(("lower", "upper"), kinds, strict=True))


def _claim_ends(case: LoadCase, book: Notebook) -> None:
    """The constant of every tip lies between the ends."""
    gaps = {"lower": factor(case.tip_constant - case.ends[0]), "upper": factor(case.ends[1] - case.tip_constant)}
    any_tip = case.domain(xi_tip=COSINES)
    straight = dict(zip(gaps, COSINES, strict=True)) if not case.bends else dict.fromkeys(gaps, case.bends)
    for end, gap in gaps.items():
        what = kinds(case)[end]
        double = what == KINDS[0]
        reached = Equal(gap.subs(xi_tip, case.vertex if double else straight[end]), 0)
        title = f"the {end} end is reached"
        name, steps = f"quartic.{case.name}.end_{end}", case.ids("quartic.free_end")
        book.claim(name, title, reached, domain=case.domain(), steps=steps, source=case.source(what))
        # At the double root the gap is a square: the tips on either side of the vertex.
        if double:
            sides = {
                "below": case.steep(xi_tip=(COSINES[0], case.vertex)),
                "above": case.steep(xi_tip=(case.vertex, 1)),
            }
        else:
            sides = {"side": any_tip}
        for side, where in sides.items():
            title = f"the constant of a tip is within the {end} end"
            _claim(book, case, f"range_{end}_{side}", title, gap, where, "free_end", f"end_{end}", what=what)


def _claim_order(case: LoadCase, book: Notebook) -> None:
    """Real distinct roots in their order, monotone in the constant."""
    where = case.domain(**{case.constant.name: case.ends})
    if case.bends:
        discriminant = case.force**2 + case.f_hat.subs(xi, 0) * case.stiffness
        _claim(book, case, "distinct", "Δ > 0, the roots of f̂ are real", discriminant, where, "levels", *ENDS)
        span = case.roots[1] - case.roots[0]
        _claim(book, case, "order", "ξ_a < ξ_b", span, where, "root_a", "root_b", "distinct")
        _claim_admissible(book, case)
        falls = -case.sense * diff(case.roots[0], case.constant)
        _claim(book, case, "falling_a", "ξ_a is monotone", falls, where, "root_a", "distinct")
    rises, last = case.sense * diff(case.roots[-1], case.constant), case.letters[-1]
    _claim(book, case, "rising_b", "the last root is monotone", rises, where, f"root_{last}", *ENDS)


def _claim_admissible(book: Notebook, case: LoadCase) -> None:
    """Where f̂ > 0: between its roots, which are in order, if H > 0; outside them if H < 0."""
    where = case.domain(**{case.constant.name: case.ends, "xi": COSINES})
    between = (xi - case.roots[0]) * (case.roots[1] - xi)
    title = "f̂ has the sign of H between its roots, and the other outside them"
    steps, source = case.ids("quartic.levels", "quartic.order"), case.source("admissible")
    relation = Equal(case.f_hat, case.stiffness * between)
    book.claim(f"quartic.{case.name}.admissible", title, relation, domain=where, steps=steps, source=source)


def _claim_limits(case: LoadCase, book: Notebook) -> None:
    """The roots at the ends: both at the vertex; or one at ±1, and by Vieta the other at its mate."""
    ends: list[tuple[Expr, ...]]
    if case.other_root is None:
        ends = [(end,) for end in COSINES]
    else:
        side = sympify(case.bends)
        mate = case.other_root.subs(xi_tip, side)
        straight = (mate, side) if case.bends == 1 else (side, mate)
        ends = [(case.vertex, case.vertex), straight]
    for end, point, side, values in zip(("lower", "upper"), case.ends, "+-", ends[:: case.sense], strict=True):
        source = case.source(f"at {kinds(case)[end]}")
        for letter, root, value in zip(case.letters, case.roots, values, strict=True):
            limit = Limit(root, case.constant, point, value, side)
            title = f"ξ_{letter} at the {end} end of the range"
            where = case.domain(**{case.constant.name: case.ends})
            name, steps = (
                f"quartic.{case.name}.{end}_{letter}",
                case.ids(f"quartic.root_{letter}", f"quartic.end_{end}"),
            )
            book.claim(name, title, limit, domain=where, steps=steps, source=source)


def _claim_positions(case: LoadCase, book: Notebook) -> None:
    """The roots of f̂ against ±1, by the sign of f̂ there and the place of its vertex (after exsl27, exhpf10)."""
    lower, upper = case.ends
    # near: the end of [−1, 1] that the roots of f̂ never enclose; far: the one that they may enclose.
    near = sympify(case.bends)
    far = -near
    reach = linear_root(case.f_hat.subs(xi, far), case.constant)
    enclosed = ((reach, upper), (lower, reach))[:: case.sense][0]
    name = case.constant.name
    # f̂ has the sign of −H outside the roots, and that of H between them.
    outside, between = -case.bends * case.f_hat, case.bends * case.f_hat
    title = f"{near} is outside the roots of f̂"
    _claim(book, case, "near_outside", title, outside.subs(xi, near), case.domain(**{name: case.ends}), "levels", *ENDS)
    title = f"the mean of the roots is on the inner side of {near}"
    _claim(book, case, "near_vertex", title, near * (near - case.vertex), case.domain(), "levels")
    if case.force != 0:
        title = f"{far} is between the roots of f̂ in one part of the range"
        where = case.domain(**{name: enclosed})
        _claim(book, case, "far_between", title, between.subs(xi, far), where, "levels", *ENDS)
    # The other part, written by the root nearer to the other side of 1 and −1.
    assert case.other_root is not None
    mate = case.other_root.subs(xi_tip, far)
    tips = case.steep(xi_tip=(case.vertex, mate) if case.bends == 1 else (mate, case.vertex))
    beyond = factor(outside.subs({case.constant: case.tip_constant, xi: far}))
    title = f"{far} is outside the roots of f̂ in the other part"
    _claim(book, case, "far_outside", title, beyond, tips, "free_end", "factors")
