"""The kernels of ``arcs`` on arrays.

Emitted by `derive emit` from kernels/arcs.py: do not edit, change that file.

Digest of the inputs: sha256 07b0b950390efab5af73e1a5f4076a40add1a2b4b30a05fd5049c1b4bd7ae1a0
"""

from __future__ import annotations

from derive.emit.kernels.arcs import Arc, Heading, Point
from derive.emit.kernels.arithmetic import epsilon
from derive.emit.kernels.array_arithmetic import (
    each_abs,
    each_any_of,
    each_arctan_share,
    each_complex_of,
    each_complex_sqrt,
    each_cos,
    each_pick,
    each_sin,
    each_sqrt,
    larger,
)
from derive.emit.kernels.formulas_each import (
    arc_kink_each,
    arc_kink_tip_each,
    arc_square_each,
    arc_y_each,
    arc_z_each,
    far_cosine_each,
    far_pair_root_each,
    far_root_each,
    far_sine_each,
    others_product_each,
    others_sum_each,
    pair_lift_each,
    pair_root_each,
    pair_root_sum_each,
    phase_rate_each,
    point_near_each,
    point_pole_each,
    rest_stiffness_each,
    rj_delta_imag_each,
    rj_delta_real_each,
    strength_each,
    tip_cubic_each,
    w_imag_each,
    w_real_each,
)
from derive.emit.kernels.swing_each import second_kind_each


