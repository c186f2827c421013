"""An energy of one's own: the curve, the map with its mutants, references by the own law, and what is refused."""

from __future__ import annotations

import cmath
import inspect
import os
import re
import subprocess
import sys
from functools import cache
from math import cos, inf, pi, sin
from pathlib import Path
from types import SimpleNamespace

import mpmath
import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st
from scenes_standin import THEORY
from sympy import Symbol
from test_layers import ALLOWED_IN_GENERATED, imports
from test_theory_section3 import PREMISES

from derive.check.judge import judge
from derive.check.mutate import mutate_all
from derive.check.verdicts import PROVED, REFUTED
from derive.emit.errors import EmitError
from derive.emit.proof import prove_module
from derive.measure.agreement import DOUBLE, agreement
from derive.measure.loading import load
from derive.measure.reference import Rod, solve
from derive.numbers import MistakeError
from derive.own_energy import emission, solver
from derive.own_energy.checks import check_names
from derive.own_energy.curve import curve_of
from derive.own_energy.emission import OwnModule
from derive.own_energy.law import at_loads, evaluate, law_of, slope
from derive.own_energy.reduction import claim_reduction, reduce_plane
from derive.own_energy.references import OwnRod, from_json, references
from derive.stages import DerivationError
from derive.theory import plane
from derive.theory.claims import Equal, Notebook
from derive.theory.energy import DIRECTION, Energy, H
from derive.theory.letters import chi, length, mass, tau, w
from derive.theory.particle import energy_of
from derive.theory.symbols import eta
from generated import oblique_numpy

ROOT = Path(__file__).resolve().parent.parent
k = Symbol("k", positive=True)
DENSITIES = {"linear": -tau * w, "quadratic": -eta * w**2 / 2, "mixed": -tau * w - eta * w**2 / 2}


@cache
def plane_of(density) -> tuple[plane.Plane, Notebook]:
    """The plane problem of an energy density in w, with the moment equation written out."""
    book = Notebook()
    for premise in PREMISES:
        book.claim(premise, "given here, derived in Section 2", Equal(0, 0))

    def residual(d3, force, e):
        turned = -sympy.diff(density, w).subs(w, d3.dot(e)) * d3.cross(e)
        return d3.cross(d3.diff(plane.s)).diff(plane.s) + d3.cross(force) + turned

    section2 = SimpleNamespace(alignment=w, energy_density=density, residual=residual)
    return plane.derive(section2, book), book


@cache
def mapped(density, known=DENSITIES["quadratic"]) -> tuple:
    """The reduction of a density, and the verdicts on its claims by what they claim."""
    own, book = plane_of(density)
    mine = Notebook()
    for claim in book.claims.values():
        mine.claim(claim.id, claim.title, claim.relation, domain=claim.domain)
    found = reduce_plane(own, mine)
    claim_reduction(found, own, plane_of(known)[0], mine)
    claims = [claim for claim in mine.claims.values() if claim.id.startswith("own.")]
    return found, {claim.id: judge(claim).verdict for claim in claims}, claims


# The curve


@pytest.mark.parametrize(
    ("density", "degree", "genus"),
    [(-tau * w, 2, 1), (-eta * w**2, 4, 1), (w - w**2, 4, 1), (w**3, 6, 3), (-k * w**4, 8, 3), (w**2 + w**5, 10, 5)],
    ids=str,
)
def test_genus(density, degree, genus):
    curve = curve_of(plane_of(density)[0])
    assert (curve.numerator.degree(), curve.genus) == (degree, genus)


# The map


@pytest.mark.parametrize("kind", DENSITIES)
def test_the_map_is_proved(kind):
    found, verdicts, _ = mapped(DENSITIES[kind])
    assert found.present == {"linear": ("tau",), "quadratic": ("eta",), "mixed": ("tau", "eta")}[kind]
    assert {"own.bending_law", "own.straightening_gamma"} <= set(verdicts) or kind == "linear"
    assert set(verdicts.values()) == {PROVED}


@pytest.mark.parametrize("kind", DENSITIES)
def test_a_wrong_solver_is_refuted(kind):
    wrong = {"linear": -eta * w**2 / 2 - w / 9, "quadratic": eta * w**2 / 2, "mixed": -eta * w**2}[kind]
    verdicts = mapped(DENSITIES[kind], wrong)[1]
    assert REFUTED in verdicts.values()


@pytest.mark.parametrize("kind", DENSITIES)
def test_no_mutant_of_the_map_survives(kind):
    outcomes = mutate_all(mapped(DENSITIES[kind])[2], jobs=1, limit=3)
    assert len(outcomes) > 10
    assert [(one.id, one.change) for one in outcomes if one.fate == "failed"] == []


