"""Verdicts: what the checker says of a claim, and on what grounds. The kinds are never merged."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import Any


class VERDICTS(StrEnum):
    """The kinds of verdict.

    PROVED: by normal form, sign analysis, limit or expansion. CERTIFIED: by ball arithmetic. AGREED: numerically,
    with the reason why there is no proof. DEFINITION: introduces a name. REFUTED: with a counterexample.
    UNKNOWN: neither, with the reason. UNREAD: the reader gave up.
    """

    PROVED = "PROVED"
    CERTIFIED = "CERTIFIED"
    AGREED = "AGREED"
    DEFINITION = "DEFINITION"
    REFUTED = "REFUTED"
    UNKNOWN = "UNKNOWN"
    UNREAD = "UNREAD"


PROVED = VERDICTS.PROVED
CERTIFIED = VERDICTS.CERTIFIED
AGREED = VERDICTS.AGREED
DEFINITION = VERDICTS.DEFINITION
REFUTED = VERDICTS.REFUTED
UNKNOWN = VERDICTS.UNKNOWN
UNREAD = VERDICTS.UNREAD


@dataclass(frozen=True)
class Verdict:
    """The verdict on one claim.

    id: of the claim. verdict: the kind. method: how it was reached. counterexample: symbol → value as text, with 'lhs'
    and 'rhs', for REFUTED. reason: why there is no proof, or what went wrong. seconds: time taken.
    """

    id: str
    verdict: VERDICTS
    method: str
    counterexample: dict[str, str] | None = None
    reason: str = ""
    seconds: float = 0.0

    def to_json(self) -> dict[str, Any]:
        """A dictionary of plain values, for JSON."""
        return {**asdict(self), "verdict": str(self.verdict)}
