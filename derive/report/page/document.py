"""The page as text, from plain data. The same data give the same bytes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from derive.report.page import derivation, modules
from derive.report.page.entries import entries
from derive.report.page.measured import measured
from derive.report.page.mutants import score
from derive.resources import templates_folder

Record = Mapping[str, Any]
FOLDER = "page"  # of the templates


@dataclass(frozen=True)
class Findings:
    """What the page shows.

    formulas, derived, records: as of ``derive.report.document.document``. claims: verdicts on the claims of the
    derivation, in its order. lines, evaluated: as of ``statements.derivation``. grounds: printed label → ids of claims.
    modules: emitted, with text and proof. explained: what each leaves out. runs: of each module, as of
    ``modules.as_data``. mutants: of ``derive check --mutants --json``, or None. measured: of ``derive measure --json``,
    or None.
    """

    formulas: Sequence[Record]
    derived: Mapping[str, Sequence[Record]]
    records: Mapping[str, Record]
    claims: Sequence[Record]
    lines: Sequence[Record]
    evaluated: Sequence[Record]
    grounds: Mapping[str, Sequence[str]]
    modules: Sequence[Record] = ()
    explained: Sequence[Record] = ()
    runs: Mapping[str, Sequence[Any]] = field(default_factory=dict)
    mutants: Record | None = None
    measured: Record | None = None


def page(found: Findings) -> str:
    """The whole page."""
    known = [one["id"] for one in found.claims]
    labels = {one["id"] for one in found.formulas}
    explained = {f"{one['scene']}_{one['backend']}": one for one in found.explained}
    emitted = [modules.module(one, explained[one["name"]], found.runs[one["name"]]) for one in found.modules]
    verdicts = {one["id"]: one for one in found.claims}
    return render(
        "page.html.jinja",
        {
            **entries(found.formulas, found.derived, found.records, found.grounds, set(known)),
            "chapters": derivation.chapters(found.lines, verdicts, labels),
            "cases": derivation.evaluated(found.evaluated, modules.places(emitted), set(known), labels),
            "claims": len(known),
            "modules": emitted,
            "mutants": score(found.mutants),
            "measured": measured(found.measured),
            "style": asset("page.css"),
            "script": asset("page.js"),
        },
    )


def asset(name: str) -> Markup:
    """A file of ours that goes into the page as it is."""
    return Markup((templates_folder() / FOLDER / name).read_text(encoding="utf-8"))


def render(template: str, context: Mapping[str, Any]) -> str:
    """The text of a template; whatever is no Markup is escaped, and what is missing is an error."""
    environment = Environment(
        loader=FileSystemLoader(templates_folder() / FOLDER),
        undefined=StrictUndefined,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    return environment.get_template(template).render(context)
