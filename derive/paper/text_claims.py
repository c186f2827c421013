"""The claims that the article makes in running text: ``claims.toml``, and their comparison with a source.

A claim is data: its *form* says which judge it needs, its other fields what it says. The fragments are the inline
formulas that are printed at its place; of the sentences nothing is kept. A claim of the form ``formula`` is its
``latex``, which is judged as a display is.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from difflib import SequenceMatcher
from functools import cache
from importlib.resources import files
from typing import Any

from .conventions import scope_of
from .ledger import Difference, Record

PREFIX = "text."
FORMULA = "formula"
ALIKE = 0.5  # an inline formula of a source that is less like the ledger's is another formula

_OWN = {"id", "line", "after", "form", "fragments", "latex", "given", "domain", "scope"}
_LABEL = re.compile(r"\\label\s*\{\s*([^{}\s]*)\s*\}")
_INLINE = re.compile(r"(?<![\\$])\$([^$]+)\$(?!\$)")
_SPACE = re.compile(r"\s+|\\[,;!]|\\q?quad\b")


@dataclass(frozen=True)
class TextClaim:
    """One claim of the running text.

    id: begins with ``text.``. line: in the source. after: the last label that stands before it. fragments: inline
    formulas printed there. scope: the section whose conventions hold. data: what the form needs. given, domain: as
    in ``Record``.
    """

    id: str
    line: int
    after: str
    form: str
    fragments: tuple[str, ...]
    scope: str
    latex: str = ""
    given: tuple[str, ...] = ()
    domain: str = ""
    data: Mapping[str, Any] = field(default_factory=dict)

    @property
    def printed(self) -> str:
        """What is printed, as LaTeX: the formula, or the fragments."""
        return self.latex or r" \,, \quad ".join(self.fragments)

    @property
    def record(self) -> Record:
        """The claim as a display: what it prints, and where."""
        return Record(self.id, self.latex, self.scope or None, self.given, self.domain, self.line)

    def but(self, **changes: Any) -> TextClaim:
        """The same claim with other data."""
        return replace(self, data={**self.data, **changes})

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {**vars(self), "fragments": list(self.fragments), "given": list(self.given), "data": dict(self.data)}


def from_json(data: Mapping[str, Any]) -> TextClaim:
    """A claim from plain values."""
    return TextClaim(**{**data, "fragments": tuple(data["fragments"]), "given": tuple(data["given"])})


@cache
def load_claims() -> dict[str, TextClaim]:
    """All claims by id, in the order of the article. ValueError for a record that is wrong."""
    data = tomllib.loads(files(__package__).joinpath("claims.toml").read_text(encoding="utf-8"))
    claims: dict[str, TextClaim] = {}
    for entry in data["claim"]:
        name = entry["id"]
        if not name.startswith(PREFIX) or name in claims:
            raise ValueError(f"claims.toml: '{name}' is there twice, or does not begin with '{PREFIX}'")
        if ("latex" in entry) != (entry["form"] == FORMULA):
            raise ValueError(f"claims.toml: '{name}' must have 'latex' if and only if its form is '{FORMULA}'")
        fragments = tuple(entry.get("fragments", ())) or ((entry["latex"],) if "latex" in entry else ())
        claims[name] = TextClaim(
            name,
            entry["line"],
            entry["after"],
            entry["form"],
            fragments,
            entry.get("scope") or scope_of(entry["after"]) or "",
            entry.get("latex", "").strip(),
            tuple(entry.get("given", ())),
            entry.get("domain", ""),
            {key: value for key, value in entry.items() if key not in _OWN},
        )
    return claims


def claims_of(text: str) -> tuple[dict[str, TextClaim], list[Difference]]:
    """The claims as a LaTeX source prints them, and where it differs from the ledger.

    A formula is taken from the source: the inline formula at its place that is most like the ledger's. Of the other
    forms only the fragments can be looked for; where one is missing, the source says something else, and what it says
    is not read: the claim is left out.
    """
    found, differences = {}, []
    for claim in load_claims().values():
        near = _near(text, claim.after)
        if near is None:
            differences.append(Difference(claim.id, 0, "absent from the source", claim.printed))
            continue
        start, place = near
        inline = [(match[1], match.start()) for match in _INLINE.finditer(place)]
        plain = [_plain(latex) for latex, _ in inline]
        missing = [one for one in claim.fragments if not any(_plain(one) in printed for printed in plain)]
        if not missing:
            found[claim.id] = claim
            continue
        latex, offset = _closest(missing[0], inline)
        line = text.count("\n", 0, start + offset) + 1
        differences.append(Difference(claim.id, line, "differs", missing[0], latex))
        if claim.form == FORMULA and latex:
            found[claim.id] = replace(claim, latex=latex, fragments=(latex,), line=line)
    return found, differences


def _near(text: str, label: str) -> tuple[int, str] | None:
    """Where the text from a label to the next begins, and that text; None if the label is not there."""
    labels = list(_LABEL.finditer(text))
    for n, match in enumerate(labels):
        if match[1] == label:
            stop = labels[n + 1].start() if n + 1 < len(labels) else len(text)
            return match.end(), text[match.end() : stop]
    return None


def _plain(latex: str) -> str:
    """Without spaces, and without the marks that end a formula."""
    return _SPACE.sub("", latex).rstrip(".,;:")


def _closest(latex: str, inline: list[tuple[str, int]]) -> tuple[str, int]:
    """The inline formula most like another, and its place; empty if none is alike."""
    scored = [(SequenceMatcher(None, _plain(latex), _plain(one)).ratio(), one, at) for one, at in inline]
    likeness, best, at = max(scored, default=(0.0, "", 0))
    return (best.strip(), at) if likeness > ALIKE else ("", 0)
