"""What becomes of the wrong variants of a claim of the running text. What is refuted is mended first."""

from __future__ import annotations

from typing import Any

from derive.check.survival import of_formula
from derive.check.text.judge import judge_text, mended, variants
from derive.check.verdicts import REFUTED
from derive.paper.text_claims import FORMULA, TextClaim

UNSOUND = "it neither holds nor can be mended"


def of_text(theory: Any, claim: TextClaim) -> list[dict[str, Any]]:
    """The fates of the variants, as plain data; a variant that is not refuted survives, whatever else is said of it."""
    if claim.form == FORMULA:
        return of_formula(theory, claim.record)
    sound = mended(theory, claim)
    if sound is None:
        return [_survivor(claim, "none", claim.printed, "", UNSOUND)]
    return [_of_variant(theory, variant, kind) for kind, variant in variants(sound)]


def _of_variant(theory: Any, variant: TextClaim, kind: str) -> dict[str, Any]:
    said = judge_text(theory, variant, mend=False)
    if said.verdict == REFUTED:
        return {"id": variant.id, "kind": kind, "fate": "killed"}
    return _survivor(variant, kind, str(dict(variant.data)), str(said.verdict), said.reason)


def _survivor(claim: TextClaim, kind: str, mutant: str, verdict: str, reason: str) -> dict[str, Any]:
    said = {"mutant": mutant, "verdict": verdict, "reason": reason}
    return {"id": claim.id, "kind": kind, "fate": "surviving", **said}
