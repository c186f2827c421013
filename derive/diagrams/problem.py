"""One rod and the solver for it, with what its answers mean in the units in which it was given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import degrees
from types import ModuleType
from typing import Any

import numpy as np

from derive.diagrams.picture import Curve, View
from derive.diagrams.rod_file import PhysicalRod

SMALL = 0.1  # above this ε its square is no longer below a hundredth
ALONG = 401  # places at which the curvature is looked at


@dataclass(frozen=True)
class Problem:
    """A rod. values: what the module takes; full: all five parameters; rod: its file, None without units."""

    scene: str
    module: ModuleType
    values: Mapping[str, float]
    full: Mapping[str, float]
    rod: PhysicalRod | None
    in_degrees: bool

    @property
    def unit(self) -> str:
        """The unit of length, or nothing."""
        return f"{self.rod.units['length']:~P}" if self.rod else ""

    @property
    def turn(self) -> str:
        """The unit of angles, or nothing."""
        return "°" if self.in_degrees else ""

    def title(self) -> str:
        """The rod in a line."""
        if not self.rod:
            return ", ".join(f"{name} = {value:.12g}" for name, value in self.values.items())
        rod, full = self.rod, self.full
        units = {name: f"{unit:~P}" for name, unit in rod.units.items()}
        return (
            f"length {rod.length:g} {units['length']}, clamp at {self.angle(rod.clamp_angle):g}{self.turn}, "
            f"field {rod.field:g} {units['field']} at {self.angle(rod.field_angle):g}{self.turn}, "
            f"force {rod.force:g} {units['force']}; "
            f"ηℓ² = {full['eta'] * rod.length**2:.6g}, βℓ² = {full['beta'] * rod.length**2:.6g}"
        )

    def equilibria(self, max_index: int | None = None, changes: Mapping[str, float] | None = None) -> list[Any]:
        """All equilibria, sorted by tip angle; changes: other values than the rod's."""
        found: list[Any] = self.module.equilibria(**{**self.values, **(changes or {})}, max_index=max_index)
        return found

    def shape(self, one: Any, s: Any) -> Any:
        """The shape at arc lengths s; by the general solver where the scene leaves shapes out."""
        if hasattr(self.module, "shape"):
            return self.module.shape(one, s)
        from generated import oblique_numpy

        twins = oblique_numpy.equilibria(**self.full)
        return oblique_numpy.shape(min(twins, key=lambda twin: abs(twin.tip_angle - one.tip_angle)), s)

    def angle(self, radians: float) -> float:
        """An angle as it is shown."""
        return degrees(radians) if self.in_degrees else radians

    def columns(self) -> dict[str, str]:
        """What is shown of an equilibrium, with its name and unit."""
        unit, turn = self.unit, self.turn
        # A curvature is in radians per length whatever angles are given in, as θ′ is.
        units = {"tip_angle": turn, "clamp_curvature": f"1/{unit}" if unit else "", "y": unit, "z": unit}
        units |= {"energy": "J" if self.rod else ""}
        names = {"tip_angle": "θ(ℓ)", "clamp_curvature": "θ′(0)", "y": "y", "z": "z", "energy": "energy"}
        return {key: f"{name} [{units[key]}]" if units[key] else name for key, name in names.items()}

    def row(self, one: Any) -> dict[str, Any]:
        """What is shown of an equilibrium, in the rod's units."""
        keys = ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy", "index")
        found = {key: getattr(one, key) for key in keys}
        found["tip_angle"] = self.angle(one.tip_angle)
        if self.rod:
            # The solver's energy is over EI.
            found["energy"] = one.energy * self.rod.bending * self.rod.metre
            del found["gamma"]
        return found | {"stable": one.index == 0}

    def smallness(self, one: Any) -> float:
        """ε (kthr7): the half-thickness times the largest curvature, or over the length if that is more."""
        assert self.rod
        half = self.rod.diameter / 2
        curvature = np.abs(self.shape(one, np.linspace(0, self.rod.length, ALONG)).curvature).max()
        return float(max(half * curvature, half / self.rod.length))

    def curves(self, found: Sequence[Any], points: int) -> list[Curve]:
        """The positions along each equilibrium."""
        s = np.linspace(0, self.full["length"], points)
        shapes = [self.shape(one, s) for one in found]
        pairs = enumerate(zip(found, shapes, strict=True), 1)
        return [Curve(k, one.index, self.angle(one.tip_angle), at.y, at.z) for k, (one, at) in pairs]

    def view(self) -> View:
        """What a picture shows besides."""
        field = self.full["field_angle"] if self.full["eta"] > 0 else None
        return View(self.full["length"], self.full["clamp_angle"], field, self.full["beta"] > 0, self.unit, self.turn)

    def csv(self, found: Sequence[Any], points: int) -> str:
        """The shapes as a table: a header, then one line for each place on each equilibrium."""
        s = np.linspace(0, self.full["length"], points)
        lines = ["equilibrium,s,theta,curvature,y,z"]
        for k, one in enumerate(found, 1):
            at = self.shape(one, s)
            rows = zip(s.tolist(), at.theta.tolist(), at.curvature.tolist(), at.y.tolist(), at.z.tolist(), strict=True)
            lines += [f"{k},{p!r},{self.angle(t)!r},{c!r},{y!r},{z!r}" for p, t, c, y, z in rows]
        return "\n".join(lines) + "\n"
