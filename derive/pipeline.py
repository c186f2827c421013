"""The main job: derive, judge, emit, prove, run against references, report; all of it holds, or nothing is written."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from derive import comparison, stages
from derive.runner import Runner
from derive.stages import Task

GOOD = {"PROVED", "CERTIFIED", "AGREED", "DEFINITION"}
# Of a printed formula REFUTED is a finding; these two mean that the checker itself gave up.
GAVE_UP = {"UNKNOWN", "UNREAD"}


class UnknownFormulaError(Exception):
    """A formula is asked for that is not there."""


@dataclass
class Job:
    """What the main job found. ``broken`` says where the derivation broke off, ``written`` which files changed."""

    claims: list[dict[str, Any]] = field(default_factory=list)
    broken: str = ""
    printed: list[dict[str, Any]] = field(default_factory=list)
    records: dict[str, dict[str, Any]] = field(default_factory=dict)
    derived: dict[str, dict[str, Any]] = field(default_factory=dict)
    modules: list[dict[str, Any]] = field(default_factory=list)
    agreements: dict[str, dict[str, Any]] = field(default_factory=dict)
    written: list[Path] = field(default_factory=list)

    @property
    def holds(self) -> bool:
        """Whether modules may be written."""
        failed = self.failed_claims() or self.failed_printed() or self.failed_derived() or self.failed_modules()
        return not (self.broken or failed)

    def failed_claims(self) -> list[dict[str, Any]]:
        """Claims of the derivation that are neither proved nor agreed."""
        return [claim for claim in self.claims if claim["verdict"] not in GOOD]

    def origins(self) -> list[dict[str, Any]]:
        """Failed claims that rest, at however many steps, on no other failed claim: where to look first."""
        failed = {claim["id"] for claim in self.failed_claims()}
        tainted: set[str] = set()
        for claim in self.claims:  # steps name earlier claims only
            if any(step in failed or step in tainted for step in claim["steps"]):
                tainted.add(claim["id"])
        return [claim for claim in self.failed_claims() if claim["id"] not in tainted]

    def failed_printed(self) -> list[dict[str, Any]]:
        """Printed formulas on which there is no verdict."""
        return [formula for formula in self.printed if formula["verdict"] in GAVE_UP]

    def failed_derived(self) -> list[str]:
        """Why derived forms of printed formulas do not read back or are not proved."""
        return [forms["failure"] for forms in self.derived.values() if forms["failure"]]

    def failed_modules(self) -> list[tuple[str, str]]:
        """Module and reason, for formulas that do not read back and for answers that differ from the references."""
        wrong = [(module["name"], module["failure"]) for module in self.modules if module["failure"]]
        return wrong + [(name, line) for name, found in self.agreements.items() for line in found["faults"]]


def judge_theory(runner: Runner, job: Job) -> None:
    """Derive, and judge every claim of the derivation."""
    listed = runner.result(Task("theory", "derivation", stages.list_claims, (), stages.THEORY))
    tasks = [Task("check", c["id"], stages.judge_claim, (c["id"],), stages.CHECK) for c in listed["claims"]]
    job.broken = listed["broken"]
    verdicts = runner.results(tasks, stages.derived)
    job.claims = [{**found, "steps": c["steps"]} for c, found in zip(listed["claims"], verdicts, strict=True)]


def printed_formulas(runner: Runner, source: str = "", only: Sequence[str] = ()) -> list[dict[str, Any]]:
    """The printed formulas to judge, from the ledger or from a LaTeX text."""
    listed = runner.result(Task("paper", "reading", stages.list_printed, (source,), stages.PAPER))
    known = [record["id"] for record in listed]
    for name in only:
        if name not in known:
            close = get_close_matches(name, known, n=1)
            hint = f"did you mean '{close[0]}'?" if close else f"there are: {', '.join(known) or 'none'}"
            raise UnknownFormulaError(f"no formula '{name}' here; {hint}")
    if not listed:
        raise UnknownFormulaError("no displayed equation here has a label that is known; give the article's source")
    return [record for record in listed if not only or record["id"] in only]


def text_claims(runner: Runner) -> list[dict[str, Any]]:
    """The claims of the running text, from the ledger."""
    return list(runner.result(Task("paper", "running text", stages.list_text, (), stages.PAPER)))


def judge_paper(
    runner: Runner, job: Job, formulas: Sequence[dict[str, Any]], claims: Sequence[dict[str, Any]] = ()
) -> None:
    """Judge printed formulas, and claims of the running text.

    A formula that has moved in the source is not judged again; one that cannot be read is, for its reason names the
    place.
    """

    def printed(record: dict[str, Any]) -> Task:
        return Task("printed", record["id"], stages.judge_printed, (record,), stages.PRINTED)

    tasks = [printed(_anywhere(record)) for record in formulas]
    tasks += [Task("text", claim["id"], stages.judge_text, (claim,), stages.PRINTED) for claim in claims]
    found = runner.results(tasks, stages.derived)
    for number, record in enumerate(formulas):
        unread = found[number]["verdict"] == "UNREAD"
        found[number] = runner.result(printed(record)) if unread else {**found[number], "line": record["line"]}
    job.printed = found


def _anywhere(record: dict[str, Any]) -> dict[str, Any]:
    """A printed formula without its place in the source."""
    return {**record, "line": 0, "column": 1}


def write_up(runner: Runner, job: Job, formulas: Sequence[dict[str, Any]]) -> None:
    """Find the derived forms of printed formulas, read back and proved."""
    ask = stages.derive_forms
    tasks = [Task("derived", record["id"], ask, (_anywhere(record),), stages.REPORT) for record in formulas]
    job.records = {record["id"]: record for record in formulas}
    job.derived = dict(zip(job.records, runner.results(tasks, stages.derived), strict=True))


def report_text(job: Job, mutants: str = "") -> str:
    """The report on what a job found, as LaTeX. mutants: a line on how wrong variants fared."""
    from derive.report.document import document

    return document(job.printed, {name: one["statements"] for name, one in job.derived.items()}, job.records, mutants)


def read_scenes(runner: Runner, scenes: Iterable[Path]) -> list[Task]:
    """One task for each module of each scene. A scene file that is wrong is an error here, before any long work."""
    paths, tasks = stages.emission_paths(), []
    for path in scenes:
        text = stages.scene_text(path)
        scene = runner.result(Task("scene", path.name, stages.read_scene, (text, str(path)), stages.EMIT))
        for backend in scene["backends"]:
            name = f"{scene['name']}_{backend}"
            tasks.append(Task("emit", name, stages.emit, (text, path.name, backend), paths))
    return tasks


def explain_scenes(runner: Runner, tasks: Sequence[Task]) -> list[dict[str, Any]]:
    """What the modules of these tasks leave out, and why."""
    asked = [Task("left out", task.label, stages.explain_scene, task.inputs, task.paths) for task in tasks]
    return runner.results(asked, stages.derived)


def emit_modules(runner: Runner, job: Job, tasks: Sequence[Task]) -> None:
    """Print the modules and read them back."""
    job.modules = runner.results(tasks, stages.derived)


def run_modules(runner: Runner, job: Job) -> None:
    """Run every module against the references of its load case."""
    wanted = {module["name"]: reference_tasks(runner, module) for module in job.modules}
    diagrams = {module["name"]: diagram_tasks(module, len(wanted[module["name"]])) for module in job.modules}
    more = [task for both in diagrams.values() for tasks in both for task in tasks]
    known = {task.key: task for tasks in (*wanted.values(), more) for task in tasks}
    answers = dict(zip(known, runner.results(list(known.values())), strict=True))
    tasks = []
    for module in job.modules:
        name, rods = module["name"], [answers[task.key] for task in wanted[module["name"]]]
        # Exchanges come with folds.
        points = (
            [[answers[task.key] for task in some] for some in diagrams[name]] if "folds" in module["functions"] else []
        )
        inputs = (module["text"], module["backend"], rods, *points)
        tasks.append(Task("agreement", name, comparison.agree, inputs, comparison.AGREEMENT))
    job.agreements = dict(zip(wanted, runner.results(tasks), strict=True))


def diagram_tasks(module: dict[str, Any], rods: int) -> tuple[list[Task], list[Task]]:
    """The tasks that give the references of a module's folds and of its exchanges, if it has any."""
    label, scene, functions = module["case"], (module["case"], module["folded"]), module["functions"]
    folds = [number for number in comparison.FOLD_RODS if number < rods and "folds" in functions]
    exchanges = [number for number in comparison.EXCHANGE_RODS if number < rods and "exchanges" in functions]
    return (
        [Task("reference", f"folds {label}", comparison.fold_reference, (*scene, n), comparison.FOLDS) for n in folds],
        [
            Task("reference", f"exchanges {label}", comparison.exchange_reference, (*scene, n), comparison.EXCHANGES)
            for n in exchanges
        ],
    )


def reference_tasks(runner: Runner, module: dict[str, Any]) -> list[Task]:
    """The tasks that give the references of a module."""
    label, scene = f"reference {module['case']}", (module["case"], module["folded"])
    count = runner.result(Task("rods", label, comparison.list_rods, scene, comparison.REFERENCE))
    return [Task("reference", label, comparison.reference, (*scene, n), comparison.REFERENCE) for n in range(count)]


def main_job(runner: Runner, scenes: Sequence[Path], *, paper: bool = True) -> Job:
    """Everything but the writing. A stage whose grounds fail is not begun."""
    job, emission = Job(), read_scenes(runner, scenes)
    judge_theory(runner, job)
    if job.holds and paper:
        formulas = printed_formulas(runner)
        judge_paper(runner, job, formulas, text_claims(runner))
        write_up(runner, job, formulas)
    if job.holds:
        emit_modules(runner, job, emission)
    if job.holds:
        run_modules(runner, job)
    return job
