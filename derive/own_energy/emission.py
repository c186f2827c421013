"""The module of an energy of one's own: the solver's kernels, with an interface that turns the axes and back."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from sympy import Expr, Symbol

from derive.emit.backends import BACKENDS
from derive.emit.formulas import formulas_of
from derive.emit.head import fill
from derive.emit.kernel_files import read_kernels
from derive.emit.module import EmittedModule, emit_module
from derive.emit.render import render
from derive.emit.scene import GENERAL_CASE, Scene
from derive.own_energy.derivation import Derivation
from derive.own_energy.reduction import LINEAR, QUADRATIC, Reduction

OUTPUTS = ("equilibria", "shape", "sweep")
# Without a field the solver has no field angle, and the user still has: until that is folded, this stands for his.
_ANGLE = "angle_field"
_MEANING = {
    "beta": ("terminal force over bending stiffness, F/(EI) ≥ 0.",),
    "length": ("length of the rod, > 0.",),
    "clamp_angle": ("θ(0), the angle from the y axis to the tangent at the clamp, in radians.",),
    "field_angle": ("α, the angle from the y axis to the field, in radians.",),
}


@dataclass(frozen=True)
class OwnModule:
    """What is emitted: its name and title, the user's names of the moduli, and the values of these in SI letters."""

    name: str
    title: str
    reduction: Reduction
    names: Mapping[str, str]
    values: Mapping[str, Expr]

    @property
    def moduli(self) -> list[str]:
        """The parameters that are moduli of the energy."""
        return [self.names[letter] for letter in self.reduction.present]

    @property
    def scene(self) -> Scene:
        """The solver that is needed: without a quadratic part, that of a dead force."""
        case = GENERAL_CASE if QUADRATIC in self.reduction.present else "force_only"
        return Scene(self.name, self.title, case, OUTPUTS, tuple(BACKENDS), {})

    def renamed(self, expr: Expr) -> Expr:
        """An expression with the user's names of the moduli."""
        letters = [symbol for symbol in expr.free_symbols if symbol.name in self.names]
        return expr.subs({letter: Symbol(self.names[letter.name], real=True) for letter in letters}, simultaneous=True)


def own_module(derivation: Derivation, name: str, names: Mapping[str, str]) -> OwnModule:
    """The module of an energy; ``names`` are other names for moduli."""
    called = {letter: names.get(letter, letter) for letter in derivation.reduction.present}
    title = f"Clamped rod of {derivation.energy.name}"
    return OwnModule(name, title, derivation.reduction, called, derivation.moduli)


def emit_own(theory: Any, own: OwnModule, backend: str) -> EmittedModule:
    """The module on a backend; unproved (see ``derive.emit.proof``)."""
    scene = own.scene
    formulas = formulas_of(theory, GENERAL_CASE, scene.case) | {one.name: one for one in own.reduction.formulas}
    module = emit_module(theory, scene, backend, kernels=sources(own, backend), formulas=formulas)
    body = module.text.split('"""', 2)[2].replace(_ANGLE, "field_angle")
    return replace(module, text=head(own, module) + body.removeprefix("\n"))


def sources(own: OwnModule, backend: str) -> dict[str, str]:
    """The kernel files, with the interface of an energy of one's own in the place of the usual one."""
    found = {stem: re.sub(r"\bEquilibrium\b", "Reduced", text) for stem, text in read_kernels().items()}
    found.pop("api_mpmath", None)
    found["standard_api"] = found["api"]
    found["own_resultant"] = render("own_resultant.py.jinja", {})
    found["api"] = interface(own, backend)
    return found


def interface(own: OwnModule, backend: str) -> str:
    """The kernel file of the interface."""
    return render("own_api.py.jinja", _interface(own, backend))


def _interface(own: OwnModule, backend: str) -> dict[str, Any]:
    names, moduli = own.names, own.moduli
    present = own.reduction.present
    angle = "field_angle" if QUADRATIC in present else _ANGLE
    parameters = ["beta", *moduli, "length", "clamp_angle", "field_angle"]
    checks = {"beta": "not_negative", "length": "positive"}
    kinds = {LINEAR: "linear", QUADRATIC: "quadratic"}
    meaning = _MEANING | {
        names[one]: (f"modulus of the energy's {kinds[one]} part over bending stiffness, of either sign.",)
        for one in present
    }
    return {
        "backend": backend,
        "signature": ", ".join([*parameters[:-1], angle]),
        "angle": angle,
        "moduli": moduli,
        "meanings": [f"{angle if one == 'field_angle' else one}: {meaning[one][0]}" for one in parameters],
        "linear": names[LINEAR] if LINEAR in present else "",
        "quadratic": names[QUADRATIC] if QUADRATIC in present else "",
        "checks": [(angle if one == "field_angle" else one, one, checks.get(one, "real")) for one in parameters],
    }


def head(own: OwnModule, module: EmittedModule) -> str:
    """The docstring of the module."""
    linear, quadratic = (letter in own.reduction.present for letter in (LINEAR, QUADRATIC))
    parts = ["Solved in the axes of the resultant of the force and the linear part"] if linear else []
    parts += ["a negative quadratic part as a positive one a quarter turn on"] if quadratic else []
    solved = ", ".join(parts)
    return render(
        "own_head.jinja",
        {
            "title": own.title,
            "arithmetic": BACKENDS[module.backend].title,
            "density": str(own.renamed(own.reduction.density)),
            "moduli": [f"{own.names[name]} = {value}" for name, value in own.values.items()],
            "acceleration": str(own.renamed(own.reduction.equation)).replace("alpha", "α").replace("theta", "θ"),
            "free": ", ".join([*own.moduli, "clamp_angle", "field_angle"]),
            "solved": f"{solved[0].upper()}{solved[1:]}.",
            "claims": fill(sorted({one.name for one in module.formulas})),
            "digest": module.digest,
        },
    )
