"""The rod in a field at any angle: results written out by hand, and the solution against Taylor integration."""

from __future__ import annotations

import random
from itertools import pairwise
from types import SimpleNamespace

import pytest
from mpmath import mp, mpf
from sympy import I, Integer, Rational, Symbol, cos, exp, lambdify, log, pi, re, simplify, sin, sqrt, tan

from derive.check import elliptic
from derive.measure.taylor import integrate
from derive.theory.load_case import xi_tip
from derive.theory.oblique import clamp_angle, place, turns
from derive.theory.oblique_cases import doubled, doubled_invariants
from derive.theory.oblique_degenerate import k
from derive.theory.oblique_quartic import m, n, p, q, theta_tip
from derive.theory.oblique_shape import b, c, g2, g3
from derive.theory.symbols import alpha, beta, ell, eta, sigma, theta, v

DIGITS = 40
HALF_PERIOD_DIGITS = 90  # ℘ is stationary at a half-period: the inverse keeps half of them
CLOSE = mpf(10) ** -30  # the theta series and the integration keep more than 35 digits on these rods
ELLIPTIC = {name: getattr(elliptic, name) for name in ("wp", "wp_prime", "wzeta", "wsigma")}
FRACTIONS = (mpf(0), mpf("0.3"), mpf("0.8"))  # of the length, from the clamp
GRID = 24  # points at which logarithms are continued: their phases move by far less than π from one to the next
A = theta_tip - alpha
CASES = ("parallel", "orthogonal", "field_only", "force_only")


@pytest.fixture(scope="module")
def oblique(theory):
    return theory.oblique


def same(left, right):
    return simplify(left - right) == 0


# Written out by hand.


def test_the_half_angle_quartic(oblique):
    expected = {
        p: beta * sin(theta_tip) + eta / 2 * sin(2 * A),
        q: beta * cos(theta_tip) + eta * cos(2 * A),
        m: beta * sin(theta_tip) - eta / 2 * sin(2 * A),
        n: beta * cos(theta_tip),
    }
    assert set(oblique.half.coefficients) == set(expected)
    assert all(same(oblique.half.coefficients[letter], value) for letter, value in expected.items())
    assert same(oblique.half.gamma, 2 * beta * cos(theta_tip) + eta * cos(A) ** 2)
    levels = 2 * beta * (cos(theta_tip) - cos(theta)) + eta * (cos(A) ** 2 - cos(theta - alpha) ** 2)
    assert same(oblique.half.levels, levels)


def test_the_lattice(oblique):
    assert (oblique.lattice.at.a, oblique.lattice.at.b, oblique.lattice.at.c) == (0, p / 4, q / 12)
    assert same(oblique.lattice.g2, q**2 / 12 - m * p / 4)
    assert same(oblique.lattice.g3, m * p * q / 48 - q**3 / 216 - n * p**2 / 16)


def test_the_pole_and_the_strength_of_the_logarithm(oblique):
    p_tip, q_tip = (oblique.half.coefficients[letter] for letter in (p, q))
    assert same(oblique.pole, q_tip / 12 + I * p_tip / 4)
    assert same(oblique.slope, I * p_tip / 4 * sqrt(eta) * exp(I * A))
    logarithm = oblique.shape.logarithm
    assert same(oblique.position, exp(I * theta_tip) * sigma + 2 * exp(I * alpha) / sqrt(eta) * logarithm)
    assert logarithm.subs(sigma, 0) == 0
    assert oblique.value_at_clamp.subs(theta_tip, 0).subs(alpha, 0) == (beta + eta) / 12


def test_the_energy(oblique):
    constant = oblique.half.gamma / 2 - eta / 2
    expected = constant * ell + re(-2 * beta * place - eta / 2 * exp(-2 * I * alpha) * turns)
    assert same(oblique.energy, expected)


def test_what_the_article_has_is_a_landen_transformation_away(oblique, theory):
    """The invariants of the pendulum without field: β²ξ²/3 − β²/4 by the half angle, β²ξ²/3 + β² in the article."""
    at = {eta: 0}
    half_angle = oblique.constants[g2].subs(at)
    assert same(half_angle, beta**2 * cos(theta_tip) ** 2 / 3 - beta**2 / 4)
    case = theory.cases["force_only"]
    article = theory.weierstrass["force_only"].g2.subs(case.constant, case.tip_constant)
    assert same(article, beta**2 * xi_tip**2 / 3 + beta**2)
    assert same(oblique.special["force_only"].mirror, -beta * cos(theta_tip) / 6)
    assert [simplify(x) for x in doubled_invariants(Integer(2), Integer(13), Integer(6))] == [188, 496]


