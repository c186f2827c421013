"""Rods that are refused on the command line, before any work: too large for doubles, or for anybody to wait for."""

from __future__ import annotations

from collections.abc import Mapping

from derive.emit.kernels.bounds import FOLDS_SLOWEST, must_be_searchable, must_have_answer, within_turns
from derive.numbers import MistakeError, spelled_option


def must_be_solvable(rod: Mapping[str, float], max_index: int | None) -> None:
    """MistakeError for a rod, all five parameters, of which not all equilibria that are wanted can be told."""
    try:
        must_turn(rod)
        must_have_answer(rod["beta"], rod["eta"], rod["length"], max_index)
    except ValueError as error:
        raise MistakeError(str(error).replace("max_index", spelled_option("max_index"))) from error


def must_be_traceable(rod: Mapping[str, float]) -> None:
    """MistakeError for a rod, with the highest loads of a range, whose branches and folds would never be done."""
    try:
        must_turn(rod)
        must_be_searchable(rod["beta"], rod["eta"], rod["length"], FOLDS_SLOWEST)
    except ValueError as error:
        raise MistakeError(str(error)) from error


def must_turn(rod: Mapping[str, float]) -> None:
    """ValueError for an angle that is not told."""
    for name in ("clamp_angle", "field_angle"):
        within_turns(spelled_option(name), rod[name])
