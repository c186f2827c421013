"""From the plane problem of an energy of one's own to the one that the solver knows, with the claims that say so.

An energy −τw − ½ηw² with w = d₃·e gives θ″ = β sin θ + τ sin(θ − α) + (η/2) sin 2(θ − α). The linear part acts like a
dead force τ along the field: with the force β it has a resultant of size B and angle ρ. In axes turned by ρ the rod is
the one of paramagnetic particles, under the force B and a field at the angle α − ρ; where η < 0, the field is turned by
a quarter and its modulus is −η.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from sympy import Expr, Integer, Matrix, Symbol, cancel, cos, diff, expand, expand_trig, oo, pi, sin

from derive.theory import symbols
from derive.theory.claims import Domain, Equal, Formula, Notebook
from derive.theory.letters import tau, w
from derive.theory.plane import Plane
from derive.theory.symbols import alpha, beta, gamma, theta, xi

eta = Symbol("eta", real=True)  # here of either sign
B = Symbol("B", positive=True)  # the resultant of the force and the linear part of the energy
rho = Symbol("rho", real=True)  # its angle from y
phi = Symbol("phi", real=True)  # θ − ρ
one, other, between = (Symbol(name, real=True) for name in ("one", "other", "between"))  # two forces, their angle
total, gap = Symbol("total", real=True), Symbol("gap", real=True)  # their sum and their difference

LINEAR, QUADRATIC = "tau", "eta"


@dataclass(frozen=True)
class Reduction:
    """What the solver needs to know of an energy.

    density: ψ(w), the energy per unit length over EI less its value at w = 0. acceleration: θ″ in θ and α.
    present: its moduli, of "tau" and "eta". along, across: the parts of the resultant along y and z. formulas: those
    that the emitted module evaluates besides the solver's.
    """

    density: Expr
    acceleration: Expr
    present: tuple[str, ...]
    along: Expr
    across: Expr
    formulas: tuple[Formula, ...]

    @property
    def equation(self) -> Expr:
        """θ″ by the variation of the energy (plane.variation), which is the shorter form."""
        return diff(self.density.subs(w, cos(theta - alpha)) - beta * cos(theta), theta)


def reduce_plane(own: Plane, book: Notebook) -> Reduction:
    """What the solver needs to know of an energy of degree 2 in w at most."""
    signed = {symbols.eta: eta}
    density, acceleration = own.energy_density.subs(signed), own.angular_acceleration.subs(signed)
    book.say("An energy of one's own. Its linear part joins the force")
    along, across = harmonics(acceleration)
    book.show("along y", along)
    book.show("along z", across)
    present = tuple(str(name) for name in (tau, eta) if density.has(name))
    formulas = tuple(write_resultant(along, across, book)) if LINEAR in present else ()
    return Reduction(density, acceleration, present, along, across, formulas)


def claim_reduction(found: Reduction, own: Plane, known: Plane, book: Notebook) -> None:
    """Claim that the plane problem ``own`` in turned axes is ``known``, the one that the solver's formulas are for."""
    for sign in (1, -1) if QUADRATIC in found.present else (0,):
        claim_law(found, own, known, sign, book)
    # d₃ = (cos θ, sin θ) is the derivative of the place: turned back by ρ, so is the place itself.
    back = Matrix([[cos(rho), -sin(rho)], [sin(rho), cos(rho)]]) * Matrix([cos(phi), sin(phi)])
    turn, domain = Equal(back, Matrix([cos(phi + rho), sin(phi + rho)])), Domain(dict.fromkeys((phi, rho), (-pi, pi)))
    book.claim("own.place", "the tangent, turned back", turn, domain=domain, steps=["plane.inextensible"])


def harmonics(acceleration: Expr) -> tuple[Expr, Expr]:
    """X and Z of the part X sin θ − Z cos θ of θ″: its values a half turn apart, halved, are that part alone."""
    turned = expand_trig(acceleration - acceleration.subs(theta, theta + pi)) / 2
    return tuple(expand(expand_trig(x)) for x in (turned.subs(theta, pi / 2), -turned.subs(theta, Integer(0))))  # type: ignore[return-value]


