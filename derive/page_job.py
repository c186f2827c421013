"""What the page of the report shows besides verdicts: the derivation, the modules, what is behind each line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from derive import pipeline, stages
from derive.grounds import GROUNDS
from derive.paper.text_claims import load_claims
from derive.runner import Runner
from derive.stages import Task

HERE = Path(__file__).resolve().parent
PAGE = HERE / "report" / "page"
DERIVATION = (*stages.THEORY, HERE / "report" / "text.py", PAGE / "statements.py", Path(__file__))
LINES = (*(HERE / "emit" / f"{name}.py" for name in ("line_formulas", "backends", "scene")), PAGE / "modules.py")


def derivation() -> dict[str, Any]:
    """The notebook of the derivation and the formulas that solvers evaluate, as data."""
    from derive.report.page.statements import derivation as written

    return written(stages.theory(), stages.derived()[1].lines)


def lines(text: str, formulas: Sequence[Sequence[str]]) -> list[list[Any]]:
    """The runs of lines of a module; formulas: name and case of each."""
    from derive.report.page.modules import Named, as_data, runs

    return as_data(runs(text, [Named(*one) for one in formulas]))


def gather(runner: Runner, job: pipeline.Job, scenes: Sequence[Path]) -> dict[str, Any]:
    """What `Findings` has besides verdicts; the modules of the job are emitted and proved."""
    written = runner.result(Task("page", "derivation", derivation, (), DERIVATION))
    tasks = pipeline.read_scenes(runner, scenes)
    pipeline.emit_modules(runner, job, tasks)
    if job.failed_modules():
        return {}
    known = [[one["name"], one["case"]] for one in written["formulas"]]
    asked = [Task("page", f"lines of {one['name']}", lines, (one["text"], known), LINES) for one in job.modules]
    names = [one["name"] for one in job.modules]
    return {
        "lines": written["lines"],
        "evaluated": written["formulas"],
        "grounds": grounds(written["lines"]),
        "modules": job.modules,
        "explained": pipeline.explain_scenes(runner, tasks),
        "runs": dict(zip(names, runner.results(asked), strict=True)),
    }


def grounds(notebook: Sequence[Mapping[str, Any]]) -> dict[str, list[str]]:
    """The claims behind each printed label: those that name it, else those on which it is said to rest.

    Behind a claim of the running text stand those of the display before it, as for `derive explain`.
    """
    found = {label: list(names) for label, names in GROUNDS.items()}
    named: dict[str, list[str]] = {}
    for line in notebook:
        if line.get("source"):
            named.setdefault(line["source"], []).append(line["id"])
    found |= named
    return found | {claim.id: found.get(claim.after, []) for claim in load_claims().values()}


def page_text(
    job: pipeline.Job,
    gathered: Mapping[str, Any],
    mutants: Mapping[str, Any] | None = None,
    measured: Mapping[str, Any] | None = None,
) -> str:
    """The page. mutants, measured: results of `derive check --mutants --json` and `derive measure --json`."""
    from derive.report.page.document import Findings, page

    forms = {name: one["statements"] for name, one in job.derived.items()}
    return page(Findings(job.printed, forms, job.records, job.claims, **gathered, mutants=mutants, measured=measured))
