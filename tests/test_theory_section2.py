"""Section 2: the results written out by hand, the claims at random points, other energies, and flipped signs."""

from __future__ import annotations

import importlib.util
import random
import sys
from functools import cache
from itertools import zip_longest
from pathlib import Path
from types import ModuleType

import mpmath
import pytest
from sympy import (
    Add,
    Derivative,
    Expr,
    Function,
    Matrix,
    Max,
    Mul,
    Pow,
    Rational,
    S,
    Symbol,
    asin,
    cos,
    diag,
    eye,
    integrate,
    pi,
    sin,
    sqrt,
    symbols,
    zeros,
)
from sympy.core.function import AppliedUndef

from derive.theory import (
    couple,
    energy,
    equilibrium,
    frame,
    kinematics,
    line_energy,
    loads,
    particle,
    placement,
    variation,
)
from derive.theory.claims import Claim, Equal, Notebook, Order
from derive.theory.energy import Energy
from derive.theory.letters import (
    EI,
    GJ,
    SI,
    X1,
    X2,
    A,
    N_par,
    N_perp,
    V,
    chi,
    chi_par,
    chi_perp,
    chi_tilde,
    e1,
    e2,
    e3,
    eps,
    eta_tilde,
    field,
    mass,
    mu0,
    nu,
    tau,
    tau_tilde,
    w,
)
from derive.theory.symbols import eta, s

DIGITS, TOLERANCE = 30, mpmath.mpf(10) ** -20  # far above rounding, far below any wrong term
ENERGIES = {"paramagnetic": lambda: None, "permanent": particle.permanent_energy}


@cache
def section2(kind: str = "paramagnetic") -> tuple[equilibrium.Equilibrium, Notebook]:
    """One run of the chain for each energy."""
    book = Notebook()
    return equilibrium.derive_section2(ENERGIES[kind](), book), book


def entries(value: object) -> list[Expr]:
    return [S.Zero + x for x in (value if hasattr(value, "shape") else [value])]


class Point(dict):
    """Numbers for symbols, unknown functions and their derivatives, drawn when first met; and for what they make."""

    def __init__(self, seed: str, **fixed: mpmath.mpf) -> None:
        self.seed, self.fixed = seed, fixed

    def __missing__(self, expr: Expr) -> mpmath.mpf:
        self[expr] = number = self.compute(expr)
        return number

    def compute(self, expr: Expr) -> mpmath.mpf:
        if expr.is_Rational:
            return mpmath.mpf(expr.p) / expr.q
        if isinstance(expr, Symbol | Derivative | AppliedUndef):
            rng = random.Random(f"{self.seed} {expr}")
            sign = 1 if expr.is_nonnegative else rng.choice((1, -1))
            return self.fixed.get(str(expr), sign * mpmath.mpf(rng.randint(100, 1000)) / 1000)
        return OPERATIONS[expr.func](*(self[x] for x in expr.args))


OPERATIONS = {
    Max: max,
    Add: lambda *x: mpmath.fsum(x),
    Mul: lambda *x: mpmath.fprod(x),
    Pow: mpmath.power,
    sin: mpmath.sin,
    cos: mpmath.cos,
}


def holds(claim: Claim) -> bool:
    """The claim at a random point; unknown functions and their derivatives are independent numbers there."""
    relation = claim.relation
    with mpmath.workdps(DIGITS):
        if isinstance(relation, Order):
            return vanishes(relation, claim.id)
        at = Point(claim.id)
        if isinstance(relation, Equal):
            pairs = list(zip_longest(entries(relation.lhs), entries(relation.rhs), fillvalue=S.NaN))
            return all(abs(at[a] - at[b]) <= TOLERANCE * (1 + abs(at[a])) for a, b in pairs)
        return at[relation.expr] > 0


def vanishes(relation: Order, seed: str) -> bool:
    """Ten times closer to zero, the expression is smaller by the power of ten that its order says."""
    near, nearer = (Point(seed, **{relation.variable.name: mpmath.mpf(x)}) for x in ("1e-4", "1e-5"))
    bound = mpmath.mpf(10) ** (mpmath.mpf("0.3") - relation.power)
    return all(abs(nearer[x]) <= bound * abs(near[x]) + TOLERANCE for x in entries(relation.expr))