def write_resultant(along: Expr, across: Expr, book: Notebook) -> Iterable[Formula]:
    """The resultant of two forces with an angle between them, in forms in which nothing cancels.

    Where they nearly balance, the two terms along the first force are a difference of the sizes themselves and a small
    square: the resultant then has all the digits that the loads have.
    """
    forces = Domain({one: (-oo, oo), other: (-oo, oo), between: (-oo, oo)})
    roles = {beta: one, tau: other, alpha: between}
    # The sum and the difference of the sizes are arguments: they must be formed first, and not with the other term.
    forms = {
        "along_near": (total, one + other, total - 2 * other * sin(between / 2) ** 2, "less"),
        "along_opposed": (gap, one - other, gap + 2 * other * cos(between / 2) ** 2, "more"),
    }
    for name, (sizes, value, form, how) in forms.items():
        title = f"the part along the first of two forces {how} than a quarter turn apart, {sizes}: {value}"
        same = Equal(form.subs(sizes, value), along.subs(roles))
        book.claim(f"own.{name}", title, same, domain=forces, steps=["plane.moment"])
        yield Formula(name, (sizes, other, between), form, f"own.{name}", title)
    title = "the part across the first force, towards the other"
    aside = across.subs(roles)
    same = Equal(aside, other * sin(between))
    book.claim("own.across", title, same, domain=forces, steps=["plane.moment"])
    yield Formula("across", (other, between), aside, "own.across", title)
    # Seen from the field, the force is the other of the two, on the other side.
    seen = Matrix([along * cos(alpha) + across * sin(alpha), along * sin(alpha) - across * cos(alpha)])
    exchanged = Matrix([part.subs({beta: tau, tau: beta}, simultaneous=True) for part in (along, across)])
    title, where = (
        "seen from the field, force and linear part change places",
        Domain(dict.fromkeys((beta, tau), (0, oo))),
    )
    steps = ["own.along_near", "own.along_opposed", "own.across"]
    book.claim("own.exchange", title, Equal(seen, exchanged), domain=where.with_range(alpha), steps=steps)


def claim_law(found: Reduction, own: Plane, known: Plane, sign: int, book: Notebook) -> None:
    """In the turned axes the equation, the energy and the first integral are those that the solver knows.

    sign: of η. The resultant has the parts B cos ρ and B sin ρ; of these, β and τ are solved for.
    """
    name = {1: "bending", -1: "straightening", 0: "dead"}[sign]
    loads, domain = loads_of(found, sign)
    angle = alpha - rho + (pi / 2 if sign < 0 else 0)
    turned = {beta: B, symbols.eta: sign * eta if sign else 0, alpha: angle, theta: phi, xi: cos(phi)}

    def own_at(expr: Expr) -> Expr:
        at = {own.alignment: cos(phi + rho - alpha), xi: cos(phi + rho), theta: phi + rho}
        return expr.subs(symbols.eta, eta).subs(at).subs(loads)

    def known_at(expr: Expr) -> Expr:
        at = expr.subs(known.alignment, cos(phi - alpha)).subs(turned, simultaneous=True)
        return at.subs(rho, loads.get(rho, rho))

    least = eta if sign < 0 else Integer(0)  # of η cos² over all directions
    weight = own.energy_density - beta * xi, known.energy_density - beta * xi
    pairs = {
        "law": ("θ″", own_at(own.angular_acceleration), known_at(known.angular_acceleration), "plane.moment"),
        "energy": ("the energy", own_at(weight[0]), known_at(weight[1]) - least / 2, "plane.variation"),
        "gamma": (
            "γ",
            own_at(own.curvature_squared.subs(gamma, gamma + least)),
            known_at(known.curvature_squared),
            "plane.first_integral",
        ),
    }
    for kind, (what, left, right, step) in pairs.items():
        title = f"in the axes of the resultant, {what} is that of the known rod ({name})"
        book.claim(f"own.{name}_{kind}", title, Equal(left, right), domain=domain, steps=[step])


def loads_of(found: Reduction, sign: int) -> tuple[dict[Symbol, Expr], Domain]:
    """β and τ by the resultant's B and ρ, as far as the energy has them, and the domain of a claim."""
    ranges: dict[Symbol, tuple[Expr, Expr]] = {B: (Integer(0), oo), rho: (-pi, pi), phi: (-pi, pi), gamma: (-oo, oo)}
    ranges |= {alpha: (-pi, pi)} | ({eta: (Integer(0), oo) if sign > 0 else (-oo, Integer(0))} if sign else {})
    parts = Matrix([found.along - B * cos(rho), found.across - B * sin(rho)])
    if LINEAR not in found.present:
        # No linear part: the resultant is the force itself, ρ = 0.
        return {beta: B, rho: Integer(0)}, Domain(ranges)
    solved = _linear(parts, (beta, tau))
    return solved, Domain(ranges)


def _linear(parts: Matrix, unknown: tuple[Symbol, Symbol]) -> dict[Symbol, Expr]:
    """The solution of two linear equations, by Cramer's rule."""
    matrix = parts.jacobian(unknown)
    right = -parts.subs(dict.fromkeys(unknown, 0))
    return {
        letter: cancel(Matrix.hstack(*(right if k == j else matrix[:, j] for j in range(2))).det() / matrix.det())
        for k, letter in enumerate(unknown)
    }
