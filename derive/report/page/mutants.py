"""The score of wrong variants, from the result of `derive check --mutants --json`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def score(given: Mapping[str, Any] | None) -> dict[str, Any] | None:
    """A table: fates, and a row for each kind of change; KeyError or TypeError for other data."""
    if given is None:
        return None
    kinds = {**given["kinds"], "all": given["counts"]}
    fates = list(dict.fromkeys(fate for counts in kinds.values() for fate in counts))
    rows = [{"kind": kind, "numbers": [counts.get(fate, 0) for fate in fates]} for kind, counts in kinds.items()]
    return {"fates": fates, "rows": rows, "survivors": len(given["survivors"])}
