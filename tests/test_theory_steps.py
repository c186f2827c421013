"""Every claim says on what it rests: chains without a gap or a circle, from any formula back to the energy."""

from __future__ import annotations

import re

import pytest

from derive import explain
from derive.theory import equilibrium, particle, sources
from derive.theory.claims import Equal, Notebook

# The claims that rest on no other, and why.
ROOTS = {
    "particle.response": "the laws of the particle's material and shape, from which its energy is made",
    "frame.curvature": "kinematics: defines the curvature vector of a frame",
    "placement.section": "kinematics: defines the section coordinates of a point",
    "placement.rotation": "kinematics: defines the rotation from one frame to another",
    "frame.frenet": "kinematics: defines curvature and torsion of a curve",
    "variation.strain_energy": "defines the elastic energy of the rod by its moment",
    "equilibrium.triple": "an identity of any three vectors that a product rule gives",
    "plane.inextensible": "kinematics: defines the angle of the tangent in the plane",
    "plane.units_curvature": "defines the unit of length",
    "plane.units_stiffness": "defines the unit of force",
    "plane.units_permeability": "defines the unit of current",
    "weierstrass.second_derivative": "a property of the Weierstrass function (DLMF 23.3.10, 23.3.12)",
    "weierstrass.resolvent": "Taylor's formula for any quartic at any of its roots",
    **dict.fromkeys(
        (f"weierstrass.side_{side}" for side in ("0_omega_1", "omega_1_omega_2", "omega_3_omega_2", "omega_3_0")),
        "a property of the Weierstrass function: its inverse on the rectangle of half-periods (DLMF 19.25.35)",
    ),
    "shape.addition": "a property of the Weierstrass functions: the addition theorem",
    "swing.sines": "a difference of cosines by half angles",
    "swing.legendre": "a quadratic form in the cosine and sine of an angle, by half the angle",
    "article.logarithm": "a property of the Weierstrass functions: the derivative of ln σ (DLMF 23.2.8)",
}


@pytest.fixture(scope="module")
def claims(theory):
    return theory.book.claims


def test_every_claim_but_the_roots_has_steps(claims):
    assert {one for one, claim in claims.items() if not claim.steps} == set(ROOTS)


def test_steps_are_earlier_claims_and_named_once(claims):
    place = {one: at for at, one in enumerate(claims)}
    for one, claim in claims.items():
        assert len(set(claim.steps)) == len(claim.steps), one
        assert all(place[step] < place[one] for step in claim.steps), one


def test_every_formula_goes_back_to_the_energy(theory, claims):
    far = explain.distances(claims)
    starts = {formula.claim for formula in (*theory.formulas, *theory.steps)}
    assert len(starts) == len(theory.formulas) + len(theory.steps) > 100
    assert not [one for one in starts if far[one] is None]
    # Not by the shortest way only: the magnetization itself is in every chain.
    assert not [one for one in starts if "particle.response" not in explain.ordered([one], claims)]


def test_only_general_facts_do_without_the_energy(claims):
    """Kinematics, elasticity, units and functions; of the load cases nothing."""
    far = explain.distances(claims)
    general = {one for one, steps in far.items() if steps is None}
    assert set(ROOTS) - {"particle.response"} <= general
    assert {one.split(".")[0] for one in general} == {
        "frame",
        "placement",
        "kinematics",
        "constraint",
        "variation",
        "loads",
        "equilibrium",
        "plane",
        "weierstrass",
        "shape",
        "article",
        "oblique",
        "swing",
    }
    assert not [one for one in general if set(one.split(".")) & set(sources.CASES)]


def test_a_given_energy_is_the_root(claims):
    """Without the paramagnetic particle the chain begins at the energy that is given."""
    book = Notebook()
    equilibrium.derive_section2(particle.permanent_energy(), book)
    roots = {one for one, claim in book.claims.items() if not claim.steps}
    assert roots == {one for one in ROOTS if one in book.claims} | {"energy.invariance"}
    assert "particle.response" not in book.claims


def test_names_rest_on_the_claims_that_stand_for_them(claims):
    """A sample, by hand: what the formulas use is in their steps."""
    for one, expected in {
        "tip.parallel.arc_y": {"motion", "pole", "pole_strength", "tip_drive", "arc_length"},
        "tip.parallel.rising_level": {"point_level", "tip_drive"},
        "tip.parallel.drop_from_gaps": {"point_level", "tip_gap"},
        "tip.force_only.arc_z": {"motion", "sine", "root_other"},
    }.items():
        assert {step.rpartition(".")[2] for step in claims[one].steps} == expected
    assert claims["tip.parallel.pole_strength"].steps[0] == "weierstrass.parallel.at_tip"