def clamp_point_each(motion, phase):
    """The point where the motion meets the clamp."""
    b, done = strength_each(motion.near_moment), motion.done_sine
    one = point_near_each(b, motion.sine, done, motion.left_sine)
    product = pair_root_each(each_sqrt(motion.near), done, phase.whole, phase.delta / motion.end)
    delta = phase_rate_each(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    # 2Δ/sin ψ is no less than ``middle``, the square of which may underflow.
    root_sum = larger(pair_root_sum_each(phase.square, delta), motion.middle)
    return Point(b, point_pole_each(b, done, each_cos(motion.done / 2)), one, product, root_sum)


def far_point_each(motion):
    """The far turning point."""
    b = strength_each(motion.near_moment)
    pole = point_pole_each(b, motion.sine, each_cos(motion.half_width))
    return Point(b, pole, 0, far_pair_root_each(motion.end), motion.middle)


def sent_back_each(motion):
    """The motion from its far turning point back to the tip, as the mirror at the y axis shows it.

    A clamp at the turning point itself, where the motion has no point by ℘, is a little before it.
    """
    return motion._replace(
        tip=-(motion.tip + 2 * motion.half_width),
        done=motion.left,
        left=motion.done,
        near_moment=motion.far_moment,
        far_moment=motion.near_moment,
        near=motion.far,
        far=motion.near,
        uneven=-motion.uneven,
        done_sine=larger(motion.left_sine, epsilon() ** 6),
        left_sine=motion.done_sine,
    )


def phase_from_far_each(motion, square, rest):
    """sin²ψ and cos²ψ of a point as the motion turned back has them."""
    first, second = motion.end / 2, motion.middle / 2
    # The square of b may underflow.
    delta = larger(phase_rate_each(first, second, square, rest), second * each_sqrt(square))
    sine, cosine = far_sine_each(first, rest, delta), far_cosine_each(second, square, delta)
    return larger(sine * sine, epsilon() ** 12), cosine * cosine


def arc_from_far_each(eta, heading, there, arc, extent):
    """The arc of a motion turned back, whose heading is ``there``, as what departs from the tip's direction."""
    y, z = arc.y + extent * (there.cosine - heading.cosine), arc.z + extent * (there.sine + heading.sine)
    return Arc(y, -z, arc.square + extent * eta * (there.double_cosine - heading.double_cosine) / 2)


def heading_of_each(field_angle, motion):
    """The direction of a motion's tip."""
    double = 2 * (motion.tip - field_angle)
    return Heading(each_cos(motion.tip), each_sin(motion.tip), each_cos(double), each_sin(double))


def arc_to_each(beta, eta, heading, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    root = far_root_each(motion.near, each_cos(motion.half_width))
    w_re, w_im = shift_each(eta, heading, motion, point, root, square, rest)
    y, z = arc_y_each(heading.sine, heading.cosine, w_re, w_im), arc_z_each(heading.sine, heading.cosine, w_re, w_im)
    first, second = motion.end / 2, motion.middle / 2
    q = rest_stiffness_each(beta, eta, heading.cosine, heading.double_cosine)
    m = tip_cubic_each(beta, eta, heading.sine, heading.double_sine)
    kink = kink_at_each(motion, first, second, point, root, q, m, square, rest)
    turned, lag = second_kind_each(first, second, square, rest, extent)
    return Arc(y, z, arc_square_each(beta, first, second, root, y, kink, turned, lag))


def shift_each(eta, heading, motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, each_sqrt(motion.near), each_sqrt(motion.far)
    twist = each_complex_of(
        rj_delta_real_each(eta, b, heading.double_cosine), rj_delta_imag_each(eta, b, heading.double_sine)
    )
    lift = pair_lift_each(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = each_complex_of(point.pole, -b), each_complex_of(lift, -b), each_complex_of(root, -b)
    third = rj_pair_each(point.one, point.product, point.root_sum, pole, lifted, less, twist)
    return w_real_each(b, third.imag), w_imag_each(b, third.real)


def kink_at_each(motion, first, second, point, root, q, m, square, rest):
    """The part of η∫cos²(θ − α) without integral; towards the tip its terms are large and cancel in the first form."""
    b, x, product = point.strength, point.pole, point.product
    delta = larger(phase_rate_each(first, second, square, rest), second * each_sqrt(square))
    across, others = each_sqrt(square * rest), others_sum_each(q, root)
    both = others_product_each(b, m, root, others)
    lift = pair_lift_each(
        each_sqrt(motion.near), each_sqrt(motion.far), motion.uneven, motion.half_cosine, square, rest
    )
    far = arc_kink_each(first, square, delta, across, b, x, root, each_sqrt(point.one), product)
    # Beyond the middle the lift may be as good as nothing to divide by, and the square of the pole, too.
    towards_tip = lift > 0.15
    lift, there = each_pick(towards_tip, lift, 1), each_pick(towards_tip, x, 1)
    return each_pick(towards_tip, arc_kink_tip_each(first, delta, across, b, there, root, others, both, lift), far)


def rj_pair_each(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    fivefold = x + pair + (p + p)
    start = fivefold / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = 5 * (each_abs(one) + each_abs(start - p) + each_sqrt(each_abs(both)))
    # Twice that of the largest departure from the mean, for these are added up.
    target = 2 * (epsilon() / 4) ** 0.125
    scale, total = 1, 0
    while each_any_of(reach > target * scale * each_abs(fivefold)):
        root, root_p = each_sqrt(x), each_complex_sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus = lift + side
        if scale == 1:
            minus = lift - side
            cancels = each_abs(plus) < each_abs(minus)
            plus = each_pick(cancels, twist / (less * each_pick(cancels, minus, 1)), plus)
        share = 1 / ((root_p + root) * plus)  # one quotient of complex numbers, which take longer than products
        raised, lifted = (lift + across, each_sqrt(x + product + across))
        end = (root_p + root_p) * raised * share
        total = total + each_arctan_share(twist * share * share, end) * share / scale
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised * 0.25
        product, root_sum = root_sum * lifted / 4, each_sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
        lift, fivefold, twist = p + product, x + pair + (p + p), twist * 0.015625
        scale *= 4
    mean = fivefold / 5
    size = scale * mean
    a, b, c = one / size, two / size, both / (size * size)
    d = -(a + b) / 2
    e2 = a * b + c - 3 * d * d
    e3 = a * c + 2 * e2 * d + 4 * d * d * d
    e4 = (2 * a * c + e2 * d + 3 * d * d * d) * d
    e5 = a * c * d * d
    bent = e2 * (9 / 88 - e2 * (1 / 16) + e3 * (45 / 272)) - e3 * (9 / 52) + e4 * (3 / 20) - e5 * (9 / 68) - 3 / 14
    series = 1 + e2 * bent + e3 * (1 / 6 + e3 * (3 / 40) - e4 * (9 / 68)) - e4 * (3 / 22) + e5 * (3 / 26)
    return series / (scale * mean * each_complex_sqrt(mean)) + 6 * total
