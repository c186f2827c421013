"""Modules of energies of one's own: the interface around a solver that echoes, the resultant, the whole chain."""

from __future__ import annotations

import cmath
import inspect
import os
import re
import subprocess
import sys
from functools import cache
from math import inf, pi

import mpmath
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scenes_standin import THEORY
from sympy import Symbol
from test_layers import ALLOWED_IN_GENERATED, imports
from test_own_energy import DENSITIES, GUIDE, ROOT, k, mapped

from derive.emit.errors import EmitError
from derive.emit.kernel_files import KernelFiles, parse_kernel
from derive.emit.pieces import parameters_of
from derive.emit.proof import prove_module
from derive.measure.agreement import DOUBLE
from derive.measure.loading import load
from derive.own_energy import chain, emission, solver
from derive.own_energy.emission import OwnModule
from derive.stages import DerivationError
from derive.theory.energy import DIRECTION, Energy, H
from derive.theory.letters import chi, current, length, mass
from derive.theory.particle import energy_of
from generated import oblique_numpy

# The module, around a solver that gives back what it was asked

ECHO = {
    "rods": '''
"""What a solver gives that says what it was asked."""
from dataclasses import dataclass
from typing import Any

@dataclass(frozen=True, slots=True)
class Equilibrium:
    """What was asked."""
    tip_angle: float
    clamp_curvature: float
    gamma: float
    y: float
    z: float
    energy: float
    index: int
    rod: Any

def length_of(rod):
    """The length."""
    return rod
''',
    "equilibria": '''
"""A solver that gives back what it was asked."""
from derive.emit.kernels.rods import Equilibrium

def all_equilibria(beta, eta, length, clamp_angle, field_angle, max_index):
    """One rod."""
    return [Equilibrium(clamp_angle, beta, eta, length, 0 * length, field_angle, 0, length)]
''',
    "dense": '''
"""A shape."""
def shape_at(equilibrium, s, position):
    """A straight rod along y."""
    return 0 * s, 0 * s, s, 0 * s
''',
    "shapes": '''
"""A shape."""
def angle_and_position(equilibrium, s, position=True):
    """A straight rod along y."""
    return 0 * s, 0 * s, s, 0 * s
''',
}


def test_the_echo_is_asked_as_the_solver_is():
    """What the interface takes from the kernels is there, with the parameters that the echo has."""
    for backend in ("numpy", "mpmath"):
        own = OwnModule("m", "m", mapped(DENSITIES["mixed"])[0], {"tau": "tau", "eta": "eta"}, {})
        files = KernelFiles(emission.sources(own, backend), backend)
        taken = [origin for origin in files.files["api"].imports.values() if isinstance(origin, tuple)]
        assert len(taken) > 10
        assert [origin for origin in taken if files.lookup(*origin) is None] == []
    for stem, text in ECHO.items():
        for name, there in parse_kernel(stem, text).definitions.items():
            if there.kind == "function":
                assert parameters_of(files.lookup(stem, name).node) == parameters_of(there.node), name


NAMES = {"tau": "mu", "eta": "kappa"}


