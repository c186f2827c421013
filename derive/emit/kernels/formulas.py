"""The formulas of the load case 'oblique' as the theory derives them, nothing folded.

Emitted by `derive emit`: do not edit, change the theory. Kernels import these by name; when a scene is emitted, the
formulas of its own load case take their place.

Digest of the inputs: sha256 50cde2c1d9b3b8032fdddc21c1e80b5a7cffe2823ad572c2908dcdc1fdef086c
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import atan, atan2, cos, sin, sqrt


def rest_stiffness(beta, eta, cosine, double_cosine):
    """dθ″/dθ by cos θ and cos 2(θ − α): small rotations h from a direction of equilibrium obey h″ = (dθ″/dθ)h; at the tip it is q.

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


def opposite_drop(beta, eta, field_angle, middle, half):
    """V(middle − π/2 − half) − V(middle + π/2 + half).

    Proved as swing.opposite_drop.
    """
    return (2 * beta * sin(middle) + eta * sin(2 * field_angle - 2 * middle) * sin(half)) * cos(half)


def rest_drop(eta, stiffness, double_cosine, double_sine, sine, cosine):
    """V(rest) − V(rest + offset), from a direction without moment, by the sine and cosine of half the offset.

    Proved as swing.rest_drop.
    """
    return 2 * (stiffness - eta * sine * (double_cosine * sine + double_sine * cosine)) * sine * sine


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


def gamma(beta, eta, cosine, aligned):
    """γ of the first integral, such that the curvature vanishes at the tip, by cos φ and cos(φ − α).

    Equation exsl8; proved as swing.gamma.
    """
    return 2 * beta * cosine + eta * aligned * aligned


def tip_cubic(beta, eta, sine, double_sine):
    """m, the coefficient of t³ in the half-angle quartic at the tip, by sin φ and sin 2(φ − α).

    Proved as swing.tip_cubic.
    """
    return beta * sine - 0.5 * eta * double_sine


def rod_energy(beta, gamma, length, y, square):
    """Energy of the rod over EI, bending, field and force, with square = η∫cos²(θ − α)ds.

    Equation exsl8; proved as swing.rod_energy.
    """
    return 0.5 * gamma * length - 2 * beta * y - square


def hill_balance(beta, eta, field_angle, before):
    """−θ″ at α − y, between force and field: zero at a maximum of V.

    Equation exsl6; proved as swing.hill_balance.
    """
    return beta * sin(before - field_angle) + 0.5 * eta * sin(2 * before)


def well_balance(beta, eta, field_angle, past):
    """−θ″ at α + π/2 + w, between the normal of the field and the opposite of the force: zero at a minimum of V.

    Equation exsl6; proved as swing.well_balance.
    """
    return 0.5 * eta * sin(2 * past) - beta * cos(field_angle + past)


def pair_balance(beta, eta, field_angle, beyond):
    """θ″ at α + π + x: zero at the second maximum and the second minimum of V.

    Equation exsl6; proved as swing.pair_balance.
    """
    return 0.5 * eta * sin(2 * beyond) - beta * sin(field_angle + beyond)


def astroid_angle(sine, cosine):
    """x at which sin α/sin x + cos α/cos x is least, by sin α and cos α: tan³x = tan α.

    Proved as swing.astroid_angle.
    """
    return atan((sine / cosine) ** (1 / 3))


def tilt(beta, eta):
    """θ > 0 where force and field balance, the field across the force.

    Proved as swing.tilt.
    """
    return atan2(sqrt(eta - beta) * sqrt(beta + eta), beta)


def tilt_from_side(beta, eta):
    """θ − π/2 where force and field balance, the field along the force.

    Proved as swing.tilt_from_side.
    """
    return atan2(beta, sqrt(eta - beta) * sqrt(beta + eta))


def tilt_stiffness(beta, eta):
    """dθ″/dθ at that angle; the negative at the well, the field along the force.

    Proved as swing.tilt_stiffness.
    """
    return (eta - beta) * (beta + eta) / eta


def tilt_cosine(beta, eta):
    """cos 2(θ − α) at that angle; the negative at the well, the field along the force.

    Proved as swing.tilt_cosine.
    """
    return 1 - 2 * beta * beta / (eta * eta)


def tilt_sine(beta, eta):
    """sin 2(θ − α) at that angle; the same at the well, the field along the force.

    Proved as swing.tilt_sine.
    """
    return -2 * beta * sqrt(eta - beta) * sqrt(beta + eta) / (eta * eta)


def turn_factor(moment_there, sine):
    """P, or P′: Q at a turning point, by θ″ there towards the other one and sin D.

    Proved as swing.turn_factor.
    """
    return 2 * moment_there / sine


def middle_excess(beta, eta, middle_cosine, double_cosine, cosine):
    """R: the part of sin²D·Q that goes with both half-angle sines, by cos M, cos 2(M − α) and cos D.

    Proved as swing.middle_excess.
    """
    return -2 * beta * middle_cosine * cosine - eta * double_cosine * (1 + cosine * cosine)


def mean_factor(beta, eta, middle_cosine, double_cosine, cosine):
    """a₀, the mean of Q over all directions: PP′ − R² = sin²D(a₀² − η²).

    Proved as swing.mean_factor.
    """
    return -2 * beta * middle_cosine - eta * double_cosine * cosine


def skew(eta, field_angle, middle):
    """(P′ − P)/(2 sin D), zero for a motion that is symmetric about its middle.

    Proved as swing.skew.
    """
    return -eta * sin(2 * field_angle - 2 * middle)


def mean_above(drop, outer_sine, inner_sine):
    """a₀ − η by what V falls from the tip to the direction 2α − M, sin(D/2) and sin(α − M).

    Proved as swing.mean_above.
    """
    return drop / ((outer_sine - inner_sine) * (outer_sine + inner_sine))