def test_the_load_cases_are_those_of_the_article(oblique):
    assert tuple(oblique.special) == CASES
    places = {name: special.at for name, special in oblique.special.items()}
    assert places["parallel"] == {alpha: 0}
    assert places["orthogonal"] == {alpha: pi / 2}
    # At any α: alone, the field has the direction of y; without it, α is nothing.
    assert places["field_only"] == {beta: 0, theta_tip: theta_tip + alpha}
    assert places["force_only"] == {eta: 0}
    for name in ("field_only", "force_only"):
        assert not any(value.has(alpha) for value in oblique.special[name].coefficients.values())


@pytest.mark.long  # the main job proves them too
def test_every_claim_is_proved(unproved):
    assert unproved("oblique.") == []


# Against integration.


def rods(count, seed=4):
    """Random rods; every third without field or without force."""
    draw = random.Random(seed)
    for number in range(count):
        numbers = {
            beta: mpf(draw.uniform(0.1, 2)),
            eta: mpf(draw.uniform(0.1, 2)),
            alpha: mpf(draw.uniform(-3, 3)),
            theta_tip: mpf(draw.uniform(-3, 3)),
            ell: mpf(draw.uniform(1, 8)),
        }
        yield {**numbers, **({beta: mpf(0)} if number % 4 == 3 else {})}


def numeric(expression, numbers):
    """The value of an expression in mpmath arithmetic; a branch of a logarithm may be given as a number for it."""
    symbols = tuple(numbers)
    return lambdify(symbols, expression, [ELLIPTIC, "mpmath"])(*numbers.values())


def continued(values):
    """Logarithms of complex numbers along a path that starts near 1, continuous from one to the next."""
    logs = [mp.log(values[0])]
    for before, after in pairwise(values):
        step = mp.log(after / before)
        assert abs(mp.im(step)) < 2.5  # the grid is fine enough to tell which way it turns
        logs.append(logs[-1] + step)
    return logs


class Solution:
    """The theory's solution of one rod, in numbers, at σ on a grid that holds the fractions of the length."""

    def __init__(self, oblique, rod):
        self.oblique, self.rod = oblique, rod
        self.numbers = {**rod, **{x: numeric(value, rod) for x, value in oblique.constants.items()}}
        pole, slope = (numeric(value, rod) for value in (oblique.pole, oblique.slope))
        self.numbers[v] = elliptic.wp_inverse(pole, slope, self.numbers[g2], self.numbers[g3])
        at_v = (self.numbers[v], self.numbers[g2], self.numbers[g3])
        assert abs(elliptic.wp(*at_v) - pole) < CLOSE * (1 + abs(pole))
        assert abs(elliptic.wp_prime(*at_v) - slope) < CLOSE * (1 + abs(slope))
        grid = {rod[ell] * number / GRID for number in range(1, GRID + 1)}
        self.grid = sorted(grid | {rod[ell] * (1 - part) for part in FRACTIONS})
        (self.call,) = oblique.shape.logarithm.atoms(log)
        self.logs = continued([self.value(self.call.args[0], at) for at in self.grid])
        # t by its numerator and its denominator, so that it may be infinite.
        values = [elliptic.wp(at, *at_v[1:]) - self.numbers[c] for at in self.grid]
        self.turns = continued([(x + 1j * self.numbers[b]) / (x - 1j * self.numbers[b]) for x in values])

    def value(self, expression, at, **more):
        return numeric(expression, {**self.numbers, sigma: at, **more})

    def position(self, expression, at):
        branch = Symbol("branch")
        numbers = {**self.numbers, sigma: at, branch: self.logs[self.grid.index(at)]}
        return numeric(expression.subs(self.call, branch), numbers)

    def theta(self, at):
        return self.rod[theta_tip] + mp.im(self.turns[self.grid.index(at)])

    @property
    def discriminant(self):
        return self.numbers[g2] ** 3 - 27 * self.numbers[g3] ** 2


@pytest.fixture(scope="module")
def solutions(oblique):
    with mp.workdps(DIGITS):
        found = [Solution(oblique, rod) for rod in rods(12)]
        for solution in found:
            rod = solution.rod
            inputs = (rod[theta_tip], rod[beta], rod[eta], rod[alpha], rod[ell])
            stops = [rod[ell] * part for part in FRACTIONS]
            path = integrate(*inputs, DIGITS, stops=stops)
            solution.points = {rod[ell] - point.s: point for point in path.points}
    return found


