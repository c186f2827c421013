"""The kernels of ``arcs`` on arrays.

Emitted by `derive emit` from kernels/arcs.py: do not edit, change that file.

Digest of the inputs: sha256 f8c4fc852f7660e89380180ca80c95942ebf23993029596540f6e6beb3217f15
"""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import epsilon
from derive.emit.kernels.array_arithmetic import (
    any_of,
    arctan_share,
    complex_of,
    complex_sqrt,
    each_abs,
    each_cos,
    each_sin,
    each_sqrt,
    pick,
)
from derive.emit.kernels.swing_each import second_kind_each


class PointEach(NamedTuple):
    """A point of a motion by ℘ − c = x and ℘ − e at its three half-period values.

    one: ℘ − e₁, with e₁ that of the far turning point. product, root_sum: √(℘ − e₂)√(℘ − e₃) and √(℘ − e₂) + √(℘ − e₃),
    real also where e₂ and e₃ are a complex pair.
    """

    strength: float  # b
    pole: float  # x
    one: float
    product: float
    root_sum: float


class ArcEach(NamedTuple):
    """A stretch of rod from the tip: ∫cos θ, ∫sin θ and η∫cos²(θ − α)."""

    y: float
    z: float
    square: float


def clamp_point_each(motion, phase):
    """The point where the motion meets the clamp."""
    strength = motion.near_moment / 4
    sine, cosine = motion.done_sine, each_cos(motion.done / 2)
    one = strength * motion.left_sine / (sine * motion.sine)
    product = each_sqrt(motion.near) * phase.delta * phase.whole / (8 * motion.end * sine)
    a, b = motion.end, motion.middle
    root_sum = each_sqrt((a * a * phase.rest + b * b * phase.square) / phase.square)
    return PointEach(strength, strength * cosine / sine, one, product, root_sum)


def far_point_each(motion):
    """The far turning point."""
    strength = motion.near_moment / 4
    cosine = each_cos(motion.half_width)
    return PointEach(strength, strength * cosine / motion.sine, 0, motion.end * motion.end / 4, motion.middle)


def arc_to_each(beta, eta, field_angle, motion, point, square, rest, extent):
    """The arc from the tip to a point, at ψ, of the given length."""
    lean = motion.tip - field_angle
    strength = point.strength
    spread = strength * strength * eta / 4
    twist = complex_of(spread * each_cos(2 * lean), spread * each_sin(2 * lean))
    pole, less = complex_of(point.pole, -strength), complex_of(point.pole - point.one, -strength)
    lift = complex_of(lift_of_each(motion, square, rest), -strength)
    third = rj_pair_each(point.one, point.product, point.root_sum, pole, lift, less, twist)
    excess = complex_of(0, 2 * strength / 3) * third
    place = complex_of(each_cos(motion.tip), each_sin(motion.tip)) * (extent + excess)
    kept = (beta * each_cos(motion.tip) + eta * each_cos(lean) * each_cos(lean)) * extent - beta * place.real
    return ArcEach(
        place.real, place.imag, kept - 2 * second_part_each(beta, eta, lean, motion, point, square, rest, extent)
    )


def lift_of_each(motion, square, rest):
    """x + √(X₂X₃), which is small where the motion is nearly a whole turn."""
    near, far = each_sqrt(motion.near), each_sqrt(motion.far)
    turn = motion.uneven + 2 * near * motion.half_cosine * motion.half_cosine
    return near * (turn + 2 * far * rest / square) / 8


def second_part_each(beta, eta, lean, motion, point, square, rest, extent):
    """d℘/dσ·Re 1/(℘ − ℘(v)) less 2∫(℘ − e₁), by which η∫cos²(θ − α) is told from what does not grow along the rod."""
    a, b = motion.end / 2, motion.middle / 2
    strength, x = point.strength, point.pole
    growth = beta * each_cos(motion.tip) + eta * each_cos(2 * lean)
    cubic = beta * each_sin(motion.tip) - eta * each_sin(lean) * each_cos(lean)
    first = motion.near * each_cos(motion.half_width) / 8
    pair_sum = -growth / 4 - first
    pair_product = strength * cubic / 4 - first * pair_sum
    delta = each_sqrt(a * a * rest + b * b * square)
    across = each_sqrt(square * rest)
    root = each_sqrt(point.one)
    far = 4 * delta * across / square - 2 * root * (1 + x * point.product / (x * x + strength * strength))
    # Towards the tip the terms above are large and cancel; x² − x√(X₂X₃) is told by what X₂X₃ is in x.
    gap = x * (x * pair_sum - pair_product) / (each_abs(x) + point.product)
    near = 4 * (b - a) * (b + a) * across / delta
    near = near + 2 * root * (strength * strength + gap) / (x * x + strength * strength)
    kink = pick(x > 1, near, far)
    return kink + 4 * second_kind_each(a, b, square, rest, extent) + 2 * (a * a - first) * extent


def rj_pair_each(x, product, root_sum, p, lift, less, twist):
    """R_J(x, y, z, p) by duplication, for x ≥ 0, complex p, and y and z by √y√z and √y + √z.

    lift, less, twist: p + √y√z, p − x and (p − x)(p − y)(p − z), which the rod gives without cancellation. Sums of
    positive terms only in x, y, z. Where √p and −√y are near each other, their sum follows from their difference.
    """
    pair = root_sum * root_sum - 2 * product
    mean = start = (x + pair + 2 * p) / 5
    one, two = start - x, 2 * start - pair
    both = start * start - start * pair + product * product
    reach = each_abs(one) + each_abs(start - p) + each_sqrt(each_abs(both))
    target = (epsilon() / 4) ** 0.125
    scale, total = 1, 0
    while any_of(reach > target * scale * each_abs(mean)):
        root, root_p = each_sqrt(x), complex_sqrt(p)
        side, across = root_p * root_sum, root * root_sum
        plus, minus = lift + side, lift - side
        cancels = (each_abs(plus) < each_abs(minus)) & (scale == 1)
        d = (root_p + root) * pick(cancels, twist / (less * pick(cancels, minus, 1)), plus)
        raised, lifted = (lift + across, each_sqrt(x + product + across))
        end = 2 * root_p * raised / d
        total = total + arctan_share(twist / (scale * scale * scale * d * d), end) / (scale * d)
        pair = root_sum * (root_sum + 2 * root) / 4
        x, p = (x + product + across) / 4, raised / 4
        product, root_sum = root_sum * lifted / 4, each_sqrt(root_sum * (root_sum + 2 * root + 2 * lifted)) / 2
        lift, mean = p + product, (x + pair + 2 * p) / 5
        scale *= 4
    size = scale * mean
    a, b, c = one / size, two / size, both / (size * size)
    d = -(a + b) / 2
    e2 = a * b + c - 3 * d * d
    e3 = a * c + 2 * e2 * d + 4 * d * d * d
    e4 = (2 * a * c + e2 * d + 3 * d * d * d) * d
    e5 = a * c * d * d
    low = -3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    high = -e2 * e2 * e2 / 16 + 3 * e3 * e3 / 40 + 3 * e2 * e4 / 20 + 45 * e2 * e2 * e3 / 272
    high = high - 9 * (e3 * e4 + e2 * e5) / 68
    return (1 + low + high) / (scale * mean * complex_sqrt(mean)) + 6 * total