def test_sources_are_equations_of_the_article_or_of_dlmf(theory, claims):
    named = "campi|eqazm|suscet|magnetiz|demten|magnha"
    label = re.compile(rf"((exsl(rm)?|exhpf|slch|kth|kthr|elmr)\d+[a-z]*|{named}|DLMF [\d.()iv]+)?")
    assert not [
        one.source for one in (*claims.values(), *theory.formulas, *theory.steps) if not label.fullmatch(one.source)
    ]
    found = {(f.case, f.name): f.source for f in (*theory.formulas, *theory.steps)}
    for name, expected in {
        "tip_gamma": ("exsl23", "exhpf12", "slch3", "slch6"),
        "pole_strength": ("exsl17",) * 4,
        "curvature_squared": ("exsl8", "exhpf1", "exsl8", "slch5"),
        "arc_y": ("exsl36", "exhpf15", "exsl36", "slch12"),
        "arc_z": ("exsl41", "exhpf19", "exsl41", "slch14"),
        "arc_length": ("DLMF 19.25.35",) * 4,
        "gap_minus_plus": ("",) * 4,
    }.items():
        assert tuple(found[case, name] for case in sources.CASES) == expected
    assert found["parallel", "cos_other"] == "exsl14"


# What is shown of it.


def test_chain_of_a_claim(theory, tmp_path):
    chain = explain.explain("tip.parallel.arc_y", tmp_path)
    assert chain["starts"] == ["tip.parallel.arc_y"]
    assert chain["formulas"] == []  # no solver evaluates the forms of single load cases
    assert [formula["name"] for formula in explain.explain("swing.arc_y", tmp_path)["formulas"]] == ["arc_y"]
    text = list(explain.lines(chain))
    heads = [line.split()[0] for line in text[1:] if not line.strip().startswith("see above")]
    assert sorted(heads) == sorted({claim["id"] for claim in chain["claims"]})  # each claim once
    assert text[1].startswith("tip.parallel.arc_y (exsl36; ")
    assert any(line.startswith("  tip.parallel.motion (exsl12; ") for line in text)
    assert any("particle.response (eqazm; about the energy)" in line for line in text)


def test_chains_of_a_printed_label(theory, tmp_path):
    chain = explain.explain("exsl21", tmp_path)
    assert {"weierstrass.parallel.at_one", "weierstrass.field_only.roots"} <= set(chain["starts"])
    assert all(theory.book.claims[one].source == "exsl21" for one in chain["starts"])
    assert "arc_y" in {formula["name"] for formula in explain.explain("exsl36", tmp_path)["formulas"]}


MODULE = '''"""A module.

Load case: parallel. Valid for all.
"""

def arc_y(arc):
    """A formula."""
    return arc

def kernel(arc):
    first = 1
    second = arc_y(arc)
    return first + second

def above(arc):
    return kernel(arc)

def plain(x):
    return x

NUMBER = 1
'''


@pytest.mark.parametrize("place", ["8", "12", "11", "16"])
def test_line_of_a_module(theory, tmp_path, place):
    """In the formula, where it is called, elsewhere in the function that calls it, in a function above that."""
    (tmp_path / "emitted.py").write_text(MODULE, encoding="utf-8")
    chain = explain.explain(f"generated/emitted.py:{place}", tmp_path)
    assert chain["starts"] == ["swing.arc_y"]
    assert explain.explain(f"emitted:{place}", tmp_path)["starts"] == chain["starts"]


@pytest.mark.parametrize(
    ("what", "said"),
    [
        ("tip.paralel.arc_y", "did you mean tip.parallel.arc_y"),
        ("arc_q", "arc_y"),
        ("exsl99", "did you mean exsl9"),
        ("motion", "tip.field_only.motion"),
        ("zzz", "'derive check' lists"),
        ("emitted.py:19", "'plain', which calls no formula"),
        ("emitted.py:21", "stands in no function"),
        ("emitted.py:-1", "stands in no function"),
        ("absent.py:3", "cannot be read as a module"),
    ],
)
def test_what_cannot_be_explained(theory, tmp_path, what, said):
    (tmp_path / "emitted.py").write_text(MODULE, encoding="utf-8")
    with pytest.raises(explain.NothingToExplainError, match=said):
        explain.explain(what, tmp_path)


def test_distances_count_the_shortest_way():
    book = Notebook()
    for one, steps in {"energy.a": (), "x.b": ("energy.a",), "x.c": ("x.b", "energy.a"), "x.d": ()}.items():
        book.claim(one, one, Equal(0, 0), steps=steps)
    assert explain.distances(book.claims) == {"energy.a": 0, "x.b": 1, "x.c": 1, "x.d": None}
