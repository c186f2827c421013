"""From an energy to a solver: derive, judge, emit, prove, run against references of the energy's own equation."""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

from sympy import Expr

from derive import output, stages
from derive.emit.errors import EmitError
from derive.measure.loading import load
from derive.numbers import MistakeError
from derive.own_energy import checks, tasks
from derive.own_energy.derivation import Derivation, derive_own
from derive.own_energy.emission import OwnModule, interface, own_module
from derive.own_energy.rods import own_rods
from derive.runner import Runner
from derive.theory.energy import Energy

GOOD = {"PROVED", "CERTIFIED", "AGREED"}
BACKENDS = ("numpy", "mpmath")
UNITS = "line_energy.dimension"  # the claim that fails first where the units that come with an energy are wrong


@dataclass(frozen=True)
class OwnSolver:
    """What the chain makes of an energy.

    density: ψ(w) over EI, w = d₃·e. acceleration: θ″. moduli: each parameter of the energy by its own letters, 1/m².
    claims: of the derivation, with verdicts. modules: by backend, with "text" and "proof". agreements: by backend, how
    far each is off the references. files: what was written.
    """

    density: Expr
    acceleration: Expr
    moduli: Mapping[str, Expr]
    claims: Sequence[Mapping[str, Any]] = field(repr=False)
    modules: Mapping[str, Mapping[str, Any]] = field(repr=False)
    agreements: Mapping[str, Mapping[str, Any]] = field(repr=False)
    files: tuple[Path, ...] = ()

    @cached_property
    def numpy(self) -> ModuleType:
        """The emitted module in double precision."""
        return load(self.modules["numpy"]["text"])

    @cached_property
    def mpmath(self) -> ModuleType:
        """Its twin in any precision."""
        return load(self.modules["mpmath"]["text"])

    def report(self) -> str:
        """What was derived, and what speaks for it, in a few lines."""
        verdicts = Counter(str(claim["verdict"]) for claim in self.claims)
        lines = [f"energy over EI by w = d₃·e: {self.density}", f"θ″ = {self.acceleration}"]
        lines += [f"{name} = {value}" for name, value in self.moduli.items()]
        lines += [f"claims: {', '.join(f'{count} {verdict}' for verdict, count in sorted(verdicts.items()))}"]
        for backend, module in self.modules.items():
            worst = max(row["roundings"] for row in self.agreements[backend]["rows"])
            count = self.agreements[backend]["equilibria"]
            proof = f"{len(module['proof'])} formulas read back and proved"
            lines.append(
                f"{module['name']}: {proof}; {count} equilibria of references, {worst:.1f} roundings off at most"
            )
        return "\n".join(lines)


def solver(
    energy: Energy,
    *,
    names: Mapping[str, str] | None = None,
    name: str = "",
    out: Path | str | None = None,
    runner: Runner | None = None,
) -> OwnSolver:
    """The solver of a rod with an energy of one's own, all of it proved and run, or nothing.

    names: other names for the moduli "tau" (of the linear part) and "eta" (of the quadratic part), which are parameters
    of the modules. name: of the modules; else made from the energy's. out: the folder to write them to, if any.
    runner: a cache, a number of processes, progress.

    MistakeError says, in a line, why the chain cannot take an energy. stages.DerivationError and EmitError mean that a
    claim, or a module, does not hold; then nothing is written.
    """
    folder = Path(out) if out is not None else None
    if folder:
        output.must_be_usable(folder)
    runner = _able(runner or Runner())
    derivation = derive_own(energy)
    own = named(derivation, name, names or {})
    tasks.hold(derivation)
    claims = judged(runner, derivation)
    modules = emitted(runner, derivation, own)
    agreements = compared(runner, derivation, own, modules)
    files = {folder / f"{one['name']}.py": one["text"] for one in modules.values()} if folder else {}
    output.write_all(files)
    moduli = {own.names[letter]: value for letter, value in derivation.moduli.items()}
    shown = own.renamed(own.reduction.density), own.renamed(own.reduction.equation)
    return OwnSolver(*shown, moduli, claims, modules, agreements, tuple(files))


def named(derivation: Derivation, name: str, names: Mapping[str, str]) -> OwnModule:
    """The module to be, under the names that the user gives; MistakeError if one of them cannot be."""
    stem = name or re.sub(r"\W+", "_", derivation.energy.name.lower(), flags=re.ASCII).strip("_")
    if not re.fullmatch(r"[a-z][a-z0-9_]*", stem):
        raise MistakeError(f"name '{stem}' of the modules must be lower-case letters, digits and underscores; give one")
    own = own_module(derivation, stem, {})
    checks.check_names(names, own.names, *(interface(own, backend) for backend in BACKENDS))
    return own_module(derivation, stem, names)


def judged(runner: Runner, derivation: Derivation) -> list[dict[str, Any]]:
    """All claims with their verdicts; DerivationError names the first that does not hold."""
    key = derivation.key
    listed = runner.result(tasks.list_task(key))
    wanted = [tasks.claim_task(key, one["id"]) for one in listed]
    found = runner.results(wanted, lambda: tasks.finished(key))
    for claim in found:
        if claim["verdict"] not in GOOD:
            values = claim["counterexample"] or {}
            why = claim["reason"] or ", ".join(f"{name} = {value}" for name, value in values.items())
            if claim["id"] == UNITS:
                why = "give units for each of its own letters that is no pure number, and the right ones"
            whose = checks.whose(derivation.energy)
            raise stages.DerivationError(
                f"{whose}: {claim['title']} ({claim['id']}) is {claim['verdict']}: {why}; nothing is emitted"
            )
    return [{**claim, "steps": one["steps"]} for one, claim in zip(listed, found, strict=True)]


def emitted(runner: Runner, derivation: Derivation, own: OwnModule) -> dict[str, dict[str, Any]]:
    """The modules by backend, read back and proved; EmitError if one is not."""
    wanted = [tasks.emit_task(derivation.key, own.name, dict(own.names), backend) for backend in BACKENDS]
    found = dict(zip(BACKENDS, runner.results(wanted, stages.theory), strict=True))
    for module in found.values():
        if module["failure"]:
            raise EmitError(f"{module['name']}: {module['failure']}")
    return found


def compared(
    runner: Runner, derivation: Derivation, own: OwnModule, modules: Mapping[str, dict[str, Any]]
) -> dict[str, dict[str, Any]]:
    """How far the modules are off the references; EmitError if one is further than rounding allows."""
    rods = [asdict(rod) for rod in own_rods(("beta", *own.moduli), own.reduction.present)]
    known = runner.results([tasks.reference_task(derivation.law, rod) for rod in rods])
    found = runner.results([tasks.agree_task(module, rods, known) for module in modules.values()])
    for module, result in zip(modules.values(), found, strict=True):
        if result["faults"]:
            raise EmitError(
                f"{module['name']} does not agree with its equation: {result['faults'][0]}; it is not written"
            )
    return dict(zip(modules, found, strict=True))


def _able(runner: Runner) -> Runner:
    """A runner whose processes know the energy: where they are not forked, this one alone."""
    return runner if sys.platform == "linux" else replace(runner, jobs=1)