@pytest.fixture(autouse=True)
def _digits():
    with mp.workdps(DIGITS):
        yield


def where(solution, at):
    """The σ of the solution's own grid nearest to that of the integration."""
    return min(solution.grid, key=lambda x: abs(x - at))


def test_the_sample_has_all_kinds(solutions):
    """Both signs of the discriminant, rods on which t passes infinity, and some where the principal value is wrong."""
    signs = [mp.sign(solution.discriminant) for solution in solutions]
    assert signs.count(1) > 3
    assert signs.count(-1) > 3
    assert any(abs(mp.im(turn)) > mp.pi for solution in solutions for turn in solution.turns)
    assert any(abs(mp.im(branch)) > mp.pi for solution in solutions for branch in solution.logs)


def test_angle_and_curvature(solutions):
    for solution in solutions:
        for at, point in solution.points.items():
            found = solution.theta(where(solution, at))
            assert abs(found - point.theta) < CLOSE
            squared = numeric(solution.oblique.half.levels, {**solution.rod, theta: found})
            assert abs(squared - point.curvature**2) < CLOSE


def test_half_angle_tangent(solutions):
    for solution in solutions:
        for at, point in solution.points.items():
            found = solution.value(solution.oblique.shape.t, where(solution, at))
            expected = mp.tan((point.theta - solution.rod[theta_tip]) / 2)
            assert abs(found - expected) < CLOSE * (1 + expected**2)


@pytest.mark.parametrize("form", ["position", "shape.position"])
def test_position(solutions, form):
    for solution in solutions:
        expression = solution.oblique
        for name in form.split("."):
            expression = getattr(expression, name)
        for at, point in solution.points.items():
            found = solution.position(expression, where(solution, at))
            assert abs(found - mp.mpc(point.y, point.z)) < CLOSE


def test_energy_and_clamp(solutions):
    for solution in solutions:
        whole, rod = solution.grid[-1], solution.rod
        values = {place: solution.position(solution.oblique.position, whole)}
        values[turns] = solution.position(solution.oblique.shape.square, whole)
        point = solution.points[max(solution.points)]
        expected = point.energy - rod[beta] * point.y  # the integration counts the force apart
        assert abs(numeric(solution.oblique.energy, {**rod, **values}) - expected) < CLOSE * 10
        value = numeric(solution.oblique.value_at_clamp, {**rod, clamp_angle: point.theta})
        exact = elliptic.wp(whole, solution.numbers[g2], solution.numbers[g3])
        assert abs(value - exact) < CLOSE * (1 + abs(exact)) ** 2


def test_length_up_to_the_first_turning_back(solutions):
    """σ is Carlson's R_F, of real arguments or of a real one and a conjugate pair."""
    for solution in solutions:
        at, invariants = solution.rod[ell] / 10, (solution.numbers[g2], solution.numbers[g3])
        value, roots = elliptic.wp(at, *invariants), elliptic.roots(*invariants)
        assert sum(abs(mp.im(root)) < CLOSE for root in roots) == (3 if solution.discriminant > 0 else 1)
        assert abs(mp.elliprf(*(value - root for root in roots)) - at) < CLOSE


@mp.workdps(HALF_PERIOD_DIGITS)
def test_without_field(oblique):
    """η = 0: ℘′(v) is zero, and the position has ζ but no σ."""
    rod = {beta: mpf("0.7"), eta: mpf(0), alpha: mpf(0), theta_tip: mpf("1.1"), ell: mpf(5)}
    numbers = {**rod, **{x: numeric(value, rod) for x, value in oblique.constants.items()}}
    numbers[v] = elliptic.wp_inverse(numeric(oblique.pole, rod), None, numbers[g2], numbers[g3])
    found = numeric(oblique.shape.without_field, {**numbers, sigma: rod[ell]})
    point = integrate(rod[theta_tip], rod[beta], 0, 0, rod[ell], DIGITS).clamp
    assert abs(found - mp.mpc(point.y, point.z)) < CLOSE


