"""What an energy must be to be taken, each refusal in one line: what is wrong, and what mends it."""

from __future__ import annotations

import ast
import keyword
from collections.abc import Iterable, Mapping

from sympy import Expr, Float, I, Poly, nan, sympify, zoo

from derive.check.timing import TimeLimit, limited
from derive.emit.errors import choices
from derive.numbers import MistakeError
from derive.own_energy.curve import Curve
from derive.theory import energy as energy_script
from derive.theory.claims import Notebook
from derive.theory.energy import DIRECTION, Energy, H
from derive.theory.letters import w
from derive.theory.line_energy import of_alignment

SECONDS = 60.0  # in which the energy of a rod is worked out; polynomials take a few
TAKEN = "taken are energies of degree 1 and 2 in w = d3.e: permanent and paramagnetic particles, and both together"


def check_energy(energy: Energy) -> None:
    """MistakeError unless the energy is exact and real, of h·a alone, and by it a polynomial that is no constant."""
    if not isinstance(energy, Energy):
        raise MistakeError(f"an Energy(name, density) is wanted, not {energy!r}; see docs/own_energy.md")
    if not energy.name.isprintable() or not energy.name.strip() or set('"\\') & set(energy.name):
        raise MistakeError(
            f"the name of the energy, {energy.name!r}, must be printable text without quotes or backslashes"
        )
    check_letters(energy)
    psi = by_alignment(energy)
    if not psi.is_polynomial(w) or psi.has(nan, zoo):
        form = "undefined at w = 0" if psi.has(nan, zoo) else psi
        raise MistakeError(
            f"{whose(energy)} is not elliptic: by w = d3.e it is {form}, no polynomial, so the square of a rod's "
            f"curvature is none in cos(theta) and sin(theta), and its length is no elliptic integral; {TAKEN}"
        )
    if Poly(psi, w).degree() < 1:
        raise MistakeError(
            f"{whose(energy)} does not depend on the direction of the rod; without a field, take force_only"
        )


def check_letters(energy: Energy) -> None:
    """MistakeError unless the density is exact and its letters are real."""
    density = density_of(energy)
    for number in density.atoms(Float):
        raise MistakeError(
            f"{whose(energy)} holds the float {number}; write it as an exact number, Rational(1, 2) for 0.5"
        )
    if density.has(I):
        raise MistakeError(f"{whose(energy)} holds the imaginary unit; it must be real")
    for letter in sorted(density.free_symbols - {*H, *DIRECTION}, key=str):
        if not letter.is_real:
            raise MistakeError(
                f"{whose(energy)} holds the letter {letter}, not known to be real; Symbol('{letter}', real=True)"
            )


def by_alignment(energy: Energy) -> Expr:
    """A · (energy per unit volume) by w, less its value at w = 0; MistakeError if it is no function of w."""
    try:
        with limited(SECONDS):
            energy_script.derive(energy, Notebook())
            return of_alignment(energy)
    except ValueError as error:
        raise MistakeError(str(error)) from error
    except TimeLimit as limit:
        raise MistakeError(
            f"{whose(energy)} could not be worked out in {SECONDS:g} s; write it as a polynomial in h.dot(a)"
        ) from limit


def density_of(energy: Energy) -> Expr:
    """The density as an expression in H and DIRECTION; MistakeError if it is none."""
    density = sympify(energy.density(H, DIRECTION), strict=True) if callable(energy.density) else None
    if not isinstance(density, Expr) or density.is_Matrix:
        kind = type(density).__name__
        raise MistakeError(
            f"{whose(energy)} must be a function density(h, a) that gives a scalar expression, no {kind}"
        )
    return density


def check_curve(energy: Energy, density: Expr, curve: Curve) -> None:
    """MistakeError if the first integral is not elliptic."""
    if curve.genus <= 1:
        return
    degree = curve.degree
    under = "4" if degree == 2 else f"4*(1 + t**2)**{degree - 2}" if degree > 3 else "4*(1 + t**2)"
    raise MistakeError(
        f"{whose(energy)} is not elliptic: the reduced energy {density} has degree {degree} in w = d3.e, so with "
        f"t = tan(theta/2) the first integral is (dt/ds)**2 = P(t)/({under}), P of degree {curve.numerator.degree()}, "
        f"a hyperelliptic curve of genus {curve.genus}, whose integrals no elliptic function inverts; {TAKEN}"
    )


def check_names(names: Mapping[str, str], present: Iterable[str], *interfaces: str) -> None:
    """MistakeError unless ``names`` gives moduli that are there names that the emitted interfaces have free."""
    present = tuple(present)
    # Every name that the interfaces use, but for the moduli that are to be renamed.
    nodes = [node for text in interfaces for node in ast.walk(ast.parse(text))]
    taken = (
        {n.id for n in nodes if isinstance(n, ast.Name)} | {n.arg for n in nodes if isinstance(n, ast.arg)} | {"dps"}
    )
    for letter, name in names.items():
        if letter not in present:
            raise MistakeError(f"names: the energy has no modulus '{letter}'{choices(letter, present)}")
        if not name.isidentifier() or not name.isascii() or keyword.iskeyword(name) or name.startswith("_"):
            raise MistakeError(f"names: '{name}' for {letter} is no name of a parameter; take a plain word")
        if name in taken - set(present) or (name in present and name not in names and name != letter):
            raise MistakeError(f"names: '{name}' for {letter} stands for something else in the module; choose another")
    if len(set(names.values())) < len(names):
        raise MistakeError("names: two moduli have one name; choose another for one of them")


def whose(energy: Energy) -> str:
    """How an energy is spoken of in a refusal."""
    return f"the energy of {energy.name}"
