"""The quartic: (ξ′)² = f(ξ) = f̂(ξ)(1 − ξ²) in the four load cases, its roots, and the range of the constant.

``parallel`` (α = 0), ``orthogonal`` (α = π/2, with γ̄), ``field_only`` (no force) and ``force_only`` (no field). In all
of them f̂ = Γ − 2Bξ − Hξ², with the force B and the field H, that bends the rod (H > 0) or straightens it (H < 0).
"""

from __future__ import annotations

from collections.abc import Mapping

from sympy import Expr, Poly, PolynomialError, Symbol, cos, diff, expand, pi, sin, sqrt

from .claims import Equal, Notebook
from .load_case import COSINES, LoadCase, NotElliptic, linear_root, sign_of, xi_tip
from .plane import Plane
from .quartic_range import claim_range
from .symbols import alpha, beta, gamma, gamma_bar, theta, xi

__all__ = ["LoadCase", "NotElliptic", "derive", "xi_tip"]


def derive(plane: Plane, book: Notebook) -> Mapping[str, LoadCase]:
    """All load cases that the energy makes elliptic; NotElliptic if the parallel one is not."""
    cases = {}
    no_field: dict[Symbol, int] = dict.fromkeys(plane.parameters, 0)
    for name, direction, absent in (
        ("parallel", 0 * pi, {}),
        ("orthogonal", pi / 2, {}),
        ("field_only", 0 * pi, {beta: 0}),
        ("force_only", 0 * pi, no_field),
    ):
        try:
            cases[name] = _case(plane, name, direction, absent, book)
        except NotElliptic as reason:
            if name == "parallel":
                raise
            book.say(f"The load case {name} is left out. {reason}")
    return cases


def _case(plane: Plane, name: str, direction: Expr, absent: dict[Symbol, int], book: Notebook) -> LoadCase:
    """f, f̂, the roots and the range of one load case, with the claims about them."""
    book.say(f"Section 3, load case {name}")
    # exsl11 with w = cos(θ − α) in terms of ξ = cos θ.
    w, density = plane.alignment, plane.energy_density
    levels = _in_xi(plane.curvature_squared, w, direction, name).subs(absent)
    work = _in_xi(-2 * density, w, direction, name).subs(absent)
    # With the orthogonal field γ is replaced by γ̄ = η − γ, so that f̂(0) = −γ̄ (exhpf1).
    constant = gamma_bar if direction else gamma
    gamma_of = linear_root(levels.subs(xi, 0) + gamma_bar, gamma) if direction else gamma
    f_hat = book.show("f̂(ξ)", expand(levels.subs(gamma, gamma_of)))
    f = book.show("f(ξ)", expand(f_hat * (1 - xi**2)))
    # f̂ = Γ − 2Bξ − Hξ².
    force, stiffness = -f_hat.coeff(xi, 1) / 2, -f_hat.coeff(xi, 2)
    # exsl23: no moment at the free end, f̂(ξ(ℓ)) = 0; by Vieta the other root is −2B/H − ξ(ℓ).
    tip_constant = book.show(f"{constant}(ξ(ℓ))", expand(linear_root(f_hat.subs(xi, xi_tip), constant)))
    other_root = expand(-2 * force / stiffness - xi_tip) if stiffness != 0 else None
    case = LoadCase(
        name=name,
        parameters=tuple(p for p in (beta, *plane.parameters) if f_hat.has(p)),
        angular_acceleration=plane.angular_acceleration.subs({alpha: direction, **absent}),
        field_work=work,
        tip_force=beta.subs(absent),
        constant=constant,
        gamma=gamma_of,
        f=f,
        f_hat=f_hat,
        force=force,
        stiffness=stiffness,
        roots=_roots(f_hat, force, stiffness),
        tip_constant=tip_constant,
        other_root=other_root,
        ends=_ends(f_hat, force, stiffness, constant),
    )
    _claim_polynomial(case, book)
    _claim_roots(case, book)
    claim_range(case, book)
    return case