def factor_product(near, far):
    """√(PP′), the geometric mean of P and P′.

    Proved as swing.factor_product.
    """
    return sqrt(near) * sqrt(far)


def end_rate_squared(product):
    """h²: (dχ/dσ)² at the turning points, by √(PP′).

    Proved as swing.end_rate_squared.
    """
    return 0.5 * product


def middle_rate_squared(product, excess):
    """g²: (dχ/dσ)² at χ = π/2, for R of either sign.

    Proved as swing.middle_rate_squared.
    """
    return 0.25 * product + 0.25 * excess


def middle_rate_squared_apart(product, excess, eta, sine, mean, above):
    """g² by the factors of PP′ − R², with sin D and above = a₀ − η, for R < 0.

    Proved as swing.middle_rate_squared_apart.
    """
    return above * (eta + mean) * sine * sine / (4 * product - 4 * excess)


def phase_sum(root_near, root_far, done_sine, left_sine):
    """√P′ sin(δ/2) + √P sin(D − δ/2).

    Proved as swing.phase_sum.
    """
    return root_near * left_sine + root_far * done_sine


def phase_lead(root_near, root_far, half_cosine, skew, sine, done_sine, gap_sine):
    """√P sin(D − δ/2) − √P′ sin(δ/2), with gap_sine = sin((D − δ)/2).

    Proved as swing.phase_lead.
    """
    return 2 * root_near * half_cosine * gap_sine - 2 * skew * sine * done_sine / (root_near + root_far)


def chi_square(behind, ahead, whole):
    """sin²χ, by the two parts of the phase's sum, and the sum.

    Equation DLMF 4.21(iii); proved as swing.chi_square.
    """
    return 4 * behind * ahead / (whole * whole)


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


def second_kind_step(first, second, square, rest, delta, arc):
    """2J′ − J for J = (b² − a²)∫sin²ψ dσ over a length, J′ the same after Gauss's step.

    Equation DLMF 19.8.19; proved as swing.second_kind_step.
    """
    return (first + second) * (first - second) * (0.5 * arc - sqrt(square * rest) / (first + delta))


def back_below(first, second, square):
    """2a(a + b)/(a + Δ) by sin²ψ′, for a > b: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_below.
    """
    return first + second + square * (first - second)


def back_below_rest(first, second, rest):
    """The same by cos²ψ′, for a < b: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_below_rest.
    """
    return 2 * first - rest * (first - second)


def back_square(first, square, below):
    """sin²ψ by sin²ψ′: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_square.
    """
    return 4 * square * first * first / (below * below)


def back_rest(first, second, gap, rest, below):
    """cos²ψ by cos²ψ′, with gap = a − b: Gauss's step undone.

    Equation DLMF 19.8(iii); proved as swing.back_rest.
    """
    return rest * (4 * first * second + rest * gap * gap) / (below * below)


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


def pair_lift(root_near, root_far, skew, sine, half_cosine, square, rest):
    """x + √X₂√X₃ by the phase.

    Proved as swing.pair_lift.
    """
    return (
        0.125
        * root_near
        * (
            2 * skew * sine / (root_near + root_far)
            + 2 * root_near * half_cosine * half_cosine
            + 2 * root_far * rest / square
        )
    )


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


def point_speed(b, done_sine, x_near, pair_root):
    """|θ_σ| by X₁ and √X₂√X₃.

    Equation exsl8; proved as swing.point_speed.
    """
    return 4 * pair_root * done_sine * done_sine * sqrt(x_near) / b


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


def turn_tilt(root_near, root_far, skew, sine, cosine):
    """√P′(1 + cos χ) − √P(1 − cos χ).

    Proved as swing.turn_tilt.
    """
    return 2 * skew * sine / (root_near + root_far) + cosine * (root_near + root_far)


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


def arc_y(sine, cosine, arc, w_re, w_im):
    """∫y′ dσ from the tip to the point, by sin φ and cos φ.

    Equation exsl36; proved as swing.arc_y.
    """
    return cosine * (arc + w_re) - sine * w_im


def arc_z(sine, cosine, arc, w_re, w_im):
    """∫z′ dσ from the tip to the point, by sin φ and cos φ.

    Equation exsl41; proved as swing.arc_z.
    """
    return sine * (arc + w_re) + cosine * w_im


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


def arc_kink(square, delta, across, b, pole, near_root, pair_root):
    """The part of ∫η cos²(θ − α)dσ without integral.

    Equation DLMF 19.29(ii); proved as swing.arc_kink.
    """
    return 4 * delta * across / square - 2 * near_root * (1 + pole * pair_root / (b * b + pole * pole))


def pole_gap(pole, size, others_sum, others_product, pair_root):
    """x² − x√X₂√X₃, with size = |x|, x > 0.

    Proved as swing.pole_gap.
    """
    return pole * (pole * others_sum - others_product) / (size + pair_root)


def arc_kink_tip(first, second, delta, across, b, pole, near_root, gap):
    """The same where x is large, by x² − x√X₂√X₃.

    Proved as swing.arc_kink_tip.
    """
    return (
        across * (4 * second - 4 * first) * (first + second) / delta
        + 2 * near_root * (gap + b * b) / (b * b + pole * pole)
    )


def arc_square(beta, eta, cosine, aligned, first, root, arc, y, kink, growth):
    """η∫cos²(θ − α)dσ from the tip to the point, by cos φ and cos(φ − α).

    Equation DLMF 19.29(ii); proved as swing.arc_square.
    """
    return (
        arc * (beta * cosine + eta * aligned * aligned)
        - beta * y
        - 2 * arc * (2 * first * first - 2 * root)
        - 2 * kink
        - 8 * growth
    )