@pytest.mark.parametrize("kind", ENERGIES)
def test_all_claims_hold_at_random_points(kind):
    _, book = section2(kind)
    assert len(book.claims) > 50
    assert [claim.id for claim in book.claims.values() if not holds(claim)] == []


# 2.1 Kirchhoff's theory


def rod() -> kinematics.Kinematics:
    return section2()[0].balance.couple.line.rod


def test_frame_that_turns_about_one_axis():
    # A plane rod, turned by φ₂ about the first axis: κ = φ₂′ d₁.
    one, bend, other = rod().frame.angles
    kappa = rod().frame.kappa_of_angles.subs({one: 0, other: pi / 3}).doit()
    assert kappa == bend.diff(s) * Matrix([cos(pi / 3), -sin(pi / 3), 0])
    # At angles of sines 3/5, 5/13 and 8/17 the frame is orthonormal, exactly.
    angles = {one: asin(Rational(3, 5)), bend: asin(Rational(5, 13)), other: asin(Rational(8, 17))}
    R = rod().frame.R.subs(angles)
    assert (R.T * R).is_diagonal()
    assert R.det() == 1


def test_derivatives_of_the_frame():
    k1, k2, k3 = rod().frame.kappa
    assert frame.along(e1, rod().frame.kappa) == Matrix([0, k3, -k2])
    assert frame.along(e2, rod().frame.kappa) == Matrix([-k3, 0, k1])
    assert frame.along(e3, rod().frame.kappa) == Matrix([k2, -k1, 0])


def test_bases_to_first_order():
    k1, k2, k3 = rod().kappa_u
    third = Matrix([-X2 * k3, X1 * k3, X2 * k1 - X1 * k2])
    assert (rod().tangents_u - Matrix.hstack(e1, e2, e3 + eps * third)).expand() == zeros(3)
    first = rod().dual_u.diff(eps).subs(eps, 0)
    assert first[2, :] == -third.T.expand()
    assert first[:2, :] == zeros(2, 3)
    assert (rod().jacobian - 1 - eps * (X2 * k1 - X1 * k2)).expand() == 0


def test_gradient_to_first_order():
    gradient = rod().gradient
    assert gradient.subs(eps, 0) == eye(3)
    first = gradient.diff(eps).subs(eps, 0).expand()
    m1, m2, m3 = rod().mu
    bending = Matrix([-X2 * m3, X1 * m3, X2 * m1 - X1 * m2])
    displacement = [Function(f"w_{i}", real=True)(X1, X2, s) for i in (1, 2, 3)]
    assert (first[:, 2] - bending).expand() == zeros(3, 1)
    assert first[:, 0] == Matrix([x.diff(X1) for x in displacement])
    assert first[:, 1] == Matrix([x.diff(X2) for x in displacement])


def test_orientation_to_first_order():
    _, _, k3 = rod().frame.kappa
    first = rod().fibre.diff(eps).subs(eps, 0).expand()
    assert first == Matrix([-X2 * k3, X1 * k3, 0])


# 2.2 Magnetostatic energy


def test_susceptibilities_by_hand():
    grain = particle.derive(Notebook())
    across = 1 / (1 / chi_perp + N_perp)
    assert (grain.susceptibilities[chi_tilde] - across).simplify() == 0
    assert (grain.susceptibilities[chi] - (1 / (1 / chi_par + N_par) - across)).simplify() == 0


def test_energy_of_a_particle_by_hand():
    h, a = Matrix(symbols("h_1:4", real=True)), Matrix(symbols("a_1:4", real=True))
    density = particle.derive(Notebook()).energy.density(h, a)
    # The two terms carry the same sign, unlike the printed kth20b.
    by_hand = -Rational(1, 2) * mu0 * nu * V * (chi * h.dot(a) ** 2 + chi_tilde * h.dot(h))
    assert (density - by_hand).expand() == 0


def test_tensors_are_what_they_say():
    assert particle.symmetric(2, 3, e3) == diag(3, 3, 2)


def test_energy_per_unit_length_by_hand():
    line = section2()[0].balance.couple.line
    assert line.moduli == {eta_tilde: A * mu0 * nu * V * chi * field**2}
    assert line.named == -eta_tilde * w**2 / 2


