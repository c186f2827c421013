"""SciPy's special functions: R_F and R_J for an equilibrium, Jacobi's functions for its shape.

Set up: with t = tan((θ − φ)/2), seen from the tip φ, (dt/dσ)² is a quartic with a root at t = 0, and X = b/t, b =
θ″(φ)/4, runs along a cubic; its roots are found by `numpy.roots`. The length of a monotone rod is R_F of the three
gaps at the clamp, solved for φ by `scipy.optimize.brentq` around the guess to the last digit; the position is one
complex R_J. For a shape X(σ) follows from sn² (three real roots) or the amplitude (one), and R_J at every point. Rods
that are not monotone, that is most unstable ones, are beyond it as they are beyond the books' formulas.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from derive.measure.bench.cells import PEER, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.methods.rod_solver import Array, RodSolver, Solved, couple, stiffness
from derive.measure.reference import Rod

AROUND = (0.02, 0.05, 0.1, 0.2)  # half-widths of brackets that are tried


def cubic(rod: Rod, tip: float) -> tuple[float, Any]:
    """b, and the roots of (dX/dσ)²/4 as a cubic in X = b cot((θ − φ)/2)."""
    moment, lean = float(couple(rod, tip)), rod.eta / 2 * np.sin(2 * (tip - rod.field_angle))
    # With w = cot: (dw/dσ)² = p w³ + q w² + m w + β cos φ, and b = p/4 makes the leading coefficient of X 4.
    return moment / 4, moment / 4 * np.roots(
        [moment, float(stiffness(rod, tip)), rod.beta * np.sin(tip) - lean, rod.beta * np.cos(tip)]
    )


def gaps(rod: Rod, tip: float, cotangent: Any) -> tuple[float, Any]:
    """b and X less each root."""
    b, roots = cubic(rod, tip)
    return b, b * np.asarray(cotangent)[..., None] - roots


def length(rod: Rod, tip: float) -> float:
    """The length of the monotone rod that has this tip angle."""
    from scipy.special import elliprf

    if tip == rod.clamp_angle:
        return np.inf
    _, apart = gaps(rod, tip, 1 / np.tan((rod.clamp_angle - tip) / 2))
    return float(np.real(elliprf(*apart.astype(complex))))


def position(tip: float, b: float, arc: Any, apart: Any, x: Any) -> Any:
    """y + iz from a point to the tip."""
    from scipy.special import elliprj

    third = elliprj(*np.moveaxis(apart.astype(complex), -1, 0), x - 1j * b)
    return np.exp(1j * tip) * (arc + 2j * b / 3 * third)


def solve(rod: Rod, tip_angle: float, _: Any = None) -> Solved | None:
    """The equilibrium with a tip near the guess, if it is monotone, or None."""
    from scipy.optimize import brentq

    for width in AROUND:
        ends = (tip_angle - width, tip_angle + width)
        miss = [length(rod, end) - rod.length for end in ends]
        if np.all(np.isfinite(miss)) and miss[0] * miss[1] < 0:
            break
    else:
        return None
    tip = float(brentq(lambda at: length(rod, at) - rod.length, *ends, xtol=1e-15, rtol=1e-15))
    b, apart = gaps(rod, tip, 1 / np.tan((rod.clamp_angle - tip) / 2))
    whole = complex(position(tip, b, rod.length, apart, b / np.tan((rod.clamp_angle - tip) / 2)))

    def at(s: Array) -> tuple[Array, Array, Array]:
        arc = np.maximum(rod.length - s, 1e-12 * rod.length)  # X is infinite at the tip
        b, roots = cubic(rod, tip)
        x = along(roots, arc)
        to_tip = position(tip, b, arc, x[..., None] - roots, x)
        return tip + 2 * np.arctan(b / x), np.real(whole - to_tip), np.imag(whole - to_tip)

    return Solved(tip, whole.real, whole.imag, at)


def along(roots: Any, arc: Array) -> Array:
    """X at distances from the tip: Weierstrass's function of them, up to a constant, by Jacobi's functions."""
    from scipy.special import ellipj

    real = np.sort(roots.real)[::-1]
    if np.max(np.abs(roots.imag)) <= 1e-9 * np.max(np.abs(roots)):
        e1, e2, e3 = real
        sn = ellipj(np.sqrt(e1 - e3) * arc, (e2 - e3) / (e1 - e3))[0]
        return np.asarray(e3 + (e1 - e3) / sn**2)
    alone = roots[np.argmin(np.abs(roots.imag))].real
    other = roots[np.argmax(roots.imag)]
    size = abs(alone - other)
    # (1 + cn)/(1 − cn) by the amplitude, which keeps its digits where cn is near 1.
    amplitude = ellipj(2 * np.sqrt(size) * arc, 0.5 + (other.real - alone) / (2 * size))[3]
    return np.asarray(alone + size / np.tan(amplitude / 2) ** 2)


def wp(u: Array, roots: tuple[float, float, float]) -> Array:
    """℘ on the real axis of a real lattice, by `ellipj`: what SciPy has of Weierstrass's functions."""
    from scipy.special import ellipj

    e1, e2, e3 = roots
    sn = ellipj(np.sqrt(e1 - e3) * u, (e2 - e3) / (e1 - e3))[0]
    return np.asarray(e3 + (e1 - e3) / sn**2)


def alone(number: int) -> Any:
    """Jacobi's functions at as many points."""
    from scipy.special import ellipj

    arguments = np.linspace(0.0, 3.0, number)
    return lambda: ellipj(arguments, 0.7)


def jacobi_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """T3: what nothing that calls `ellipj` at every point is faster than. T5: ℘."""
    given = problem.inputs
    if problem.task == "T3":
        yield Cell("no rod", lambda: alone(len(given[2])), 0.0, lambda _: [None] * 3, whole=False)
    if problem.task == "T5" and given.kind == "p":
        yield Cell("array", lambda: lambda: wp(given.u, given.values), 1e-10)


SOLVER = RodSolver(
    "SciPy R_F, R_J, ellipj",
    solve,
    settings=(None,),
    quick=(None,),
    spelled=lambda _: "brentq",
    limit=lambda _: 1e-11,
    tasks=("T1", "T3"),
)
METHODS = (SOLVER.method("scipy"), Method("SciPy ellipj", PEER, jacobi_cells, ("scipy",)))
