"""An energy of one's own: the curve, the map with its mutants, references by the own law, and what is refused."""

from __future__ import annotations

import cmath
import re
import subprocess
import sys
from functools import cache
from math import cos, pi, sin
from pathlib import Path
from types import SimpleNamespace

import mpmath
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import Symbol
from test_theory_section3 import PREMISES

from derive.check.judge import judge
from derive.check.mutate import mutate_all
from derive.check.verdicts import PROVED, REFUTED
from derive.measure.agreement import DOUBLE, agreement
from derive.measure.reference import Rod, solve
from derive.numbers import MistakeError
from derive.own_energy import emission, solver
from derive.own_energy.checks import check_names
from derive.own_energy.curve import curve_of
from derive.own_energy.emission import OwnModule
from derive.own_energy.law import at_loads, evaluate, law_of, slope
from derive.own_energy.reduction import claim_reduction, reduce_plane
from derive.own_energy.references import OwnRod, from_json, references
from derive.theory import plane
from derive.theory.claims import Equal, Notebook
from derive.theory.energy import Energy
from derive.theory.letters import tau, w
from derive.theory.symbols import eta
from generated import oblique_numpy

ROOT = Path(__file__).resolve().parent.parent
GUIDE = (ROOT / "docs" / "own_energy.md").read_text(encoding="utf-8")
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

    def turned(one, turn, eta, length):
        place = complex(one.y, sign["z"] * one.z) * cmath.exp(1j * turn)
        return SimpleNamespace(
            tip_angle=one.tip_angle + turn,
            clamp_curvature=one.clamp_curvature,
            gamma=one.gamma + sign["gamma"] * eta,
            y=place.real,
            z=place.imag,
            energy=one.energy - sign["energy"] * eta * length / 2,
            index=one.index,
        )

    def equilibria(beta, tau, eta, length, clamp_angle, field_angle):
        pull = beta + tau * cmath.exp(1j * field_angle)
        turn = sign["turn"] * cmath.phase(pull)
        lean = field_angle - sign["lean"] * turn + sign["field"] * pi / 2
        found = oblique_numpy.equilibria(abs(pull), -eta, length, clamp_angle - turn, lean)
        return [turned(one, turn, eta, length) for one in found]

    return SimpleNamespace(equilibria=equilibria)


def test_the_map_by_hand_agrees():
    result = agreement(by_hand(), [(ROD.arguments, answers())], DOUBLE)
    assert result.holds
    assert max(row.roundings for row in result.rows.values()) < 20


@pytest.mark.parametrize(
    "wrong", [{"turn": -1}, {"lean": -1}, {"field": 0}, {"energy": -1}, {"z": -1}, {"gamma": -1}], ids=str
)
def test_a_wrong_map_does_not_agree(wrong):
    reasons = agreement(by_hand(**wrong), [(ROD.arguments, answers())], DOUBLE).reasons()
    assert any("is off by" in reason or "equilibria instead of" in reason for reason in reasons)


# What is refused

REFUSED = {
    "no polynomial": (
        lambda h, a: -k * sympy.sqrt(1 + h.dot(a) ** 2),
        r"is not elliptic: by w = d3.e it is -A\*k\*sqrt",
    ),
    "Langevin": (lambda h, a: -sympy.log(sympy.sinh(h.dot(a)) / h.dot(a)), "undefined at w = 0, no polynomial"),
    "a crystal": (lambda h, a: -k * a[0] ** 2, "changes when field and particles turn together"),
    "no direction": (lambda h, a: -k * h.dot(h), "does not depend on the direction of the rod"),
    "a float": (lambda h, a: -0.5 * h.dot(a), "holds the float -0.5.*Rational"),
    "a letter": (lambda h, a: -Symbol("c") * h.dot(a), r"the letter c, not known to be real; Symbol\('c', real=True\)"),
    "a vector": (lambda h, a: h.cross(a), "must be a function density.* that gives a scalar expression, no Immutable"),
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
    code, printed = re.findall(r"```(?:python)?\n(.*?)```", GUIDE, re.DOTALL)[-2:]
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
