"""Tasks of the main job that run emitted modules against references, each as in `stages`.

Modules of a load case are run on the same rods, whose references are found once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from derive.measure.loading import load
from derive.stages import EXACT

HERE = Path(__file__).resolve()
MEASURE = HERE.parent / "measure"
REFERENCE = (HERE, *(MEASURE / f"{name}.py" for name in ("taylor", "reference", "scan", "rods")))
FOLDS = (*REFERENCE, *(MEASURE / f"{name}.py" for name in ("counts", "folds", "fold_references")))
EXCHANGES = (*FOLDS, *(MEASURE / f"{name}.py" for name in ("exchanges", "exchange_references")))
_AGREEMENT = ("agreement", "fold_agreement", "exchange_agreement", "sweeps", "loading")
AGREEMENT = (*EXCHANGES, *(MEASURE / f"{name}.py" for name in _AGREEMENT))
# Of the rods of a load case, those whose folds are looked for, and those whose exchanges are.
FOLD_RODS = (0, 2, 4)
EXCHANGE_RODS = (0,)


def list_rods(case: str, folded: dict[str, str]) -> int:
    """How many rods the modules of a scene are run on; ``folded``: its constants to EXACT digits."""
    return len(_rods(case, folded))


def _rods(case: str, folded: dict[str, str]) -> list[Any]:
    from derive.measure.rods import rods

    return rods(case, {name: float(text) for name, text in folded.items()})


def _exact(folded: dict[str, str]) -> dict[str, Any]:
    from mpmath import mp, mpf

    with mp.workdps(EXACT):
        return {name: mpf(text) for name, text in folded.items()}


def reference(case: str, folded: dict[str, str], number: int) -> list[dict[str, Any]]:
    """All equilibria of one of the rods of a load case, to 40 digits; ``folded``: its constants to EXACT digits."""
    from derive.measure.rods import references

    return [found.to_json() for found in references(_rods(case, folded)[number], _exact(folded))]


def fold_reference(case: str, folded: dict[str, str], number: int) -> dict[str, Any] | None:
    """All folds of one of the rods of a load case as the field grows, to 40 digits; None where it is too stiff."""
    from derive.measure.fold_references import fold_references

    found = fold_references(_rods(case, folded)[number], _exact(folded))
    return None if found is None else found.to_json()


def exchange_reference(case: str, folded: dict[str, str], number: int) -> dict[str, Any]:
    """Where two folds of one of the rods of a load case meet as the force grows, to 40 digits."""
    from derive.measure.exchange_references import exchange_references

    return exchange_references(_rods(case, folded)[number], _exact(folded)).to_json()


def agree(
    text: str,
    backend: str,
    known: Sequence[Sequence[dict[str, Any]]],
    folds: Sequence[dict[str, Any] | None] | None = None,
    exchanges: Sequence[dict[str, Any]] = (),
) -> dict[str, Any]:
    """How far a module is off the references; an exception in the module is a fault like any other.

    folds, exchanges: the references of its folds and exchanges, if it has any.
    """
    from derive.measure.agreement import DOUBLE, TWIN_DIGITS, agreement
    from derive.measure.exchange_agreement import enter_exchanges
    from derive.measure.exchange_references import ExchangeList
    from derive.measure.fold_agreement import enter_folds
    from derive.measure.fold_references import FoldList
    from derive.measure.reference import Reference

    answers = [[Reference.from_json(one) for one in rod] for rod in known]
    unit = 10.0**-TWIN_DIGITS if backend == "mpmath" else DOUBLE
    try:
        module = load(text)
    except Exception as error:
        return {"rows": [], "faults": [f"it cannot be imported: {type(error).__name__}: {error}"], "equilibria": 0}
    result = agreement(module, [(rod[0].rod, rod) for rod in answers], unit)
    if folds is not None:
        enter_folds(result, module, [FoldList.from_json(one) for one in folds if one], unit)
    enter_exchanges(result, module, [ExchangeList.from_json(one) for one in exchanges], unit)
    rows = [asdict(row) for row in result.rows.values()]
    return {"rows": rows, "faults": result.reasons(), "equilibria": result.equilibria}