def test_integral_over_a_section():
    assert line_energy.over_section(3 + X1 - 2 * X2) == 3 * A
    assert line_energy.over_triangle(X1) == line_energy.over_triangle(X2) == 0
    assert integrate(integrate(S.One, (X2, -1, 1 - X1)), (X1, -1, 2)) == Rational(9, 2)
    second = X1 * X2
    with pytest.raises(ValueError, match="first order"):
        line_energy.over_section(second)


def test_modulus_is_a_force():
    # Twice the unit of mass halves its numbers; the modulus scales as a force does, not as force · length² / current².
    modulus = section2()[0].balance.couple.line.moduli[eta_tilde]
    length, time, current = (Symbol(name, positive=True) for name in ("length", "time", "current"))
    ratio = modulus.subs({x: x * size for x, size in SI.items()}, simultaneous=True) / modulus
    assert ratio == mass * length / time**2
    per_field = (ratio / SI[field] ** 2).simplify()
    assert (per_field - ratio * length**2 / current**2).simplify() == 0


# 2.3 Equilibrium


def test_couple_by_hand():
    pair = section2()[0].balance.couple
    h1, h2, h3 = line_energy.FIELD
    scale = A * mu0 * nu * V * chi * h3
    assert (pair.by_variation - scale * Matrix([-h2, h1, 0])).expand() == zeros(3, 1)
    assert (pair.by_variation - pair.by_induction).expand() == zeros(3, 1)
    assert pair.modulus == A * mu0 * nu * V * chi * field**2 * w


def test_balance_of_moments_by_hand():
    balance = section2()[0].balance
    k, f, e = rod().frame.kappa, variation.FORCE, variation.DIRECTION
    straight = balance.moment.subs(dict.fromkeys(rod().kappa_u, 0)).doit()
    modulus = A * mu0 * nu * V * chi * field**2
    by_hand = Matrix(
        [
            EI * k[0].diff(s) + (GJ - EI) * k[1] * k[2] - f[1] - modulus * e[2] * e[1],
            EI * k[1].diff(s) + (EI - GJ) * k[0] * k[2] + f[0] + modulus * e[2] * e[0],
            GJ * k[2].diff(s),
        ]
    )
    assert (straight - by_hand).expand() == zeros(3, 1)
    assert (balance.force - f.diff(s) - k.cross(f)).expand() == zeros(3, 1)


@pytest.mark.parametrize(
    ("kind", "density"), [("paramagnetic", -eta * w**2 / 2), ("permanent", -tau * w)], ids=["para", "permanent"]
)
def test_plane_rod(kind, density):
    state, _ = section2(kind)
    theta, beta, alpha = Function("theta")(s), Symbol("beta"), Symbol("alpha")
    d3, e = Matrix([0, cos(theta), sin(theta)]), Matrix([0, cos(alpha), sin(alpha)])
    assert state.alignment == w
    assert state.energy_density == density
    residual = state.residual(d3, beta * e2, e).doit()
    couple_of_field = density.diff(w).subs(w, cos(theta - alpha)) * sin(theta - alpha)
    by_hand = theta.diff(s, 2) - beta * sin(theta) + couple_of_field
    assert (residual[0] - by_hand).expand(trig=True).simplify() == 0
    assert residual[1:, 0] == zeros(2, 1)


# Other energies


def test_permanent_magnet_gives_a_couple_of_constant_modulus():
    state, book = section2("permanent")
    M0 = Symbol("M_0", positive=True)
    line = state.balance.couple.line
    assert line.moduli == {tau_tilde: A * mu0 * nu * V * M0 * field}
    assert state.moduli == {tau: A * mu0 * nu * V * M0 * field / EI}
    assert state.balance.couple.modulus == A * mu0 * nu * V * M0 * field
    # Turning the field about changes the couple's sign; for paramagnetic particles it does not.
    d3, e = Matrix([1, 0, 0]), Matrix([Rational(3, 5), Rational(4, 5), 0])
    assert state.residual(d3, zeros(3, 1), e) == -state.residual(d3, zeros(3, 1), -e) == tau * d3.cross(e)
    other = section2()[0]
    assert other.residual(d3, zeros(3, 1), e) == other.residual(d3, zeros(3, 1), -e)
    assert not any(claim_id.startswith("particle.") for claim_id in book.claims)


