"""The peers that solve the boundary value problem, as one table: method, settings, and how one is called."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from typing import Any

from derive.measure.reference import Rod
from derive.measure.work.cells import PEER, Cell
from derive.measure.work.problems import Diagram, Problem

TOLERANCES = (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
SHOOTING = (1e-3, 1e-6, 1e-9, 1e-12)
ORDERS = (8, 12, 16, 24, 32, 48)


@dataclass(frozen=True)
class Peer:
    """place: module and function in `peers`. settings: what its last arguments may be; those of a quick run first.

    tasks: those it can do. all_of: it finds all equilibria from nine guesses, with the settings that are worth it.
    """

    method: str
    place: str
    settings: tuple[Any, ...]
    quick: tuple[Any, ...]
    tasks: str
    more: tuple[Any, ...] = ()


PEERS = (
    Peer("solve_bvp", "bvp", TOLERANCES, (1e-3, 1e-8), "T1 T2 T3 T4 T6"),
    Peer("shooting, DOP853", "shooting", SHOOTING, (1e-6,), "T1 T2 T3 T4 T6", ("DOP853",)),
    Peer("shooting, LSODA", "shooting", SHOOTING, (1e-6,), "T1 T2 T3 T6", ("LSODA",)),
    Peer("shooting, Radau", "shooting", SHOOTING[:3], (1e-3,), "T1 T3", ("Radau",)),
    Peer("Chebyshev", "chebyshev", ORDERS, (16, 32), "T1 T2 T3 T4 T6"),
    Peer("discrete rod, L-BFGS", "discrete", (20, 80), (20,), "T1", ("L-BFGS",)),
    Peer("discrete rod, trust-ncg", "discrete", (20, 80, 320, 1280), (20,), "T1 T3", ("trust-ncg",)),
    Peer("SciPy R_F, R_J, ellipj", "special", ((),), ((),), "T1 T3"),
)
# Nine guesses for every rod cost the more; of a discrete rod the coarsest and finest are enough.
FOR_ALL = {1e-3, 1e-6, 1e-8, 1e-10, 1e-9, 16, 32, 48}


def absent() -> str:
    """Why the peers are left out, or nothing."""
    return "" if find_spec("scipy") else "SciPy is not installed (pip install 'magnetic-rods[bench]')"


def peer_cells(problem: Problem, *, quick: bool) -> Iterator[Cell]:
    """Every peer with every setting, on a problem of rods."""
    for peer in PEERS if not absent() else ():
        for setting in peer.quick if quick else peer.settings:
            if problem.task not in peer.tasks or (problem.task in ("T2", "T4") and setting not in FOR_ALL):
                continue
            yield Cell(problem, peer.method, spelled(setting), PEER, partial(call, problem, peer, setting))


def spelled(setting: Any) -> str:
    """A setting for tables: a tolerance, a number of nodes, or none."""
    if setting == ():
        return "–"
    return f"tol {setting:.0e}".replace("e-0", "e-") if isinstance(setting, float) else f"n = {setting}"


def call(problem: Problem, peer: Peer, setting: Any) -> Callable[[], Any]:
    """What is timed."""
    from importlib import import_module

    module = import_module(f"derive.measure.work.peers.{peer.place}")
    arguments = peer.more if setting == () else (setting, *peer.more)

    def solve(rod: Rod, tip: float, **options: Any) -> Any:
        return module.solve(rod, tip, *arguments, **options)

    match problem.task:
        case "T1":
            return lambda: [answers([solve(rod, tip)]) for rod, tip in problem.inputs]
        case "T2" | "T4":
            return partial(every, solve, rods_of(problem))
        case "T3":
            shaped = partial(solve, shape=True) if peer.place == "shooting" else solve
            return partial(shape, shaped, problem.inputs)
        case _:
            return lambda: [module.fold(rod, *guess, *arguments) for rod, guess in problem.inputs]


def rods_of(problem: Problem) -> list[Rod]:
    """Those for which all equilibria are wanted."""
    given = problem.inputs
    return [given.rod(number) for number in given.sample] if isinstance(given, Diagram) else list(given)


def answers(found: list[Any]) -> list[tuple[Any, Any, Any]]:
    """Tip angle and position of what was found."""
    return [(one.tip_angle, one.y, one.z) for one in found if one is not None]


def every(solve: Any, rods: list[Rod]) -> list[Any]:
    """All that nine guesses find, for each rod."""
    from derive.measure.work.peers.common import all_found

    return [answers(all_found(solve, rod)) for rod in rods]


def shape(solve: Any, inputs: tuple[Any, ...]) -> Any:
    """θ, y and z at all points; three times None where nothing was found. Only the sample is handed on."""
    rod, tip, s, sample = inputs
    found = solve(rod, tip)
    if found is None:
        return [[float("nan")] * len(sample)] * 3
    return [column[sample].tolist() for column in found.at(s)]
