"""The motion between two turning points, for any angle of the field: proved, and against Taylor integration."""

from __future__ import annotations

import random
from itertools import pairwise

import pytest
from mpmath import mp, mpf
from sympy import lambdify

from derive.measure.taylor import integrate

DIGITS = 40
CLOSE = mpf(10) ** -30  # the integration and the quadrature keep more than 35 digits on these motions
RODS = 12
PARTS = ("real", "imag")


@pytest.fixture(scope="module")
def formulas(theory):
    """The formulas as functions of numbers, by name."""
    swing = theory.swing
    return {f.name: lambdify(f.arguments, f.expression, "mpmath") for f in (*swing.formulas, *swing.steps)}


@pytest.fixture(autouse=True)
def _digits():
    with mp.workdps(DIGITS):
        yield


@pytest.mark.long  # the main job proves them too
def test_every_claim_is_proved(unproved):
    assert unproved("swing.") == []


def test_formulas_are_of_one_case_and_named_once(theory):
    known = (*theory.swing.formulas, *theory.swing.steps)
    assert len({f.name for f in known}) == len(known)
    assert {f.case for f in known} == {"oblique"}
    assert "alpha" not in {symbol.name for f in known for symbol in f.arguments}


class Motion:
    """A rod at rest at its tip, and the angle at which it would turn back; found by roots of V, without formulas."""

    def __init__(self, draw):
        self.field = (mpf(draw.uniform(0.1, 2)), mpf(draw.uniform(0.1, 3)), mpf(draw.uniform(-3, 3)))
        beta, eta, alpha = self.field
        self.tip = mpf(draw.uniform(-3, 3))
        if self.slope(self.tip) < 0:  # the mirror image rises
            self.field, self.tip = (beta, eta, -alpha), -self.tip
        step, angle = mp.pi / 200, self.tip + mp.pi / 200
        while self.potential(angle) < self.potential(self.tip):
            angle += step
        turn = mp.findroot(
            lambda x: self.potential(x) - self.potential(self.tip), (angle - step, angle), solver="anderson"
        )
        self.half_width, self.middle = (turn - self.tip) / 2, (turn + self.tip) / 2

    def loads(self):
        """β, η, and the cosines of the tip angle and of that to the field."""
        beta, eta, alpha = self.field
        return beta, eta, mp.cos(self.tip), mp.cos(self.tip - alpha)

    def potential(self, angle):
        beta, eta, alpha = self.field
        return beta * mp.cos(angle) + eta * mp.cos(angle - alpha) ** 2 / 2

    def slope(self, angle):
        """θ″."""
        beta, eta, alpha = self.field
        return beta * mp.sin(angle) + eta * mp.sin(2 * (angle - alpha)) / 2

    def factors(self, formulas):
        """P, P′ and R."""
        turns = (self.middle - self.half_width, self.middle + self.half_width)
        ends = (formulas["moment"](*self.field, turns[0]), -formulas["moment"](*self.field, turns[1]))
        near, far = (formulas["turn_factor"](moment, mp.sin(self.half_width)) for moment in ends)
        return near, far, formulas["middle_excess"](*self.cosines())

    def cosines(self):
        """β, η and the cosines of the middle, of twice its angle to the field, and of half the width."""
        beta, eta, alpha = self.field
        return beta, eta, mp.cos(self.middle), mp.cos(2 * (self.middle - alpha)), mp.cos(self.half_width)


@pytest.fixture(scope="module")
def motions():
    with mp.workdps(DIGITS):
        draw = random.Random(11)
        return [Motion(draw) for _ in range(RODS)]


def integrated(motion, length):
    beta, eta, alpha = motion.field
    return integrate(motion.tip, beta, eta, alpha, length, DIGITS).clamp


def test_the_length_by_the_legendre_integral(formulas, motions):
    """θ at the length ∫dχ/√(h² cos²χ + g² sin²χ) from the tip is the angle whose phase is χ."""
    signs = set()
    for motion in motions:
        near, far, excess = motion.factors(formulas)
        signs.add(mp.sign(excess))
        product = formulas["factor_product"](near, far)
        rates = formulas["end_rate_squared"](product), formulas["middle_rate_squared"](product, excess)
        for part in (mpf("0.2"), mpf("0.7"), mpf("0.99")):
            done = 2 * motion.half_width * part
            squared = formulas["phase_tangent_squared"](near, far, done, 2 * motion.half_width - done)
            chi = 2 * mp.atan(mp.sqrt(squared))
            # Legendre's F wants h² only, and continues past π/2.
            length = mp.ellipf(chi, 1 - rates[1] / rates[0]) / mp.sqrt(rates[0])
            assert abs(integrated(motion, length).theta - motion.tip - done) < CLOSE
    assert signs == {1, -1}


