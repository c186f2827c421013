"""Where a motion leads: ∫e^{iθ} and the energy from the tip to a point, by Carlson's integrals (DLMF 19.36(i))."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import (
    any_of,
    arctan_share,
    complex_of,
    complex_sqrt,
    cos,
    epsilon,
    larger,
    pick,
    sin,
    sqrt,
)
from derive.emit.kernels.formulas import (
    arc_kink,
    arc_kink_tip,
    arc_square,
    arc_y,
    arc_z,
    far_cosine,
    far_pair_root,
    far_root,
    far_sine,
    others_product,
    others_sum,
    pair_lift,
    pair_root,
    pair_root_sum,
    phase_rate,
    point_near,
    point_pole,
    rest_stiffness,
    rj_delta_imag,
    rj_delta_real,
    strength,
    tip_cubic,
    w_imag,
    w_real,
)
from derive.emit.kernels.swing import second_kind


class Point(NamedTuple):
    """A point of a motion by ℘ − c = x and ℘ − e at its three half-period values.

    one: ℘ − e₁, with e₁ that of the far turning point. product, root_sum: √(℘ − e₂)√(℘ − e₃) and √(℘ − e₂) + √(℘ − e₃),
    real also where e₂ and e₃ are a complex pair.
    """

    strength: float  # b
    pole: float  # x
    one: float
    product: float
    root_sum: float


class Heading(NamedTuple):
    """The tip's direction: cos and sin of φ, and of 2(φ − α)."""

    cosine: float
    sine: float
    double_cosine: float
    double_sine: float


class Arc(NamedTuple):
    """A stretch of rod from the tip, less what it would be if it were straight along the tip's direction.

    ∫cos θ, ∫sin θ and η∫cos²(θ − α), with cos θ − cos φ for cos θ and likewise.
    """

    y: float
    z: float
    square: float


def clamp_point(motion, phase):
    """The point where the motion meets the clamp."""
    b, done = strength(motion.near_moment), motion.done_sine
    one = point_near(b, motion.sine, done, motion.left_sine)
    product = pair_root(sqrt(motion.near), done, phase.whole, phase.delta / motion.end)
    delta = phase_rate(motion.end / 2, motion.middle / 2, phase.square, phase.rest)
    # 2Δ/sin ψ is no less than ``middle``, the square of which may underflow.
    root_sum = larger(pair_root_sum(phase.square, delta), motion.middle)
    return Point(b, point_pole(b, done, cos(motion.done / 2)), one, product, root_sum)


def far_point(motion):
    """The far turning point."""
    b = strength(motion.near_moment)
    pole = point_pole(b, motion.sine, cos(motion.half_width))
    return Point(b, pole, 0, far_pair_root(motion.end), motion.middle)


def sent_back(motion):
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


def phase_from_far(motion, square, rest):
    """sin²ψ and cos²ψ of a point as the motion turned back has them."""
    first, second = motion.end / 2, motion.middle / 2
    # The square of b may underflow.
    delta = larger(phase_rate(first, second, square, rest), second * sqrt(square))
    sine, cosine = far_sine(first, rest, delta), far_cosine(second, square, delta)
    return larger(sine * sine, epsilon() ** 12), cosine * cosine


def arc_from_far(eta, heading, there, arc, extent):
    """The arc of a motion turned back, whose heading is ``there``, as what departs from the tip's direction."""
    y, z = arc.y + extent * (there.cosine - heading.cosine), arc.z + extent * (there.sine + heading.sine)
    return Arc(y, -z, arc.square + extent * eta * (there.double_cosine - heading.double_cosine) / 2)


def heading_of(field_angle, motion):
    """The direction of a motion's tip."""
    double = 2 * (motion.tip - field_angle)
    return Heading(cos(motion.tip), sin(motion.tip), cos(double), sin(double))


def arc_to(beta, eta, heading, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    root = far_root(motion.near, cos(motion.half_width))
    w_re, w_im = shift(eta, heading, motion, point, root, square, rest)
    y, z = arc_y(heading.sine, heading.cosine, w_re, w_im), arc_z(heading.sine, heading.cosine, w_re, w_im)
    first, second = motion.end / 2, motion.middle / 2
    q = rest_stiffness(beta, eta, heading.cosine, heading.double_cosine)
    m = tip_cubic(beta, eta, heading.sine, heading.double_sine)
    kink = kink_at(motion, first, second, point, root, q, m, square, rest)
    turned, lag = second_kind(first, second, square, rest, extent)
    return Arc(y, z, arc_square(beta, first, second, root, y, kink, turned, lag))


def shift(eta, heading, motion, point, root, square, rest):
    """W as real and imaginary part: ∫e^{iθ} from the tip is e^{iφ}(σ + W)."""
    b, near, far = point.strength, sqrt(motion.near), sqrt(motion.far)
    twist = complex_of(rj_delta_real(eta, b, heading.double_cosine), rj_delta_imag(eta, b, heading.double_sine))
    lift = pair_lift(near, far, motion.uneven, motion.half_cosine, square, rest)
    pole, lifted, less = complex_of(point.pole, -b), complex_of(lift, -b), complex_of(root, -b)
    third = rj_pair(point.one, point.product, point.root_sum, pole, lifted, less, twist)
    return w_real(b, third.imag), w_imag(b, third.real)


def kink_at(motion, first, second, point, root, q, m, square, rest):
    """The part of η∫cos²(θ − α) without integral; towards the tip its terms are large and cancel in the first form."""
    b, x, product = point.strength, point.pole, point.product
    delta = larger(phase_rate(first, second, square, rest), second * sqrt(square))
    across, others = sqrt(square * rest), others_sum(q, root)
    both = others_product(b, m, root, others)
    lift = pair_lift(sqrt(motion.near), sqrt(motion.far), motion.uneven, motion.half_cosine, square, rest)
    far = arc_kink(first, square, delta, across, b, x, root, sqrt(point.one), product)
    # Beyond the middle the lift may be as good as nothing to divide by, and the square of the pole, too.
    towards_tip = lift > 0.15
    lift, there = pick(towards_tip, lift, 1), pick(towards_tip, x, 1)
    return pick(towards_tip, arc_kink_tip(first, delta, across, b, there, root, others, both, lift), far)


def rj_pair(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    fivefold = x + pair + (p + p)
    start = fivefold / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = 5 * (abs(one) + abs(start - p) + sqrt(abs(both)))
    # Twice that of the largest departure from the mean, for these are added up.
    target = 2 * (epsilon() / 4) ** 0.125
    scale, total = 1, 0
    while any_of(reach > target * scale * abs(fivefold)):
        root, root_p = sqrt(x), complex_sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus = lift + side
        if scale == 1:
            minus = lift - side
            cancels = abs(plus) < abs(minus)
            plus = pick(cancels, twist / (less * pick(cancels, minus, 1)), plus)
        share = 1 / ((root_p + root) * plus)  # one quotient of complex numbers, which take longer than products
        raised, lifted = lift + across, sqrt(x + product + across)
        end = (root_p + root_p) * raised * share
        total = total + arctan_share(twist * share * share, end) * share / scale
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised * 0.25
        product, root_sum = root_sum * lifted / 4, sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
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
    return series / (scale * mean * complex_sqrt(mean)) + 6 * total
