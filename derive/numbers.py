"""The numbers that a user gives on the command line, each checked at the border."""

from __future__ import annotations

import argparse
import inspect
import math
from collections.abc import Collection, Sequence
from types import ModuleType


class MistakeError(Exception):
    """Something in what was asked cannot be; the message says what, where, and what mends it."""


def given_numbers(options: argparse.Namespace) -> dict[str, float]:
    """The numbers on the command line, each checked by itself."""
    texts = {name: getattr(options, name) for name in ("beta", "eta", "length", "clamp_angle", "field_angle")}
    values = {name: number(spelled_option(name), text) for name, text in texts.items() if text is not None}
    for name, value in values.items():
        must_be_possible(name, value)
    return values


def must_be_possible(name: str, value: float) -> None:
    """MistakeError for a value that lies outside the range of its parameter."""
    if (name in ("beta", "eta") and value < 0) or (name == "length" and value <= 0):
        bound = "positive" if name == "length" else "at least 0"
        raise MistakeError(f"--{name} must be {bound} (got {value:g})")


def parameters(scene: str, module: ModuleType, values: dict[str, float]) -> dict[str, float]:
    """The numbers that a module needs; MistakeError if one is missing or too many."""
    known = inspect.signature(module.equilibria).parameters.values()
    wanted = [one.name for one in known if one.kind is not one.KEYWORD_ONLY]
    must_be_these(scene, wanted, values)
    return {name: values[name] for name in wanted}


def must_be_these(scene: str, wanted: Sequence[str], given: Collection[str]) -> None:
    """MistakeError for a parameter of a scene that is missing, or that it does not have."""
    needs = f"scene '{scene}' needs {', '.join(map(spelled_option, wanted))}"
    for name in wanted:
        if name not in given:
            raise MistakeError(f"{spelled_option(name)} is missing; {needs}")
    for name in given:
        if name not in wanted:
            raise MistakeError(f"{spelled_option(name)} is no parameter here; {needs}")


def spelled_option(name: str) -> str:
    """A parameter as an option."""
    return "--" + name.replace("_", "-")


def number(option: str, text: str) -> float:
    """A finite number from the command line."""
    try:
        value = float(text)
    except ValueError:
        from derive.emit.constants import parse_constant

        try:
            value = float(parse_constant(text))
        except (ValueError, OverflowError) as error:
            raise MistakeError(f"{option}: {error}") from error
    if not math.isfinite(value):
        raise MistakeError(f"{option} must be a finite number (got {text})")
    return value
