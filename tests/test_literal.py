"""The output `literal`: the article's own formulas, against the solver, against Taylor integration, against itself.

What is expected of it, with u the rounding of the arithmetic, D = 1 − 27g₃²/g₂³ (0 where two roots of f meet) and
r = 1 + β/η (1 without a field): y within 64u(1/D + r) lengths, and θ, θ′/√(β + η) and z/ℓ within 8√(ur/D), since they
are inverse functions of ξ, or its root, at the end of their domain. The solver itself is good to the last digits.
"""

from __future__ import annotations

import ast
import math
from math import pi, sqrt
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from derive.check.judge import judge
from derive.check.verdicts import PROVED
from derive.emit import scene as scenes
from derive.emit.committed import emit_kernels
from derive.emit.errors import EmitError, SceneError
from derive.emit.kernels import article_formulas, literal
from derive.emit.module import emit_module
from derive.emit.proof import prove_formulas, prove_module
from derive.emit.scene import parse_scene
from derive.measure.loading import load
from derive.measure.taylor import integrate
from derive.resources import kernels_folder
from derive.stages import theory

ULP = 2.0**-52
FIELD_ANGLES = {"parallel": 0.0, "field_only": 0.0, "force_only": 0.0, "orthogonal": pi / 2}
SOLVED = ("parallel", "field_only", "force_only")  # the cases whose equilibria are emitted
FOUND = ("theta", "curvature", "y", "z")
# The article's rods, and others: β, η, length, clamp angle.
RODS = [
    (0.00035, 0.00052, 80.0, 3 * pi / 4),
    (0.0003, 0.0005, 80.0, pi / 2),
    (0.3, 2.0, 1.5, -0.7),
    (1.9, 0.6, 4.0, 8.0),
    (0.02, 1.7, 6.0, 2.2),
    (2.0, 1.0, 5.5, 2.9),
]


def emitted(case: str, backend: str, outputs: str = '["literal"]') -> Any:
    scene = parse_scene(f'[scene]\nname = "sample"\ncase = "{case}"\noutputs = {outputs}')
    return emit_module(theory(), scene, backend)


# With the solver beside it, where a test asks for its equilibria.
OUTPUTS = {(case, "numpy"): '["equilibria", "shape", "literal"]' for case in SOLVED}
OUTPUTS |= {(case, "mpmath"): '["equilibria", "literal"]' for case in ("parallel", "force_only")}


class Modules(dict[tuple[str, str], Any]):
    """Emitted modules by case and backend, proved; each is made when it is first asked for."""

    def __missing__(self, key: tuple[str, str]) -> Any:
        module = emitted(*key, OUTPUTS.get(key, '["literal"]'))
        assert any(proof.formula.startswith("article_y") for proof in prove_module(module))
        self[key] = load(module.text)
        return self[key]


@pytest.fixture(scope="module")
def modules() -> Modules:
    return Modules()


def loads(case: str, beta: Any, eta: Any) -> tuple[Any, Any]:
    return (0 * beta if case == "field_only" else beta), (0 * eta if case == "force_only" else eta)


def rod_of(case: str, beta: Any, eta: Any, length: Any, tip_angle: Any, context: Any = math) -> Any:
    """An equilibrium is fixed by its tip angle: what `literal` takes of it, of the rod that it belongs to."""
    xi, across = context.cos(tip_angle), context.sin(tip_angle)
    gamma = 2 * beta * xi + eta * (across**2 if case == "orthogonal" else xi**2)
    rod = SimpleNamespace(beta=beta, eta=eta, length=length, scale=0)
    return SimpleNamespace(rod=rod, gamma=gamma, tip_angle=tip_angle)


def literally(module: Any, one: Any, s: Any, **digits: Any) -> Any:
    """`literal` of such an equilibrium, as if the module had found it."""
    found = module.Equilibrium([getattr(one, name, None) for name in module.Equilibrium._fields])
    return module.literal(found, s, **digits)


def share(case: str, one: Any) -> float:
    """D, by the invariants of f."""
    beta, eta, gamma = float(one.rod.beta), float(one.rod.eta), float(one.gamma)
    level, stiffness = (gamma - eta, -eta) if case == "orthogonal" else (gamma, eta)
    spread, mean = beta**2 + level * stiffness, (level + stiffness) / 6
    return 1 - 27 * mean**2 * (spread - mean**2) ** 2 / (spread + 3 * mean**2) ** 3


def within(case: str, one: Any, found: Any, expected: Any, unit: float) -> None:
    """Every quantity at every place is as near as the head of this file says."""
    beta, eta, length = (float(value) for value in (one.rod.beta, one.rod.eta, one.rod.length))
    gap, ratio = share(case, one), 1 + (beta / eta if eta else 0)
    root = 8 * sqrt(unit * ratio / gap)
    bounds = {"y": 64 * unit * (1 / gap + ratio) * length, "z": root * length}
    bounds |= {"theta": root, "curvature": root * sqrt(beta + eta)}
    for name in FOUND:
        pairs = zip(getattr(found, name), getattr(expected, name), strict=True)
        worst = max(float(abs(a - b)) for a, b in pairs)
        assert worst <= bounds[name], (case, name, one, worst, bounds[name])