def test_energy_that_saturates():
    k = Symbol("k", positive=True)
    energy_ = Energy("saturating particles", lambda h, a: -k * sqrt(1 + h.dot(a) ** 2))
    line = line_energy.derive(energy_, rod(), LooseNotebook())
    assert line.moduli == {}
    assert (line.psi_m - A * k * (1 - sqrt(1 + field**2 * w**2))).expand() == 0


def test_energy_with_a_direction_of_its_own_is_refused():
    crystal = Energy("a crystal", lambda h, a: -(a[0] ** 2) * h.dot(h))
    with pytest.raises(ValueError, match="turn together"):
        equilibrium.derive_section2(crystal)


# Flipped signs


class LooseNotebook(Notebook):
    """A notebook for one script alone: the claims of earlier scripts are not in it."""

    def claim(self, *arguments, steps=(), **named):
        return super().claim(*arguments, **named)


def mutant(script: ModuleType, old: str, new: str, monkeypatch) -> ModuleType:
    """The script with one place of its source changed."""
    source = Path(script.__file__).read_text(encoding="utf-8")
    assert source.count(old) == 1, f"{old!r} must stand once in {script.__name__}"
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutant", loader=None))
    monkeypatch.setitem(sys.modules, "mutant", module)
    exec(compile(source.replace(old, new), "mutant", "exec"), module.__dict__)
    return module


FLIPS = [
    (energy, "h.cross(-self.moment(h, a)) + a", "h.cross(-self.moment(h, a)) - a"),
    (particle, "along - across,", "along + across,"),
    (particle, "density = -mu0", "density = mu0"),
    (frame, "v.diff(s) + kappa", "v.diff(s) - kappa"),
    (frame, "cosine * sine.diff(s) - sine", "cosine * sine.diff(s) + sine"),
    (placement, "e3 + along(place", "e3 - along(place"),
    (loads, "elastic + constraint - FORCES", "elastic + constraint + FORCES"),
    (loads, "- COUPLES.dot(TURN)", "+ COUPLES.dot(TURN)"),
    (kinematics, "rod.frame.kappa.cross(POINT)", "-rod.frame.kappa.cross(POINT)"),
    (line_energy, "-letter * w", "letter * w"),
    (couple, "return -d3.cross", "return d3.cross"),
    (couple, "couple * (1 + e3", "couple * (1 - e3"),
    (variation, "along(SHIFT, kappa) - TURN", "along(SHIFT, kappa) + TURN"),
    (variation, "density.diff(x) - density", "density.diff(x) + density"),
    (equilibrium, "bending + d3.cross", "bending - d3.cross"),
    (equilibrium, "modulus = -energy", "modulus = energy"),
]


def derive_one(script: ModuleType, module: ModuleType, book: Notebook) -> None:
    """Run a script's ``derive`` on the records of the scripts before it."""
    state = section2()[0]
    line = state.balance.couple.line
    before = {
        energy: lambda: (module.Energy("mutant", line.energy.density) if script is energy else line.energy,),
        particle: lambda: (),
        frame: lambda: (),
        placement: lambda: (line.rod.frame,),
        loads: lambda: (state.balance,),
        kinematics: lambda: (line.rod.frame,),
        line_energy: lambda: (line.energy, line.rod),
        couple: lambda: (line,),
        variation: lambda: (state.balance.couple,),
        equilibrium: lambda: (state.balance,),
    }
    module.derive(*before[script](), book)


@pytest.mark.parametrize(("script", "old", "new"), FLIPS, ids=[f"{f[0].__name__[14:]}: {f[2]}" for f in FLIPS])
def test_a_flipped_sign_breaks_a_claim(script, old, new, monkeypatch):
    book = LooseNotebook()
    try:
        derive_one(script, mutant(script, old, new, monkeypatch), book)
    except ValueError:
        return
    assert not all(holds(claim) for claim in book.claims.values())


@pytest.mark.parametrize("script", [energy, particle, frame, placement, kinematics])
def test_scripts_print_their_derivation(script, capsys):
    script.main()
    assert "[" + script.__name__.rpartition(".")[2] + "." in capsys.readouterr().out


def test_last_script_prints_all_of_section_2(capsys, monkeypatch):
    _, known = section2()
    monkeypatch.setattr(equilibrium, "derive_section2", lambda book: book.lines.extend(known.lines))
    equilibrium.main()
    printed = capsys.readouterr().out
    assert known.claims
    assert all(f"[{claim_id}]" in printed for claim_id in known.claims)
