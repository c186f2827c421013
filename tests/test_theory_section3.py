"""Section 3: the results written out by hand, and the Carlson forms against quadrature and integration."""

from __future__ import annotations

import random
from types import SimpleNamespace

import pytest
from mpmath import mp, mpf
from sympy import Integer, Rational, Symbol, cos, diff, exp, lambdify, oo, pi, simplify, sin, sqrt

from derive.check import elliptic
from derive.theory import chain
from derive.theory.claims import Equal, Notebook
from derive.theory.load_case import NotElliptic, xi_tip
from derive.theory.symbols import alpha, beta, eta, gamma, gamma_bar, s, theta, xi
from derive.theory.tip_names import arc, drive, gap, minus, plus, sin_tip, x_minus, x_other, x_plus

w = Symbol("w", real=True)
CASES = ("parallel", "orthogonal", "field_only", "force_only")
# What Section 3 takes from Section 2.
PREMISES = ("frame.binormal", *(f"equilibrium.{name}" for name in ("energy", "constitutive", "twist", "residual")))
CARLSON = {"RF": mp.elliprf, "RC": mp.elliprc, "RD": mp.elliprd, "RJ": mp.elliprj}


def from_density(density, book=None):
    """Section 3 from an energy density in w, with the moment equation written out."""

    def residual(d3, force, e):
        turned = -diff(density, w).subs(w, d3.dot(e)) * d3.cross(e)
        return d3.cross(d3.diff(s)).diff(s) + d3.cross(force) + turned

    section2 = SimpleNamespace(alignment=w, energy_density=density, residual=residual)
    book = book or Notebook()
    for premise in PREMISES:
        book.claim(premise, "given here, derived in Section 2", Equal(0, 0))
    return chain.derive_section3(section2, book)


@pytest.fixture(scope="module")
def theory():
    return from_density(-eta * w**2 / 2)


@pytest.fixture(scope="module")
def formulas(theory):
    return {
        (f.case, f.name): lambdify(f.arguments, f.expression, [CARLSON, "mpmath"])
        for f in (*theory.formulas, *theory.steps)
    }


def same(left, right):
    return simplify(left - right) == 0


# The plane problem.


def test_equation_of_motion(theory):
    assert same(theory.plane.angular_acceleration, beta * sin(theta) + eta / 2 * sin(2 * (theta - alpha)))


def test_first_integral_and_square(theory):
    k2 = gamma - 2 * beta * xi - eta * w**2
    assert same(theory.plane.curvature_squared, k2)
    assert same(theory.plane.square, k2 * (1 - xi**2))


def test_dimensionless_variables(theory):
    A, inertia, E, mu0, F, h, k = (Symbol(name, positive=True) for name in ("A", "I", "E", "mu_0", "F", "h_a", "k"))
    expected = {
        s: s * sqrt(A / inertia),
        k: k * sqrt(inertia / A),
        F: F / (E * A),
        h: h * sqrt(inertia * mu0 / (E * A**2)),
        beta: beta * inertia / A,
        eta: eta * inertia / A,
    }
    assert all(same(theory.plane.barred[q], value) for q, value in expected.items())


# The quartic.

QUARTICS = {
    "parallel": eta * xi**4 + 2 * beta * xi**3 - (gamma + eta) * xi**2 - 2 * beta * xi + gamma,
    "orthogonal": -eta * xi**4 + 2 * beta * xi**3 + (gamma_bar + eta) * xi**2 - 2 * beta * xi - gamma_bar,
    "field_only": eta * xi**4 - (gamma + eta) * xi**2 + gamma,
    "force_only": 2 * beta * xi**3 - gamma * xi**2 - 2 * beta * xi + gamma,
}
ROOTS = {
    "parallel": [(-beta + sign * sqrt(beta**2 + gamma * eta)) / eta for sign in (-1, 1)],
    "orthogonal": [(beta + sign * sqrt(beta**2 + gamma_bar * eta)) / eta for sign in (-1, 1)],
    "field_only": [-sqrt(gamma / eta), sqrt(gamma / eta)],
    "force_only": [gamma / (2 * beta)],
}
ENDS = {
    "parallel": (-(beta**2) / eta, eta + 2 * beta),
    "orthogonal": (-(beta**2) / eta, eta + 2 * beta),
    "field_only": (Integer(0), eta),
    "force_only": (-2 * beta, 2 * beta),
}
TIPS = {
    "parallel": eta * xi_tip**2 + 2 * beta * xi_tip,
    "orthogonal": eta * xi_tip**2 - 2 * beta * xi_tip,
    "field_only": eta * xi_tip**2,
    "force_only": 2 * beta * xi_tip,
}


