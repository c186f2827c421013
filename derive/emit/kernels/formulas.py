"""The formulas as the theory derives them, nothing folded.

Emitted by `derive emit`: do not edit, change the theory. Kernels import these by name; when a scene is emitted, they
are specialised to it, and a formula that its load case has of its own takes their place.

Digest of the inputs: sha256 962de67b87fad771a7acae1f77fad81821b5bdc7737ee3612cc653cd33b5749f
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import sqrt


def rest_stiffness(beta, eta, cosine, double_cosine):
    """dθ″/dθ by cos θ and cos 2(θ − α), where small rotations h obey h″ = (dθ″/dθ)h; at the tip it is q.

    Proved as swing.rest_stiffness.
    """
    return beta * cosine + eta * double_cosine


def rest_moment(eta, stiffness, double_cosine, double_sine, sine, cosine):
    """θ″ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.rest_moment.
    """
    return (
        2
        * sine
        * (
            cosine * (stiffness - 2 * eta * double_cosine * sine * sine)
            - 0.5 * eta * double_sine * sine * (3 - 4 * sine * sine)
        )
    )


def stiffness_beside(eta, stiffness, double_cosine, double_sine, sine, cosine):
    """dθ″/dθ at an offset from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.stiffness_beside.
    """
    return (
        stiffness * (1 - 2 * sine * sine)
        - eta * sine * (2 * double_cosine * sine * (3 - 4 * sine * sine) + double_sine * cosine * (3 - 8 * sine * sine))
    )


def rest_fall(eta, stiffness, double_cosine, double_sine, middle_sine, middle_cosine, half_sine, half_cosine):
    """V(rest + middle − half) − V(rest + middle + half), from a direction without moment.

    Proved as swing.rest_fall.
    """
    return (
        4
        * half_sine
        * half_cosine
        * (
            2
            * middle_sine
            * middle_cosine
            * (
                stiffness
                - 2
                * eta
                * double_cosine
                * (middle_sine * middle_sine + (1 - 2 * middle_sine * middle_sine) * half_sine * half_sine)
            )
            - eta
            * double_sine
            * (
                (3 - 4 * middle_sine * middle_sine) * middle_sine * middle_sine
                + (1 - 8 * middle_sine * middle_sine * middle_cosine * middle_cosine) * half_sine * half_sine
            )
        )
    )


def tip_cubic(beta, eta, sine, double_sine):
    """m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α).

    Proved as swing.tip_cubic.
    """
    return beta * sine - 0.5 * eta * double_sine


def force_balance(beta, eta, gap_sine, lean_half_sine, side_cosine, turn_sine, turn_half_sine):
    """θ″ at π − p, and at p with the field at λ from the normal of the force, by β − η.

    Equation exsl6; proved as swing.force_balance.
    """
    return (
        gap_sine * (beta - eta)
        - 2 * eta * (lean_half_sine * side_cosine - turn_sine * turn_half_sine * turn_half_sine)
    )


def force_stiffness(eta, lean_sine, lean_cosine, along, across, gap_sine):
    """−dθ″/dθ at π − p, dθ″/dθ at p, where θ″ vanishes, by cosine and sine of λ + p.

    Proved as swing.force_stiffness.
    """
    return eta * (lean_sine * along * along * along + lean_cosine * across * across * across) / gap_sine


def pair_couple(beta, eta, force_sine, lean_half_sine, side_cosine, turn_sine, turn_half_sine):
    """θ″ at π + λ + x, and at −λ − x with the field at λ from the normal of the force.

    Equation exsl6; proved as swing.pair_couple.
    """
    return (
        force_sine * (eta - beta)
        - 2 * eta * (lean_half_sine * side_cosine + turn_sine * turn_half_sine * turn_half_sine)
    )


def cusp_couple(beta, eta, couple, stiffness, half_sine, quarter_sine, three_sine, near_sine, far_sine, force_sine):
    """θ″ at an angle u beside the cusp, by θ″ and dθ″/dθ there.

    Proved as swing.cusp_couple.
    """
    return (
        couple
        + 2
        * half_sine
        * (stiffness + 2 * beta * quarter_sine * force_sine - eta * (quarter_sine * near_sine + three_sine * far_sine))
    )


def pair_stiffness(eta, lean_cosine, cusp_cosine, beside_sine, along, across, force_sine):
    """dθ″/dθ of the pair, where θ″ vanishes, by the sine of what x is beyond the cusp.

    Proved as swing.pair_stiffness.
    """
    return (
        -eta
        * lean_cosine
        * beside_sine
        * (along * along + along * across + across * across)
        / (cusp_cosine * cusp_cosine * cusp_cosine * force_sine)
    )


def shot_bend(beta, eta, growth):
    """a bound of |∂²θ(0)/∂θ(ℓ)²| for every tip, by cosh(ℓ√(β + η)) − 1: it solves G″ = (β + η)G + (β + 2η)cosh².

    Proved as swing.shot_bend.
    """
    return growth * (beta + 2 * eta) * (3 + growth) / (3 * beta + 3 * eta)


def end_excess(rate, stiffness, cosine):
    """R by one end of the motion: by P (or P′) and dθ″/dθ there, and cos D.

    Proved as swing.end_excess.
    """
    return stiffness + 1.5 * rate * cosine


def end_twist(eta, rate, stiffness, sine, cosine):
    """sin(D + 2(M − α)) by the far turning point, or sin(D − 2(M − α)) by the tip.

    Proved as swing.end_twist.
    """
    return (-0.5 * rate * cosine - stiffness) / (eta * sine)


def end_above(eta, rate, twist_sine, twist_cosine):
    """a₀ − η by P (or P′), and by the sine and cosine of D ± 2(M − α).

    Proved as swing.end_above.
    """
    return rate - eta * twist_sine * twist_sine / (1 + twist_cosine)


def phase_sum(root_near, root_far, done_sine, left_sine):
    """√P′ sin(δ/2) + √P sin(D − δ/2).

    Proved as swing.phase_sum.
    """
    return root_near * left_sine + root_far * done_sine


def phase_lead(root_near, half_cosine, uneven, done_sine, gap_sine):
    """√P sin(D − δ/2) − √P′ sin(δ/2), with gap_sine = sin((D − δ)/2) and uneven = √P′ − √P.

    Proved as swing.phase_lead.
    """
    return 2 * root_near * half_cosine * gap_sine - uneven * done_sine


def chi_square(behind, ahead):
    """sin²χ, by the two parts of the phase's sum as shares of it.

    Equation DLMF 4.21(iii); proved as swing.chi_square.
    """
    return 4 * behind * ahead


def half_square(end, square, tilt, delta):
    """sin²ψ by sin²χ = square and cos χ = tilt ≥ 0: χ runs to π, ψ to π/2, with half the rates.

    Equation DLMF 22.6(iii); proved as swing.half_square.
    """
    return end * square / ((end + delta) * (1 + tilt))


def half_rest(end, tilt, delta):
    """cos²ψ by cos χ = tilt ≥ 0.

    Equation DLMF 22.6(iii); proved as swing.half_rest.
    """
    return (delta + end * tilt) / (end + delta)


def half_square_beyond(end, tilt, delta):
    """sin²ψ by cos χ = −tilt ≤ 0.

    Equation DLMF 22.6(iii); proved as swing.half_square_beyond.
    """
    return end * (1 + tilt) / (end + delta)


def half_rest_beyond(end, middle, square, tilt, delta):
    """cos²ψ by sin²χ = square and cos χ = −tilt ≤ 0.

    Equation DLMF 22.6(iii); proved as swing.half_rest_beyond.
    """
    return square * middle * middle / ((delta + end * tilt) * (end + delta))


def phase_rate(first, second, square, rest):
    """Δ = √(a² cos²ψ + b² sin²ψ), dψ/dσ.

    Equation DLMF 19.2.4; proved as swing.phase_rate.
    """
    return sqrt(rest * first * first + square * second * second)


def gauss_square(square, total, below):
    """sin²ψ′ of Gauss's step, which keeps the integral: a′ = (a + b)/2, b′ = √(ab); total = a + b, below = a + Δ.

    Equation DLMF 19.8(iii); proved as swing.gauss_square.
    """
    return square * total * total / (below * below)


def gauss_rest(first, second, square, rest, delta, below):
    """cos²ψ′ of Gauss's step, without a difference; below = a + Δ.

    Equation DLMF 19.8(iii); proved as swing.gauss_rest.
    """
    return (
        2
        * first
        * rest
        * (first + (first * first + square * second * second) / (delta + second * square))
        / (below * below)
    )


def far_sine(first, rest, delta):
    """sin ψ of the same point by the length from the far turning point.

    Equation DLMF 22.4(iii); proved as swing.far_sine.
    """
    return first * sqrt(rest) / delta


def far_cosine(second, square, delta):
    """cos ψ of the same point by the length from the far turning point.

    Equation DLMF 22.4(iii); proved as swing.far_cosine.
    """
    return second * sqrt(square) / delta


def phase_bend(share, first_share, square, rest, across, delta):
    """kS′τ′/(1 + kS′) after Gauss's step, by k = (a − b)/(a + b) and 1 + k; τ = sin ψ cos ψ/Δ.

    Equation DLMF 19.8(iii); proved as swing.phase_bend.
    """
    return share * square * across / ((rest + first_share * square) * delta)


def lag_step(bend, share, second_share, square, rest):
    """τ′ − τ for τ = sin ψ cos ψ/Δ, τ′ the same after Gauss's step, by ``phase_bend``, k and 1 − k.

    Equation DLMF 19.8(iii); proved as swing.lag_step.
    """
    return bend * share * rest / (rest + second_share * square)


def gauss_gap(gap, total):
    """a′ − b′ after Gauss's step, by gap = a − b and total = a′ + b′.

    Equation DLMF 19.8(i); proved as swing.gauss_gap.
    """
    return 0.25 * gap * gap / total


def tangent_exchanged(first, second, tan_phase):
    """Tan ψ of the same length where a and b are exchanged.

    Equation DLMF 22.17(i); proved as swing.tangent_exchanged.
    """
    return second * tan_phase / first


def landen_more(share, tan_phase):
    """by what share tan ψ is more before Landen's step than after it.

    Equation DLMF 19.8(ii); proved as swing.landen_more.
    """
    return share * (1 + tan_phase * tan_phase) / (2 - share * (1 + tan_phase * tan_phase))


def landen_root(bent):
    """√(a² + b² tan²ψ)/a.

    Equation DLMF 19.2.4; proved as swing.landen_root.
    """
    return sqrt(1 + bent * bent)


def landen_tangent(share, tan_phase, root):
    """Tan ψ after Landen's step.

    Equation DLMF 19.8(ii); proved as swing.landen_tangent.
    """
    return tan_phase * (2 - share) / (1 + root)


def landen_less(share, bent, root):
    """by what share tan ψ is less after Landen's step.

    Equation DLMF 19.8(ii); proved as swing.landen_less.
    """
    return (share + bent * bent / (1 + root)) / (1 + root)


def gauss_more(share, tan_square):
    """by what share tan²ψ is more before Gauss's step than after it.

    Equation DLMF 19.8(iii); proved as swing.gauss_more.
    """
    return share * (4 + 4 * tan_square - share) / ((2 - share) ** 2 + tan_square * (4 - 4 * share))


def gauss_less(share, root, other_root):
    """by what share tan²ψ is less after Gauss's step, by root = √(1 + tan²ψ) and other_root = √(1 + (b/a)² tan²ψ).

    Equation DLMF 19.8(iii); proved as swing.gauss_less.
    """
    return (
        0.5
        * share
        * (
            1
            + root
            * (2 - share)
            * ((1 - share) ** 2 + other_root * other_root)
            / ((other_root + root * (1 - share) ** 2) * (1 + root * other_root))
        )
    )


def phase_ratio(share, square, rest):
    """Δ/a by share = (b/a)².

    Equation DLMF 19.2.4; proved as swing.phase_ratio.
    """
    return sqrt(rest + share * square)


def before_over(square, rest, by_ratio):
    """What the cosine of a difference of lengths is divided by; by_ratio is Δ/a at the length taken off.

    Equation DLMF 22.8(i); proved as swing.before_over.
    """
    return rest + square * by_ratio * by_ratio


def before_cosine(square, rest, ratio, by_square, by_rest, by_ratio, over):
    """cos ψ at the difference of two lengths from the tip.

    Equation DLMF 22.8(i); proved as swing.before_cosine.
    """
    return (ratio * by_ratio * sqrt(square * by_square) + sqrt(rest * by_rest)) / over


def before_sine(square, rest, ratio, by_square, by_rest, by_ratio, fall):
    """sin ψ at the difference of two lengths from the tip, by the difference of their sin²ψ.

    Equation DLMF 22.8(i); proved as swing.before_sine.
    """
    return fall / (by_ratio * sqrt(square * by_rest) + ratio * sqrt(rest * by_square))


def strength(moment_there):
    """b of the expansion t = b/(℘ − c), by θ″ at the tip.

    Equation exsl17; proved as swing.strength.
    """
    return 0.25 * moment_there


def point_pole(b, sine, cosine):
    """x = ℘ − c by the sine and cosine of δ/2, or any two numbers in their ratio.

    Equation exsl22; proved as swing.point_pole.
    """
    return b * cosine / sine


def far_root(near, cosine):
    """ê₁, the value of x at the far turning point, by P and cos D.

    Proved as swing.far_root.
    """
    return 0.125 * near * cosine


def point_near(b, sine, done_sine, left_sine):
    """X₁ = x − ê₁ at a point, zero at the far turning point, by sin D, sin(δ/2) and sin(D − δ/2).

    Proved as swing.point_near.
    """
    return b * left_sine / (sine * done_sine)


def near_by_phase(square, rest, bend):
    """X₁ by sin²ψ, cos²ψ and bend = a²/Δ.

    Equation DLMF 19.25.35; proved as swing.near_by_phase.
    """
    return rest * bend * bend / square


def pair_root_sum(square, delta):
    """√X₂ + √X₃ by sin²ψ and Δ.

    Equation DLMF 19.26(iii); proved as swing.pair_root_sum.
    """
    return 2 * delta / sqrt(square)


def far_pair_root(end):
    """√X₂√X₃ at the far turning point, by the rate of χ there.

    Proved as swing.far_pair_root.
    """
    return 0.25 * end * end


def pair_lift(root_near, root_far, uneven, half_cosine, square, rest):
    """x + √X₂√X₃ by the phase, with uneven = √P′ − √P.

    Proved as swing.pair_lift.
    """
    return 0.125 * root_near * (uneven + 2 * root_near * half_cosine * half_cosine + 2 * root_far * rest / square)


def pair_root(root_near, done_sine, whole, rate):
    """√X₂√X₃ by the phase's sum and the rate of χ over that at the turning points.

    Proved as swing.pair_root.
    """
    return 0.125 * root_near * whole * rate / done_sine


def turn_speed(sine, done_sine, left_sine, whole, rate):
    """|θ_σ| by the phase's sum and the rate of χ over that at the turning points.

    Equation exsl8; proved as swing.turn_speed.
    """
    return whole * rate * sqrt(2) * sqrt(done_sine * left_sine) / sine


def chi_rate(square, rest, flat, scale):
    """The rate of χ over that at the turning points, by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_rate.
    """
    return (rest * rest + flat * (1 + rest)) / scale


def chi_cosine(square, rest, flat, scale):
    """cos χ by the phase: it doubles the elliptic argument.

    Equation DLMF 22.6(iii); proved as swing.chi_cosine.
    """
    return (rest * rest - square * flat) / scale


def chi_versine(square, rest, flat, scale):
    """1 − cos χ by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_versine.
    """
    return 2 * square * (rest + flat) / scale


def chi_coversine(rest, scale):
    """1 + cos χ by the phase.

    Equation DLMF 22.6(iii); proved as swing.chi_coversine.
    """
    return 2 * rest / scale


def chi_scale(square, rest, flat):
    """What cos χ, 1 ± cos χ and the rate of χ are divided by, with flat = (b/a)² sin²ψ.

    Equation DLMF 22.6(iii); proved as swing.chi_scale.
    """
    return rest * (1 + square) + square * flat


def turn_level(root_near, root_far, versine, coversine):
    """√P(1 − cos χ) + √P′(1 + cos χ).

    Proved as swing.turn_level.
    """
    return root_near * versine + root_far * coversine


def turn_tilt(root_near, root_far, uneven, cosine):
    """√P′(1 + cos χ) − √P(1 − cos χ), with uneven = √P′ − √P.

    Proved as swing.turn_tilt.
    """
    return uneven + cosine * (root_near + root_far)


def turn_tilt_apart(root_near, root_far, versine, coversine):
    """√P′(1 + cos χ) − √P(1 − cos χ) where P and P′ are far apart.

    Proved as swing.turn_tilt_apart.
    """
    return root_far * coversine - root_near * versine


def turn_over(root, half_sine, half_cosine, part):
    """sin D times √P(1 − cos χ), or √P′(1 + cos χ).

    Equation DLMF 4.21(iii); proved as swing.turn_over.
    """
    return 2 * root * half_sine * half_cosine * part


def turn_under(half_sine, half_cosine, level, tilt):
    """by which turn_over is divided for tan(δ/2); with −tilt for tan(D − δ/2).

    Proved as swing.turn_under.
    """
    return tilt * half_sine * half_sine + level * half_cosine * half_cosine


def unit_sine(over, under):
    """Sine of the angle in (0, π) whose tangent is over/under.

    Equation DLMF 4.14.7; proved as swing.unit_sine.
    """
    return over / sqrt(over * over + under * under)


def rj_delta_real(eta, b, double_cosine):
    """The real part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, by cos 2(φ − α).

    Equation DLMF 19.26(iii); proved as swing.rj_delta_real.
    """
    return 0.25 * eta * double_cosine * b * b


def rj_delta_imag(eta, b, double_sine):
    """The imaginary part of (p − X₁)(p − X₂)(p − X₃), p = x − ib, for the duplication of R_J, by sin 2(φ − α).

    Equation DLMF 19.26(iii); proved as swing.rj_delta_imag.
    """
    return 0.25 * eta * double_sine * b * b


def w_real(b, rj_im):
    """The real part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{iθ}dσ = e^{iφ}(σ + W).

    Equation DLMF 19.29(ii); proved as swing.w_real.
    """
    return -2 * b * rj_im / 3


def w_imag(b, rj_re):
    """The imaginary part of W = (2ib/3)R_J(X₁, X₂, X₃, x − ib): ∫e^{iθ}dσ = e^{iφ}(σ + W).

    Equation DLMF 19.29(ii); proved as swing.w_imag.
    """
    return 2 * b * rj_re / 3


def arc_y(sine, cosine, w_re, w_im):
    """∫y′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ.

    Equation exsl36; proved as swing.arc_y.
    """
    return cosine * w_re - sine * w_im


def arc_z(sine, cosine, w_re, w_im):
    """∫z′ dσ from the tip to the point less what it is along the tip's direction, by sin φ and cos φ.

    Equation exsl41; proved as swing.arc_z.
    """
    return sine * w_re + cosine * w_im


def others_sum(q, root):
    """ê₂ + ê₃ by ê₁.

    Proved as swing.others_sum.
    """
    return -0.25 * q - root


def others_product(b, m, root, others_sum):
    """ê₂ê₃ by ê₁ and ê₂ + ê₃.

    Proved as swing.others_product.
    """
    return 0.25 * b * m - root * others_sum


def arc_kink(first, square, delta, across, b, pole, root, near_root, pair_root):
    """The part of ∫η cos²(θ − α)dσ without integral.

    Equation DLMF 19.29(ii); proved as swing.arc_kink.
    """
    return (
        across * (2 * first * first - 2 * root) / delta
        + 4 * delta * across / square
        - 2 * near_root * (1 + pole * pair_root / (b * b + pole * pole))
    )


def arc_kink_tip(first, delta, across, b, pole, root, others_sum, others_product, lift):
    """The same towards the tip, with lift = x + √X₂√X₃: it is small as σ³, and so are its terms.

    Proved as swing.arc_kink_tip.
    """
    return (
        across
        * (
            (lift + first * first - root - others_sum) * b * b
            + pole * (first * first - root) * (pole * others_sum - others_product) / lift
            - pole * others_product
        )
        / (delta * (b * b + pole * pole))
    )


def arc_square(beta, first, second, root, y_apart, kink, turned, lag):
    """η∫cos²(θ − α)dσ from the tip to the point less what it is along the tip's direction, by the same of y.

    Equation DLMF 19.29(ii); proved as swing.arc_square.
    """
    return (
        -beta * y_apart
        - 8 * turned * (second - first) * (first + second)
        - 2 * lag * (2 * first * first - 2 * root)
        - 2 * kink
    )
