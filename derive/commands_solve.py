"""`derive solve`: all equilibria of one rod, or what brings its tip to a place."""

from __future__ import annotations

import argparse
import importlib.util
from collections.abc import Sequence
from math import radians
from typing import Any

from rich.markup import escape

from derive import commands, show
from derive.diagrams import aim, picture
from derive.diagrams.plotting import format_of, library
from derive.diagrams.problem import SMALL, Problem
from derive.diagrams.refused import must_be_solvable, must_be_traceable
from derive.diagrams.rod_file import read_rod
from derive.diagrams.tables import table
from derive.numbers import MistakeError, given_numbers, number, parameters, spelled_option

GENERAL = "oblique"  # the scene in which a rod from a file is solved


def run_solve(options: argparse.Namespace) -> int:
    """All equilibria of one rod, or all settings that reach a target."""
    must_fit(options)
    problem = problem_of(options)
    return aimed(problem, options) if options.target else listed(problem, options)


def must_fit(options: argparse.Namespace) -> None:
    """MistakeError for options that do not go together, before any work."""
    if options.scene is None and options.rod is None:
        raise MistakeError("no rod is given; name a scene, as in `derive solve parallel …`, or a file with --rod")
    if options.scene is not None and options.rod is not None:
        raise MistakeError(f"--rod brings its own loads; leave out the scene '{options.scene}'")
    if options.max_index is not None and options.max_index < 0:
        raise MistakeError(f"--max-index must be at least 0 (got {options.max_index})")
    if options.points < 2:
        raise MistakeError(f"--points must be at least 2 (got {options.points})")
    if options.range and not options.target:
        raise MistakeError("--range is for a --target; leave it out, or add as in --target y=-20")
    if options.target and (options.csv or options.plot):
        raise MistakeError("--csv and --plot show one rod; solve that of the setting found, without --target")
    if options.count and (options.target or options.max_index is not None):
        raise MistakeError("--count is of all equilibria of one rod; leave out --target and --max-index")
    if options.count:
        needs_flint()
    if options.plot:
        format_of(options.plot)
        library()


def needs_flint() -> None:
    """MistakeError where ball arithmetic is missing."""
    if importlib.util.find_spec("flint") is None:
        raise MistakeError("--count needs python-flint: pip install 'magnetic-rods[certified]'")


def problem_of(options: argparse.Namespace) -> Problem:
    """The rod that was asked for."""
    numbers = given_numbers(options)
    varied = aim.VARIED[options.vary] if options.target else None
    if options.rod:
        if numbers:
            raise MistakeError(f"{spelled_option(next(iter(numbers)))} is given by the file of --rod; leave it out")
        rod = read_rod(options.rod)
        with commands.running(options) as runner:
            module = commands.solver(runner, GENERAL)
        values = rod.parameters()
        return Problem(GENERAL, module, values, values, rod, options.degrees or rod.degrees)
    if options.degrees:
        numbers = {name: radians(value) if name.endswith("angle") else value for name, value in numbers.items()}
    if varied in numbers:
        raise MistakeError(f"{spelled_option(varied)} is what is sought; leave it out, or choose another with --vary")
    with commands.running(options) as runner:
        module = commands.solver(runner, options.scene)
    values = parameters(options.scene, module, numbers | ({varied: 0.0} if varied else {}))
    return Problem(options.scene, module, values, folded(options.scene) | values, None, options.degrees)


def folded(scene: str) -> dict[str, float]:
    """The parameters that a scene fixes."""
    from derive.emit.scene import load_scene

    return {name: float(value) for name, value in load_scene(commands.scene_path(scene)).folded.items()}


def listed(problem: Problem, options: argparse.Namespace) -> int:
    """Show and write all equilibria."""
    must_be_solvable(problem.full, options.max_index)
    try:
        found = problem.equilibria(options.max_index)
    except ValueError as error:
        raise MistakeError(str(error)) from error
    found = sorted(found, key=lambda one: (one.index, one.tip_angle))
    rows = [{"number": k, **problem.row(one)} for k, one in enumerate(found, 1)]
    count = "1 equilibrium" if len(found) == 1 else f"{len(found)} equilibria"
    show.console().print(escape(f"{count}: {problem.title()}"), soft_wrap=True)
    table(show.console(), [*problem.columns().values()], (cells(row, problem) for row in rows))
    data: dict[str, Any] = {"scene": problem.scene, "parameters": dict(problem.values)}
    if problem.rod:
        data |= {"units": {name: f"{unit:~}" for name, unit in problem.rod.units.items()} | {"energy": "J"}}
        data["epsilon"] = smallness(problem, found)
    if options.count:
        data["proved"] = counted(problem, len(found))
    commands.save(options.json, data | {"degrees": problem.in_degrees, "equilibria": rows})
    if options.csv:
        commands.write_file(options.csv, problem.csv(found, options.points).encode())
    if options.plot:
        kind = format_of(options.plot)
        commands.write_file(options.plot, picture.drawn(problem.curves(found, 401), problem.view(), kind))
    return 1 if options.count and data["proved"] != len(found) else 0


