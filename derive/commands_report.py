"""`derive report`: what was found about the printed formulas, as LaTeX and, where pdflatex is installed, as PDF."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from derive import output, pdf, pipeline, show, stages
from derive.commands import REPORT, running, save
from derive.commands_check import read, unread
from derive.numbers import MistakeError


def run_report(options: argparse.Namespace) -> int:
    """Judge, write up, and write the report; with --check compare it with what is there."""
    if options.paper and not options.out:
        raise MistakeError("with --paper, say with --out where its report goes; generated/ is about the ledger")
    folder, mutants = options.out or output.default_folder(), score(options.mutants)
    if options.pdf and not pdf.found():
        raise MistakeError("--pdf needs pdflatex, which is not installed; leave it out for LaTeX alone")
    output.must_be_usable(folder)
    job = judged(options)
    if job.broken or job.failed_claims() or job.failed_derived():
        show.show_failures(show.console(stderr=True), job)
        print("derive report: not everything holds; nothing was written", file=sys.stderr)
        return 1
    text = pipeline.report_text(job, mutants)
    path, drift = folder / REPORT, list[str]()
    if options.check:
        drift = output.drift({path: text}, folder, complete=False)
        sys.stdout.writelines(drift)
    else:
        written = output.write_all({path: text}) and [path]
        written += [pdf.compiled(path)] if pdf.found() else []
        print(
            f"{path}: {show.spelled(job.printed)}; written: {', '.join(one.name for one in written) or 'nothing new'}"
        )
    save(options.json, {**found(job), "drift": [line.rstrip("\n") for line in drift]})
    if drift:
        print(f"derive report: {path} differs from what is found; run 'derive report'", file=sys.stderr)
    show.show_failures(show.console(stderr=True), job)
    return 0 if job.holds and not drift else 1


def judged(options: argparse.Namespace) -> pipeline.Job:
    """The verdicts on the derivation and on the printed formulas, and the derived forms."""
    there, job = read(options.paper), pipeline.Job()
    records = [stages.plain(record) for record in there.records]
    claims = [claim.to_json() for claim in there.claims]
    with running(options) as runner:
        pipeline.judge_theory(runner, job)
        if job.holds:
            pipeline.judge_paper(runner, job, records, claims)
            pipeline.write_up(runner, job, records)
    job.printed += [unread(name) for name in there.missing]
    return job


def found(job: pipeline.Job) -> dict[str, Any]:
    """Verdicts with the derived forms of each formula, as data."""
    derived = {name: one["statements"] for name, one in job.derived.items()}
    formulas = [{**one, "derived": derived.get(one["id"], [])} for one in job.printed]
    return {"counts": show.counts(job.printed), "claims": show.counts(job.claims), "formulas": formulas}


def score(path: Path | None) -> str:
    """A line on wrong variants, from the result of `derive check --mutants --json`; empty without one."""
    if path is None:
        return ""
    try:
        counts = json.loads(path.read_text(encoding="utf-8"))["counts"]
        return ", ".join(f"{int(number)} {fate}" for fate, number in counts.items())
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise MistakeError(f"{path}: no result of 'derive check --mutants --json {path.name}' ({error})") from error
