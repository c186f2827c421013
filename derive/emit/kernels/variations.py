"""How the half-swing and the first arrival of a motion change with its tip angle and the loads, in closed form.

The rod's length on a branch is stationary in the tip angle exactly where ∂θ(0)/∂θ(ℓ) = 0, for on the branch
θ_σ dL + ∂θ(0)/∂θ(ℓ) dθ(ℓ) = 0: this is where two equilibria meet.
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, cos, epsilon, pick, sin, sqrt


class Change(NamedTuple):
    """The change of the tip angle and of the loads, along which a derivative is taken."""

    tip: float
    beta: float
    eta: float


class Numbers(NamedTuple):
    """Derivatives of the numbers of the Legendre form: of the logarithms of far/near, end and middle, and of the far
    turning point itself."""

    ratio: float
    end: float
    middle: float
    turn: float


def rates_of_times(beta, eta, field_angle, motion, phase, swing, arrival, change):
    """Derivatives of half-swing and first arrival along a change of tip angle and loads; the clamp angle stays.

    phase, swing, arrival: of the motion.

    dI = −(S + X) dlog a − (C − X) dlog b + dψ/Δ for I = ∫dψ/Δ, Δ² = a² cos²ψ + b² sin²ψ, with S = ∫sin²ψ/Δ,
    C = ∫cos²ψ/Δ and X = sin ψ cos ψ/Δ (DLMF 19.4(i), there for E, F and k).
    """
    numbers = changes_of_numbers(beta, eta, field_angle, motion, change)
    a, b = motion.end, motion.middle
    square, rest = phase.square, phase.rest
    all_sine, sine = sine_part(a / 2, b / 2, 1, 0, swing), sine_part(a / 2, b / 2, square, rest, arrival)
    speed = sqrt(a * a * rest + b * b * square) / 2
    across = sqrt(square * rest)
    # ψ moves against χ: sin²ψ = a(1 − cos χ)/(a + Δ_χ). Δ_χ − a cos χ without cancellation:
    forth = (a + phase.delta) * rest
    done, left = sqrt(motion.far) * motion.done_sine, sqrt(motion.near) * motion.left_sine
    sine_chi = 2 * sqrt(done * left) / phase.whole
    first = forth >= phase.delta
    behind = pick(first, (b * sine_chi) * (b * sine_chi) / pick(first, forth, 1), 2 * phase.delta - forth)
    moved = across * behind * (numbers.end - numbers.middle) / (2 * phase.delta * speed)
    near_cot = cos(motion.done / 2) / motion.done_sine * change.tip
    far_cot = cos(motion.left / 2) / motion.left_sine * numbers.turn
    clamped = sine_chi * (numbers.ratio - near_cot - far_cot) / (4 * phase.delta)
    edge = across / speed
    swing_rate = -all_sine * numbers.end - (swing - all_sine) * numbers.middle
    arrival_rate = -(sine + edge) * numbers.end - (arrival - sine - edge) * numbers.middle + moved + clamped
    return swing_rate, arrival_rate


def changes_of_numbers(beta, eta, field_angle, motion, change):
    """Derivatives of the turning pair (V stays equal at its ends) and of the numbers made from it."""
    tip, half, sine = motion.tip, motion.half_width, motion.sine
    cosine, middle, turn = cos(half), tip + half, tip + 2 * half
    cos_middle, sin_middle = cos(middle), sin(middle)
    double_cos, double_sin = cos(2 * (middle - field_angle)), sin(2 * (middle - field_angle))
    loads = sine * (cosine * double_sin * change.eta + 2 * sin_middle * change.beta)
    d_turn = (loads - motion.near_moment * change.tip) / motion.far_moment
    d_half, d_middle = (d_turn - change.tip) / 2, (d_turn + change.tip) / 2
    cot = cosine / sine * d_half
    near = moment_rate(beta, eta, field_angle, tip, change.tip, change) / motion.near_moment - cot
    far = -moment_rate(beta, eta, field_angle, turn, d_turn, change) / motion.far_moment - cot
    ratio = change_of_ratio(beta, eta, field_angle, motion, change, loads / motion.far_moment)
    product = sqrt(motion.near) * sqrt(motion.far)
    d_product = product * (near + far) / 2
    wide = 1 + cosine * cosine
    excess = -(2 * beta * cos_middle * cosine + eta * double_cos * wide)
    d_excess = 2 * (beta * cos_middle + eta * double_cos * cosine) * sine * d_half
    d_excess = d_excess + 2 * (beta * sin_middle * cosine + eta * double_sin * wide) * d_middle
    d_excess = d_excess - 2 * cos_middle * cosine * change.beta - double_cos * wide * change.eta
    square = 4 * motion.middle * motion.middle
    if excess >= 0:
        return Numbers(ratio, (near + far) / 4, (d_product + d_excess) / (2 * square), d_turn)
    mean = -(2 * beta * cos_middle + eta * cosine * double_cos)
    d_mean = 2 * (beta * sin_middle + eta * cosine * double_sin) * d_middle + eta * sine * double_cos * d_half
    d_mean = d_mean - 2 * cos_middle * change.beta - cosine * double_cos * change.eta
    below = product - excess
    # 4·middle² = sin²D (mean − η)(mean + η)/below, in which mean − η is told by the rest.
    apart = square * below / (sine * sine * (mean + eta))
    logarithm = 2 * cot + (d_mean - change.eta) / apart + (d_mean + change.eta) / (mean + eta)
    logarithm = logarithm - (d_product - d_excess) / below
    return Numbers(ratio, (near + far) / 4, logarithm / 2, d_turn)


def change_of_ratio(beta, eta, field_angle, motion, change, d_turn):
    """The derivative of log(far/near); d_turn: of the far turning point by the loads alone.

    What the tip does to it is put by the condition of turning pairs, by which far − near is 2η sin 2(middle − α) times
    sin(half_width): where the motion is nearly a whole turn both logarithms change much and alike.
    """
    tip, near, far = motion.tip, motion.near, motion.far
    turn = tip + 2 * motion.half_width
    stiffness = beta * cos(tip) + eta * cos(2 * (tip - field_angle))
    by_tip = 6 * cos(motion.half_width) * near * near + 4 * stiffness * (near + far)
    by_near = moment_rate(beta, eta, field_angle, tip, 0, change) / motion.near_moment
    by_far = moment_rate(beta, eta, field_angle, turn, d_turn, change) / motion.far_moment
    skew = motion.uneven * (sqrt(near) + sqrt(far)) / (2 * motion.sine)
    return -by_tip * skew / (near * far * far) * change.tip - by_far - by_near


def moment_rate(beta, eta, field_angle, angle, d_angle, change):
    """The derivative of θ″ at an angle that changes too."""
    lean = angle - field_angle
    stiffness = beta * cos(angle) + eta * cos(2 * lean)
    return stiffness * d_angle + sin(angle) * change.beta + sin(2 * lean) / 2 * change.eta


def sine_part(a, b, square, rest, arrival):
    """∫sin²ψ/√(a² cos²ψ + b² sin²ψ) over the same range as ``arrival``, the integral without sin²ψ.

    ``second_kind`` over b² − a², which is taken out of each of its terms: aₖ₊₁² − bₖ₊₁² = (aₖ − bₖ)²/4.
    """
    limit, more, weight, total = 2 * epsilon() ** 0.5, True, 1, 0
    while more:
        more = any_of(abs(a - b) > limit * a)
        delta = sqrt(a * a * rest + b * b * square)
        total = total + weight * (arrival / 2 - sqrt(square * rest) / (a + delta))
        sum_, below = a + b, a + delta
        inner = a + (a * a + b * b * square) / (delta + b * square)
        scale = below * below
        weight = weight * (a - b) / (2 * sum_)
        square, rest = sum_ * sum_ * square / scale, 2 * a * rest * inner / scale
        a, b = sum_ / 2, sqrt(a * b)
    return total
