"""A page of the real derivation and one real module, with verdicts made up for all printed formulas: quick to make."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from derive import page_job, stages
from derive.paper.ledger import load_ledger
from derive.paper.text_claims import load_claims
from derive.report.contents import VERDICTS
from derive.report.page.document import Findings, page

ROOT = Path(__file__).resolve().parent.parent
MODULE = "remote_control_numpy"
HOSTILE = '</math><script>alert("&amp;")</script><img src=http://x.invalid onerror=alert(1)>'
REPAIR = {
    "latex": r"\gamma = 2 \beta", "verdict": "PROVED", "edits": [HOSTILE], "tried": 2,
    "changes": [[r"\beta", HOSTILE]],
}  # fmt: skip


def verdict(name: str, line: int, printed: str, number: int) -> dict[str, Any]:
    """A record as of `derive check --json`; verdicts take turns, and what is refuted has a counterexample."""
    said = list(VERDICTS)[number % len(VERDICTS)]
    refuted = said == "REFUTED"
    printed = HOSTILE if said in ("UNREAD", "UNKNOWN") else printed
    one = {
        "printed": printed, "verdict": said, "method": f"method {number}", "reason": HOSTILE if refuted else "",
        "counterexample": {"beta": "1/3", HOSTILE: HOSTILE, "lhs": "1.0", "rhs": "-2e-7"} if refuted else None,
        "repair": REPAIR if refuted else None, "seconds": 0.1, "relations": [],
    }  # fmt: skip
    return {"id": name, "line": line, **one, "statements": [one]}


@cache
def findings() -> Findings:
    """What the page of the stand-in shows."""
    ledger = load_ledger()
    printed = [(one.id, one.line, one.latex) for one in (*ledger.values(), *load_claims().values())]
    printed += [(f"{HOSTILE}{number}", 0, HOSTILE) for number in range(len(VERDICTS))]
    written = page_job.derivation()
    text = (ROOT / "generated" / f"{MODULE}.py").read_text(encoding="utf-8")
    known = [[one["name"], one["case"]] for one in written["formulas"]]
    size = {"functions": 1, "lines": 1, "bytes": 1}
    absent = [{"kind": "function", "name": HOSTILE, "reason": "not wanted: output folds"}]
    explained = {"scene": "remote_control", "backend": "numpy", "outputs": ["equilibria"], "absent": absent}
    folded = {"length": {"value": "80", "by": "the scene"}}
    return Findings(
        formulas=[verdict(*one, number) for number, one in enumerate(printed)],
        derived={},
        records={name: {**stages.plain(one), "domain": HOSTILE} for name, one in ledger.items()},
        claims=[
            {"id": one["id"], "verdict": "PROVED", "method": "normal form", "reason": HOSTILE}
            for one in written["lines"]
            if "id" in one
        ],
        lines=written["lines"],
        evaluated=written["formulas"],
        grounds=page_job.grounds(written["lines"]),
        modules=[{"name": MODULE, "case": "parallel", "text": text, "proof": [{}] * 3}],
        explained=[{**explained, "folded": folded, "size": size, "full_size": size}],
        runs={MODULE: page_job.lines(text, known)},
        mutants={"counts": {"killed": 3}, "kinds": {HOSTILE: {"killed": 3}}, "survivors": []},
        measured=measured(),
    )


@cache
def whole() -> str:
    """The page with all its parts."""
    return page(findings())


def bare() -> str:
    """The page without modules, score and measurements."""
    return page(replace(findings(), modules=(), explained=(), runs={}, mutants=None, measured=None))


def measured() -> dict[str, Any]:
    """A result of `derive measure --json`, with a family that nobody knows."""
    time = {"median": 2e-3, "low": 1e-3, "high": 3e-3, "runs": 3}
    task = {
        "key": "tasks/T1/a", "problem": "T1", "title": HOSTILE, "unit": "rod", "method": HOSTILE, "group": "ours",
        "setting": "n = 3", "share": 1.0, "whole": True, "errors": {"worst": 1e-15, "found": 3, "of": 3, "spurious": 0},
        "seconds": time, "ratio": {"median": 1.0},
    }  # fmt: skip
    peer = {**task, "method": "peer", "group": "peer", "errors": {**task["errors"], "worst": 3e-7, "spurious": 1}}
    nothing = {**task, "method": "none", "whole": False, "errors": {**task["errors"], "worst": None, "found": 0}}
    grown = {
        "key": "growth/a",
        "series": "a shape",
        "variable": "points",
        "value": 100,
        "amount": 100,
        "seconds": time,
        "bytes": 10**6,
    }
    far = {**grown, "value": 200, "amount": 200, "bytes": 2 * 10**6, "seconds": {**time, "median": 8e-3}}
    solver = {"solver": "ours", "bounds": 0.5, "ulps": 2.0, "quantity": "y", "failures": []}
    lost = {**solver, "solver": "literal", "bounds": None, "failures": [HOSTILE]}
    point = {
        "map": "loads", "title": HOSTILE, "labels": [HOSTILE, "η"], "shape": [1, 1], "row": 0, "column": 0,
        "at": ["1", "2"], "solvers": [solver, lost],
    }  # fmt: skip
    called = {"excess": 0.5, "loss": 2.0, "condition": 3.0}
    search = {"name": HOSTILE, "operations": 5, "rod": {"beta": 1.0, "eta": 0.0, "length": 2.0, "clamp_angle": 1.0}}
    return {
        "about": {"mode": "quick", "machine": {"cores": 2}, "versions": {"python": "3"}, "commit": "abc"},
        "records": {
            "tasks": [task, peer, nothing],
            "growth": [grown, far],
            "atlas": [point],
            "stability": [{**search, "called": called}],
            "extremes": [{"rod": HOSTILE, "errors": {"y": 1e-9}}],
        },
        "failed": {"tasks/T9": HOSTILE},
    }