@cache
def echo(kind, backend="numpy"):
    """The module of an energy around the echo, proved and loaded."""
    reduction = mapped(DENSITIES[kind])[0]
    names = {letter: NAMES[letter] for letter in reduction.present}
    own = OwnModule("echo", "Echo", reduction, names, {})
    wanted = ("arithmetic", "arguments", "api")
    with pytest.MonkeyPatch.context() as patch:
        real = {stem: text for stem, text in emission.read_kernels().items() if stem.removesuffix("_mpmath") in wanted}
        patch.setattr(emission, "read_kernels", lambda: real | ECHO)
        module = emission.emit_own(THEORY, own, backend)
    proved = {proof.formula for proof in prove_module(module)}
    assert proved == ({"across", "along_near", "along_opposed"} if "tau" in names else set())
    return load(module.text)


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
@pytest.mark.parametrize("kind", DENSITIES)
def test_the_module_has_the_users_parameters(kind, backend):
    module, moduli = echo(kind, backend), {"linear": ["mu"], "quadratic": ["kappa"], "mixed": ["mu", "kappa"]}[kind]
    head = ["beta", *moduli, "length", "clamp_angle", "field_angle", "max_index"]
    found = list(inspect.signature(module.equilibria).parameters)
    assert found == head + ["dps"] * (backend == "mpmath")
    values = dict.fromkeys(moduli, -0.5) | {"beta": 0.25, "length": 2.0, "clamp_angle": 0.3, "field_angle": 0.7}
    (one,) = module.equilibria(**values)
    turn = {"quadratic": 0.0}.get(kind, cmath.phase(0.25 - 0.5 * cmath.exp(0.7j)))
    place = 2 * cmath.exp(1j * turn)
    assert (float(one.tip_angle), float(one.y), float(one.z)) == pytest.approx((0.3, place.real, place.imag), abs=1e-14)
    swept = module.sweep(**values | {"clamp_angle": [0.1, 0.3]})
    assert list(swept.case) == [0, 1]
    assert swept.y[1] == one.y
    shape = module.shape(one, [0.0, 1.0])
    assert complex(float(shape.y[1]), float(shape.z[1])) == pytest.approx(place / 2, abs=1e-14)
    assert float(shape.theta[0]) == pytest.approx(turn, abs=1e-14)


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_a_negative_quadratic_part_is_a_field_a_quarter_turn_on(backend):
    rod = {"beta": 1.0, "length": 2.0, "clamp_angle": 0.3, "field_angle": 0.7}
    (one,) = echo("quadratic", backend).equilibria(kappa=-0.5, **rod)
    # The echo gives back η as γ, and the field angle as the energy; then the part's least value is added to both.
    assert (float(one.gamma), float(one.energy)) == pytest.approx((0.5 - 0.5, 0.7 + pi / 2 + 0.5))
    (one,) = echo("quadratic", backend).equilibria(kappa=0.5, **rod)
    assert (float(one.gamma), float(one.energy)) == pytest.approx((0.5, 0.7))


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_bad_arguments_are_named(backend):
    module, good = (
        echo("mixed", backend),
        {"beta": 1, "mu": 1, "kappa": 1, "length": 1, "clamp_angle": 0, "field_angle": 0},
    )
    for name, value, error, says in (
        ("mu", "x", TypeError, "mu must be a real number"),
        ("kappa", inf, ValueError, "kappa must be finite"),
        ("beta", -1, ValueError, "beta must not be negative"),
        ("length", 0, ValueError, "length must be positive"),
    ):
        with pytest.raises(error, match=says):
            module.equilibria(**good | {name: value})
        with pytest.raises(error, match=rf"{name}\[1\]"):
            module.sweep(**good | {name: [1, value]})
    with pytest.raises(ValueError, match=r"length|shapes"):
        module.sweep(**good | {"mu": [1, 2, 3], "kappa": [1, 2]})
    with pytest.raises(ValueError, match=r"s\[1\] must lie in \[0, "):
        module.shape(module.equilibria(**good)[0], [0, 2])


SIZES = st.floats(1e-3, 1e3) | st.sampled_from([0.0, 1.0, 1e-160])
ANGLES = st.floats(-30, 30) | st.sampled_from([0.0, pi / 2, pi, -pi, 3.1415926, pi - 1e-9]) | st.floats(3.141, 3.142)


@given(SIZES, SIZES | SIZES.map(lambda x: -x), ANGLES)
@example(1.0, 1.0, pi)
@example(1.0, 1.0 + 2.0**-52, pi - 1e-12)
def test_the_resultant_keeps_its_digits(force, pull, angle):
    """However nearly the two cancel: the size to some roundings of itself, the angles to some roundings."""
    size, turn, left = echo("mixed").resultant(force, pull, angle)
    with mpmath.workdps(400):
        exact = mpmath.mpf(force) + mpmath.mpf(pull) * mpmath.expj(mpmath.mpf(angle))
        assert abs(size - abs(exact)) <= 8 * DOUBLE * abs(exact)
        if exact:
            off = (turn - mpmath.arg(exact) + mpmath.pi) % (2 * mpmath.pi) - mpmath.pi
            assert abs(off) <= 8 * DOUBLE * max(1, abs(angle))
    assert abs(turn + left - angle) <= 4 * DOUBLE * max(1, abs(angle))


