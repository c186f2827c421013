"""The motion of any rod between two turning points: the formulas that solvers evaluate, for every field angle.

They start from the half-angle quartic of ``oblique`` and need no load case. The scripts: ``swing_levels`` (θ″ and the
potential V), ``swing_rest`` (the directions of equilibrium), ``swing_shots`` (bounds for every tip), ``swing_turns``
(two turning points), ``swing_ends`` (the same by one of them), ``swing_rates`` (the length as a Legendre integral),
``swing_phase`` (its phase, and Gauss's step), ``swing_second`` (an integral of the second kind by that step),
``swing_landen`` (that step and Landen's by what they change), ``swing_before`` (the phase a length before a known
one), ``swing_points`` (℘ at the tip), ``swing_place`` and ``swing_angle`` (the same and θ by the phase),
``swing_along`` (integrals as claims), ``swing_arcs`` (the position), ``swing_square`` and ``swing_energy``
(∫η cos²(θ − α), by R_D and by the phase).
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import expand

from .claims import Formula, Notebook
from .oblique import Oblique
from .plane import Plane
from .swing_angle import write_angle
from .swing_arcs import write_arcs
from .swing_before import write_before
from .swing_ends import write_ends
from .swing_energy import write_energy
from .swing_landen import write_landen
from .swing_levels import Levels, write_levels
from .swing_names import Writer
from .swing_phase import write_phase
from .swing_place import write_place
from .swing_points import Points, write_points
from .swing_rates import write_rates
from .swing_rest import write_rest
from .swing_second import write_second_kind
from .swing_shots import write_shots
from .swing_square import write_square
from .swing_turns import Turns, write_turns
from .symbols import eta


@dataclass(frozen=True)
class Swing:
    """levels, turns, points: from the scripts of these names.

    formulas: those that solvers evaluate, of the case ``oblique``. steps: those that they rest on.
    """

    levels: Levels
    turns: Turns
    points: Points
    formulas: tuple[Formula, ...]
    steps: tuple[Formula, ...]


def derive(plane: Plane, oblique: Oblique, book: Notebook) -> Swing | None:
    """The formulas of the motion; None for another energy than that of paramagnetic particles."""
    book.say("Any angle of the field. The potential")
    if expand(plane.energy_density + eta * plane.alignment**2 / 2) != 0:
        book.say("It is not that of the energy −½ηw², for which the motion is written down.")
        return None
    writer = Writer(book)
    levels = write_levels(plane, oblique.half, writer)
    write_rest(levels, writer)
    write_shots(levels, writer)
    book.say("Any angle of the field. The motion between two turning points")
    turns = write_turns(levels, writer)
    write_ends(levels, turns, writer)
    write_rates(writer)
    write_phase(writer)
    write_second_kind(writer)
    write_landen(writer)
    write_before(writer)
    book.say("Any angle of the field. Points of the motion by ℘ at the tip")
    points = write_points(levels, turns, oblique.half, writer)
    place = write_place(writer)
    write_angle(writer)
    position = write_arcs(points, oblique.half, writer)
    write_square(position, oblique.half, writer)
    write_energy(place, position, oblique.half, writer)
    return Swing(levels, turns, points, tuple(writer.formulas), tuple(writer.steps))


def main() -> None:
    """Print the derivation up to here."""
    from .chain import print_up_to

    print_up_to("swing")


if __name__ == "__main__":
    main()