@pytest.mark.parametrize("name", CASES)
@mp.workdps(HALF_PERIOD_DIGITS)
def test_the_article_s_function_of_a_load_case(theory, name):
    """℘ of the article's invariants is ℘(σ) + ℘(σ + ω) − e, and ξ by it is cos θ."""
    case, functions, special = theory.cases[name], theory.weierstrass[name], theory.oblique.special[name]
    rod = {beta: mpf("0.6"), eta: mpf("0.9"), alpha: mpf("0.4"), theta_tip: mpf("1.3")}
    tip = {xi_tip: cos(theta_tip)}
    invariants = [
        numeric(x.subs(case.constant, case.tip_constant).subs(tip), rod) for x in (functions.g2, functions.g3)
    ]
    own = [numeric(x.subs(special.coefficients), rod) for x in (theory.oblique.lattice.g2, theory.oblique.lattice.g3)]
    mirror, at = numeric(special.mirror, rod), mpf("0.8")
    value = elliptic.wp(at, *own)
    expected = elliptic.wp(at, *invariants)
    assert abs(doubled(value, mirror, own[0]) - expected) < CLOSE * (1 + abs(expected))
    omega = elliptic.wp_inverse(mirror, None, *own)
    assert abs(value + elliptic.wp(at + omega, *own) - mirror - expected) < CLOSE * (1 + abs(expected))
    found = numeric(functions.at_tip.xi_at(Symbol("value")).subs(tip), {**rod, Symbol("value"): expected})
    direction = {"orthogonal": mp.pi / 2}.get(name, 0)
    inputs = [rod[x] if x in case.parameters else 0 for x in (beta, eta)]
    assert abs(found - mp.cos(integrate(rod[theta_tip], *inputs, direction, at, DIGITS).clamp.theta)) < CLOSE


# The discriminant zero.


def degenerate_rods():
    """A rod on its way to a straight direction, k real; and one beside a lower crest of θ′², k imaginary."""
    yield SimpleNamespace(beta=mpf(1) / 2, eta=mpf(2), alpha=mpf(0), tip=mp.pi / 3, double=mp.pi, real=True)
    strength, field, direction = mpf("0.2"), mpf(1), mpf("0.5")

    def squared(angle):
        return -2 * strength * mp.cos(angle) - field * mp.cos(angle - direction) ** 2

    def slope(angle):
        return 2 * strength * mp.sin(angle) + field * mp.sin(2 * (angle - direction))

    crests = [mp.findroot(slope, start) for start in (direction + mp.pi / 2, direction - mp.pi / 2)]
    low, high = sorted(crests, key=squared)
    tip = mp.findroot(lambda angle: squared(angle) - squared(low), high + mpf("0.3"))
    yield SimpleNamespace(beta=strength, eta=field, alpha=direction, tip=tip, double=low, real=False)


@pytest.mark.parametrize("number", [0, 1])
def test_degenerate_rods(oblique, number):
    rod = list(degenerate_rods())[number]
    numbers = {beta: rod.beta, eta: rod.eta, alpha: rod.alpha, theta_tip: rod.tip}
    numbers |= {x: numeric(value, numbers) for x, value in oblique.constants.items()}
    assert abs(numbers[g2] ** 3 - 27 * numbers[g3] ** 2) < CLOSE
    value = numbers[c] + numbers[b] / mp.tan((rod.double - rod.tip) / 2)
    numbers[k] = mp.sqrt(3 * value)
    assert (mp.im(numbers[k]) == 0) == rod.real
    at = mpf("1.2")
    point = integrate(rod.tip, rod.beta, rod.eta, rod.alpha, at, DIGITS).clamp
    half = numbers[b] / (numeric(oblique.degenerate.value, {k: numbers[k], sigma: at}) - numbers[c])
    assert abs(rod.tip + 2 * mp.atan(half) - point.theta) < CLOSE
    found = numeric(oblique.degenerate.position, {**numbers, sigma: at})
    assert abs(found - mp.mpc(point.y, point.z)) < CLOSE


def test_a_straight_rod_has_no_invariants(oblique):
    """p = 0: ℘ is degenerate, with the double value −q/24 or q/12 by the sign of q."""
    straight = {p: 0, q: 3, m: 5, n: 7}
    assert [oblique.lattice.g2.subs(straight), oblique.lattice.g3.subs(straight)] == [Rational(3, 4), Rational(-1, 8)]


def test_the_clamp_may_be_the_opposite_direction(oblique):
    """Where θ(0) is θ(ℓ) + π, t is infinite and ℘(ℓ) = c."""
    assert same(oblique.value_at_clamp.subs(1 / tan((clamp_angle - theta_tip) / 2), 0), oblique.constants[c])
