"""What a diagram is asked for with: one load that varies, another that may take several values, the rest fixed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from derive.numbers import MistakeError, must_be_possible, must_be_these, number, spelled_option

LOADS = ("beta", "eta", "length", "clamp_angle", "field_angle")
FEWEST, MOST = 2, 1_000_000


@dataclass(frozen=True)
class Request:
    """Values of the parameter that varies; for each curve of the family the loads that do not."""

    parameter: str
    values: tuple[float, ...]
    curves: tuple[dict[str, float], ...]


def request(scene: str, wanted: tuple[str, ...], texts: Mapping[str, str | None]) -> Request:
    """What the command line asks of a scene whose parameters are ``wanted``; MistakeError says what is wrong.

    A number fixes a parameter, low:high:points lets it vary, several numbers with commas make a family of curves.
    """
    given = {name: text for name, text in texts.items() if text is not None}
    must_be_these(scene, wanted, given)
    varying = [name for name in wanted if ":" in given[name]]
    several = [name for name in wanted if "," in given[name]]
    if len(varying) != 1 or len(several) > 1:
        raise MistakeError(
            f"one parameter must be a range low:high:points (there are {len(varying)}), and at most one a list with "
            f"commas (there are {len(several)}); as in --eta 0:0.001:500 --beta 0.0002,0.00035"
        )
    fixed = {name: checked(name, given[name]) for name in wanted if name not in (*varying, *several)}
    return Request(varying[0], span(varying[0], given[varying[0]]), tuple(family(several, given, fixed)))


def family(several: list[str], given: Mapping[str, str], fixed: dict[str, float]) -> Iterator[dict[str, float]]:
    """The loads of each curve."""
    if not several:
        yield fixed
    for name in several:
        for part in given[name].split(","):
            yield {**fixed, name: checked(name, part)}


def checked(name: str, text: str) -> float:
    """One number within the bounds of its parameter."""
    value = number(spelled_option(name), text.strip())
    must_be_possible(name, value)
    return value


def span(name: str, text: str) -> tuple[float, ...]:
    """The values of low:high:points."""
    option, parts = spelled_option(name), text.split(":")
    if len(parts) != 3 or not parts[2].strip().isdigit():
        raise MistakeError(f"{option} must be low:high:points, as in 0:0.001:500 (got {text})")
    low, high, count = checked(name, parts[0]), checked(name, parts[1]), int(parts[2])
    if not low < high:
        raise MistakeError(f"{option}: the range must ascend (got {low:g} to {high:g})")
    if not FEWEST <= count <= MOST:
        raise MistakeError(f"{option}: from {FEWEST} to {MOST} points are possible (got {count})")
    return tuple(low + (high - low) * k / (count - 1) for k in range(count - 1)) + (high,)