def counted(problem: Problem, found: int) -> int | None:
    """How many equilibria are proved to exist, None if that is not told; shown."""
    from derive.measure.reference import Rod
    from derive.measure.verified.counting import count

    number = count(Rod(**problem.full))
    if number == found:
        show.console().print("proved by ball arithmetic: there are no more and no fewer")
    elif number is None:
        why = "two equilibria all but meet, or two directions without moment do"
        show.console(stderr=True).print(f"derive solve: the number is not proved: {why}; change a load a little")
    else:
        show.console(stderr=True).print(
            f"derive solve: {found} found, but {number} proved to exist: a fault of the solver"
        )
    return number


def aimed(problem: Problem, options: argparse.Namespace) -> int:
    """Show and write all settings that bring the tip to the target."""
    name = aim.VARIED[options.vary]
    coordinate, value = aim.goal(problem, options.target, number)
    low, high = aim.limits(problem, name, options.range, number)
    must_be_traceable({**problem.full, name: high})
    try:
        reach = aim.reached(problem, name, coordinate, value, low, high)
    except ValueError as error:
        raise MistakeError(str(error)) from error
    hits = [hit for hit in reach.hits if options.max_index is None or hit.equilibrium.index <= options.max_index]
    seen = [problem.angle(x) if coordinate == "tip_angle" else x for x in (reach.low, reach.high)]
    between = within(problem, name, (low, high), coordinate, seen)
    if not hits:
        raise unreached(options.target, between, lost=bool(reach.hits))
    title, unit = aim.label(problem, name)
    count = "1 setting" if len(hits) == 1 else f"{len(hits)} settings"
    show.console().print(escape(f"{count} with {options.target}; {between}"), soft_wrap=True)
    hits.sort(key=lambda hit: (hit.equilibrium.index, hit.parameter))
    rows = [
        {"number": k, title.replace(" ", "_"): aim.outward(problem, name, hit.parameter), name: hit.parameter}
        | problem.row(hit.equilibrium)
        for k, hit in enumerate(hits, 1)
    ]
    first = f"{title} [{unit}]" if unit else title
    key = title.replace(" ", "_")
    table(show.console(), [first, *problem.columns().values()], ([*cells(row, problem, key)] for row in rows))
    data: dict[str, Any] = {"scene": problem.scene, "target": options.target, "vary": name, "range": [low, high]}
    if problem.rod:
        data["epsilon"] = smallness(problem, [hit.equilibrium for hit in hits])
    commands.save(options.json, data | {"reachable": seen, "degrees": problem.in_degrees, "solutions": rows})
    return 0


def within(problem: Problem, name: str, limits: Sequence[float], coordinate: str, seen: Sequence[float]) -> str:
    """Between what the tip is while a load goes from one limit to the other."""
    title, unit = aim.label(problem, name)
    low, high = (aim.outward(problem, name, end) for end in limits)
    span = f"{title} from {low:.6g} to {high:.6g}{f' {unit}' if unit else ''}"
    shown = {"y": "y", "z": "z", "tip_angle": "θ(ℓ)"}[coordinate]
    return f"over {span} the tip's {shown} lies between {seen[0]:.5g} and {seen[1]:.5g}"


def unreached(target: str, between: str, *, lost: bool) -> MistakeError:
    """What is wrong with a target. lost: equilibria of a larger index than is asked for have it."""
    such, more = "", "choose a target in there, or another --range or --vary"
    if lost:
        such, more = "such ", "it is reached with --max-index left out"
    return MistakeError(f"--target {target}: no {such}equilibrium has it: {between}; {more}")


def cells(row: dict[str, Any], problem: Problem, *first: str) -> list[str]:
    """A line of the table."""
    numbers = [f"{float(row[key]):.11g}" for key in (*first, *problem.columns())]
    return [str(row["number"]), *numbers, str(row["index"]), "stable" if row["stable"] else "unstable"]


def smallness(problem: Problem, found: Sequence[Any]) -> list[float]:
    """ε of each equilibrium, shown with a warning where the theory is stretched."""
    values = [problem.smallness(one) for one in found]
    worst = max(values, default=0.0)
    show.console().print(f"ε = {worst:.3g} at most: half the diameter times the curvature, or over the length")
    if worst > SMALL:
        show.console(stderr=True).print(
            f"derive solve: warning: ε is above {SMALL:g}; the theory of rods holds up to ε², here {worst**2:.2g}",
            soft_wrap=True,
        )
    return values
