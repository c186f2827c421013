"""What the displays rest on that say nothing of their own: they put one derived thing into another, or name it.

A display whose label is the source of a claim rests on that claim; the others are here, with the claims that make them
hold. ``derive explain`` starts from these.
"""

from __future__ import annotations

GROUNDS: dict[str, tuple[str, ...]] = {
    # Where ξ may lie: f̂ ≥ 0 between, or outside, its roots, and a cosine.
    "exsl15": ("quartic.parallel.levels", "quartic.parallel.factors", "quartic.parallel.order"),
    "exhpf4": ("quartic.orthogonal.levels", "quartic.orthogonal.factors", "quartic.orthogonal.order"),
    # ϰ is ℘: the differential equation of the one is that of the other.
    "exsl19a": ("weierstrass.resolvent", "weierstrass.parallel.at_one"),
    "exsl20": ("weierstrass.resolvent", "weierstrass.parallel.at_one"),
    "slch9": ("weierstrass.force_only.linear",),
    # The substitution, its derivative, and the differential equation after it.
    "exsl28": ("weierstrass.resolvent",),
    "slch7": ("weierstrass.force_only.linear",),
    "slch8": ("weierstrass.force_only.linear", "quartic.force_only.motion"),
    # The tip lies at a half-period.
    "exsl30": ("quartic.parallel.free_end", "weierstrass.parallel.roots"),
    # y″ by the curvature, and z as its integral.
    "exsl37": ("plane.bending", "quartic.parallel.gamma"),
    "exsl38": ("shape.parallel.z", "shape.parallel.z_sign"),
    "exsl40": ("shape.parallel.z", "shape.parallel.square"),
    "slch13": ("shape.force_only.z", "shape.force_only.z_sign"),
    "exhpf16": ("shape.orthogonal.z_above", "shape.orthogonal.z_below"),
    # The two examples, by the figures that show them: whole rods under given loads.
    "Fi:F_H_ortogonali": ("plane.moment", "plane.first_integral", "quartic.orthogonal.free_end"),
    "Fi:F_fisso_H_variabile": ("plane.moment", "plane.first_integral", "quartic.parallel.free_end"),
}