# The law and its references


@given(*(st.floats(-4, 4) for _ in range(5)))
def test_the_law_as_data_is_the_equation(b, t, e, at, field):
    found = mapped(DENSITIES["mixed"])[0]
    law = law_of(found.density, found.acceleration, w, ("beta", "tau", "eta"))
    couple, density = (at_loads(law[part], [b, t, e], cos(field), sin(field), float) for part in ("couple", "density"))
    expected = b * sin(at) + t * sin(at - field) + e / 2 * sin(2 * (at - field))
    assert evaluate(couple, cos(at), sin(at)) == pytest.approx(expected, abs=1e-12)
    assert evaluate(slope(density), cos(at), sin(at)) == pytest.approx(expected, abs=1e-12)
    level = -t * cos(at - field) - e / 2 * cos(at - field) ** 2 - b * cos(at)
    assert evaluate(density, cos(at), sin(at)) == pytest.approx(level, abs=1e-12)


def test_the_references_are_those_of_the_paramagnetic_rod():
    """Two integrations that share the steps, not the equation: one has it in θ − α, the other as a law."""
    known = Rod(beta=0.2, eta=0.9, length=3.0, clamp_angle=2.6, field_angle=0.3)
    law = law_of(DENSITIES["quadratic"], plane_of(DENSITIES["quadratic"])[0].angular_acceleration, w, ("beta", "eta"))
    rod = OwnRod(("beta", "eta"), (known.beta, known.eta), known.length, known.clamp_angle, known.field_angle)
    answers = [from_json(rod, one) for one in references(law, rod)]
    assert [one.index for one in answers] == [0, 1, 0]
    for one in answers:
        expected = solve(known, one.values["tip_angle"])
        assert one.index == expected.index
        assert all(abs(one.values[name] - value) < mpmath.mpf(10) ** -39 for name, value in expected.values.items())
        assert all(one.sensitivity[name] > 0.99 * size for name, size in expected.sensitivity.items())


# The module, around a solver that gives back what it was asked

ECHO = {
    "equilibria": '''
"""A solver that gives back what it was asked."""
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

def all_equilibria(beta, eta, length, clamp_angle, field_angle, max_index):
    """One rod."""
    return [Equilibrium(clamp_angle, beta, eta, length, 0 * length, field_angle, 0, length)]

def length_of(rod):
    """The length."""
    return rod
''',
    "dense": '''
"""A shape."""
def shape_at(equilibrium, s, position):
    """A straight rod along y."""
    return 0 * s, 0 * s, s, 0 * s
''',
    "shapes": '''
"""A shape."""
def angle_and_position(equilibrium, s):
    """A straight rod along y."""
    return 0 * s, 0 * s, s, 0 * s
''',
}
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


# The run against the references

ROD = OwnRod(("beta", "tau", "eta"), (0.3, 0.4, -0.5), 2.5, -0.7, 1.9)


@cache
def answers():
    found = mapped(DENSITIES["mixed"])[0]
    law = law_of(found.density, found.acceleration, w, ROD.names)
    return [from_json(ROD, one) for one in references(law, ROD)]


def by_hand(**wrong):
    """The map as a module by hand on the shipped solver; ``wrong`` are the signs and shifts put into it."""
    sign = {"turn": 1, "lean": 1, "field": 1, "energy": 1, "z": 1, "gamma": 1} | wrong

    def equilibria(beta, tau, eta, length, clamp_angle, field_angle):
        pull = beta + tau * cmath.exp(1j * field_angle)
        turn = sign["turn"] * cmath.phase(pull)
        lean = field_angle - sign["lean"] * turn + sign["field"] * pi / 2
        found = oblique_numpy.equilibria(abs(pull), -eta, length, clamp_angle - turn, lean)
        for one in found:
            place = complex(one.y, sign["z"] * one.z) * cmath.exp(1j * turn)
            yield SimpleNamespace(
                **{name: getattr(one, name) for name in ("clamp_curvature", "index")},
                tip_angle=one.tip_angle + turn,
                gamma=one.gamma + sign["gamma"] * eta,
                y=place.real,
                z=place.imag,
                energy=one.energy - sign["energy"] * eta * length / 2,
            )

    return SimpleNamespace(equilibria=lambda *args, **named: list(equilibria(*args, **named)))


def test_the_map_by_hand_agrees():
    result = agreement(by_hand(), [(ROD.arguments, answers())], DOUBLE)
    assert result.holds
    assert max(row.roundings for row in result.rows.values()) < 20


