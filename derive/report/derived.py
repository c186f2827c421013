"""Derived forms: what the theory gives for a printed statement, in the article's letters, read back and proved.

The first side that says something by itself is valued in the theory; its value is written in the printed letters. The
LaTeX of it must read back as the same tree, and the statement that it makes must be proved in the reading it came
from. Where there is no such form (a range, a hypothesis, a value that has no letters) the kind says why.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from derive.check.branches import branches, index_values
from derive.check.judge import judge
from derive.check.meaning import Components, MeaningError
from derive.check.readings import readings
from derive.check.statements import claims_of
from derive.check.verdicts import PROVED
from derive.paper import tree as t
from derive.paper.ledger import Record
from derive.paper.reader import parse
from derive.report.forms import SilentError, form_in
from derive.report.lines import in_lines
from derive.report.tidy import SpellError

SECONDS = 20.0  # for the proof of one form
LONGEST = 700  # characters of a form that anybody would read
FORMS = 3  # different forms of one statement; more say less than the printed one


class ReadBackError(Exception):
    """A derived form does not read back, or is not proved: a fault of this program."""


@dataclass(frozen=True)
class Form:
    """One derived form. where: the readings in which it was found and proved."""

    latex: str
    where: tuple[str, ...]


@dataclass(frozen=True)
class Derived:
    """The derived forms of one statement; without forms, kind says why there are none."""

    forms: tuple[Form, ...]
    kind: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {"forms": [{"latex": one.latex, "where": list(one.where)} for one in self.forms], "kind": self.kind}


def derived_forms(theory: Any, record: Record) -> list[Derived]:
    """The derived forms of every statement of a record; ReadError if the reader cannot read it."""
    scope = record.scope or ""
    given = tuple(statement for latex in record.given for statement in parse(latex, scope))
    return [derived(theory, record, statement, given) for statement in parse(record.latex, scope)]


def derived(theory: Any, record: Record, statement: t.Statement, given: tuple[t.Statement, ...]) -> Derived:
    """The derived forms of one statement, in all its readings. ReadBackError if one of them is wrong."""
    found: dict[str, list[str]] = {}
    kind = unvalued(statement)
    if kind:
        return Derived((), kind)
    try:
        for one in placed(theory, record, statement, given):
            latex = in_lines(one.form, record.scope or "")
            if len(latex) > LONGEST:
                return Derived((), "too long to be read; both sides were compared in the theory")
            if holds(latex, one, record):
                found.setdefault(latex, []).append(one.title)
    except SilentError as reason:
        return Derived((), str(reason))
    except MeaningError:  # the verdict says what has no meaning
        return Derived((), "not valued")
    except SpellError:
        return Derived((), "no closed form in the letters of the section; both sides were compared in the theory")
    if not found:
        return Derived((), "named only by what is printed, which does not hold")
    if len(found) > FORMS:
        return Derived((), "a form of its own in each reading; both sides were compared in all of them")
    return Derived(tuple(Form(latex, tuple(dict.fromkeys(where))) for latex, where in found.items()))


def unvalued(statement: t.Statement) -> str:
    """Why a statement has no derived form, judged by its relation; empty if it may have one."""
    if statement.operators[0] in ("in", "notin"):
        return "a range: decided by signs, not by a value"
    if any(isinstance(node, t.BigO) for side in statement.sides for node in side.walk()):
        return "an order of magnitude: the expansion of both sides was compared"
    return ""


@dataclass(frozen=True)
class Placed:
    """A derived statement in one reading, for one choice of indices; title says which.

    repeats: the value is that of a printed side, since the first has none but its name.
    """

    form: t.Statement
    repeats: bool
    reading: Components
    given: tuple[t.Statement, ...]
    title: str


def placed(theory: Any, record: Record, statement: t.Statement, given: tuple[t.Statement, ...]) -> Iterator[Placed]:
    """The derived statement in every reading, for every branch and choice of indices."""
    for branch in branches(statement):
        assumed = (*given, *branch.given)
        for reading in readings(theory, record.scope or "", branch.statement.sides, assumed):
            if not reading.reads(*branch.statement.sides[:2]):
                continue
            for indices in index_values(branch.statement):
                form, repeats = form_in(reading, record.scope or "", branch.statement, assumed, indices)
                named = (f"{letter} = {value}" for letter, value in indices.items())
                title = ", ".join(part for part in (branch.title, reading.title, *named) if part)
                yield Placed(form, repeats, reading, assumed, title)


def holds(latex: str, one: Placed, record: Record) -> bool:
    """Is the LaTeX, read back, the form, and proved in its reading? ReadBackError if not.

    False if the form says nothing there, or if it repeats what is printed and that does not hold.
    """
    back = parse(latex, record.scope or "")
    if back != [one.form]:
        raise ReadBackError(f"{record.id}: the derived form does not read back: {latex}")
    claims = list(claims_of(back[0], one.reading, one.given, record.id))
    for title, claim, _ in claims:
        verdict = judge(claim, SECONDS)
        if verdict.verdict != PROVED and one.repeats:
            return False
        if verdict.verdict != PROVED:
            said = f"{verdict.verdict}, {verdict.reason or verdict.counterexample}"
            raise ReadBackError(f"{record.id}: the derived form is not proved ({title}, {one.title}; {said}): {latex}")
    return bool(claims)
