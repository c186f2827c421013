"""What methods share that solve the boundary value problem from a guess: how they are called for each task."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.measure.bench.cells import PEER, Call, Cell, Method, Problem
from derive.measure.bench.families import Plan
from derive.measure.reference import Rod

Array = NDArray[np.floating[Any]]
# Turns from the clamp angle to the tip angle from which a user would start, who looks for all equilibria.
TURNS = np.linspace(-3.0, 3.0, 9)
APART = 1e-3  # tip angles nearer than this are taken for one


@dataclass(frozen=True)
class Solved:
    """One equilibrium: tip angle, tip position, and θ, y, z at arc lengths."""

    tip_angle: float
    y: float
    z: float
    at: Callable[[Array], tuple[Array, Array, Array]]


@dataclass(frozen=True)
class RodSolver:
    """A method that finds the equilibrium near a guess of the tip angle, and a fold near guesses of η and tip angle.

    solve(rod, tip angle, setting) gives Solved or None, fold(rod, η, tip angle, setting) gives (η, tip angle) or None.
    settings: tolerances, numbers of nodes. quick: those of a quick run, and of problems that are too much for all.
    spelled: a setting for tables. limit: from a setting to the worst error that is no fault.
    """

    name: str
    solve: Callable[[Rod, float, Any], Solved | None]
    settings: Sequence[Any]
    quick: Sequence[Any]
    spelled: Callable[[Any], str]
    limit: Callable[[Any], float]
    tasks: Sequence[str]
    fold: Callable[[Rod, float, float, Any], tuple[float, float] | None] | None = None

    def method(self, *needs: str) -> Method:
        """As a method of others."""
        return Method(self.name, PEER, self.cells, needs)

    def cells(self, problem: Problem, plan: Plan) -> Iterator[Cell]:
        """One for each setting."""
        if problem.task in self.tasks:
            for setting in self.quick if plan.quick or problem.brief else self.settings:
                share = self.share(problem)
                limit = self.limit(setting)
                yield Cell(self.spelled(setting), partial(self.call, problem, setting), limit, share=share)

    def share(self, problem: Problem) -> float:
        """Of a diagram, the rods that are solved."""
        given = problem.inputs
        return len(given.sample) / len(given.beta) if problem.task == "T4" else 1.0

    def call(self, problem: Problem, setting: Any) -> Call:
        """What is timed, on a problem."""
        given = problem.inputs

        def solve(rod: Rod, tip_angle: float) -> Solved | None:
            return self.solve(rod, tip_angle, setting)

        match problem.task:
            case "T1":
                return lambda: [answers([solve(rod, tip)]) for rod, tip in given]
            case "T2":
                return lambda: [all_found(solve, rod) for rod in given[1]]
            case "T3":
                return partial(shape, solve, *given)
            case "T4":
                return lambda: [all_found(solve, rod) for rod in given.rods]
            case _:
                fold = self.fold
                assert fold is not None
                return lambda: [fold(rod, eta, tip, setting) for rod, (eta, tip) in given]


def answers(found: Sequence[Solved | None]) -> list[tuple[float, float, float]]:
    """Tip angle and position of what was found."""
    return [(one.tip_angle, one.y, one.z) for one in found if one is not None]


def all_found(solve: Callable[[Rod, float], Solved | None], rod: Rod) -> list[tuple[float, float, float]]:
    """What nine guesses lead to, each equilibrium once, sorted by tip angle."""
    found = list[Solved]()
    for turn in TURNS:
        one = solve(rod, rod.clamp_angle + float(turn))
        if one is not None and all(abs(one.tip_angle - other.tip_angle) > APART for other in found):
            found.append(one)
    found.sort(key=lambda solved: solved.tip_angle)
    return answers(found)


def shape(
    solve: Callable[[Rod, float], Solved | None], rod: Rod, tip: float, s: Array, sample: Array
) -> list[list[float]]:
    """θ, y and z at all points; of these the sample is handed on."""
    found = solve(rod, tip)
    if found is None:
        return [[float("nan")] * len(sample)] * 3
    return [column[sample].tolist() for column in found.at(s)]


def couple(rod: Rod, theta: Any) -> Any:
    """θ″ at an angle."""
    return rod.beta * np.sin(theta) + rod.eta / 2 * np.sin(2 * (theta - rod.field_angle))


def stiffness(rod: Rod, theta: Any) -> Any:
    """dθ″/dθ."""
    return rod.beta * np.cos(theta) + rod.eta * np.cos(2 * (theta - rod.field_angle))


def bend(rod: Rod, theta: Any) -> Any:
    """d²θ″/dθ²."""
    return -rod.beta * np.sin(theta) - 2 * rod.eta * np.sin(2 * (theta - rod.field_angle))


def first_guess(rod: Rod, tip_angle: float, share: Array) -> Array:
    """The parabola over s/ℓ that has the clamp angle at the clamp, and the tip angle and no curvature at the tip."""
    return np.asarray(rod.clamp_angle + (tip_angle - rod.clamp_angle) * share * (2 - share))


def by_tolerance(tolerance: float) -> str:
    """A tolerance for tables: tol 1e-8."""
    return f"tol {tolerance:.0e}".replace("e-0", "e-")


def by_number(number: int) -> str:
    """A number of nodes or segments for tables."""
    return f"n = {number}"