@pytest.mark.parametrize("name", CASES)
def test_quartic(theory, name):
    case = theory.cases[name]
    assert same(case.f, QUARTICS[name])
    assert same(case.tip_constant, TIPS[name])
    for found, expected in ((case.roots, ROOTS[name]), (case.ends, ENDS[name])):
        assert all(same(one, two) for one, two in zip(found, expected, strict=True))


def test_gamma_bar(theory):
    assert same(theory.cases["orthogonal"].gamma, eta - gamma_bar)


# The Weierstrass function.


def test_constants_at_one(theory):
    parallel, orthogonal = (theory.weierstrass[name].at_one for name in ("parallel", "orthogonal"))
    assert same(parallel.b, beta + (eta - gamma) / 2)
    assert same(parallel.c, (beta + eta) / 2 - (gamma + eta) / 12)
    assert same(orthogonal.b, beta + (gamma_bar - eta) / 2)
    assert same(orthogonal.c, (beta - eta) / 2 + (gamma_bar + eta) / 12)


def test_invariants(theory):
    for name, constant, sign in (("parallel", gamma, -1), ("orthogonal", gamma_bar, 1)):
        sixth, delta = (constant + eta) / 6, beta**2 + constant * eta
        assert same(theory.weierstrass[name].g2, delta + 3 * sixth**2)
        assert same(theory.weierstrass[name].g3, sign * sixth * (delta - sixth**2))
    cubic = theory.weierstrass["force_only"]
    assert same(cubic.g2, beta**2 + gamma**2 / 12)
    assert same(cubic.g3, gamma**3 / 216 - beta**2 * gamma / 6)
    assert cubic.linear == (gamma / (6 * beta), 2 / beta)


def test_slope_at_the_pole(theory):
    for name, sign in (("parallel", 1), ("orthogonal", -1), ("field_only", 1), ("force_only", 0)):
        found = theory.weierstrass[name]
        expected = sign * eta * found.at_one.b**2
        assert same(found.slope_squared, expected)


def test_starts(theory):
    starts = {name: [(one.value, one.half_period) for one in theory.weierstrass[name].uo_cases] for name in CASES}
    assert starts == {
        "parallel": [("xi_b", "omega_3"), ("xi_b", "omega_3"), ("xi_a", "omega_2")],
        "orthogonal": [("xi_b", "omega_1"), ("xi_a", "omega_2"), ("xi_a", "omega_3")],
        "field_only": [("xi_b", "omega_3"), ("xi_a", "omega_2")],
        "force_only": [("xi_2", "omega_2")],
    }


def middle(domain):
    """A point well inside a domain."""
    point = {}
    for symbol, (lower, upper) in domain.ranges.items():
        lower, upper = (end.subs(point) if hasattr(end, "subs") else Integer(end) for end in (lower, upper))
        point[symbol] = lower + 1 if upper == oo else lower + (upper - lower) * Rational(2, 5)
    return point


@pytest.mark.parametrize("name", CASES)
def test_rod_begins_at_u_o(theory, name):
    """ξ(u_o + s) of the article is ξ(ℓ) + b/(℘(ℓ − s) − c) of the tip."""
    case, found = theory.cases[name], theory.weierstrass[name]
    for start in found.uo_cases:
        point = middle(start.domain)
        at_tip = {case.constant: case.tip_constant.subs(point)}
        g2, g3 = (mp.mpmathify(g.subs(at_tip).subs(point)) for g in (found.g2, found.g3))
        e1, e2, e3 = sorted((e.real for e in elliptic.roots(g2, g3)), reverse=True)
        omega1 = mp.elliprf(0, e1 - e2, e1 - e3)
        omega3 = 1j * mp.elliprf(0, e2 - e3, e1 - e3)
        end = {"omega_1": omega1, "omega_2": omega1 + omega3, "omega_3": omega3}[start.half_period]
        sigma = omega1 / 3
        value = Symbol("value")
        if found.linear is None:
            xi_of = found.at_one.xi_at(value).subs(at_tip)
        else:
            xi_of = (found.linear[0] + found.linear[1] * value).subs(at_tip)
        article = lambdify(value, xi_of.subs(point), "mpmath")(elliptic.wp(end - sigma, g2, g3))
        tip = lambdify(value, found.at_tip.xi_at(value).subs(point), "mpmath")(elliptic.wp(sigma, g2, g3))
        assert abs(article - tip) < 1e-12
        assert -1 < tip < 1


# The shape.


def test_heights(theory):
    z = {name: theory.shapes[name].z for name in CASES}
    assert same(diff(z["parallel"][""], xi) ** 2, 1 / (gamma - 2 * beta * xi - eta * xi**2))
    assert same(diff(z["orthogonal"]["above"], xi) ** 2, 1 / (eta * xi**2 - 2 * beta * xi - gamma_bar))
    assert same(z["force_only"][""], sqrt(gamma - 2 * beta * xi) / beta)