def test_both_forms_of_the_middle_rate(formulas, motions):
    for motion in motions:
        near, far, excess = motion.factors(formulas)
        mean, product = formulas["mean_factor"](*motion.cosines()), formulas["factor_product"](near, far)
        eta, sine = motion.field[1], mp.sin(motion.half_width)
        apart = sine**2 * formulas["middle_rate_squared_apart"](product, excess, eta, mean, mean - eta)
        assert abs(apart - formulas["middle_rate_squared"](product, excess)) < CLOSE
        skew = formulas["skew"](eta, motion.field[2], motion.middle)
        uneven = formulas["root_skew"](mp.sqrt(near), mp.sqrt(far), skew, sine)
        assert abs(uneven - mp.sqrt(far) + mp.sqrt(near)) < CLOSE


def test_moments_and_drops(formulas, motions):
    """From a direction of equilibrium, also at an offset where the difference of V keeps no digit."""
    for motion in motions:
        ends = (motion.tip, 2 * motion.middle - motion.tip)
        rest = mp.findroot(motion.slope, ends, solver="anderson")
        assert abs(formulas["moment"](*motion.field, rest)) < CLOSE
        beta, eta, alpha = motion.field
        double = mp.cos(2 * (rest - alpha)), mp.sin(2 * (rest - alpha))
        stiffness = formulas["rest_stiffness"](beta, eta, mp.cos(rest), double[0])
        known = (eta, stiffness, *double)
        for offset in (mpf("1.3"), mpf("-0.2"), mpf(10) ** -18):
            found = formulas["rest_moment"](*known, *halves(offset))
            assert abs(found - motion.slope(rest + offset)) < CLOSE
            found = formulas["rest_fall"](*known, *halves(offset / 3), *halves(offset))
            ends = (rest + offset / 3 - offset, rest + offset / 3 + offset)
            assert abs(found - (motion.potential(ends[0]) - motion.potential(ends[1]))) < CLOSE
        small = mpf(10) ** -12
        assert abs(formulas["rest_moment"](*known, *halves(small)) / small - stiffness) < small * 10
        # Half of the offset is the middle, and half of the difference.
        found = formulas["rest_fall"](*known, *halves(small / 2), *halves(small / 2))
        assert abs(found * 2 / small**2 - stiffness) < small * 10
        ahead = motion.half_width / 3
        found = formulas["level_drop"](*motion.field, motion.middle, ahead)
        expected = motion.potential(motion.middle - ahead) - motion.potential(motion.middle + ahead)
        assert abs(found - expected) < CLOSE
        assert abs(formulas["level_drop"](*motion.field, motion.middle, motion.half_width)) < CLOSE


def halves(angle):
    """Sine and cosine of half an angle."""
    return mp.sin(angle / 2), mp.cos(angle / 2)


class Place:
    """A point of a motion, δ from its tip, by the theory's formulas."""

    def __init__(self, formulas, motion, part):
        self.done = 2 * motion.half_width * part
        near, self.far, _ = motion.factors(formulas)
        self.near_factor = near
        self.b = formulas["strength"](formulas["moment"](*motion.field, motion.tip))
        beta, eta, alpha = motion.field
        turn = 2 * (motion.tip - alpha)
        self.q = formulas["rest_stiffness"](beta, eta, mp.cos(motion.tip), mp.cos(turn))
        self.m = formulas["tip_cubic"](beta, eta, mp.sin(motion.tip), mp.sin(turn))
        there = formulas["factor_at"](*motion.field, motion.middle, motion.half_width, motion.tip + self.done)
        left = 2 * motion.half_width - self.done
        self.pole = formulas["point_pole"](self.b, *halves(self.done))
        self.near = formulas["point_near"](self.b, mp.sin(motion.half_width), mp.sin(self.done / 2), mp.sin(left / 2))
        self.sum = formulas["pair_sum"](self.b, self.q, self.done, motion.half_width)
        root = formulas["far_root"](near, mp.cos(motion.half_width))
        assert abs(formulas["pair_sum_by_root"](self.pole, self.q, root) - self.sum) < CLOSE * (1 + abs(self.sum))
        self.product = formulas["pair_product"](near, there, motion.half_width, self.done)
        self.rate = formulas["point_rate"](self.near, self.product)
        root = mp.sqrt(mp.mpc(self.sum**2 / 4 - self.product))
        self.pair = (self.sum / 2 + root, self.sum / 2 - root)
        self.arc = mp.re(mp.elliprf(self.near, *self.pair))

    def shift(self, formulas, motion):
        """W: its real and its imaginary part."""
        value = mp.elliprj(self.near, *self.pair, self.pole - 1j * self.b)
        return formulas["w_real"](self.b, mp.im(value)), formulas["w_imag"](self.b, mp.re(value))

    def squares(self, formulas, motion, y):
        """η∫cos²(θ − α) by both forms."""
        root = formulas["far_root"](self.near_factor, mp.cos(motion.half_width))
        first, (other, last) = self.near, self.pair
        start = (*motion.field, motion.tip, self.b)
        end = (self.rate, self.near_factor, self.far, self.arc, y)
        second = mp.re(mp.elliprd(other, last, first))
        seconds = mp.re(mp.elliprd(first, other, last) + mp.elliprd(first, last, other))
        return (
            formulas["square_before"](*start, root, self.pole, first, *end, second),
            formulas["square_beyond"](*start, self.q, self.m, root, self.pole, self.product, *end, seconds),
        )


