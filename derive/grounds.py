"""What the displays rest on that say nothing of their own: they put one derived thing into another, or name it.

A display whose label is the source of a claim rests on that claim; the others are here, with the claims that make them
hold. ``derive explain`` starts from these.
"""

from __future__ import annotations

GROUNDS: dict[str, tuple[str, ...]] = {
    # The substitution, its derivative, the differential equation after it, and that its unknown is ℘.
    "exsl28": ("weierstrass.resolvent",),
    "slch7": ("weierstrass.force_only.linear",),
    "slch8": ("weierstrass.force_only.linear", "quartic.force_only.motion"),
    "slch9": ("weierstrass.force_only.linear",),
    # The two examples, by the figures that show them: whole rods under given loads.
    "Fi:F_H_ortogonali": ("plane.moment", "plane.first_integral", "quartic.orthogonal.free_end"),
    "Fi:F_fisso_H_variabile": ("plane.moment", "plane.first_integral", "quartic.parallel.free_end"),
}
