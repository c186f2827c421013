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
    """The verdict on the printed formula of a label; none if it is the name of something else."""
    from derive.paper.ledger import load_ledger

    record, job = load_ledger().get(label), pipeline.Job()
    if record is not None:
        pipeline.judge_paper(runner, job, [stages.plain(record)])
    return job.printed
