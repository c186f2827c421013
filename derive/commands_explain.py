"""`derive explain`: the chain from a formula back to the energy, and what is printed under its label."""

from __future__ import annotations

import argparse
from typing import Any

from derive import explain, output, pipeline, stages
from derive.commands import running, save
from derive.numbers import MistakeError
from derive.runner import Runner


def run_explain(options: argparse.Namespace) -> int:
    """The chain of claims from a formula back to the energy."""
    try:
        chain = explain.explain(options.what, output.default_folder())
    except explain.NothingToExplainError as error:
        raise MistakeError(str(error)) from error
    with running(options) as runner:
        chain["printed"] = printed(runner, options.what)
    save(options.json, chain)
    for line in explain.lines(chain):
        print(line)
    return 0


def printed(runner: Runner, label: str) -> list[dict[str, Any]]:
    """The verdict on the printed formula, or claim of the text, of a label; none if it names something else."""
    from derive.paper.ledger import load_ledger
    from derive.paper.text_claims import load_claims

    records = [stages.plain(record) for record in load_ledger().values() if record.id == label]
    claims = [claim.to_json() for claim in load_claims().values() if claim.id == label]
    job = pipeline.Job()
    pipeline.judge_paper(runner, job, records, claims)
    return job.printed
