"""The phase by its tangent, in steps that change it little.

With t = tan ψ the length is ∫dt/√((1 + t²)(a² + b²t²)). Where a and b are near each other, Gauss's step changes t² by
little. Where b is small beside a, Landen's does, with c = √(a² − b²): it replaces a and c by their arithmetic and
geometric mean, b by (a − c)/2, and ends where b = 0 and t = sinh aσ. Where a < b they are exchanged. Both are written
by the share by which they change t or t²: of a small share few digits are rounded.
"""

from __future__ import annotations

from sympy import Expr, Symbol, diff, oo, sqrt, symbols

from .claims import Domain, Equal
from .swing_names import Writer
from .swing_phase import first, second

share = Symbol("share", real=True)  # (a − b)/a in Gauss's step, (a − c)/a in Landen's
bent = Symbol("bent", real=True)  # b tan ψ/a
tan_phase, tan_square = symbols("tan_phase tan_square", real=True)  # tan ψ, tan²ψ
root, other_root = symbols("root other_root", real=True)
POSITIVE = (0, oo)
TANGENTS = Domain({first: POSITIVE, second: POSITIVE, tan_phase: POSITIVE, tan_square: POSITIVE, share: (0, 1)})
SOURCE = "DLMF 19.8(ii)"


def speed(at: Expr, one: Expr, other: Expr) -> Expr:
    """(dσ/dt)² by t² and by the squares of the rates."""
    return 1 / ((1 + at) * (one + other * at))


def write_landen(writer: Writer) -> None:
    """Both steps, forth and back, by shares."""
    writer.add(
        "tangent_exchanged",
        (first, second, tan_phase),
        tan_phase * second / first,
        "tan ψ of the same length where a and b are exchanged",
        lambda value: Equal(
            diff(value, tan_phase) ** 2 * speed(value**2, second**2, first**2),
            speed(tan_phase**2, first**2, second**2),
        ),
        TANGENTS,
        steps=("phase_rate",),
        source="DLMF 22.17(i)",
    )
    _write_landen(writer)
    _write_gauss(writer)


def _write_landen(writer: Writer) -> None:
    """Landen's step in tan ψ: with g = share, c = (1 − g)a."""
    square, squared = share * (2 - share), first**2 * share * (2 - share)  # (b/a)², and b²
    by_half = share * (1 + tan_phase**2)
    more = writer.add(
        "landen_more",
        (share, tan_phase),
        by_half / (2 - by_half),
        "by what share tan ψ is more before Landen's step than after it",
        lambda value: Equal(
            diff(tan_phase * (1 + value), tan_phase) ** 2 * speed(tan_phase**2 * (1 + value) ** 2, first**2, squared),
            speed(tan_phase**2, first**2 * (2 - share) ** 2 / 4, first**2 * share**2 / 4),
        ),
        TANGENTS,
        steps=("phase_rate",),
        source=SOURCE,
    )
    there = writer.add(
        "landen_root",
        (bent,),
        sqrt(1 + bent**2),
        "√(a² + b² tan²ψ)/a",
        lambda value: Equal(
            value.subs(bent, second * tan_phase / first) ** 2 * first**2, first**2 + second**2 * tan_phase**2
        ),
        TANGENTS,
        steps=("phase_rate",),
        source="DLMF 19.2.4",
    )
    there = there.subs(bent, sqrt(square) * tan_phase)
    after = writer.add(
        "landen_tangent",
        (share, tan_phase, root),
        tan_phase * (2 - share) / (1 + root),
        "tan ψ after Landen's step",
        lambda value: Equal((value * (1 + more.subs(tan_phase, value))).subs(root, there), tan_phase),
        TANGENTS,
        steps=("landen_more", "landen_root"),
        source=SOURCE,
    )
    writer.add(
        "landen_less",
        (share, bent, root),
        (share + bent**2 / (1 + root)) / (1 + root),
        "by what share tan ψ is less after Landen's step",
        lambda value: Equal(
            (tan_phase * (1 - value)).subs(bent, sqrt(square) * tan_phase).subs(root, there), after.subs(root, there)
        ),
        TANGENTS,
        steps=("landen_tangent", "landen_root"),
        source=SOURCE,
    )


def _write_gauss(writer: Writer) -> None:
    """Gauss's step in tan²ψ: with g = share, b = (1 − g)a."""
    other, source = 1 - share, "DLMF 19.8(iii)"
    more = writer.add(
        "gauss_more",
        (share, tan_square),
        share * (4 - share + 4 * tan_square) / ((2 - share) ** 2 + 4 * other * tan_square),
        "by what share tan²ψ is more before Gauss's step than after it",
        # dt = dt²/2t.
        lambda value: Equal(
            diff(tan_square * (1 + value), tan_square) ** 2
            * speed(tan_square * (1 + value), 1, other**2)
            / (tan_square * (1 + value)),
            speed(tan_square, (2 - share) ** 2 / 4, other) / tan_square,
        ),
        TANGENTS,
        steps=("phase_rate",),
        source=source,
    )
    by_one, by_both = sqrt(1 + tan_square), sqrt(1 + other**2 * tan_square)
    back = 1 + (1 + other) * root * (other_root**2 + other**2) / (
        (other**2 * root + other_root) * (1 + root * other_root)
    )
    writer.add(
        "gauss_less",
        (share, root, other_root),
        share * back / 2,
        "by what share tan²ψ is less after Gauss's step, by root = √(1 + tan²ψ) and other_root = √(1 + (b/a)² tan²ψ)",
        lambda value: undone(value.subs({root: by_one, other_root: by_both}), more),
        TANGENTS,
        steps=("gauss_more",),
        source=source,
    )


def undone(less: Expr, more: Expr) -> Equal:
    """What a step makes of tan²ψ is undone."""
    after = tan_square * (1 - less)
    return Equal(after * (1 + more.subs(tan_square, after)), tan_square)
