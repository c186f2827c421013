"""What the commands print: short tables, and failures with their place."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from derive.pipeline import GOOD, Job

SHOWN = 6  # ids of failures that follow from others
# In the order of trust.
ORDER = ("PROVED", "CERTIFIED", "AGREED", "DEFINITION", "REFUTED", "UNKNOWN", "UNREAD")


def console(*, stderr: bool = False) -> Console:
    """The terminal; a file or a pipe has lines as long as they need."""
    found = Console(stderr=stderr, highlight=False)
    return found if found.is_terminal else Console(stderr=stderr, highlight=False, width=140)


def counts(records: Iterable[Mapping[str, Any]]) -> dict[str, int]:
    """How many records have each verdict; verdicts that none has are left out."""
    found = Counter(str(record["verdict"]) for record in records)
    return {verdict: found[verdict] for verdict in ORDER if found[verdict]}


def spelled(records: Sequence[Mapping[str, Any]]) -> str:
    """Counts in one line."""
    return ", ".join(f"{number} {verdict}" for verdict, number in counts(records).items()) or "none"


def show_job(console: Console, job: Job, written: Sequence[Path], seconds: float) -> None:
    """The table at the end of the main job."""
    table = Table(title="From the energy to verified solvers", title_justify="left", show_header=False)
    table.add_column(no_wrap=True)
    table.add_column(overflow="fold")
    table.add_row("claims of the derivation", spelled(job.claims))
    if job.printed:
        table.add_row("printed formulas", spelled(job.printed))
        refuted = [formula["id"] for formula in job.printed if formula["verdict"] == "REFUTED"]
        if refuted:
            table.add_row("refuted as printed", ", ".join(refuted))
    for module in job.modules:
        agreed = job.agreements[module["name"]]
        table.add_row(f"module {module['name']}", f"{len(module['proof'])} formulas proved; {error_line(agreed)}")
    table.add_row("files changed", ", ".join(path.name for path in written) or "none")
    table.add_row("time", f"{seconds:.1f} s")
    console.print(table)


def error_line(agreed: Mapping[str, Any]) -> str:
    """The worst error of a module against the references, in one line."""
    worst = max(agreed["rows"], key=lambda row: row["relative"])
    number = agreed["equilibria"]
    return f"worst error {worst['relative']:.1e} ({worst['quantity']}) on {number} equilibria of the references"


def show_failures(console: Console, job: Job) -> None:
    """What keeps the modules from being written, one paragraph each."""
    origins = job.origins()
    for claim in origins:
        console.print(
            f"[bold red]{claim['verdict']}[/] claim [bold]{claim['id']}[/]: {escape(claim['title'])}", soft_wrap=True
        )
        show_grounds(console, claim)
    names = [claim["id"] for claim in job.failed_claims() if claim not in origins]
    if names:
        others = f"{', '.join(names[:SHOWN])}{', …' if len(names) > SHOWN else ''}"
        console.print(f"{len(names)} more that rest on these fail too: {others}", soft_wrap=True)
    if job.broken:
        console.print(f"[bold red]the derivation breaks off[/]: {escape(job.broken)}", soft_wrap=True)
    for formula in job.failed_printed():
        console.print(f"[bold red]{formula['verdict']}[/] printed formula [bold]{formula['id']}[/]", soft_wrap=True)
        show_grounds(console, formula)
    for reason in job.failed_derived():
        console.print(f"[bold red]derived form[/] {escape(reason)}", soft_wrap=True)
    for name, reason in job.failed_modules():
        console.print(f"[bold red]module {name}[/]: {escape(reason)}", soft_wrap=True)


def show_grounds(console: Console, record: Mapping[str, Any]) -> None:
    """Counterexample and reason of a verdict."""
    if example := record.get("counterexample"):
        items = example.items() if isinstance(example, Mapping) else enumerate(example)
        console.print(
            "  counterexample: " + escape(", ".join(f"{name} = {value}" for name, value in items)), soft_wrap=True
        )
    if reason := record.get("reason"):
        console.print(f"  reason: {escape(reason)}", soft_wrap=True)


def show_printed(console: Console, formulas: Sequence[Mapping[str, Any]], not_judged: int, seconds: float) -> None:
    """Verdicts on printed formulas, and the grounds of those that are not proved."""
    table = Table(show_edge=False)
    for heading in ("formula", "line", "verdict", "method", "time"):
        table.add_column(heading, justify="right" if heading in ("line", "time") else "left", overflow="fold")
    for formula in formulas:
        line, taken = str(formula.get("line") or ""), f"{formula.get('seconds', 0):.2f} s"
        table.add_row(formula["id"], line, str(formula["verdict"]), escape(formula.get("method", "")), taken)
    if not_judged:
        table.add_row(f"{not_judged} others", "", "not judged", "", "")
    console.print(table)
    for formula in formulas:
        if formula["verdict"] not in GOOD:
            show_finding(console, formula)
    console.print(f"{spelled(formulas)}; {seconds:.1f} s")
    if not_judged:
        console.print(f"{not_judged} other displays of the source are not judged yet (--json FILE lists their labels)")


def show_finding(console: Console, formula: Mapping[str, Any]) -> None:
    """A printed formula that does not hold, or has no verdict: its place, its statements, the grounds, the mend."""
    place = f" (line {formula['line']})" if formula.get("line") else ""
    console.print(f"[bold]{formula['id']}[/] {formula['verdict']}{place}")
    wrong = [one for one in formula.get("statements", ()) if one["verdict"] not in GOOD]
    for statement in wrong or [formula]:
        console.print(f"  printed: {escape(' '.join(statement['printed'].split()))}", soft_wrap=True)
        show_grounds(console, statement)
        if repair := statement.get("repair"):
            how = f"{' and '.join(repair['edits'])}; {repair['tried']} tried"
            console.print(f"  repair ({repair['verdict']}; {how}): {escape(repair['latex'])}", soft_wrap=True)
            for before, after in repair["changes"]:
                console.print(f"    {escape(before)} becomes {escape(after)}", soft_wrap=True)
        elif statement["verdict"] == "REFUTED":
            console.print("  repair: no small edit was found that is proved")


def show_differences(console: Console, differences: Sequence[Mapping[str, Any]]) -> None:
    """Where a source and the ledger say other things."""
    for one in differences:
        if one["kind"] == "differs":
            console.print(f"[bold]{one['id']}[/] (line {one['line']}) differs from the ledger; the source is judged")
        else:
            console.print(f"[bold]{one['id']}[/] is {one['kind']}")


def show_mutants(
    console: Console, kinds: Mapping[str, Mapping[str, int]], survivors: Sequence[Mapping[str, Any]], seconds: float
) -> None:
    """What became of the mutants, by kind of change; survivors one by one."""
    table = Table(show_edge=False)
    table.add_column("kind of mutation")
    columns = list(dict.fromkeys(fate for fates in kinds.values() for fate in fates))
    for fate in columns:
        table.add_column(fate, justify="right")
    for kind, fates in kinds.items():
        table.add_row(escape(kind), *(str(fates.get(fate, 0)) for fate in columns))
    console.print(table)
    for one in survivors:
        console.print(f"[bold red]surviving[/] {one['id']}: {escape(one['mutant'])} ({one['verdict']})", soft_wrap=True)
        show_grounds(console, one)
    console.print(f"{seconds:.1f} s")


def show_equilibria(console: Console, equilibria: Sequence[Any], title: str) -> None:
    """All equilibria of one rod."""
    names = {"tip_angle": "θ(ℓ)", "clamp_curvature": "θ′(0)", "y": "y", "z": "z", "energy": "energy", "index": "index"}
    columns = [name for name in names if not equilibria or hasattr(equilibria[0], name)]
    console.print(escape(title), soft_wrap=True)
    table = Table(show_edge=False)
    for name in columns:
        table.add_column(names[name], justify="right", no_wrap=True)
    for one in equilibria:
        values = [getattr(one, name) for name in columns]
        table.add_row(*(str(v) if isinstance(v, int) else f"{float(v):.11g}" for v in values))
    console.print(table)
