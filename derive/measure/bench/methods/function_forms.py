"""Weierstrass's functions in the forms that they can be evaluated in, for the real axis of a real lattice.

q-series: `emit/kernels/weierstrass.py`, from which the output `literal` of a scene is emitted, on arrays; and its
mpmath twin, point by point. AGM: descending Landen transformations of sn, and of E for ζ (DLMF 22.20(ii), 19.8(i)).
Carlson: R_F inverted by Newton's method, in the root of ℘ − e₁, which is smooth at the half-period (DLMF 19.25.35).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from types import ModuleType
from typing import Any

import numpy as np
from mpmath import mp, mpf

from derive.emit.kernels import carlson, weierstrass
from derive.measure.bench.cells import OURS, VARIANT, Call, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.bench.methods.emitted import DIGITS, DOUBLES, LOST, ready
from derive.measure.bench.methods.rod_solver import Array
from derive.measure.bench.tasks.functions import Lattice

SERIES = {"p": "wp", "zeta": "wzeta", "sigma": "wsigma"}
MOST_STEPS = 40


def series_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """On arrays."""
    if problem.task == "T5":
        given = problem.inputs
        call = partial(getattr(weierstrass, SERIES[given.kind]), given.u, given.g2, given.g3)
        # Near a zero the error counts against a small value.
        yield Cell("array", ready(call), DOUBLES, lambda found: found.real.tolist(), all_found=True)


def twin_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """At many digits, at the points that have references."""
    if problem.task == "T5" and plan.emitted and not plan.quick:
        for digits in DIGITS:
            call = twin(plan.emitted("literal_mpmath"), problem.inputs, digits)
            share = len(problem.inputs.sample) / problem.units
            yield Cell(f"{digits} digits", ready(call), LOST * 10.0**-digits, share=share, all_found=True)


def twin(module: ModuleType, given: Lattice, digits: int) -> Call:
    """σ by the exponential of the logarithm that the article's formulas need."""
    points = [mpf(x) for x in given.u[given.sample].tolist()]
    function = getattr(module, {"p": "wp", "zeta": "wzeta", "sigma": "wlog_sigma"}[given.kind])

    def call() -> list[Any]:
        with mp.workdps(digits):
            found = [function(x, mpf(given.g2), mpf(given.g3)) for x in points]
            return [mp.re(mp.exp(value) if given.kind == "sigma" else value) for value in found]

    return call


def agm_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """℘ and ζ."""
    by_agm: dict[str, Callable[[Lattice], Array]] = {"p": wp_agm, "zeta": wzeta_agm}
    if problem.task == "T5" and problem.inputs.kind in by_agm:
        call = partial(by_agm[problem.inputs.kind], problem.inputs)
        yield Cell("array", ready(call), 1e-11, lambda found: found.tolist())


def descended(z: Array, m: float) -> tuple[Array, Array, Array, Array]:
    """sn, cn, dn and E(am z) by the means of 1 and k′, down and up again (DLMF 22.20.3 to 22.20.5, 19.8.9)."""
    a, b, c = [1.0], float(np.sqrt(1 - m)), [float(np.sqrt(m))]
    while abs(c[-1]) > np.finfo(float).eps * a[-1]:
        c.append((a[-1] - b) / 2)
        a_next, b = (a[-1] + b) / 2, float(np.sqrt(a[-1] * b))
        a.append(a_next)
    share = 1 - sum(2.0 ** (n - 1) * part * part for n, part in enumerate(c))  # E/K
    phase, growing = 2.0 ** (len(a) - 1) * a[-1] * z, np.zeros_like(z)
    for n in range(len(a) - 1, 0, -1):
        growing += c[n] * np.sin(phase)
        phase = (phase + np.arcsin(c[n] / a[n] * np.sin(phase))) / 2
    sn, cn = np.sin(phase), np.cos(phase)
    return sn, cn, np.sqrt(1 - m * sn * sn), share * z + growing


def scaled(given: Lattice) -> tuple[float, float, float]:
    """√(e₁ − e₃), m and e₃ (DLMF 23.6(ii))."""
    e1, e2, e3 = given.values
    return float(np.sqrt(e1 - e3)), (e2 - e3) / (e1 - e3), e3


def wp_agm(given: Lattice) -> Array:
    """℘ = e₃ + (e₁ − e₃)/sn²."""
    root, m, e3 = scaled(given)
    return np.asarray(e3 + (root / descended(root * given.u, m)[0]) ** 2)


def wzeta_agm(given: Lattice) -> Array:
    """ζ, the integral of −℘: −e₃u − √(e₁ − e₃)(z − E(am z) − cn z dn z/sn z), z = √(e₁ − e₃)·u."""
    root, m, e3 = scaled(given)
    z = root * given.u
    sn, cn, dn, second = descended(z, m)
    return np.asarray(root * (cn * dn / sn + second - z) - e3 * given.u)


def carlson_cells(problem: Problem, plan: Plan) -> Iterator[Cell]:
    """℘, point by point."""
    if problem.task == "T5" and problem.inputs.kind == "p":
        given = problem.inputs
        points, share = given.u[given.sample].tolist(), len(given.sample) / problem.units
        yield Cell("Newton", ready(lambda: [wp_carlson(x, given) for x in points]), 1e-11, share=share)


def wp_carlson(u: float, given: Lattice) -> float:
    """R_F(t², t² + e₁ − e₂, t² + e₁ − e₃) = u solved for t = √(℘ − e₁) by Newton's method."""
    e1, e2, e3 = given.values
    period = 2 * given.half_periods[0]
    u = abs(u - period * round(u / period))
    t = 1 / u
    for _ in range(MOST_STEPS):
        p, q = t * t + e1 - e2, t * t + e1 - e3
        step = (carlson.rf(t * t, p, q) - u) * float(np.sqrt(p * q))
        t = max(t + step, t / 4)
        if abs(step) <= 2 * np.finfo(float).eps * t:
            break
    return t * t + e1


METHODS = (
    Method("q-series, NumPy", OURS, series_cells),
    Method("q-series, mpmath", OURS, twin_cells),
    Method("AGM, NumPy", VARIANT, agm_cells),
    Method("Carlson, Python", VARIANT, carlson_cells),
)
