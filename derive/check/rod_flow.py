"""The rod from its tip, for whole intervals of tip angles and fields at once, with rigorous error bounds.

With τ = (ℓ − s)/ℓ the rod obeys θ̈ = B sin θ + (H/2) sin 2θ, B = βℓ², H = ηℓ² (−ηℓ² for a field across the force),
θ = t and θ̇ = 0 at the tip. With S = sin θ, C = cos θ it is a polynomial system, so that its Taylor coefficients are
products of series: Ṡ = Cω, Ċ = −Sω, ω̇ = S(B + HC). Each step adds the remainder, which is the next coefficient
somewhere in a box that holds the whole step: |θ̈| ≤ B + |H|/2 and, for the derivatives by t and H, Gronwall's lemma
give the box.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from derive.check.balls import Array, Ball, exactly, rational, series_product, sine_cosine, unbounded

LEAST_STEPS = 8  # a power of two, so that the step is exact
FINE = 0.4  # the greatest √(B + |H|) times the step
ORDER = 14

AUXILIARY = ("pull", "stiff")
OVER = [rational(Fraction(1, n)) for n in range(1, ORDER + 1)]
OVER.insert(0, OVER[0])  # 1/n at place n; place 0 is not used

State = dict[str, Ball]


@dataclass(frozen=True)
class Clamp:
    """What tips arrive at. angle: θ at the clamp; y, z: the tip's position over ℓ; by_tip, by_field: derivatives."""

    angle: Ball
    y: Ball
    z: Ball
    by_tip: State
    by_field: State


@unbounded
def integrate(tip: Ball, force: Ball, field: Ball, *, derivatives: bool = True) -> Clamp:
    """From tips θ = t to the clamp, for B and H. All balls have the shape of ``tip``, or hold one number."""
    sine, cosine = sine_cosine(tip)
    zero, one = exactly(np.zeros_like(tip.mid)), exactly(np.ones_like(tip.mid))
    # θ, ω, S, C, y, z; h, g: ∂θ/∂t and its rate; p, q: ∂θ/∂H and its rate; and the derivatives of y, z.
    state = {"theta": tip, "omega": zero, "S": sine, "C": cosine, "y": zero, "z": zero}
    if derivatives:
        state |= {"h": one} | dict.fromkeys(("g", "p", "q", "y_h", "z_h", "y_p", "z_p"), zero)
    steps = LEAST_STEPS
    while np.max(np.sqrt(force.size() + field.size())) / steps > FINE:
        steps *= 2
    for _ in range(steps):
        state = _advanced(state, force, field, 1.0 / steps, ORDER)
    by_tip, by_field = (
        {"angle": state[angle], "y": state[y], "z": state[z]} if derivatives else {}
        for angle, y, z in (("h", "y_h", "z_h"), ("p", "y_p", "z_p"))
    )
    return Clamp(state["theta"], state["y"], state["z"], by_tip, by_field)


def _advanced(state: State, force: Ball, field: Ball, step: float, order: int) -> State:
    """One step: the Taylor polynomial from the state, and the remainder from the box."""
    series = _coefficients(state, force, field, order - 1)
    rest = _coefficients(_box(state, force, field, step), force, field, order)
    found = {}
    for name in state:
        total = rest[name][order].scaled(step)
        for k in range(order - 1, 0, -1):
            total = (total + series[name][k]).scaled(step)
        found[name] = total + state[name]
    return found


def _box(state: State, force: Ball, field: Ball, step: float) -> State:
    """Balls that hold the solutions during a step."""
    pull = np.maximum(force.size() + field.size(), 1e-3)
    rate = np.sqrt(pull) * (1 + 1e-12)
    grown = 1.001 / (1 - rate * step)  # at least exp(rate · step)
    turn = step * pull * 1.001  # ω changes by less
    way = step * (state["omega"].size() + turn) * 1.001
    moves: dict[str, Array | float] = {
        "omega": turn,
        "theta": way,
        "S": way,
        "C": way,
        "y": step * 1.001,
        "z": step * 1.001,
    }
    if "h" not in state:
        return {name: ball.wider(moves[name] * 1.001) for name, ball in state.items()}
    most = (rate * state["h"].size() + state["g"].size()) * grown * 1.001  # rate·|h| + |g| grows like exp(rate · τ)
    forced = (rate * state["p"].size() + state["q"].size() + step) * grown * 1.001  # and is driven by |sin 2θ|/2
    moves |= {"h": step * most, "g": step * rate * most, "p": step * forced, "q": step * (rate * forced + 1)}
    moves |= {"y_h": step * most / rate, "z_h": step * most / rate}
    moves |= {"y_p": step * forced / rate, "z_p": step * forced / rate}
    return {name: ball.wider(moves[name] * 1.001) for name, ball in state.items()}


def _coefficients(state: State, force: Ball, field: Ball, last: int) -> State:
    """Taylor coefficients 0 … last of everything, along the first axis."""
    shape = np.broadcast_shapes(*(ball.mid.shape for ball in (state["theta"], force, field)))
    found = {name: _Series(last + 1, shape) for name in (*state, *AUXILIARY)}
    for name, ball in state.items():
        found[name].put(0, ball)
    for k in range(last):
        upto = {name: series.upto(k) for name, series in found.items()}
        rates = _rates(upto, found, k, force, field)
        if "h" in state:
            rates |= _derived_rates(upto, found, k, force, field)
        for name, rate in rates.items():
            found[name].put(k + 1, rate * OVER[k + 1])
    return {name: found[name].upto(last) for name in state}


def _rates(upto: State, found: dict[str, _Series], k: int, force: Ball, field: Ball) -> State:
    """The coefficients of order k of the derivatives of the rod itself."""
    S, C, omega = upto["S"], upto["C"], upto["omega"]
    pull = field * C[k]  # of B + HC
    found["pull"].put(k, pull + force if k == 0 else pull)
    return {
        "theta": omega[k],
        "omega": series_product(S, found["pull"].upto(k)),
        "S": series_product(C, omega),
        "C": -series_product(S, omega),
        "y": C[k],
        "z": S[k],
    }


def _derived_rates(upto: State, found: dict[str, _Series], k: int, force: Ball, field: Ball) -> State:
    """The same of the derivatives by t and H: ḧ = (BC + H(2C² − 1))h, p̈ the same with SC = ½ sin 2θ added."""
    S, C, h, p = upto["S"], upto["C"], upto["h"], upto["p"]
    stiff = force * C[k] + (field * series_product(C, C)).scaled(2.0)
    found["stiff"].put(k, stiff - field if k == 0 else stiff)
    stiffness = found["stiff"].upto(k)
    return {
        "h": upto["g"][k],
        "g": series_product(stiffness, h),
        "p": upto["q"][k],
        "q": series_product(stiffness, p) + series_product(S, C),
        "y_h": -series_product(S, h),
        "z_h": series_product(C, h),
        "y_p": -series_product(S, p),
        "z_p": series_product(C, p),
    }


class _Series:
    """Coefficients of a power series, filled from the first."""

    def __init__(self, length: int, shape: tuple[int, ...]) -> None:
        self.mid: Array = np.zeros((length, *shape))
        self.rad: Array = np.zeros((length, *shape))

    def put(self, k: int, ball: Ball) -> None:
        """Set coefficient k."""
        self.mid[k], self.rad[k] = ball.mid, ball.rad

    def upto(self, k: int) -> Ball:
        """Coefficients 0 … k."""
        return Ball(self.mid[: k + 1], self.rad[: k + 1])
