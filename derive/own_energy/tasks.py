"""The steps of the chain for an energy of one's own as tasks: plain data in and out, so that the cache can keep them.

An energy is Python, no data: the tasks take it by its key from what this process (or the one it was forked from) holds.
"""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

from derive import comparison, stages
from derive.own_energy.derivation import Derivation
from derive.stages import Task, plain

HERE = Path(__file__).resolve().parent
OWN_REFERENCE = tuple(HERE / f"{name}.py" for name in ("law", "integration", "scan", "references", "rods"))
LAWS = (*comparison.REFERENCE, *OWN_REFERENCE)

_held: dict[str, Derivation] = {}


def hold(derivation: Derivation) -> None:
    """Keep a derivation for the tasks of this process and its children."""
    _held[derivation.key] = derivation


def finished(key: str) -> Any:
    """The notebook of a derivation with all its claims."""
    return _held[key].finish(stages.theory().plane)


def list_claims(key: str) -> list[dict[str, Any]]:
    """The claims of the derivation, in order."""
    return [{"id": c.id, "title": c.title, "steps": list(c.steps)} for c in finished(key).claims.values()]


def judge_claim(key: str, name: str) -> dict[str, Any]:
    """The verdict on one of them."""
    from derive.check.judge import judge

    claim = finished(key).claims[name]
    return {"title": claim.title, **plain(judge(claim))}


def emit(key: str, name: str, names: dict[str, str], backend: str) -> dict[str, Any]:
    """One module, printed, read back and proved; "failure" says why it must not be written, if it must not."""
    from derive.emit.errors import EmitError
    from derive.emit.proof import prove_module
    from derive.own_energy.emission import emit_own, own_module

    own = own_module(_held[key], name, names)
    found = {"name": f"{name}_{backend}", "backend": backend, "text": "", "proof": [], "failure": ""}
    try:
        module = emit_own(stages.theory(), own, backend)
        return {**found, "text": module.text, "proof": [plain(one) for one in prove_module(module)]}
    except EmitError as error:
        return {**found, "failure": str(error)}


def reference(law: dict[str, Any], rod: dict[str, Any]) -> list[dict[str, Any]]:
    """All equilibria of a rod by its own law."""
    from derive.own_energy.references import OwnRod, references

    return references(law, OwnRod(**rod))


def agree(text: str, backend: str, rods: list[dict[str, Any]], known: list[list[dict[str, Any]]]) -> dict[str, Any]:
    """How far a module is off the references; "faults" say what keeps it from being written."""
    from derive.measure.agreement import DOUBLE, TWIN_DIGITS, agreement
    from derive.measure.loading import load
    from derive.own_energy.references import OwnRod, from_json

    pairs = []
    for given, answers in zip(rods, known, strict=True):
        rod = OwnRod(**given)
        pairs.append((rod.arguments, [from_json(rod, one) for one in answers]))
    try:
        module = load(text)
    except Exception as error:
        return {"rows": [], "faults": [f"it cannot be imported: {type(error).__name__}: {error}"], "equilibria": 0}
    result = agreement(module, pairs, 10.0**-TWIN_DIGITS if backend == "mpmath" else DOUBLE)  # type: ignore[arg-type]
    rows = [asdict(row) for row in result.rows.values()]
    return {"rows": rows, "faults": result.reasons(), "equilibria": result.equilibria}


def claim_task(key: str, name: str) -> Task:
    """The task that judges a claim."""
    return Task("own claim", name, judge_claim, (key, name), (*stages.CHECK, HERE))


def list_task(key: str) -> Task:
    """The task that lists the claims."""
    return Task("own claims", "derivation", list_claims, (key,), (*stages.CHECK, HERE))


def emit_task(key: str, name: str, names: dict[str, str], backend: str) -> Task:
    """The task that emits and proves a module."""
    return Task("own module", f"{name}_{backend}", emit, (key, name, names, backend), (*stages.emission_paths(), HERE))


def reference_task(law: dict[str, Any], rod: dict[str, Any]) -> Task:
    """The task that finds the equilibria of a rod."""
    return Task("own reference", "reference", reference, (law, rod), LAWS)


def agree_task(module: dict[str, Any], rods: list[dict[str, Any]], known: list[Any]) -> Task:
    """The task that compares a module with the references."""
    paths = (*comparison.AGREEMENT, *OWN_REFERENCE)
    return Task("own agreement", module["name"], agree, (module["text"], module["backend"], rods, known), paths)