def test_the_length_by_the_symmetric_integral(formulas, motions):
    """σ = R_F(X₁, X₂, X₃), with X₂ and X₃ real or conjugate."""
    kinds = set()
    for motion in motions:
        for part in (mpf("0.01"), mpf("0.4"), mpf("0.98")):
            place = Place(formulas, motion, part)
            kinds.add(abs(mp.im(place.pair[0])) > CLOSE)
            point = integrated(motion, place.arc)
            assert abs(point.theta - motion.tip - place.done) < CLOSE
            drop = motion.potential(motion.tip) - motion.potential(point.theta)
            assert abs(formulas["curvature_squared"](drop) - point.curvature**2) < CLOSE
    assert kinds == {True, False}


def test_position_and_energy(formulas, motions):
    """y, z and ∫η cos²(θ − α), and by them the energy, which the integration counts without the force."""
    for motion in motions:
        for part in (mpf("0.03"), mpf("0.5"), mpf("0.97")):
            place = Place(formulas, motion, part)
            point = integrated(motion, place.arc)
            shift = place.shift(formulas, motion)
            tip = mp.sin(motion.tip), mp.cos(motion.tip)
            y = formulas["arc_y"](*tip, *shift) + place.arc * tip[1]
            z = formulas["arc_z"](*tip, *shift) + place.arc * tip[0]
            assert abs(mp.mpc(y - point.y, z - point.z)) < CLOSE
            beta, gamma = motion.field[0], formulas["gamma"](*motion.loads())
            for square in place.squares(formulas, motion, y):
                energy = formulas["rod_energy"](beta, gamma, place.arc, y, square)
                assert abs(energy - (point.energy - beta * y)) < CLOSE


def test_the_second_form_at_the_far_turning_point(formulas, motions):
    """A whole half-swing: X₁ is zero there, where the first form has no value."""
    for motion in motions:
        place = Place(formulas, motion, 1)
        assert abs(place.near) < CLOSE
        place.near = mpf(0)
        place.rate = mpf(0)
        point = integrated(motion, place.arc)
        assert abs(point.curvature) < CLOSE
        tip = mp.sin(motion.tip), mp.cos(motion.tip)
        y = formulas["arc_y"](*tip, *place.shift(formulas, motion)) + place.arc * tip[1]
        root, (other, last) = formulas["far_root"](place.near_factor, mp.cos(motion.half_width)), place.pair
        seconds = mp.re(mp.elliprd(0, other, last) + mp.elliprd(0, last, other))
        ends = (place.rate, place.near_factor, place.far, place.arc, y, seconds)
        square = formulas["square_beyond"](
            *motion.field, motion.tip, place.b, place.q, place.m, root, place.pole, place.product, *ends
        )
        bending = formulas["gamma"](*motion.loads()) * place.arc / 2 - motion.field[0] * y - square
        assert abs(bending - point.energy) < CLOSE


def test_the_duplication_of_the_third_kind(formulas, motions):
    """(p − X₁)(p − X₂)(p − X₃) is the same at every point."""
    for motion in motions:
        eta, alpha = motion.field[1:]
        double = (mp.cos(2 * (motion.tip - alpha)), mp.sin(2 * (motion.tip - alpha)))
        for part in (mpf("0.2"), mpf("0.8")):
            place = Place(formulas, motion, part)
            at = place.pole - 1j * place.b
            product = (at - place.near) * (at - place.pair[0]) * (at - place.pair[1])
            real, imag = (formulas[f"rj_delta_{one}"](eta, place.b, x) for one, x in zip(PARTS, double, strict=True))
            assert abs(product - mp.mpc(real, imag)) < CLOSE * (1 + abs(at)) ** 3