# The tip.


def test_table_of_formulas(theory):
    found = {f.name: (f.arguments, f.expression) for f in (*theory.formulas, *theory.steps) if f.case == "parallel"}
    expected = {
        "root_plus": ((plus, drive), -plus * drive / 2),
        "root_minus": ((minus, drive), minus * drive / 2),
        "root_other": ((eta, plus, minus), eta * plus * minus / 4),
        "gap_other_plus": ((beta, eta, plus), plus * (2 * beta + eta * plus) / 4),
        "gap_other_minus": ((minus, gap), minus * gap / 4),
        "cos_level": ((beta, eta), 1 - 2 * beta / eta),
    }
    for name, (arguments, expression) in expected.items():
        assert found[name] == (arguments, expression)
    assert found["arc_z"][0] == (eta, plus, minus, sin_tip, x_other)
    assert found["arc_y"][0] == (eta, plus, minus, drive, xi_tip, arc, x_plus, x_minus, x_other)


class Rod:
    """Formulas of one case at numbers for the parameters, a tip and a point of the rod."""

    def __init__(self, formulas, name, tip, to, **parameters):
        self.formulas, self.name = formulas, name
        known = {**parameters, "xi_tip": tip, "xi": to, "plus": 1 + tip, "minus": 1 - tip, "drop": tip - to}
        known |= {"one_minus": 1 - to, "one_plus": 1 + to, "sin_tip": mp.sqrt(1 - tip**2)}
        self.known = known

    def __call__(self, formula):
        if formula not in self.known:
            function = self.formulas[self.name, formula]
            arguments = function.__code__.co_varnames[: function.__code__.co_argcount]
            renamed = {
                "drive": "tip_drive",
                "gap": "tip_gap",
                "level": "point_level",
                "x_plus": "point_plus",
                "x_minus": "point_minus",
                "x_other": "point_other",
                "arc": "arc_length",
            }
            self.known[formula] = function(*(self(renamed.get(name, name)) for name in arguments))
        return self.known[formula]


def by_quadrature(theory, name, tip, to, parameters):
    """σ, ∫ξ, ∫√(1 − ξ²) and −2∫ψ from the tip; smooth at both ends by ξ = ξ(ℓ) + (ξ − ξ(ℓ)) sin²φ."""
    case = theory.cases[name]
    numbers = {symbol: parameters[symbol.name] for symbol in case.parameters}
    f = lambdify((xi, xi_tip), (case.at_tip * (1 - xi**2)).subs(numbers), "mpmath")
    work = lambdify(xi, case.field_work.subs(numbers), "mpmath")

    def element(phi, integrand):
        here = tip + (to - tip) * mp.sin(phi) ** 2
        return abs(to - tip) * mp.sin(2 * phi) / mp.sqrt(f(here, tip)) * integrand(here)

    integrands = (lambda x: 1, lambda x: x, lambda x: mp.sqrt(1 - x**2), work)
    with mp.workdps(40):
        return [
            mp.quad(lambda phi, g=g: element(phi, g), [0, mp.pi / 4, mp.pi / 2], method="gauss-legendre", maxdegree=6)
            for g in integrands
        ]


def random_rod(name, rng):
    """Parameters, a tip of either kind, and a point on its orbit before the next turning point."""
    parameters = {"beta": mpf(rng.uniform(0.1, 2)), "eta": mpf(rng.uniform(0.1, 4))}
    b, h = parameters["beta"], parameters["eta"]
    b, h = {"parallel": (b, h), "orthogonal": (b, -h), "field_only": (0 * b, h), "force_only": (b, 0 * h)}[name]
    tip = mpf(rng.uniform(-0.95, 0.95))
    other = -2 * b / h - tip if h else mpf(100)
    falls = b + h * tip > 0
    limits = [-1, other] if falls else [1, other]
    end = max(x for x in limits if x < tip) if falls else min(x for x in limits if x > tip)
    return parameters, tip, tip + (end - tip) * mpf(rng.uniform(0.1, 0.95)), falls


@pytest.mark.parametrize("name", CASES)
def test_arcs_against_quadrature(theory, formulas, name):
    rng, kinds = random.Random(7), set()
    with mp.workdps(20):
        for _ in range(8):
            parameters, tip, to, falls = random_rod(name, rng)
            kinds.add(falls)
            rod = Rod(formulas, name, tip, to, **parameters)
            expected = by_quadrature(theory, name, tip, to, parameters)
            wanted = ("arc_length", "arc_y", "arc_z", "arc_square")[: 3 if name == "force_only" else 4]
            for formula, value in zip(wanted, expected, strict=False):
                assert abs(rod(formula) - value) < mpf(10) ** -14 * (1 + abs(value)), (formula, parameters, tip, to)
            assert abs(rod("angle") - mp.acos(to)) < mpf(10) ** -14
    assert kinds == ({True} if name == "force_only" else {True, False})


