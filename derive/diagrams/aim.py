"""What `--target`, `--vary` and `--range` say, and the answer in the rod's units."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, pi, radians
from typing import Any

from derive.diagrams.problem import Problem
from derive.diagrams.target import Reach, reaching
from derive.diagrams.units import quantity, registry
from derive.emit.kernels.folds import all_folds
from derive.numbers import MistakeError

COORDINATES = {"y": "y", "z": "z", "angle": "tip_angle"}
VARIED = {"eta": "eta", "field": "eta", "beta": "beta", "force": "beta", "field-angle": "field_angle"}
FAR = 10.0  # how far is looked if no range is given: up to ℓ√η, or ℓ√β, of this size

Number = Callable[[str, str], float]  # option, text → a number


def goal(problem: Problem, text: str, number: Number) -> tuple[str, float]:
    """Coordinate and value of a target such as "y=-20" or "z=3 mm"."""
    name, mark, value = (part.strip() for part in text.partition("="))
    if name not in COORDINATES or not mark or not value:
        raise MistakeError(f'--target: "{text}" is no target; write y=…, z=… or angle=…, as in --target y=-20')
    where = f"--target {name}"
    if name == "angle":
        return "tip_angle", turned(problem, value, where, number)
    if problem.rod and has_unit(value):
        return name, float(quantity(value, "mm", where).to(problem.rod.units["length"]).magnitude)
    return name, number(where, value)


def turned(problem: Problem, text: str, where: str, number: Number) -> float:
    """An angle in radians."""
    if problem.rod and has_unit(text) and "pi" not in text:
        return float(quantity(text, "degree", where).to("radian").magnitude)
    value = number(where, text)
    return radians(value) if problem.in_degrees else value


def has_unit(text: str) -> bool:
    """Whether more than a number was written."""
    return any(letter.isalpha() for letter in text.lower().replace("e", "").replace("pi", "")) or "°" in text


def limits(problem: Problem, name: str, text: str | None, number: Number) -> tuple[float, float]:
    """The range of the parameter, in the solver's terms."""
    if text is None:
        return (0.0, pi) if name == "field_angle" else (0.0, usual(problem.full["length"]))
    parts = text.split(":")
    if len(parts) != 2:
        raise MistakeError(f'--range: "{text}" is no range; write LOW:HIGH, as in --range 0:0.001')
    low, high = (inward(problem, name, part.strip(), number) for part in parts)
    if not low < high:
        raise MistakeError(f'--range: "{text}" is empty; the first number must be the lower one')
    if low < 0 and name != "field_angle":
        raise MistakeError(f'--range: "{text}" goes below 0; begin at 0 (a field the other way is the same field)')
    return low, high


def usual(length: float) -> float:
    """The load up to which is looked if no range is given."""
    high = (FAR / length) * (FAR / length)
    if not 0 < high < inf:
        raise MistakeError(
            f"--range is needed: the usual one is no double with --length {length:g}; or take another unit"
        )
    return high


def inward(problem: Problem, name: str, text: str, number: Number) -> float:
    """A value of the parameter as the solver takes it."""
    if name == "field_angle":
        return turned(problem, text, "--range", number)
    if not problem.rod:
        return number("--range", text)
    unit = problem.rod.units["field" if name == "eta" else "force"]
    united = has_unit(text)
    value = float(quantity(text, f"{unit:~}", "--range").to(unit).magnitude) if united else number("--range", text)
    if value < 0:
        return -1.0  # refused by the caller, whatever its size
    return problem.rod.eta(value) if name == "eta" else problem.rod.beta(value)


def outward(problem: Problem, name: str, value: float) -> float:
    """A value of the parameter as it is shown."""
    if name == "field_angle":
        return problem.angle(value)
    if not problem.rod:
        return value
    return problem.rod.field_of(value) if name == "eta" else problem.rod.force_of(value)


def label(problem: Problem, name: str) -> tuple[str, str]:
    """Name and unit of the parameter as they are shown."""
    if name == "field_angle":
        return "field angle", "°" if problem.in_degrees else ""
    if not problem.rod:
        return {"eta": "η", "beta": "β"}[name], ""
    kind = "field" if name == "eta" else "force"
    return kind, f"{registry().Quantity(1, problem.rod.units[kind]).units:~P}"


def reached(problem: Problem, name: str, coordinate: str, value: float, low: float, high: float) -> Reach:
    """All values of the parameter that bring the tip there."""

    def solve(parameter: float) -> list[Any]:
        try:
            return problem.equilibria(None, {name: parameter})
        except ArithmeticError as error:
            raise MistakeError(
                f"the solver fails at {name} = {parameter!r} ({error}); choose another --range"
            ) from error

    full = problem.full
    cuts = []
    if name == "eta":
        given = (full["beta"], full["length"], full["clamp_angle"], full["field_angle"])
        cuts = [fold.eta for fold in all_folds(*given, low, high)]
    return reaching(solve, coordinate, value, low, high, cuts)