@pytest.mark.parametrize("ratio", [mpf("0.6"), mpf("1.4"), mpf("6")])
def test_directions_of_equilibrium(formulas, ratio):
    """One hill, one well, and a second pair of each above the astroid: as many as θ″ has zeros."""
    for alpha in (mpf("0.05"), mpf("0.8"), mpf("1.5")):
        field = (mpf(1), ratio, alpha)
        start = mpf(10) ** -9

        def changes(function, low, high, start=start):
            grid = mp.linspace(low + start, high - start, 400)
            signs = [mp.sign(function(x)) for x in grid]
            return sum(one != two for one, two in pairwise(signs))

        hills = changes(lambda y, field=field: formulas["hill_balance"](*field, y), 0, alpha)
        wells = changes(lambda w, field=field: formulas["well_balance"](*field, w), 0, mp.pi / 2 - alpha)
        more = changes(lambda x, a=alpha: formulas["pair_height"](a, x) - ratio, 0, mp.pi / 2)
        least = (mp.cos(alpha) ** (mpf(2) / 3) + mp.sin(alpha) ** (mpf(2) / 3)) ** (mpf(3) / 2)
        assert (hills, wells, more) == (1, 1, 2 if ratio > least else 0)
        whole = changes(lambda x, field=field: formulas["moment"](*field, x), mpf("0.01"), 2 * mp.pi + mpf("0.01"))
        assert whole == hills + wells + more


def phase_by_sines(formulas, motion, part):
    """h, g, sin²ψ and cos²ψ of a point of a motion, from its angles."""
    near, far, excess = motion.factors(formulas)
    product = formulas["factor_product"](near, far)
    end = mp.sqrt(formulas["end_rate_squared"](product))
    middle = mp.sqrt(formulas["middle_rate_squared"](product, excess))
    done, left = 2 * motion.half_width * part, 2 * motion.half_width * (1 - part)
    roots, sines = (mp.sqrt(near), mp.sqrt(far)), (mp.sin(done / 2), mp.sin(left / 2))
    whole, gap = formulas["phase_sum"](*roots, *sines), mp.sin((left - done) / 4)
    lead = formulas["phase_lead"](roots[0], mp.cos(motion.half_width / 2), roots[1] - roots[0], sines[0], gap)
    square = formulas["chi_square"](roots[1] * sines[0] / whole, roots[0] * sines[1] / whole)
    size, delta = abs(lead / whole), formulas["phase_rate"](end, middle, square, (lead / whole) ** 2)
    if lead >= 0:
        half = formulas["half_square"](end, square, size, delta), formulas["half_rest"](end, size, delta)
    else:
        rest = formulas["half_rest_beyond"](end, middle, square, size, delta)
        half = formulas["half_square_beyond"](end, size, delta), rest
    return end, middle, *half


def test_energy_by_the_phase(formulas, motions):
    """η∫cos²(θ − α) by both forms of the part without integral, against the energy of the integration."""
    for motion in motions[:6]:
        beta, eta, alpha = motion.field
        for part in (mpf("0.1"), mpf("0.5"), mpf("0.9")):
            place, (end, middle, square, rest) = Place(formulas, motion, part), phase_by_sines(formulas, motion, part)
            first, second = end / 2, middle / 2
            delta = formulas["phase_rate"](first, second, square, rest)
            assert abs(formulas["near_by_phase"](square, rest, first**2 / delta) - place.near) < CLOSE * (
                1 + place.near
            )
            product, across = mp.sqrt(place.product), mp.sqrt(square * rest)
            root = formulas["far_root"](place.near_factor, mp.cos(motion.half_width))
            others = formulas["others_sum"](place.q, root)
            both = formulas["others_product"](place.b, place.m, root, others)
            at = (first, square, delta, across, place.b, place.pole, root, mp.sqrt(place.near), product)
            kinks = [formulas["arc_kink"](*at)]
            if place.pole > 0:
                near = (place.b, place.pole, root, others, both, place.pole + product)
                kinks.append(formulas["arc_kink_tip"](first, delta, across, *near))
            psi = mp.atan2(mp.sqrt(square), mp.sqrt(rest))

            def turning(x, a=first, b=second):
                return mp.sin(x) ** 2 / mp.sqrt((a * mp.cos(x)) ** 2 + (b * mp.sin(x)) ** 2)

            turned, point = mp.quad(turning, mp.linspace(0, psi, 9)), integrated(motion, place.arc)
            straight = place.arc * mp.cos(motion.tip), place.arc * eta * mp.cos(motion.tip - alpha) ** 2
            known, lag = (beta, first, second, root, point.y - straight[0]), place.arc - across / delta
            for kink in kinks:
                square_there = formulas["arc_square"](*known, kink, turned, lag) + straight[1]
                gamma = formulas["gamma"](*motion.loads())
                energy = formulas["rod_energy"](beta, gamma, place.arc, point.y, square_there)
                assert abs(energy - (point.energy - beta * point.y)) < CLOSE