def _in_xi(expression: Expr, w: Symbol, direction: Expr, name: str) -> Expr:
    """The expression in ξ = cos θ: w = ξ if the field is along the force, w² = 1 − ξ² if it is normal to it."""
    try:
        terms = Poly(expression, w).terms()
    except PolynomialError as error:
        raise NotElliptic(f"{name}: the energy is not a polynomial in w = d₃·e, so f(ξ) is no polynomial") from error
    odd = [power for (power,), _ in terms if power % 2]
    if direction and odd:
        why = f"the energy holds w**{odd[0]}, an odd power of w = sin θ, which is no polynomial in ξ = cos θ"
        raise NotElliptic(f"{name}: {why}")
    square = 1 - xi**2 if direction else xi**2
    reached = expand(sum(value * square ** (power // 2) * xi ** (power % 2) for (power,), value in terms))
    degree = Poly(reached, xi).degree()
    if degree > 2:
        why = f"f̂(ξ) has degree {degree}; above degree 2, f = f̂(1 − ξ²) is beyond quartic (hyperelliptic)"
        raise NotElliptic(f"{name}: {why}")
    return reached


def _roots(f_hat: Expr, force: Expr, stiffness: Expr) -> tuple[Expr, ...]:
    """The roots of f̂ = Γ − 2Bξ − Hξ², ascending (exsl14, exhpf3, slch2; one in slch4)."""
    level = f_hat.subs(xi, 0)
    if stiffness == 0:
        return (level / (2 * force),)
    spread = sqrt(expand(force**2 + level * stiffness)) / (sign_of(stiffness) * stiffness)
    return (-force / stiffness - spread, -force / stiffness + spread)


def _ends(f_hat: Expr, force: Expr, stiffness: Expr, constant: Symbol) -> tuple[Expr, Expr]:
    """The range of the constant: f̂ has real roots and a tip in [−1, 1] (exsl24, exsl25, exhpf8, after slch6)."""
    at_plus, at_minus = (linear_root(f_hat.subs(xi, side), constant) for side in (1, -1))
    if stiffness == 0:
        ends = (at_minus, at_plus)
    else:
        # f̂(0) is least or greatest where f̂ has a double root, and at the other end where a straight rod is a tip.
        double = linear_root(f_hat.subs(xi, -force / stiffness), constant)
        ends = (double, at_plus) if sign_of(stiffness) == 1 else (at_minus, double)
    return ends if diff(f_hat, constant) == 1 else (ends[1], ends[0])


def _claim_polynomial(case: LoadCase, book: Notebook) -> None:
    """f against the equation of motion: ½f′(ξ) is ξ″ (exsl12)."""
    at, any_constant = {xi: cos(theta)}, {case.constant.name: (0, 1)}
    second = -cos(theta) * case.f_hat.subs(at) - sin(theta) * case.angular_acceleration
    motion = Equal(diff(case.f, xi).subs(at) / 2, second)
    where, name = case.domain(theta=(0, pi), **any_constant), f"quartic.{case.name}"
    source = case.source("quartic")
    steps: tuple[str, ...] = ("plane.square", "plane.moment")
    book.claim(f"{name}.motion", "½f′ is ξ″", motion, domain=where, steps=steps, source=source)
    where = case.domain(xi=COSINES, **any_constant)
    shape = Equal(case.f_hat, case.f_hat.subs(xi, 0) - 2 * case.force * xi - case.stiffness * xi**2)
    steps = ("plane.first_integral",)
    book.claim(f"{name}.levels", "f̂ = Γ − 2Bξ − Hξ²", shape, domain=where, steps=steps, source=source)
    # The two meanings of the constant: exsl8, and f̂(0) = ±(the constant).
    energy = Equal(case.f_hat, case.gamma - 2 * case.tip_force * xi - case.field_work)
    steps = ("plane.first_integral", "plane.energy")
    levels = case.source("first integral")
    book.claim(f"{name}.gamma", "f̂ = γ − 2βξ + 2ψ", energy, domain=where, steps=steps, source=levels)
    title = f"f̂(0) is {'−γ̄' if case.constant == gamma_bar else 'γ'}"
    start = Equal(case.f_hat.subs(xi, 0) * diff(case.f_hat, case.constant), case.constant)
    steps = (f"{name}.levels", f"{name}.gamma")
    book.claim(f"{name}.constant", title, start, domain=where, steps=steps, source=source)
    if case.constant == gamma_bar:
        whole = Equal(case.gamma + gamma_bar, case.field_work.subs(xi, 0))
        steps = (f"{name}.gamma", f"{name}.constant")
        book.claim(f"{name}.gamma_bar", "γ + γ̄ = η", whole, domain=where, steps=steps, source=levels)


def _claim_roots(case: LoadCase, book: Notebook) -> None:
    """The roots of f̂, and the boundary condition (exsl14, exsl23)."""
    source, name = case.source("roots"), f"quartic.{case.name}"
    levels = f"{name}.levels"
    where = case.domain(**{case.constant.name: case.ends})
    for letter, root in zip(case.letters, case.roots, strict=True):
        zero = Equal(case.f_hat.subs(xi, root), 0)
        title = f"ξ_{letter} is a root of f̂"
        book.claim(f"{name}.root_{letter}", title, zero, domain=where, steps=(levels,), source=source)
    where = case.domain(xi_tip=COSINES, xi=COSINES)
    free = Equal(case.at_tip.subs(xi, xi_tip), 0)
    # exsl1, exsl2: the moment is EI times the curvature, and f̂ is the square of that.
    title, steps = "no moment at the free end", ("equilibrium.constitutive", levels)
    book.claim(f"{name}.free_end", title, free, domain=where, steps=steps, source=case.source("free end"))
    if case.other_root is not None:
        factors = Equal(case.at_tip, -case.stiffness * (xi - xi_tip) * (xi - case.other_root))
        steps = (levels, f"{name}.free_end")
        book.claim(f"{name}.factors", "f̂ by its two roots", factors, domain=where, steps=steps, source=source)


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("quartic")


if __name__ == "__main__":
    main()