@pytest.mark.parametrize(
    "wrong", [{"turn": -1}, {"lean": -1}, {"field": 0}, {"energy": -1}, {"z": -1}, {"gamma": -1}], ids=str
)
def test_a_wrong_map_does_not_agree(wrong):
    assert not agreement(by_hand(**wrong), [(ROD.arguments, answers())], DOUBLE).holds


# What is refused

REFUSED = {
    "no polynomial": (lambda h, a: -k * sympy.sqrt(1 + h.dot(a) ** 2), "is not elliptic: by w = d3.e it is -A*k*sqrt"),
    "Langevin": (lambda h, a: -sympy.log(sympy.sinh(h.dot(a)) / h.dot(a)), "undefined at w = 0, no polynomial"),
    "a crystal": (lambda h, a: -k * a[0] ** 2, "changes when field and particles turn together"),
    "no direction": (lambda h, a: -k * h.dot(h), "does not depend on the direction of the rod"),
    "a float": (lambda h, a: -0.5 * h.dot(a), "holds the float -0.5.*Rational"),
    "a letter": (lambda h, a: -Symbol("c") * h.dot(a), r"the letter c, not known to be real; Symbol\('c', real=True\)"),
    "a vector": (lambda h, a: h.cross(a), "must be a function density.* that gives a scalar"),
    "imaginary": (lambda h, a: sympy.I * h.dot(a), "imaginary unit"),
    'a "quote"': (lambda h, a: h.dot(a), "printable text without quotes"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_the_chain_cannot_take_is_said_in_a_line(name):
    density, says = REFUSED[name]
    with pytest.raises(MistakeError, match=says) as caught:
        solver(Energy(name, density))
    assert "\n" not in str(caught.value)


def test_the_refusal_of_the_guide():
    """A fourth power: the last Python of the guide, and what it prints."""
    code, printed = re.findall(r"```(?:python)?\n(.*?)```", (ROOT / "docs" / "own_energy.md").read_text(), re.DOTALL)[
        -2:
    ]
    run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 1
    assert run.stderr.splitlines()[-1] == f"derive.numbers.{printed.strip()}"


@pytest.mark.parametrize(
    ("names", "says"),
    [
        ({"eta": "x"}, "no modulus 'eta'"),
        ({"tau": "1x"}, "is no name of a parameter"),
        ({"tau": "lambda"}, "is no name of a parameter"),
        ({"tau": "beta"}, "stands for something else"),
        ({"tau": "cos"}, "stands for something else"),
        ({"tau": "dps"}, "stands for something else"),
    ],
    ids=str,
)
def test_names_that_cannot_be(names, says):
    own = OwnModule("m", "m", mapped(DENSITIES["linear"])[0], {"tau": "tau"}, {})
    with pytest.raises(MistakeError, match=says):
        check_names(names, ("tau",), emission.interface(own, "numpy"))


# The whole chain

BOTH = energy_of(
    "magnets that also gain", Symbol("M_0", positive=True) * DIRECTION + chi * H.dot(DIRECTION) * DIRECTION
)


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
def test_both_parts_together_and_nothing_of_a_wrong_one(tmp_path, monkeypatch):
    """A mixed energy agrees with the shipped solver; with one sign turned in the kernel nothing is written."""
    both = solver(BOTH, out=tmp_path / "good")
    rod = {"length": 3.0, "clamp_angle": 0.4, "field_angle": 0.9}
    plain = oblique_numpy.equilibria(beta=0.7, eta=1.3, **rod)
    got = both.numpy.equilibria(beta=0.7, tau=0.0, eta=1.3, **rod)
    assert [one.tip_angle for one in got] == pytest.approx([one.tip_angle for one in plain], rel=1e-14)
    assert [one.energy for one in got] == pytest.approx([one.energy for one in plain], rel=1e-14)
    assert len(list((tmp_path / "good").iterdir())) == 2
    usual = emission.render

    def turned(template, context):
        return usual(template, context).replace("angle - left, left", "angle + left, left")

    monkeypatch.setattr(emission, "render", turned)
    monkeypatch.setenv("DERIVE_CACHE", str(tmp_path / "cache"))
    with pytest.raises(EmitError, match=r"does not agree with its equation: .*it is not written"):
        solver(BOTH, out=tmp_path / "wrong")
    assert not (tmp_path / "wrong").exists()


@pytest.mark.long
def test_wrong_units_are_a_claim_that_does_not_hold(tmp_path):
    wrong = Energy("wrong units", lambda h, a: -k * h.dot(a), {k: length * mass})
    with pytest.raises(DerivationError, match=r"is a force .* REFUTED"):
        solver(wrong, out=tmp_path / "none")
    assert not (tmp_path / "none").exists()