# The formulas and their code


def test_every_formula_stands_for_a_proved_claim() -> None:
    claims = theory().book.claims
    formulas = [f for f in theory().formulas if f.family == "article"]
    assert {f.case for f in formulas} == set(FIELD_ANGLES)
    assert {f.claim for f in formulas} <= set(claims)
    for name in [name for name in claims if name.startswith("article.")]:
        assert judge(claims[name]).verdict == PROVED, name
    labels = {f.source for f in formulas}
    assert {"exsl18", "exsl21", "exsl22", "exsl36", "exsl41", "slch11", "slch12", "slch14"} <= labels
    assert {"exhpf5", "exhpf6", "exhpf7", "exhpf15", "exhpf19"} <= labels


def test_the_kernels_have_the_formulas_as_emitted() -> None:
    text = emit_kernels(theory())["article_formulas"]
    assert text == (kernels_folder() / "article_formulas.py").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("case", "old", "new"),
    [
        ("parallel", "wzeta(v, g2, g3)", "wzeta(s, g2, g3)"),
        ("parallel", "- wlog_sigma(v + u_o, g2, g3)", "+ wlog_sigma(v + u_o, g2, g3)"),
        ("orthogonal", "/ wp_prime(v, g2, g3)", "/ wp(v, g2, g3)"),
        ("orthogonal", "near_acosh((beta", "near_acosh((eta"),
        ("force_only", "wzeta(u_o, g2, g3)", "wzeta(u_o, g3, g2)"),
    ],
)
def test_a_wrong_line_is_not_proved(case: str, old: str, new: str) -> None:
    module = emitted(case, "numpy")
    assert module.text.count(old)
    with pytest.raises(EmitError, match="is not proved equal"):
        prove_formulas(module.text.replace(old, new, 1), module.formulas, "wrong.py")


def test_who_does_not_ask_for_it_does_not_get_it() -> None:
    assert "article_" not in emitted("parallel", "numpy", '["equilibria", "shape"]').text
    text = emitted("force_only", "numpy").text
    assert "wlog_sigma" not in text
    assert "article_z_above" not in text
    tree = ast.walk(ast.parse(text))
    assert "eta" not in {node.id if isinstance(node, ast.Name) else getattr(node, "arg", "") for node in tree}