@pytest.mark.parametrize("name", ["parallel", "orthogonal", "field_only"])
def test_arcs_reach_the_next_turning_point(theory, formulas, name):
    """At ξ_o, and at ±1, one x vanishes and nothing is infinite."""
    parameters = {"beta": mpf("0.3"), "eta": mpf("1.7")}
    tips = {"parallel": ("0.2", "0.8", "-0.6"), "orthogonal": ("-0.3", "0.6"), "field_only": ("0.4", "-0.4")}[name]
    with mp.workdps(20):
        for tip in map(mpf, tips):
            b = 0 if name == "field_only" else parameters["beta"]
            h = -parameters["eta"] if name == "orthogonal" else parameters["eta"]
            other, falls = -2 * b / h - tip, b + h * tip > 0
            to = max(x for x in (-1, other) if x < tip) if falls else min(x for x in (1, other) if x > tip)
            rod = Rod(formulas, name, tip, mpf(to), **parameters)
            near = by_quadrature(theory, name, tip, mpf(to), parameters)
            for formula, value in zip(("arc_length", "arc_y", "arc_z", "arc_square"), near, strict=True):
                assert abs(rod(formula) - value) < 1e-9


@pytest.mark.parametrize("name", CASES)
def test_rod_by_integration(theory, formulas, name):
    """From the tip, θ″ integrated: the point found has the curvature and the arc length of the formulas."""
    case = theory.cases[name]
    parameters = {"beta": mpf("0.7"), "eta": mpf("1.1")}
    numbers = {symbol: parameters[symbol.name] for symbol in case.parameters}
    turning = lambdify(theta, case.angular_acceleration.subs(numbers), "mpmath")
    for angle in (mpf("0.9"), mpf("2.4")):
        rod = mp.odefun(lambda _, q: [q[1], turning(q[0]), mp.cos(q[0]), mp.sin(q[0])], 0, [angle, 0, 0, 0])
        end, curvature, y, z = rod(mpf("0.8"))
        point = Rod(formulas, name, mp.cos(angle), mp.cos(end), **parameters)
        found = [point(f) for f in ("arc_length", "arc_y", "arc_z", "angle", "curvature_squared")]
        expected = [mpf("0.8"), y, z, end, curvature**2]
        assert max(abs(one - two) for one, two in zip(found, expected, strict=True)) < 1e-11


def test_small_field_is_no_field(formulas):
    """As η → 0 the lengths of the parallel rod go over into those without a field, digit by digit."""
    near, none = (
        Rod(formulas, name, mpf("0.3"), mpf("-0.4"), beta=mpf("0.8"), eta=mpf(10) ** -18)
        for name in ("parallel", "force_only")
    )
    for formula in ("arc_length", "arc_y", "arc_z", "tip_gamma"):
        assert abs(near(formula) - none(formula)) < 1e-15
    assert abs(near("arc_square")) < 1e-14


# Other energies.


def test_energy_decides():
    theory = from_density(-3 * eta * w**2)
    assert same(theory.cases["parallel"].f_hat, gamma - 2 * beta * xi - 6 * eta * xi**2)
    assert same(theory.cases["orthogonal"].f_hat, 6 * eta * xi**2 - 2 * beta * xi - gamma_bar)


def test_energy_of_permanent_magnets():
    tau = Symbol("tau", positive=True)
    book = Notebook()
    theory = from_density(-tau * w, book)
    assert same(theory.cases["parallel"].f_hat, gamma - 2 * (beta + tau) * xi)
    assert "orthogonal" not in theory.cases
    assert any("odd power of w" in line for line in book.text())


def test_energies_that_are_not_elliptic():
    for density, reason in ((-eta * w**4, "degree 4"), (exp(w), "not a polynomial"), (w**3, "degree 3")):
        with pytest.raises(NotElliptic, match=reason):
            from_density(density)


def test_claims_name_their_steps(theory):
    assert len(theory.book.claims) > 300
    assert {f.claim for f in (*theory.formulas, *theory.steps)} <= set(theory.book.claims)


def test_straight_rod(theory):
    case = {f.case: f.expression for f in (*theory.formulas, *theory.steps) if f.name == "straight_stiffness"}
    assert same(case["parallel"], -beta * xi - eta * (2 * xi**2 - 1))
    assert same(case["orthogonal"], -beta * xi + eta * (2 * xi**2 - 1))
    bent = theory.cases["parallel"].angular_acceleration
    assert same(-diff(bent, theta).subs(theta, pi), case["parallel"].subs(xi, cos(pi)))
