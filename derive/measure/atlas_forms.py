"""θ along a rod from its tip, by closed forms as people write them today, on arrays.

`by_ellipj`: the field along the force (or one load alone); tan(θ/2) is one Jacobi function of scipy.special.ellipj.
With a = tan(φ/2), C = cos²(φ/2), S = sin²(φ/2), G = β + ηC and H = β − ηS, tan²(θ/2) = τ² obeys
τ_σ² = (τ² − a²)(G + Hτ²)C, so that τ = a/cn, a/dn or a·dn.

`by_invariants`: any field; t = tan((θ − φ)/2) = (p/4)/(℘(σ) − q/12) with g₂ and g₃ as doubles. What follows after
them is done well: gaps between the roots without further loss, Jacobi functions by the arithmetic-geometric mean with
both m and 1 − m. What goes wrong is then the fault of g₂ and g₃.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.measure.reference import Rod

Array = NDArray[np.float64]
MOST_STEPS = 40
LEAST = 1e-300  # of 1 − m: the mean of 1 and 0 is none


def by_ellipj(rod: Rod, tips: Array, sigma: Any) -> Array:
    """θ at lengths σ from the tip; tips and σ are broadcast. For field_angle = 0."""
    from scipy.special import ellipj

    turns = np.round(tips / (2 * np.pi))
    tip = tips - 2 * np.pi * turns
    a, c, s = np.tan(tip / 2), np.cos(tip / 2) ** 2, np.sin(tip / 2) ** 2
    g, h = rod.beta + rod.eta * c, rod.beta - rod.eta * s
    passes, grows = h >= 0, g * c >= -h * s
    square = np.where(passes, g * c + h * s, np.where(grows, g * c, -h * s))
    some = np.where(square > 0, square, 1.0)
    least = np.where(passes, h * s, np.where(grows, -h * s, g * c)) / some
    _, cn, dn, _ = ellipj(np.sqrt(square) * sigma, np.clip(1 - least, 0, 1))
    below = np.where(passes, cn, np.where(grows, dn, 1.0))
    above = np.where(passes | grows, a, a * dn)
    return 2 * np.arctan2(np.abs(above), below) * np.sign(a) + 2 * np.pi * turns


def by_invariants(rod: Rod, tips: Array, sigma: Any) -> Array:
    """θ at lengths σ from the tip, by ℘ of g₂ and g₃."""
    lean = tips - rod.field_angle
    force, across = rod.beta * np.cos(tips), rod.beta * np.sin(tips)
    p = across + rod.eta / 2 * np.sin(2 * lean)
    q = force + rod.eta * np.cos(2 * lean)
    m = across - rod.eta / 2 * np.sin(2 * lean)
    g2 = q**2 / 12 - m * p / 4
    g3 = m * p * q / 48 - q**3 / 216 - force * p**2 / 16
    over = wp(np.asarray(sigma, dtype=float), g2, g3) - q / 12
    turned = 2 * np.arctan2(np.abs(p) / 4, over)
    return tips + np.where(p == 0, 0.0, np.sign(p) * turned)


def wp(u: Array, g2: Array, g3: Array) -> Array:
    """℘(u; g₂, g₃) for real u (Abramowitz and Stegun 18.9), ∞ at 0."""
    u, g2, g3 = np.broadcast_arrays(u, g2, g3)
    discriminant = g2**3 - 27 * g3**2
    real = discriminant >= 0
    with np.errstate(all="ignore"):
        value = np.where(real, _of_real_roots(u, g2, g3, discriminant), _of_a_pair(u, g2, g3))
        return np.where((g2 == 0) & (g3 == 0), 1 / u**2, value)


def _of_real_roots(u: Array, g2: Array, g3: Array, discriminant: Array) -> Array:
    size = np.sqrt(np.maximum(g2, 0) / 3)
    root, real = np.sqrt(np.maximum(discriminant, 0)), np.sqrt(27) * g3
    angle, rest = np.arctan2(root, real) / 3, np.arctan2(root, -real) / 3
    upper, lower = np.sqrt(3) * size * np.sin(rest), np.sqrt(3) * size * np.sin(angle)
    least = size * np.cos(angle + 2 * np.pi / 3)
    whole = upper + lower
    sn, _, _ = jacobi(np.sqrt(whole) * u, lower / whole, upper / whole)
    return least + whole / sn**2


def _of_a_pair(u: Array, g2: Array, g3: Array) -> Array:
    root = np.sqrt(np.maximum(27 * g3**2 - g2**3, 0))
    # The real root of 4x³ − g₂x − g₃: of Cardano's two parts the larger one, then the other by their product.
    part = np.cbrt((np.sqrt(27) * np.abs(g3) + root) / (8 * np.sqrt(27))) * np.where(g3 < 0, -1, 1)
    single = part + g2 / (12 * part)
    size = np.sqrt(np.maximum(3 * single**2 - g2 / 4, 0))
    share = 3 * single / (4 * size)
    sn, cn, dn = jacobi(np.sqrt(size) * u, 0.5 - share, 0.5 + share)
    # (1 + cn 2w)/(1 − cn 2w) = (cn w/(sn w dn w))² at half the argument, without a difference.
    return single + size * (cn / (sn * dn)) ** 2


def jacobi(u: Array, m: Array, rest: Array) -> tuple[Array, Array, Array]:
    """sn, cn, dn by the descending Landen transformation (Abramowitz and Stegun 16.4), with m and 1 − m."""
    rest = np.maximum(rest, LEAST)
    a, b = np.ones(np.shape(m)), np.sqrt(rest)
    shares, scale = [], 1.0
    for _ in range(MOST_STEPS):
        shares.append((a - b) / (a + b))
        a, b, scale = (a + b) / 2, np.sqrt(a * b), 2 * scale
        if not np.any(shares[-1] > 1e-16):
            break
    phase = scale * a * u
    for share in reversed(shares):
        phase = (phase + np.arcsin(np.clip(share * np.sin(phase), -1, 1))) / 2
    sn, cn = np.sin(phase), np.cos(phase)
    return sn, cn, np.sqrt(rest + m * cn**2)