def test_a_field_at_any_angle_has_no_literal_formulas(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(scenes.CASES, "oblique", {})
    with pytest.raises(SceneError, match=r"^my.toml:4: the article has no formulas for case 'oblique'"):
        parse_scene('[scene]\nname = "x"\ncase = "oblique"\noutputs = ["literal"]\n', "my.toml")


# Its values


@pytest.mark.parametrize("case", SOLVED)
def test_it_agrees_with_the_solver(case: str, modules: Any) -> None:
    module, indices = modules[case, "numpy"], set()
    for beta, eta, length, clamp_angle in RODS:
        own = {"field_only": (eta,), "force_only": (beta,)}.get(case, (beta, eta))
        for one in module.equilibria(*own, length, clamp_angle):
            s = np.linspace(0, length, 21)
            one = SimpleNamespace(
                rod=SimpleNamespace(beta=loads(case, beta, eta)[0], eta=loads(case, beta, eta)[1], length=length),
                gamma=one.gamma,
                tip_angle=one.tip_angle,
                index=one.index,
                whole=one,
            )
            if share(case, one) < 1e-13:
                continue
            within(case, one, module.literal(one.whole, s), module.shape(one.whole, s), ULP)
            assert module.literal(one.whole, length).y == pytest.approx(one.whole.y, abs=1e-6 * length)
            indices.add(one.index)
    assert max(indices) >= (1 if case != "parallel" else 2)


@pytest.mark.parametrize("case", FIELD_ANGLES)
def test_it_agrees_with_taylor_integration(case: str, modules: Any) -> None:
    """Rods of up to several half-waves with any tip, which shares no formula with it."""
    rng, paths = np.random.default_rng(7), set()
    for _ in range(25):
        beta, eta = loads(case, *(10 ** rng.uniform(-1.5, 1, 2)))
        length, tip_angle = rng.uniform(0.5, 7) / sqrt(beta + eta), rng.uniform(-7, 7)
        one, s = rod_of(case, beta, eta, length, tip_angle), np.array([0, 0.1, 0.45, 0.8]) * length
        path = integrate(tip_angle, beta, eta, FIELD_ANGLES[case], length, 25, stops=[float(x) for x in s[1:]])
        points = [next(p for p in (path.clamp, *path.points) if abs(float(p.s) - x) < 1e-12 * length) for x in s]
        if share(case, one) < 1e-13:
            continue
        expected = SimpleNamespace(
            theta=[float(p.theta) for p in points],
            curvature=[float(p.curvature) for p in points],
            y=[float(path.clamp.y - p.y) for p in points],
            z=[float(path.clamp.z - p.z) for p in points],
        )
        module = modules[case, "numpy"]
        within(case, one, literally(module, one, s), expected, ULP)
        constant = module.article_constant(*((eta,) if case != "force_only" else ()), one.gamma)
        own = {"field_only": (eta,), "force_only": (beta,)}.get(case, (beta, eta))
        paths.add(module.path_of(*own, constant, *((tip_angle,) if case != "force_only" else ())).end)
    # Every ω̄ that the article knows in this case is met.
    assert paths == {"force_only": {(1, 1)}, "orthogonal": {(0, 1), (1, 0), (1, 1)}}.get(case, {(0, 1), (1, 1)})


@pytest.mark.parametrize("digits", [15, 50, 200])
@pytest.mark.parametrize("case", FIELD_ANGLES)
def test_the_twin_at_any_precision(case: str, digits: int, modules: Any) -> None:
    """Against a run with 40 digits more; the caller's precision stays what it was."""
    module, before = modules[case, "mpmath"], mp.dps
    beta, eta = loads(case, mpf(3) / 8, mpf(5) / 8)
    for tip_angle in (mpf("0.5"), mpf("2.75"), mpf("-4")):
        with mp.workdps(digits + 45):
            one = rod_of(case, beta, eta, mpf(5), tip_angle, mp)
            s = [mpf(k) * 5 / 3 for k in range(4)]
        rough, fine = literally(module, one, s, dps=digits), literally(module, one, s, dps=digits + 40)
        within(case, one, rough, fine, 10.0 ** (1 - digits))
        assert fine.y[2] != rough.y[2]
    assert mp.dps == before


def test_the_twins_agree(modules: Any) -> None:
    one = rod_of("parallel", 0.5, 1.25, 4.0, 1.0)
    exact = rod_of("parallel", mpf(0.5), mpf(1.25), mpf(4), mpf(1), mp)
    pair = [literally(modules["parallel", "numpy"], one, 2.5), literally(modules["parallel", "mpmath"], exact, 2.5)]
    for name in FOUND:
        assert float(getattr(pair[0], name)) == pytest.approx(float(getattr(pair[1], name)), abs=1e-12)


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_a_clamp_where_the_function_is_infinite(backend: str, modules: Any) -> None:
    """In an orthogonal field u may be 0 to the last digit, where ξ = 1: the rod begins along the force."""
    module, (beta, eta) = modules["orthogonal", backend], (0.25, 1.5)
    if backend == "mpmath":
        beta, eta = mpf(beta), mpf(eta)
    one = rod_of(
        "orthogonal", beta, eta, 1.0, mpf(1) if backend == "mpmath" else 1.0, mp if backend == "mpmath" else math
    )
    constant = module.article_constant(eta, one.gamma)
    g2, g3 = module.article_g2(beta, eta, constant), module.article_g3(beta, eta, constant)
    one.rod.length = module.half_periods(g2, g3)[0]
    assert module.motion_of(beta, eta, one.rod.length, one.gamma, one.tip_angle).u_o == 0
    found = literally(module, one, [0.0])
    assert float(found.theta[0]) == found.y[0] == 0
    path = integrate(1.0, float(beta), float(eta), pi / 2, float(one.rod.length), 25)
    assert abs(float(path.clamp.theta)) < 1e-14
    assert float(found.curvature[0]) == pytest.approx(float(path.clamp.curvature), rel=1e-12)


# Where it has no value


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_where_the_formulas_have_no_value(backend: str, modules: Any) -> None:
    straight = modules["parallel", backend].equilibria(0.5, 1.0, 3.0, 0.0)
    with pytest.raises(ValueError, match="two half-period values meet"):
        modules["parallel", backend].literal(straight[0], 1.0)
    (bent, *_) = modules["parallel", backend].equilibria(0.5, 0.0, 3.0, 1.0)
    with pytest.raises(ValueError, match="divide by the root of eta; without a field use the case 'force_only'"):
        modules["parallel", backend].literal(bent, 1.0)
    (free, *_) = modules["force_only", backend].equilibria(0.0, 3.0, 1.0)
    with pytest.raises(ValueError, match="divide by beta"):
        modules["force_only", backend].literal(free, 1.0)
    with pytest.raises(ValueError, match=r"s must lie in \[0, "):
        modules["parallel", backend].literal(bent, 3.5)


def test_the_kernels_work_as_they_stand() -> None:
    """Not emitted, they are those of the general case."""
    one = rod_of("parallel", 0.5, 1.25, 4.0, 1.0)
    theta, *_ = literal.angle_and_position_literally(one, np.array([4.0]))
    assert theta[0] == pytest.approx(1.0, abs=1e-7)
    assert article_formulas.article_sense() == 1
