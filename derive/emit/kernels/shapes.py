"""The shape of a rod along its length, elementwise in the arc length."""

from __future__ import annotations

from derive.emit.kernels.agm import agm, half_period, root_ratios
from derive.emit.kernels.arithmetic import pi, sqrt
from derive.emit.kernels.array_arithmetic import each_abs, each_atan2, each_floor, each_where
from derive.emit.kernels.formulas_each import arc_y_each, arc_z_each
from derive.emit.kernels.rods import arc_to, half_period_point
from derive.emit.kernels.timing import roots_of


def angle_and_position(equilibrium, s):
    """θ, θ′, y and z at arc lengths s from the clamp."""
    if equilibrium.tip is None:
        angle = equilibrium.tip_angle
        slope = s / equilibrium.rod.length
        return angle + 0 * s, 0 * s, equilibrium.y * slope, equilibrium.z * slope
    rod, tip = equilibrium.rod, equilibrium.tip
    angle, turning, y, z = from_tip(rod.beta, rod.eta, tip, rod.length - s)
    if rod.mirrored:
        return 2 * pi * (rod.turns + 1) - angle, turning, equilibrium.y - y, equilibrium.z + z
    return 2 * pi * rod.turns + angle, -turning, equilibrium.y - y, equilibrium.z - z


def from_tip(beta, eta, tip, sigma):
    """θ, dθ/dσ, ∫₀^σ cos θ and ∫₀^σ sin θ at arc lengths σ from the tip.

    tan(θ/2) is tan(θ_ℓ/2) times the square root of (℘ − e₊)/(℘ − e₋), so it is one ratio of cn, dn and 1.
    """
    roots = roots_of(beta, eta, tip)
    passes = eta <= beta or tip.passes
    steps = agm(sqrt(roots.long_gap), sqrt(roots.short_gap))
    half = half_period(steps)
    waves = each_floor(sigma / (2 * half) + 0.5)
    within = sigma - 2 * half * waves
    r, cn, dn = root_ratios(steps, each_abs(within))
    ratios = {roots.order[0]: cn, roots.order[1]: dn, roots.order[2]: 1}
    side = each_where(within < 0, -1, 1)
    # Through π the motion of θ takes two periods of ℘: every other one is its mirror image.
    flip = each_where(waves % 2 == 0, 1, -1) if passes else 1
    up = tip.half_sine * ratios["+"]
    across = tip.half_cosine * ratios["-"] * flip
    swing = dn if passes else cn
    drive = tip.drive
    turning = 2 * tip.half_sine * tip.half_cosine * drive * r * swing * side * flip / (up * up + across * across)
    y, z = part_arc(beta, eta, tip, sigma, r, ratios)
    whole = arc_to(beta, eta, tip, half_period_point(beta, eta, tip))
    xi_tip = (tip.half_cosine - tip.half_sine) * (tip.half_cosine + tip.half_sine)
    y = xi_tip * sigma + 2 * waves * (whole.y - xi_tip * half) + side * y
    z = flip * side * z + (0 if passes else 2 * waves * whole.z)
    return 2 * each_atan2(up, across), turning, y, z


def part_arc(beta, eta, tip, sigma, r, ratios):
    """∫(cos θ − ξ_ℓ) and ∫sin θ from the tip to a point of the first half-period.

    The arguments of Carlson's integrals are (℘ − e)r², finite at the tip too; by homogeneity the integral of the
    third kind then takes a factor r³ and the elementary one a factor r.
    """
    plus, minus = 2 * tip.half_cosine**2, 2 * tip.half_sine**2
    scaled = [ratios[name] * ratios[name] + 0 * r for name in "+-o"]
    drive = tip.drive
    y = r**3 * arc_y_each(eta * r * r, plus, minus, drive, 0, 0, *scaled)
    z = r * arc_z_each(eta * r * r, plus, minus, 2 * tip.half_sine * tip.half_cosine, scaled[2])
    return y, z
