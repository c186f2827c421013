"""Directions of equilibrium that all but merge: θ″ and dθ″/dθ there, without cancellation.

Where the field is nearly along the force, or nearly across it, and η next to β, three directions merge; elsewhere on
Stoner and Wohlfarth's astroid a hill and a well do. A field at the angle λ from the force and one at λ from its normal
have the same directions of this kind but for a quarter turn and a sign: π − p and p, where V is stationary between the
normal of the field and the force, and π + λ + x and −λ − x, the second pair. Close to each other they are told by their
distance from the force or from the cusp, where tan³x = tan λ; and η and β, of which only the difference counts, are
subtracted first.
"""

from __future__ import annotations

from sympy import Add, Expr, Integer, Matrix, Symbol, cos, diff, oo, pi, sin, symbols

from .claims import Domain, Equal
from .swing_levels import Levels
from .swing_names import Writer, field_angle, turned
from .symbols import beta, eta, theta

lean = Symbol("lean", real=True)  # λ: from the force to the field, or from its normal
gap = Symbol("gap", real=True)  # p
turn = Symbol("turn", real=True)  # x
cusp = Symbol("cusp", real=True)  # x where the pair is born
beside = Symbol("beside", real=True)  # x less that
# Sines and cosines: of λ/2 and λ, of p, of x or λ + p and half of it, of λ + x, and of what stands beside λ/2.
lean_sine, lean_half_sine, lean_cosine, gap_sine = symbols("lean_sine lean_half_sine lean_cosine gap_sine", real=True)
turn_sine, turn_half_sine = symbols("turn_sine turn_half_sine", real=True)
force_sine, side_cosine = symbols("force_sine side_cosine", real=True)
along, across = symbols("along across", real=True)  # cos and sin of λ + p; of x with sin and cos of the cusp
couple, stiffness = symbols("couple stiffness", real=True)  # θ″ and dθ″/dθ at the cusp
half_sine, quarter_sine, three_sine = symbols("half_sine quarter_sine three_sine", real=True)  # of u/2, u/4, 3u/4
near_sine, far_sine = symbols("near_sine far_sine", real=True)  # of 2x + u/4 and 2x + 3u/4 at the cusp
cusp_cosine, beside_sine = symbols("cusp_cosine beside_sine", real=True)
scale = Symbol("scale", positive=True)  # sin λ/sin³x = cos λ/cos³x at the cusp
LEAN = {beta: (Integer(0), oo), eta: (Integer(0), oo), lean: (Integer(0), pi / 2)}
BESIDE_FORCE = Domain({**LEAN, gap: (0, pi / 2)})
PAIR = Domain({**LEAN, turn: (0, pi / 2)})


def write_merging(levels: Levels, writer: Writer) -> None:
    """θ″ and dθ″/dθ of the directions beside the force, and of the pair."""
    stiff = diff(levels.moment, theta)
    _write_beside_force(levels.moment, stiff, writer)
    _write_pair(levels.moment, stiff, writer)
    _write_beside_cusp(levels.moment, stiff, writer)


def _leaning(value: Expr, angle: Expr) -> Expr:
    """A value in θ and α at an angle, for the field at λ from the force."""
    return turned(value, angle).subs(field_angle, lean)


def _steep(value: Expr, angle: Expr) -> Expr:
    """The same for the field at λ from the normal of the force."""
    return turned(value, angle).subs(field_angle, pi / 2 - lean)


def _write_beside_force(moment: Expr, stiff: Expr, writer: Writer) -> None:
    """π − p for the field at λ, p for the field at π/2 − λ."""
    angles = {
        gap_sine: sin(gap),
        lean_sine: sin(lean),
        lean_cosine: cos(lean),
        lean_half_sine: sin(lean / 2),
        side_cosine: cos(Add(gap, lean / 2)),
        turn_sine: sin(Add(lean, gap)),
        turn_half_sine: sin(Add(lean, gap) / 2),
        along: cos(Add(lean, gap)),
        across: sin(Add(lean, gap)),
    }
    unlike = lean_half_sine * side_cosine - turn_sine * turn_half_sine**2
    writer.add(
        "force_balance",
        (beta, eta, gap_sine, lean_half_sine, side_cosine, turn_sine, turn_half_sine),
        (beta - eta) * gap_sine - 2 * eta * unlike,
        "θ″ at π − p, and at p with the field at λ from the normal of the force, by β − η",
        lambda value: Equal(
            Matrix([value.subs(angles), value.subs(angles)]),
            Matrix([_leaning(moment, pi - gap), _steep(moment, gap)]),
        ),
        BESIDE_FORCE,
        steps=("moment",),
        source="exsl6",
    )
    writer.add(
        "force_stiffness",
        (eta, lean_sine, lean_cosine, along, across, gap_sine),
        eta * (lean_sine * along**3 + lean_cosine * across**3) / gap_sine,
        "−dθ″/dθ at π − p, dθ″/dθ at p, where θ″ vanishes, by cosine and sine of λ + p",
        lambda value: Equal(
            Matrix([-value.subs(angles) * sin(gap), value.subs(angles) * sin(gap)]),
            Matrix(
                [
                    _leaning(stiff, pi - gap) * sin(gap) + _leaning(moment, pi - gap) * cos(gap),
                    _steep(stiff, gap) * sin(gap) - _steep(moment, gap) * cos(gap),
                ]
            ),
        ),
        BESIDE_FORCE,
        steps=("moment", "rest_stiffness"),
    )


