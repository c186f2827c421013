"""Quantities with units: read from text, checked, and given back in the unit in which they came."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

from derive.numbers import MistakeError


@cache
def registry() -> Any:
    """Pint's registry of units; MistakeError without pint."""
    try:
        import pint
    except ModuleNotFoundError as error:
        raise MistakeError("units need the package pint: pip install 'magnetic-rods[units]'") from error
    return pint.UnitRegistry()


def quantity(text: str, like: str, where: str) -> Any:
    """The text as a quantity of the dimension of the unit ``like``; MistakeError names ``where``."""
    found = parsed(text, f'write it as in "1 {like}"', where)
    if not found.is_compatible_with(like):
        raise MistakeError(f'{where}: "{text}" is no {meaning(like)}; write it as in "1 {like}"')
    if registry()(like).dimensionless and found.unitless:
        raise MistakeError(f'{where}: "{text}" has no unit; write it as in "1 {like}"')
    return found


def parsed(text: str, mend: str, where: str) -> Any:
    """A finite number with its unit."""
    amount, _, unit = split(text)
    try:
        value = float(amount)
    except ValueError:
        raise MistakeError(f'{where}: "{text}" does not begin with a number; {mend}') from None
    if not math.isfinite(value):
        raise MistakeError(f'{where}: "{text}" is no finite number; {mend}')
    units = registry()
    try:
        return units.Quantity(value, units.parse_units(unit))
    except Exception as error:  # pint raises errors of its own, of its parser's and of Python's tokeniser
        raise MistakeError(f'{where}: "{unit}" is no unit; {mend}') from error


def split(text: str) -> tuple[str, str, str]:
    """Number and unit, where the number is the longest beginning that is one: "1e-3 m", "20mT"."""
    text = text.strip()
    for end in range(len(text), 0, -1):
        try:
            float(text[:end])
        except ValueError:
            continue
        return text[:end], "", text[end:].strip()
    return text.partition(" ")


def meaning(unit: str) -> str:
    """What a unit measures, in words."""
    words = {"mm": "length", "MPa": "stress", "mN": "force", "mT": "field", "degree": "angle"}
    return words.get(unit, f"quantity like {unit}")