def test_an_absent_part_leaves_the_angles_exact():
    assert echo("mixed").resultant(0.0, 2.0, 1.1) == (2.0, 1.1, 0.0)
    assert echo("mixed").resultant(2.0, 0.0, 1.1) == (2.0, 0.0, 1.1)


# The whole chain

M0 = Symbol("M_0", positive=True)
BOTH = energy_of("magnets that also gain", M0 * DIRECTION + chi * H.dot(DIRECTION) * DIRECTION, {M0: current / length})


@pytest.mark.long
def test_the_example(tmp_path):
    run = [sys.executable, "examples/permanent_magnet.py", str(tmp_path)]
    printed = subprocess.run(
        run, cwd=ROOT, capture_output=True, text=True, check=True, env=os.environ | {"PYTHONPATH": str(ROOT)}
    ).stdout
    assert re.search(r"^claims: \d+ PROVED$", printed, re.MULTILINE)
    assert printed.count("formulas read back and proved") == 2
    assert [line.rsplit(": ")[1] for line in printed.splitlines()[-3:]] == ["stable", "unstable", "stable"]
    assert {path.name for path in tmp_path.iterdir()} == {"permanent_magnet_numpy.py", "permanent_magnet_mpmath.py"}
    for path in tmp_path.iterdir():
        assert {name.split(".")[0] for name in imports(path)} <= ALLOWED_IN_GENERATED
    lint = [sys.executable, "-m", "ruff", "check", "--config", "pyproject.toml", str(tmp_path)]
    assert subprocess.run(lint, cwd=ROOT, capture_output=True, text=True, check=False).returncode == 0


@pytest.mark.long
def test_the_guide(tmp_path):
    """The first Python of the guide runs as it stands."""
    code = re.search(r"```python\n(.*?)```", GUIDE, re.DOTALL)[1]
    found = {"__name__": "guide"}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path)
        exec(compile(code, "own_energy.md", "exec"), found)
    assert [one.index for one in found["found"]] == [0, 1, 0]
    assert {claim["verdict"] for claim in found["magnet"].claims} == {"PROVED"}
    assert len(list((tmp_path / "magnet").iterdir())) == 2


@pytest.mark.long
def test_both_parts_together_and_nothing_of_a_wrong_one(tmp_path, monkeypatch):
    """A mixed energy agrees with the shipped solver; with one sign turned in the kernel nothing is written."""
    both = solver(BOTH, out=tmp_path / "good")
    rod = {"length": 3.0, "clamp_angle": 0.4, "field_angle": 0.9}
    plain = oblique_numpy.equilibria(beta=0.7, eta=1.3, **rod)
    got = both.numpy.equilibria(beta=0.7, tau=0.0, eta=1.3, **rod)
    assert [one.tip_angle for one in got] == pytest.approx([one.tip_angle for one in plain], rel=1e-14)
    assert [one.energy for one in got] == pytest.approx([one.energy for one in plain], rel=1e-14)
    assert len(list((tmp_path / "good").iterdir())) == 2
    turned = ("angle - left, left", "angle + left, left")
    wrong = {name: one | {"text": one["text"].replace(*turned)} for name, one in both.modules.items()}
    assert all(wrong[name]["text"] != one["text"] for name, one in both.modules.items())
    monkeypatch.setattr(chain, "emitted", lambda *_: wrong)
    with pytest.raises(EmitError, match=r"does not agree with its equation: .*it is not written"):
        solver(BOTH, out=tmp_path / "wrong")
    assert not (tmp_path / "wrong").exists()


@pytest.mark.long
def test_wrong_units_are_a_claim_that_does_not_hold(tmp_path):
    wrong = Energy("wrong units", lambda h, a: -k * h.dot(a), {k: length * mass})
    with pytest.raises(DerivationError, match=r"is a force .* REFUTED: give units for each"):
        solver(wrong, out=tmp_path / "none")
    assert not (tmp_path / "none").exists()