def _write_pair(moment: Expr, stiff: Expr, writer: Writer) -> None:
    """π + λ + x for the field at λ, −λ − x for the field at π/2 − λ."""
    angles = {
        force_sine: sin(Add(lean, turn)),
        lean_half_sine: sin(lean / 2),
        side_cosine: cos(Add(turn, lean / 2)),
        turn_sine: sin(turn),
        turn_half_sine: sin(turn / 2),
    }
    unlike = lean_half_sine * side_cosine + turn_sine * turn_half_sine**2
    writer.add(
        "pair_couple",
        (beta, eta, force_sine, lean_half_sine, side_cosine, turn_sine, turn_half_sine),
        (eta - beta) * force_sine - 2 * eta * unlike,
        "θ″ at π + λ + x, and at −λ − x with the field at λ from the normal of the force",
        lambda value: Equal(
            Matrix([value.subs(angles), value.subs(angles)]),
            Matrix([_leaning(moment, Add(pi, lean, turn)), _steep(moment, -Add(lean, turn))]),
        ),
        PAIR,
        steps=("moment",),
        source="exsl6",
    )
    place = Add(lean, turn)
    cubes = eta * (sin(lean) * cos(turn) ** 3 - cos(lean) * sin(turn) ** 3)
    level = Equal(
        Matrix([cubes, -cubes]),
        Matrix(
            [
                _leaning(stiff, pi + place) * sin(place) - _leaning(moment, pi + place) * cos(place),
                _steep(stiff, -place) * sin(place) + _steep(moment, -place) * cos(place),
            ]
        ),
    )
    title = "dθ″/dθ of the pair by cubes; at tan³x = tan λ it is θ″ cot(λ + x)"
    writer.claim("pair_cubes", title, level, PAIR, steps=("moment", "rest_stiffness"))


def _write_beside_cusp(moment: Expr, stiff: Expr, writer: Writer) -> None:
    """x = cusp + u."""
    place = Add(pi, lean, cusp)
    angles = {
        couple: _leaning(moment, place),
        stiffness: _leaning(stiff, place),
        half_sine: sin(beside / 2),
        quarter_sine: sin(beside / 4),
        three_sine: sin(3 * beside / 4),
        near_sine: sin(2 * cusp + beside / 4),
        far_sine: sin(2 * cusp + 3 * beside / 4),
        force_sine: sin(Add(lean, cusp, beside / 4)),
    }
    field = three_sine * far_sine + quarter_sine * near_sine
    writer.add(
        "cusp_couple",
        (beta, eta, couple, stiffness, half_sine, quarter_sine, three_sine, near_sine, far_sine, force_sine),
        couple + 2 * half_sine * (stiffness - eta * field + 2 * beta * quarter_sine * force_sine),
        "θ″ at an angle u beside the cusp, by θ″ and dθ″/dθ there",
        lambda value: Equal(value.subs(angles), _leaning(moment, Add(place, beside))),
        Domain({**LEAN, cusp: (0, pi / 2), beside: (-1, 1)}),
        steps=("pair_couple", "pair_cubes"),
    )
    sines = {
        cusp_cosine: cos(cusp),
        lean_cosine: scale * cos(cusp) ** 3,
        beside_sine: sin(Add(turn, -cusp)),
        along: cos(cusp) * sin(turn),
        across: sin(cusp) * cos(turn),
    }
    cubes = eta * scale * ((sin(cusp) * cos(turn)) ** 3 - (cos(cusp) * sin(turn)) ** 3)
    writer.add(
        "pair_stiffness",
        (eta, lean_cosine, cusp_cosine, beside_sine, along, across, force_sine),
        -eta * lean_cosine * beside_sine * (along**2 + along * across + across**2) / (cusp_cosine**3 * force_sine),
        "dθ″/dθ of the pair, where θ″ vanishes, by the sine of what x is beyond the cusp",
        lambda value: Equal(value.subs(sines) * force_sine, cubes),
        Domain({eta: (0, oo), scale: (0, oo), cusp: (0, pi / 2), turn: (0, pi / 2), force_sine: (0, 1)}),
        steps=("pair_cubes", "astroid_place"),
    )
