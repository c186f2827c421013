"""`derive report`: what was found, as one HTML page, and about the printed formulas as LaTeX and PDF.

The LaTeX is committed and compared. The page and the PDF are made from the same findings, are large, and are not.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from derive import output, page_job, pdf, pipeline, show, stages
from derive.commands import REPORT, running, save, shipped
from derive.commands_check import read, unread
from derive.numbers import MistakeError
from derive.report.page.measured import measured
from derive.report.page.mutants import score as score_table

PAGE = "report.html"


def run_report(options: argparse.Namespace) -> int:
    """Judge, write up, and write the report; with --check compare what is committed with what is there."""
    if options.paper and not options.out:
        raise MistakeError("with --paper, say with --out where its report goes; generated/ is about the ledger")
    folder, mutants, timed = options.out or output.default_folder(), score(options.mutants), times(options.measured)
    if options.pdf and not pdf.found():
        raise MistakeError("--pdf needs pdflatex, which is not installed; leave it out for LaTeX and HTML alone")
    output.must_be_usable(folder)
    job = judged(options)
    without_page = options.check or options.no_page
    gathered = gather(options, job) if sound(job) and not without_page else {}
    if not sound(job):
        show.show_failures(show.console(stderr=True), job)
        print("derive report: not everything holds; nothing was written", file=sys.stderr)
        return 1
    text = pipeline.report_text(job, line(mutants))
    path, drift = folder / REPORT, list[str]()
    if options.check:
        drift = output.drift({path: text}, folder, complete=False)
        sys.stdout.writelines(drift)
    else:
        page = {} if without_page else {folder / PAGE: page_job.page_text(job, gathered, mutants, timed)}
        write({path: text, **page}, path, job)
    save(options.json, {**found(job), "drift": [one.rstrip("\n") for one in drift]})
    if drift:
        print(f"derive report: {path} differs from what is found; run 'derive report'", file=sys.stderr)
    show.show_failures(show.console(stderr=True), job)
    return 0 if job.holds and not drift else 1


def write(files: Mapping[Path, str], latex: Path, job: pipeline.Job) -> None:
    """Write LaTeX and page, then the PDF where it can be made, and say what was written."""
    written = output.write_all(files)
    written += [pdf.compiled(latex)] if pdf.found() else []
    names = ", ".join(one.name for one in written) or "nothing new"
    without = "" if pdf.found() else "; no PDF: pdflatex is not installed"
    print(f"{latex.parent}: {show.spelled(job.printed)}; written: {names}{without}")


def sound(job: pipeline.Job) -> bool:
    """May a report be written? What is found about the article's formulas, or not, is for the report to say."""
    return not (job.broken or job.failed_claims() or job.failed_derived() or job.failed_modules())


def gather(options: argparse.Namespace, job: pipeline.Job) -> dict[str, Any]:
    """What the page shows besides verdicts."""
    with running(options) as runner:
        return page_job.gather(runner, job, shipped())


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


def score(path: Path | None) -> dict[str, Any] | None:
    """The result of `derive check --mutants --json`; None without one."""
    if path is None:
        return None
    try:
        given = json.loads(path.read_text(encoding="utf-8"))
        line(given), score_table(given)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise MistakeError(f"{path}: no result of 'derive check --mutants --json {path.name}' ({error})") from error
    return dict(given)


def line(mutants: Mapping[str, Any] | None) -> str:
    """A line on wrong variants; empty without a score."""
    return ", ".join(f"{int(number)} {fate}" for fate, number in mutants["counts"].items()) if mutants else ""


def times(path: Path | None) -> dict[str, Any] | None:
    """The result of `derive measure --json`; None without one."""
    if path is None:
        return None
    try:
        given = json.loads(path.read_text(encoding="utf-8"))
        measured(given)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise MistakeError(f"{path}: no result of 'derive measure --json {path.name}' ({error})") from error
    return dict(given)
