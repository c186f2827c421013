"""Lengths and phases of one motion, by Gauss's and Landen's transformations in steps that change little.

A small change rounds less than a product. Where the rates are near each other Gauss's steps are small, else Landen's,
in which c = √(a² − b²) is near a (DLMF 19.8(ii)). On arrays ``swing.lengths`` does with one of them.
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import asinh, atan, epsilon, pi, sinh, sqrt, tan
from derive.emit.kernels.formulas import (
    gauss_gap,
    gauss_less,
    gauss_more,
    landen_less,
    landen_more,
    landen_root,
    landen_tangent,
    tangent_exchanged,
)

APART = 0.7  # the quotient of the rates below which Landen's steps are the smaller ones: 1/√2


def swing_and_arrival(a, b, square, rest):
    """The complete and the incomplete integral of 1/√(a² cos²ψ + b² sin²ψ), by sin²ψ and cos²ψ."""
    tangent = sqrt(square / (rest if rest > 0 else epsilon() ** 19))
    if a < b:
        a, b, tangent = b, a, tangent_exchanged(a, b, tangent)
    shares, mean = small_steps(a, b)
    ratio = b / a
    if ratio > APART:
        # Beyond this ψ is a right angle to rounding, and cubes of the tangent may overflow.
        tangent = min(tangent, epsilon() ** -2)
        square = tangent * tangent
        for share in shares:
            root, other_root = sqrt(1 + square), sqrt(1 + (1 - share) * (1 - share) * square)
            square = square - square * gauss_less(share, root, other_root)
        return pi / (2 * mean), atan(sqrt(square)) / mean
    first = shares[0]
    # The half-swing ends where the tangent is infinite: after a step it is not.
    whole = descended((2 - first) / ratio, shares[1:], first / (2 - first))
    return asinh(whole) / mean, asinh(descended(tangent, shares, ratio)) / mean


def descended(tangent, shares, ratio):
    """tan ψ after Landen's steps. ratio: of the rates before them."""
    for share in shares:
        bent = ratio * tangent
        root = landen_root(bent)
        less = landen_less(share, bent, root)
        tangent = tangent - tangent * less if less < 0.25 else landen_tangent(share, tangent, root)
        ratio = share / (2 - share)
    return tangent


def phase_at(a, b, length, left):
    """sin²ψ and cos²ψ at lengths from the tip and from the half-swing's end, by the nearer one of them."""
    first = length <= left
    tangent = tangent_at(a, b, length) if first else tangent_at(b, a, left)
    square = tangent * tangent
    small, large = square / (1 + square), 1 / (1 + square)
    return (small, large) if first else (large, small)


def tangent_at(a, b, length):
    """tan ψ at a length up to the middle of the half-swing."""
    if a < b:
        return tangent_exchanged(b, a, tangent_at(b, a, length))
    shares, mean = small_steps(a, b)
    if b > APART * a:
        tangent = tan(mean * length)
        square = tangent * tangent
        for share in reversed(shares):
            square = square + square * gauss_more(share, square)
        return sqrt(square)
    tangent = sinh(mean * length)
    for share in reversed(shares):
        tangent = tangent + tangent * landen_more(share, tangent)
    return tangent


def small_steps(a, b):
    """What each step takes from the larger one of two numbers to their mean, twice, as shares of it; and the mean.

    The two are a and b for Gauss's steps, a and √(a² − b²) for Landen's, which go on until nothing is left of b.
    """
    ratio = b / a
    if ratio > APART:
        gap, least = a - b, epsilon() / 8
    else:
        gap, least = b * (b / (a + sqrt((a - b) * (a + b)))), epsilon() * ratio * ratio / 8
    shares, large, less = [gap / a], a, gap / 2
    while True:
        next_one = large - gap / 2
        gap = gauss_gap(gap, next_one + sqrt(large * (large - gap)))
        if gap <= least * large:
            return shares, a - less
        shares.append(gap / next_one)
        large, less = next_one, less + gap / 2
