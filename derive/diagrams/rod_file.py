"""A rod in physical units, from a TOML file."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from derive.diagrams import particle
from derive.diagrams.units import quantity, registry
from derive.numbers import MistakeError

QUANTITIES = {"length": "mm", "diameter": "mm", "youngs_modulus": "MPa", "field": "mT", "force": "mN"}
PURE = ("volume_fraction", "aspect_ratio", "susceptibility", "susceptibility_across")
ANGLES = ("clamp_angle", "field_angle")
OPTIONAL = {"susceptibility_across"}
KEYS = (*QUANTITIES, *PURE, *ANGLES)
MAY_VANISH = {"field", "force"}


@dataclass(frozen=True)
class PhysicalRod:
    """A rod and its loads. Lengths in the unit of the rod's length, angles in radians.

    bending: EI, N m². chi: χ of a particle. eta_per: η in 1/m² of a field of 1 A/m. field, force: in the file's units.
    units: those of length, field and force in the file; degrees: whether its angles are.
    """

    length: float
    diameter: float
    bending: float
    chi: float
    eta_per: float
    field: float
    force: float
    clamp_angle: float
    field_angle: float
    degrees: bool
    units: Mapping[str, Any]

    @property
    def metre(self) -> float:
        """One metre in the unit of length."""
        return float(registry().Quantity(1, "m").to(self.units["length"]).magnitude)

    def eta(self, field: float) -> float:
        """η per square of the unit of length, for a field in the file's unit."""
        strength = amperes_per_metre(registry().Quantity(field, self.units["field"]))
        return self.eta_per * strength**2 / self.metre**2

    def field_of(self, eta: float) -> float:
        """The field in the file's unit, for η."""
        strength = math.sqrt(eta * self.metre**2 / self.eta_per)
        return float(in_unit_of_field(strength, self.units["field"]))

    def beta(self, force: float) -> float:
        """β per square of the unit of length, for a force in the file's unit."""
        newtons = registry().Quantity(force, self.units["force"]).to("N").magnitude
        return float(newtons / self.bending / self.metre**2)

    def force_of(self, beta: float) -> float:
        """The force in the file's unit, for β."""
        newtons = registry().Quantity(beta * self.metre**2 * self.bending, "N")
        return float(newtons.to(self.units["force"]).magnitude)

    def parameters(self) -> dict[str, float]:
        """What a solver takes."""
        angles = {"clamp_angle": self.clamp_angle, "field_angle": self.field_angle}
        return {"beta": self.beta(self.force), "eta": self.eta(self.field), "length": self.length, **angles}


def amperes_per_metre(strength: Any) -> float:
    """A field in A/m; one in tesla is μ₀ times it."""
    if strength.is_compatible_with("T"):
        return float(strength.to("T").magnitude / particle.MU0)
    return float(strength.to("A/m").magnitude)


def in_unit_of_field(strength: float, unit: Any) -> float:
    """A field in A/m in another unit."""
    quantities = registry().Quantity
    if quantities(1, unit).is_compatible_with("T"):
        return float(quantities(strength * particle.MU0, "T").to(unit).magnitude)
    return float(quantities(strength, "A/m").to(unit).magnitude)


def read_rod(path: Path) -> PhysicalRod:
    """The rod of a file; MistakeError names file, key and mend."""
    table = read_table(path)
    given = {key: quantity_at(table, path, key) for key in QUANTITIES}
    pure = {key: pure_at(table, path, key) for key in PURE if key in table}
    angles = {key: angle_at(table, path, key) for key in ANGLES}
    must_be_a_rod(given, pure, path)
    diameter = given["diameter"].to("m").magnitude
    bending = particle.stiffness(given["youngs_modulus"].to("Pa").magnitude, diameter)
    along = pure["susceptibility"]
    chi = particle.excess(along, pure.get("susceptibility_across", along), pure["aspect_ratio"])
    if chi <= 0:
        raise MistakeError(f"{path}: susceptibility_across: the particles would turn across the field; lower it")
    unit = given["length"].units
    return PhysicalRod(
        float(given["length"].magnitude),
        float(given["diameter"].to(unit).magnitude),
        bending,
        chi,
        particle.eta_of(chi, pure["volume_fraction"], diameter, bending, 1.0),
        float(given["field"].magnitude),
        float(given["force"].magnitude),
        **angles,
        degrees=any("deg" in str(table[key]) or "°" in str(table[key]) for key in ANGLES),
        units={name: given[name].units for name in ("length", "field", "force")},
    )


def read_table(path: Path) -> dict[str, Any]:
    """Keys and values of the file, the keys checked."""
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise MistakeError(f"{path}: cannot be read ({error.strerror}); see examples/rod.toml") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise MistakeError(f"{path}: no TOML ({error}); see examples/rod.toml") from error
    for key in table:
        if key not in KEYS:
            raise MistakeError(f"{path}: {key}: unknown key; possible: {', '.join(KEYS)}")
    for key in KEYS:
        if key not in table and key not in OPTIONAL:
            example = f'"1 {QUANTITIES[key]}"' if key in QUANTITIES else '"90 degree"' if key in ANGLES else "10"
            example = "0.1" if key == "volume_fraction" else example
            raise MistakeError(f"{path}: {key} is missing; add a line such as {key} = {example}")
    return table


def quantity_at(table: Mapping[str, Any], path: Path, key: str) -> Any:
    """A quantity with a unit, not negative; zero only where a load may be absent."""
    value, like, where = table[key], QUANTITIES[key], f"{path}: {key}"
    if not isinstance(value, str):
        raise MistakeError(f'{where}: {value!r} has no unit; write it in quotes, as in "1 {like}"')
    in_amperes = key == "field" and "A" in value and not value.rstrip().endswith("T")
    found = quantity(value, "A/m" if in_amperes else like, where)
    if found.magnitude < 0 or (found.magnitude == 0 and key not in MAY_VANISH):
        mend = {
            "field": "it must be at least 0; its direction is field_angle",
            "force": "it must be at least 0; it points along y",
        }.get(key, "it must be positive")
        raise MistakeError(f'{where}: "{value}" is not possible; {mend}')
    return found


def pure_at(table: Mapping[str, Any], path: Path, key: str) -> float:
    """A number without unit."""
    value = table[key]
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise MistakeError(f"{path}: {key}: {value!r} is no finite number; write one without unit or quotes")
    return float(value)


def angle_at(table: Mapping[str, Any], path: Path, key: str) -> float:
    """An angle in radians, from "90 degree" or a number of radians."""
    value = table[key]
    if isinstance(value, str):
        return float(quantity(value, "degree", f"{path}: {key}").to("radian").magnitude)
    return pure_at(table, path, key)


def must_be_a_rod(given: Mapping[str, Any], pure: Mapping[str, float], path: Path) -> None:
    """MistakeError for what is no rod with prolate particles in it."""
    if not 0 < pure["volume_fraction"] < 1:
        raise MistakeError(f"{path}: volume_fraction: {pure['volume_fraction']:g} must lie between 0 and 1")
    if pure["aspect_ratio"] <= 1:
        raise MistakeError(f"{path}: aspect_ratio: {pure['aspect_ratio']:g} must be above 1: a prolate particle")
    for key in PURE[2:]:
        if pure.get(key, 1.0) <= 0:
            raise MistakeError(f"{path}: {key}: {pure[key]:g} must be positive: a paramagnetic particle")
    if given["diameter"] >= given["length"]:
        raise MistakeError(
            f"{path}: diameter: {given['diameter']:~} is no less than the length; a rod is longer than that"
        )
