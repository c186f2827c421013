"""What a plain statement asserts in a reading: the claims for its relations, ± and limits put in.

- Relations are read as ``relations`` says, ± as ``either`` does: one sign for the whole statement.
- ``A → B``: a limit, for the limit that the text assumes (its hypothesis ``γ → γ_1``). The target of an arrow does
  not vary, so whatever stands right of an arrow is taken *at* the limit: ``ξ_b → ξ_b = 1 + 2β/η`` says that ξ_b tends
  to its value at the limit, and that this value is 1 + 2β/η. The verdict's reason says where this was needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from sympy import Symbol, nan, oo, zoo

from derive.check import either, relations
from derive.check.meaning import Components, MeaningError
from derive.paper import tree as t
from derive.paper.symbolic import NONE, Indices
from derive.theory.claims import Claim, Domain, Limit


def claims_of(
    statement: t.Statement, reading: Components, given: tuple[t.Statement, ...], stem: str, indices: Indices = NONE
) -> Iterator[tuple[str, Claim, str]]:
    """The claims that a plain statement makes in a reading, for given values of its free indices.

    Of each: what it says, the claim, and how it had to be read.
    """
    found = list(_unsigned(statement, reading, given, stem, indices))
    claims, sign = either.resolved([claim for _, claim, _ in found])
    for (title, _, note), claim, before in zip(found, claims, (claim for _, claim, _ in found), strict=True):
        if sign and claim is not before:
            note = "; ".join(part for part in (note, reading.sign_note(either.NAMES[sign], title)) if part)
        yield title, claim, note


def _unsigned(
    statement: t.Statement, reading: Components, given: tuple[t.Statement, ...], stem: str, indices: Indices
) -> Iterator[tuple[str, Claim, str]]:
    """The same with ± as it is printed."""
    values = [_value(side, reading, indices) for side in statement.sides]
    limit: tuple[Symbol, Any, str] | None = None
    note = ""
    for n, operator in enumerate(statement.operators):
        left, right, sides = values[n], values[n + 1], statement.sides[n : n + 2]
        if not reading.reads(*sides):
            continue
        domain = reading.domain if limit is None else _without(reading.domain, limit[0])
        if operator == "->":
            limit = limit or limit_of(reading, given)
            variable, point, side = limit
            at_limit = _at(right, limit)
            if at_limit != right:
                note = f"right of the arrow, what depends on {variable} is taken at the limit {variable} = {point}"
            said: Iterable[relations.Said] = [("", Limit(left, variable, point, at_limit, side))]
            domain = reading.domain
            values[n + 1 :] = [_at(value, limit) for value in values[n + 1 :]]
        elif operator == "=" and (orders := relations.orders(sides, reading, indices)):
            said, domain = [("", relations.order(left, right, reading, min(orders), sides[1]))], reading.domain
        elif isinstance(sides[1], t.Interval):
            said = relations.membership(operator, left, right, sides[1], reading)
        else:
            said = relations.said(operator, left, right, reading)
        for part, relation in said:
            claim = Claim(f"{stem}.{n + 1}", "as printed", relation, domain, reading.hypotheses, source=stem)
            yield ", ".join(filter(None, (f"{n + 1}: {operator}", part))), claim, note


def _value(side: t.Node, reading: Components, indices: Indices) -> Any:
    """The value of a side; of an interval, the values of its ends."""
    if isinstance(side, t.Interval):
        return tuple(_finite(reading.of(end, indices), reading) for end in side.parts())
    return _finite(reading.of(side, indices), reading)


def _finite(value: Any, reading: Components) -> Any:
    known = value
    for old, new in reading.hypotheses:
        known = known.subs(old, new)
    if known.has(oo, -oo, zoo, nan):
        raise MeaningError("a side is infinite or undefined, say by a division by 0")
    return value


def limit_of(reading: Components, given: tuple[t.Statement, ...]) -> tuple[Symbol, Any, str]:
    """Variable, point and side of the limit that the text assumes; MeaningError if there is none, or two."""
    arrows = [statement for statement in given if statement.operators == ("->",)]
    if len(arrows) != 1 or reading.constant is None or reading.ends is None:
        raise MeaningError("an arrow needs one limit among the hypotheses of the text")
    variable, point = (reading.of(side) for side in arrows[0].sides)
    if variable != reading.constant or point not in reading.ends:
        raise MeaningError(f"the limit {variable} → {point} is not at an end of the range of {reading.constant}")
    return variable, point, "+" if point == reading.ends[0] else "-"


def _at(value: Any, limit: tuple[Symbol, Any, str]) -> Any:
    return value.subs(limit[0], limit[1])


def _without(domain: Domain, variable: Symbol) -> Domain:
    return Domain({s: r for s, r in domain.ranges.items() if s != variable}, domain.conditions)
