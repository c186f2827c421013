"""The user's own equation as plain data, and its numbers for one rod: all that the references know of an energy.

θ″ and the energy density are polynomials in the loads, cos α, sin α, cos θ and sin θ, read from the derivation before
anything is mapped on anything. Numbers are of any kind that can be added and multiplied: doubles or mpf.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import prod
from typing import Any

# Terms: numerator, denominator, and the exponents of the loads, cos α, sin α, cos θ, sin θ.
Terms = list[tuple[int, int, list[int]]]
# A polynomial in cos θ and sin θ by its exponents (i, j), j ≤ 1.
Trigonometric = dict[tuple[int, int], Any]


def law_of(density: Any, acceleration: Any, w: Any, loads: tuple[str, ...]) -> dict[str, Any]:
    """The law of a rod: "loads", their names, and the terms of "couple" (θ″) and "density" (ψ(w) − β cos θ).

    density: ψ in w. acceleration: θ″ in θ and α; both in the letters β and those named in ``loads``.
    """
    from sympy import Poly, Symbol, cos, expand_trig, sin

    from derive.theory.symbols import alpha, beta, theta

    letters = {symbol.name: symbol for symbol in (density + acceleration).free_symbols} | {"beta": beta}
    angles = [cos(alpha), sin(alpha), cos(theta), sin(theta)]
    plain = [Symbol(name) for name in ("cos_field", "sin_field", "cos", "sin")]
    generators = [*(letters[name] for name in loads), *plain]

    def terms(expr: Any) -> Terms:
        written = expand_trig(expr).expand().subs(dict(zip(angles, plain, strict=True)))
        found = Poly(written, *generators).terms()
        return [(int(value.p), int(value.q), list(map(int, powers))) for powers, value in found]

    whole = density.subs(w, cos(theta - alpha)) - beta * cos(theta)
    return {"loads": list(loads), "couple": terms(acceleration), "density": terms(whole)}


def at_loads(terms: Terms, loads: list[Any], cosine: Any, sine: Any, number: Callable[[int], Any]) -> Trigonometric:
    """A polynomial of the law for one rod: its loads, and the cosine and sine of its field angle."""
    found: Trigonometric = {}
    for over, under, powers in terms:
        *given, i, j = powers
        factors = [base**power for base, power in zip([*loads, cosine, sine], given, strict=True) if power]
        _add(found, i, j, prod(factors, start=number(over)) / number(under))
    return found


def _add(found: Trigonometric, i: int, j: int, value: Any) -> None:
    """Add value·cosⁱ sinʲ, with sin² = 1 − cos²."""
    if j > 1:
        _add(found, i, j - 2, value)
        _add(found, i + 2, j - 2, -value)
    else:
        found[i, j] = found.get((i, j), 0) + value


def slope(polynomial: Mapping[tuple[int, int], Any]) -> Trigonometric:
    """The derivative by θ."""
    found: Trigonometric = {}
    for (i, j), value in polynomial.items():
        if i:
            _add(found, i - 1, j + 1, -i * value)
        if j:
            _add(found, i + 1, j - 1, j * value)
    return found


def evaluate(polynomial: Mapping[tuple[int, int], Any], cosine: Any, sine: Any) -> Any:
    """The value at an angle of this cosine and sine."""
    return sum((value * cosine**i * sine**j for (i, j), value in polynomial.items()), start=0 * cosine)
