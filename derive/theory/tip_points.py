"""Formulas of ℘ at the tip's expansion: b, the half-period values less c, and ℘ less each of them at a point."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from sympy import Expr, Integer, cancel, diff

from .claims import Equal, Limit
from .load_case import COSINES, LoadCase, xi_tip
from .symbols import beta, eta, xi
from .tip_names import Writer, drive, drop, gap, level, minus, one_minus, one_plus, plus
from .weierstrass import Weierstrass

SIGNS = {"plus": 1, "minus": -1}  # the roots 1 and −1 of f


def write_roots(case: LoadCase, functions: Weierstrass, roots: Mapping[str, Expr], writer: Writer) -> None:
    """b, and the half-period values less c and less each other."""
    named, b, c = writer.named, functions.at_tip.b, functions.at_tip.c
    slope = diff(case.at_tip * (1 - xi**2), xi).subs(xi, xi_tip)
    writer.add(
        "pole_strength",
        (plus, minus, drive),
        named(b, plus, minus, drive),
        "b = f′(ξ(ℓ))/4: ξ = ξ(ℓ) + b/(℘ − c)",
        lambda value: Equal(4 * value, slope),
        steps=("weierstrass.at_tip", "quartic.free_end"),
        source="strength",
    )
    at_tip = {case.constant: case.tip_constant}
    g2, g3 = functions.g2.subs(at_tip), functions.g3.subs(at_tip)
    arguments = {"plus": (plus, drive), "minus": (minus, drive), "other": (eta, plus, minus)}
    written = {}
    for side, value in roots.items():
        names = tuple(name for name in arguments[side] if name is not eta)
        # A root of 4ϰ³ − g₂ϰ − g₃ ...
        written[side] = writer.add(
            f"root_{side}",
            arguments[side],
            named(value, *names),
            f"the half-period value e_{side} less c",
            lambda e: Equal(4 * (e + c) ** 3 - g2 * (e + c) - g3, 0),
            steps=("weierstrass.at_tip",),
            source="expansion",
        )
        # ... and the one at which ξ is 1, −1 or ξ_o.
        root = SIGNS.get(side, case.other_root)
        if root is not None:
            there = Equal(written[side] * (root - xi_tip), b)
            steps = [f"tip.root_{side}", "tip.pole_strength"]
            if side == "other":
                steps.append("quartic.factors")
            title = f"ξ = {root} where ℘ = e_{side}"
            writer.claim(f"root_{side}_place", title, there, steps=steps, source="expansion")
    pairs = {
        "gap_minus_plus": ("minus", "plus", (drive,)),
        "gap_other_plus": ("other", "plus", (beta, eta, plus)),
        "gap_other_minus": ("other", "minus", (minus, gap)),
    }
    for name, (one, two, arguments_) in pairs.items():
        names = tuple(symbol for symbol in arguments_ if symbol not in (beta, eta))
        writer.add(
            name,
            arguments_,
            named(cancel(roots[one] - roots[two]), *names),
            f"e_{one} − e_{two}",
            _step(written[two], written[one]),
            steps=(f"tip.root_{one}", f"tip.root_{two}"),
            source="none",
        )


def write_points(case: LoadCase, b: Expr, roots: Mapping[str, Expr], writer: Writer) -> None:
    """℘ less c and less each half-period value at a point of the rod, by ξ there."""
    named, pole = writer.named, b / (xi - xi_tip)
    arguments = {
        "plus": (plus, drive, one_minus, drop),
        "minus": (minus, drive, one_plus, drop),
        "other": (plus, minus, level, drop),
    }
    written = {}
    for side, names in arguments.items():
        written[side] = writer.add(
            f"point_{side}",
            names,
            named(cancel(pole - roots[side]), *names),
            f"x_{side} = ℘ − e_{side} at the point where cos θ = ξ",
            _above(roots[side], b),
            steps=(f"tip.root_{side}", "tip.pole_strength"),
            source="solution",
        )
    strength = writer.add(
        "point_pole",
        (plus, minus, drive, drop),
        named(cancel(pole), plus, minus, drive, drop),
        "x_pole = ℘ − c at the point where cos θ = ξ",
        lambda value: Equal(xi_tip + b / value, xi),
        steps=("tip.pole_strength",),
        source="solution",
    )
    # ℘′² = 4 x₊x₋x_o = (d℘/dξ)² f(ξ): σ runs along the rod.
    cubic = 4 * written["plus"] * written["minus"] * written["other"]
    speed = diff(strength.subs(writer.meaning), xi) ** 2 * case.at_tip * (1 - xi**2)
    steps = (*(f"tip.point_{side}" for side in (*written, "pole")), "quartic.motion")
    writer.claim("speed", "℘′² at a point of the rod", Equal(cubic, speed), steps=steps, source="substituted")
    # At the tip all of them are infinite, and the lengths start from zero.
    # On one side of the vertex b is of one sign.
    falls = COSINES if not case.bends else (case.vertex, 1) if case.bends == 1 else (COSINES[0], case.vertex)
    falling = case.steep(xi_tip=falls, xi=COSINES)
    for side, value in (*written.items(), ("pole", strength)):
        small = cancel(1 / value.subs(writer.meaning))
        zero = Limit(small, xi, xi_tip, Integer(0), "+-")
        steps, title = (f"tip.point_{side}",), f"x_{side} is infinite at the tip"
        writer.claim(f"point_{side}_tip", title, zero, falling, steps=steps, source="solution")


def _step(below: Expr, above: Expr) -> Callable[[Expr], Equal]:
    """The property of a difference: it leads from one value to the other."""
    return lambda value: Equal(value + below, above)


def _above(root: Expr, b: Expr) -> Callable[[Expr], Equal]:
    """The property of ℘ − e: with e − c it is b/(ξ − ξ(ℓ))."""
    return lambda value: Equal((value + root) * (xi - xi_tip), b)
