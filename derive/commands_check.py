"""`derive check`: verdicts on the derivation and on the printed formulas, and how their mutants fare."""

from __future__ import annotations

import argparse
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from derive import pipeline, show, stages
from derive.commands import latex, running, save
from derive.paper.ledger import Record, compare, from_source, load_ledger
from derive.paper.text_claims import TextClaim, claims_of, from_json, load_claims
from derive.runner import Runner
from derive.stages import Task

NEAR = 3  # labels named when one is not known
MISSING = "it is in the ledger, but not in this source"
NOT_PRINTED = f"{MISSING}: not all of the inline formulas that it rests on are printed there"
HERE = (Path(__file__).resolve(),)


@dataclass(frozen=True)
class Printed:
    """What there is to judge.

    records, claims: of the ledger, or as a source prints them. differences: from the ledger, in the source. missing:
    ids of the ledger that the source does not have. not_judged: labels of the source that the ledger does not have.
    """

    source: str
    records: tuple[Record, ...]
    claims: tuple[TextClaim, ...]
    differences: tuple[dict[str, Any], ...] = ()
    missing: tuple[str, ...] = ()
    not_judged: tuple[str, ...] = ()


def run_check(options: argparse.Namespace) -> int:
    """Verdicts, or with --mutants the fates of wrong variants."""
    start, found = time.perf_counter(), chosen(read(options.paper), options.only)
    if options.mutants:
        return run_mutants(options, found)
    job = pipeline.Job()
    with running(options) as runner:
        if not options.only:
            pipeline.judge_theory(runner, job)
        if job.holds:
            claims = [claim.to_json() for claim in found.claims]
            pipeline.judge_paper(runner, job, [stages.plain(record) for record in found.records], claims)
    job.printed += [unread(name) for name in found.missing]
    counted = {"counts": show.counts(job.printed), "claims": show.counts(job.claims)}
    compared = {"differences": list(found.differences), "not_judged": list(found.not_judged)}
    save(options.json, {"source": found.source, **counted, "formulas": job.printed, **compared})
    if job.claims:
        print(f"claims of the derivation: {show.spelled(job.claims)}")
    show.show_printed(show.console(), job.printed, len(found.not_judged), time.perf_counter() - start)
    show.show_differences(show.console(), found.differences)
    show.show_failures(show.console(stderr=True), job)
    return 0 if job.holds else 1


def read(paper: Path | None) -> Printed:
    """The ledger, or what a LaTeX source says in its place."""
    ledger = load_ledger()
    if paper is None:
        return Printed("ledger", tuple(ledger.values()), tuple(load_claims().values()))
    text = latex(paper)
    there, differences = from_source(text), compare(ledger, text)
    claims, text_differences = claims_of(text)
    kinds = {one.id: one.kind for one in differences}
    missing = tuple(name for name, kind in kinds.items() if kind == "absent from the source")
    if len(missing) == len(ledger):
        reason = f"none of its {len(there)} displayed equations has a label of the ledger; give the article's source"
        raise pipeline.UnknownFormulaError(f"{paper}: {reason}")
    others = tuple(name for name, kind in kinds.items() if kind == "absent from the ledger")
    differing = tuple(stages.plain(one) for one in (*differences, *text_differences) if one.id not in others)
    records = tuple(there[name] for name in ledger if name in there)
    missing += tuple(name for name in load_claims() if name not in claims)
    return Printed(str(paper), records, tuple(claims.values()), differing, missing, others)


def chosen(found: Printed, only: Sequence[str]) -> Printed:
    """What is asked for; UnknownFormulaError for a label that cannot be judged."""
    if not only:
        return found
    known = [record.id for record in found.records] + [claim.id for claim in found.claims]
    for name in only:
        if name not in known:
            raise pipeline.UnknownFormulaError(f"no formula '{name}' here; {_hint(name, found, known)}")
    records = tuple(record for record in found.records if record.id in only)
    claims = tuple(claim for claim in found.claims if claim.id in only)
    differences = tuple(one for one in found.differences if one["id"] in only)
    return replace(found, records=records, claims=claims, differences=differences, missing=(), not_judged=())


def _hint(name: str, found: Printed, known: Sequence[str]) -> str:
    if name in found.missing:
        return MISSING
    if name in found.not_judged:
        return "the source displays it, but it is not judged yet"
    near = get_close_matches(name, known, n=NEAR, cutoff=0.5)
    return f"did you mean {' or '.join(repr(one) for one in near)}?" if near else f"there are: {', '.join(known)}"


def unread(name: str) -> dict[str, Any]:
    """The verdict on a formula that is not there."""
    claim = load_claims().get(name)
    printed, reason = (claim.printed, NOT_PRINTED) if claim else (load_ledger()[name].latex, MISSING)
    said = {"verdict": "UNREAD", "printed": printed, "method": "none", "counterexample": None, "repair": None}
    return {"id": name, "line": 0, **said, "reason": reason, "seconds": 0.0, "statements": []}


def run_mutants(options: argparse.Namespace, found: Printed) -> int:
    """Wrong variants of claims and of printed formulas: all must fail, or be proved to say the same."""
    from derive.check.survival import score

    start = time.perf_counter()
    with running(options) as runner:
        fates = [one for fates in runner.results(mutant_tasks(runner, options, found), stages.derived) for one in fates]
    survivors = [one for one in fates if one["fate"] == "surviving"]
    kinds = score(fates, lambda one: one["kind"])
    totals = score(fates, lambda one: "all").get("all", {})
    by_id = score(fates, lambda one: one["id"])
    save(options.json, {"source": found.source, "counts": totals, "kinds": kinds, "ids": by_id, "survivors": survivors})
    show.show_mutants(show.console(), {**kinds, "all": totals}, survivors, time.perf_counter() - start)
    return 1 if survivors or not fates else 0


def mutant_tasks(runner: Runner, options: argparse.Namespace, found: Printed) -> list[Task]:
    """One task for each claim of the derivation (none if formulas are chosen) and for each printed formula."""
    tasks = []
    if not options.only:
        listed = runner.result(Task("theory", "derivation", stages.list_claims, (), stages.THEORY))
        if listed["broken"]:
            raise stages.DerivationError(f"the derivation breaks off: {listed['broken']}")
        paths = (*stages.CHECK, *HERE)
        tasks = [Task("mutants", one["id"], claim_mutants, (one["id"],), paths) for one in listed["claims"]]
    printed_paths = (*stages.PRINTED, *HERE)
    records = [stages.plain(record) for record in found.records]
    tasks += [Task("mutants", one["id"], formula_mutants, (one,), printed_paths) for one in records]
    claims = [claim.to_json() for claim in found.claims]
    return tasks + [Task("mutants", one["id"], text_mutants, (one,), printed_paths) for one in claims]


def claim_mutants(name: str) -> list[dict[str, Any]]:
    """The fates of the mutants of one claim of the derivation."""
    from derive.check.survival import of_claim

    return of_claim(stages.derived()[1].claims[name])


def formula_mutants(record: dict[str, Any]) -> list[dict[str, Any]]:
    """The fates of the mutants of one printed formula."""
    from derive.check.survival import of_formula

    return of_formula(stages.theory(), Record(**{**record, "given": tuple(record["given"])}))


def text_mutants(claim: dict[str, Any]) -> list[dict[str, Any]]:
    """The fates of the mutants of one claim of the running text."""
    from derive.check.text.survival import of_text

    return of_text(stages.theory(), from_json(claim))
