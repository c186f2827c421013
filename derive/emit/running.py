"""Running an emitted module before it is written: each result against the reference, on a few rods of its scene."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from types import ModuleType
from typing import Any

from mpmath import exp, fabs, mpf, sqrt, workdps

from derive.emit.errors import EmitError
from derive.emit.module import EmittedModule
from derive.emit.reference import integrate
from derive.emit.scene import Scene

# Rods that bend without being stiff: β·length², η·length² and the clamp angle. Stiff ones are for `derive measure`.
RODS = (("1.5", "4", "2.2"), ("3", "0.7", "-1.1"), ("5", "20", "3.9"), ("30", "6", "2.8"))
_LENGTH = "1.25"
_DIGITS = 30  # of the mpmath twin in the run
# About 50 roundings, times the growth of a clamp error along the rod; found: 3e-16 and 2e-31.
_ALLOWED = {"numpy": mpf("1e-14"), "mpmath": mpf("1e-28")}
_GUARD_DIGITS = 10  # of comparisons beyond that
_STIFFEST = 12  # length·√(β + η) beyond which a rounded clamp curvature says nothing about the tip


def load(module: EmittedModule) -> ModuleType:
    """The module as Python imports it, from its text."""
    made = ModuleType(f"_emitted_{module.name}")
    sys.modules[made.__name__] = made
    try:
        exec(compile(module.text, module.path, "exec"), made.__dict__)
    except Exception as error:
        raise EmitError(f"{module.path}: cannot be imported: {type(error).__name__}: {error}") from error
    finally:
        del sys.modules[made.__name__]
    return made


def rods(scene: Scene) -> Iterator[dict[str, Any]]:
    """Parameters of the rods to run, folded constants included, as exact text or mpf."""
    for beta, eta, clamp_angle in RODS:
        with workdps(_DIGITS):
            folded = {name: mpf(str(value.evalf(_DIGITS))) for name, value in scene.folded.items()}
            length = folded.get("length", mpf(_LENGTH))
            rod = {"length": length, "clamp_angle": mpf(clamp_angle), "field_angle": mpf(0)}
            rod |= {"beta": mpf(beta) / length**2, "eta": mpf(eta) / length**2} | folded
            if rod["length"] * sqrt(rod["beta"] + rod["eta"]) <= _STIFFEST:
                yield rod


def run_against_reference(module: EmittedModule) -> Iterator[str]:
    """Run every output on every rod; yields what was run, raises EmitError where a result is wrong."""
    made = load(module)
    for rod in rods(module.scene):
        given = {name: rod[name] for name in module.scene.parameters}
        if module.backend == "numpy":
            given = {name: float(value) for name, value in given.items()}
            rod = {**rod, **{name: mpf(value) for name, value in given.items()}}
        try:
            yield from _run(module, made, rod, given)
        except EmitError:
            raise
        except Exception as error:
            text = ", ".join(f"{name}={float(value):.6g}" for name, value in given.items())
            raise EmitError(f"{module.path}: fails at {text}: {type(error).__name__}: {error}") from error


def _run(module: EmittedModule, made: ModuleType, rod: dict[str, Any], given: dict[str, Any]) -> Iterator[str]:
    extra = {"dps": _DIGITS} if module.backend == "mpmath" else {}
    text = ", ".join(f"{name}={float(value):.6g}" for name, value in given.items())
    if "equilibria" in module.scene.outputs:
        found = made.equilibria(**given, **extra)
        if not found:
            raise EmitError(f"{module.path}: no equilibrium at {text}; there is always one")
        for equilibrium in found:
            _check(module, rod, equilibrium, text)
            if "shape" in module.scene.outputs:
                _check_shape(module, made, rod, equilibrium, text, extra)
        yield f"{len(found)} equilibria at {text}"
    if "sweep" in module.scene.outputs:
        swept = made.sweep(**given, **extra)
        if "equilibria" in module.scene.outputs and len(swept.tip_angle) != len(found):
            raise EmitError(f"{module.path}: sweep finds {len(swept.tip_angle)} of {len(found)} equilibria at {text}")
        yield f"sweep at {text}"


def _compare(module: EmittedModule, rod: dict[str, Any], pairs: dict[str, tuple[Any, Any]], text: str) -> None:
    """All pairs agree within the allowed loss, enlarged by the growth of errors along the rod."""
    with workdps(_DIGITS + _GUARD_DIGITS):
        allowed = _ALLOWED[module.backend] * exp(rod["length"] * sqrt(rod["beta"] + rod["eta"]))
        for name, (got, wanted) in pairs.items():
            error = fabs(mpf(got) - wanted) / (1 + fabs(wanted))
            if not error <= allowed:
                raise EmitError(
                    f"{module.path}: {name} = {got} at {text}, but integration from the clamp gives "
                    f"{float(wanted):.17g} (off by {float(error):.1e}, allowed {float(allowed):.1e})"
                )


def _at(rod: dict[str, Any], equilibrium: Any, s: Any) -> Any:
    names = ("beta", "eta", "clamp_angle", "field_angle")
    return integrate(**{n: rod[n] for n in names}, length=s, curvature=mpf(equilibrium.clamp_curvature))


def _check(module: EmittedModule, rod: dict[str, Any], equilibrium: Any, text: str) -> None:
    end = _at(rod, equilibrium, rod["length"])
    pairs = {name: (getattr(equilibrium, name), getattr(end, name)) for name in ("y", "z", "energy")}
    pairs |= {"tip_angle": (equilibrium.tip_angle, end.theta), "the curvature at the tip": (0, end.curvature)}
    _compare(module, rod, pairs, text)


def _check_shape(
    module: EmittedModule, made: ModuleType, rod: dict[str, Any], equilibrium: Any, text: str, extra: dict[str, Any]
) -> None:
    s = rod["length"] * mpf("0.375")
    s = mpf(float(s)) if module.backend == "numpy" else s
    found = made.shape(equilibrium, float(s) if module.backend == "numpy" else s, **extra)
    here = _at(rod, equilibrium, s)
    pairs = {name: (getattr(found, name), getattr(here, name)) for name in ("theta", "curvature", "y", "z")}
    _compare(module, rod, pairs, f"{text}, s={float(s):.6g}")
