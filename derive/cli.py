"""The command line. It reads arguments and shows errors; the work is done in `commands` and below."""

from __future__ import annotations

import argparse
import importlib
import sys
from collections.abc import Sequence
from pathlib import Path

USAGE, FAILED, INTERRUPTED = 2, 1, 130
# Where commands are that do not stand in `commands`.
PLACES = {
    "check": "commands_check",
    "emit": "commands_emit",
    "explain": "commands_explain",
    "measure": "commands_measure",
    "report": "commands_report",
    "solve": "commands_solve",
    "figures": "commands_figures",
    "sweep": "commands_sweep",
}
NUMBERS = ("beta", "eta", "length", "clamp-angle", "field-angle")
# What `derive solve --target` may vary, by the names of the solvers and by those of the laboratory.
VARIED = ("eta", "field", "beta", "force", "field-angle")

SWEEP = (
    "One parameter is a range, as in --eta 0:0.001:500; another may be a list, as in --beta 0.0002,0.00035, for a "
    "family of curves. Folds and pitchforks are located to rounding; jumps are those of a slow loading, each way."
)
CHECK_CODES = (
    "Exit code 0: every claim of the derivation holds, and every formula has a verdict (REFUTED is one: a finding "
    "about the article); with --mutants, no wrong variant survives. 1: a claim fails, or a formula is UNKNOWN, "
    "UNREAD or missing in FILE. 2: a mistake in what was asked, or FILE is no such source."
)


def parser() -> argparse.ArgumentParser:
    """All commands and their options."""
    top = argparse.ArgumentParser(prog="derive", description="From the magnetic energy of a rod to verified solvers.")
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--no-cache", action="store_true", help="compute everything anew and keep nothing")
    common.add_argument("--jobs", type=int, default=0, metavar="N", help="processes (default: one per core)")
    common.add_argument("--json", type=Path, metavar="FILE", help="write the result as JSON, too")
    commands = top.add_subparsers(dest="command", metavar="COMMAND")

    add = commands.add_parser("all", parents=[common], help="the main job (also with no command)")
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the modules (default: generated)")

    add = commands.add_parser(
        "check", parents=[common], help="judge the derivation and the printed formulas", epilog=CHECK_CODES
    )
    add.add_argument("--paper", type=Path, metavar="FILE", help="read the formulas from a LaTeX source")
    add.add_argument("--only", action="append", default=[], metavar="ID", help="only this formula; may be repeated")
    add.add_argument("--mutants", action="store_true", help="judge wrong variants of all: each must fail")

    add = commands.add_parser("emit", parents=[common], help="write proved solver modules")
    add.add_argument("scenes", nargs="*", metavar="SCENE.toml", help="scene file or name (default: all shipped)")
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the modules (default: generated)")
    add.add_argument("--check", action="store_true", help="write nothing; exit 1 with a diff on drift")
    add.add_argument(
        "--explain", action="store_true", help="write nothing; what each module leaves out, why, and what that saves"
    )

    add = commands.add_parser(
        "report", parents=[common], help="write what was found about the printed formulas, as LaTeX and PDF"
    )
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the report (default: generated)")
    add.add_argument("--paper", type=Path, metavar="FILE", help="judge a LaTeX source (needs --out)")
    add.add_argument("--mutants", type=Path, metavar="FILE", help="score of `derive check --mutants --json FILE`")
    add.add_argument("--pdf", action="store_true", help="fail where pdflatex is missing (else only LaTeX is written)")
    add.add_argument("--check", action="store_true", help="write nothing; exit 1 with a diff on drift")

    add = commands.add_parser("explain", parents=[common], help="the chain from a formula back to the energy")
    add.add_argument(
        "what", metavar="ID|MODULE:LINE", help="printed label, claim, formula, or a line of an emitted module"
    )

    add = commands.add_parser("solve", parents=[common], help="all equilibria of one rod")
    solve_options(add)
    for name in NUMBERS:
        add.add_argument(f"--{name}", metavar="X", help="a number; multiples of pi as in 3*pi/4")

    add = commands.add_parser("measure", parents=[common], help="error against run time, for us and for others")
    add.add_argument("--quick", action="store_true", help="smaller runs, kept only with --out; times say little")
    add.add_argument("--only", action="append", default=[], metavar="PART", help="T1 … V, growth, atlas, stability")
    add.add_argument("--out", type=Path, metavar="DIR", help="records to go on from, tables, pictures (measurements)")

    add = commands.add_parser("sweep", parents=[common], help="complete branches over one parameter", epilog=SWEEP)
    add.add_argument("scene", metavar="SCENE", help="shipped scene, or a scene file")
    for name in NUMBERS:
        add.add_argument(f"--{name}", metavar="X", help="a number, a range low:high:points, or numbers with commas")
    for name, what in (("csv", "every point of every branch"), ("npz", "the same as arrays"), ("plot", "a picture")):
        add.add_argument(f"--{name}", type=Path, metavar="FILE", help=what)
    shown = ("y", "z", "tip_angle", "energy", "clamp_curvature")
    add.add_argument("--show", choices=shown, default="y", help="what the picture shows (default: y)")
    add.add_argument("--store", type=Path, metavar="DIR", help="keep what is computed, and go on from what is there")
    add.add_argument("--dask", metavar="ADDRESS", help="compute on the Dask cluster of this scheduler")
    add = commands.add_parser("figures", help="draw the article's figures, the set of folds and a turning field")
    add.add_argument("names", nargs="*", metavar="NAME", help="figure (default: all); a wrong name lists them")
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the files (default: figures)")
    add.add_argument("--format", default="svg,png", metavar="LIST", help="of svg, png, pdf (default: svg,png)")
    return top


def solve_options(add: argparse.ArgumentParser) -> None:
    """The options of the command, but for the rod's numbers."""
    add.add_argument("scene", nargs="?", metavar="SCENE", help="shipped scene, or a scene file; none with --rod")
    add.add_argument("--rod", type=Path, metavar="FILE", help="rod, particles and loads in physical units (TOML)")
    add.add_argument("--degrees", action="store_true", help="angles in degrees, given and shown")
    add.add_argument("--max-index", type=int, metavar="N", help="leave out what is less stable; 0: stable ones only")
    add.add_argument("--csv", type=Path, metavar="FILE", help="write the shapes: s, theta, curvature, y, z")
    add.add_argument("--points", type=int, default=201, metavar="N", help="places along a rod in the CSV (default 201)")
    add.add_argument("--plot", type=Path, metavar="FILE", help="draw the equilibria (.svg, .png or .pdf)")
    add.add_argument("--target", metavar="y=X", help="find what brings the tip to y=X, z=X or angle=X")
    add.add_argument("--vary", choices=VARIED, default="eta", help="what is varied for it (default: the field)")
    add.add_argument("--range", metavar="LOW:HIGH", help="the range in which it is sought")


def joined(arguments: Sequence[str]) -> list[str]:
    """Arguments with every number tied to its option, so that -1e-3 is not taken for an option."""
    result: list[str] = []
    options, rest = {f"--{name}" for name in NUMBERS}, iter(arguments)
    for argument in rest:
        value = next(rest, None) if argument in options else None
        result.append(argument if value is None else f"{argument}={value}")
    return result


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; the exit code is 0 if all is well, 1 if a check failed, 2 for a mistake in what was asked."""
    given = joined(sys.argv[1:] if arguments is None else arguments)
    if not given or (given[0].startswith("-") and given[0] not in ("-h", "--help")):
        given = ["all", *given]
    options = parser().parse_args(given)
    from derive import commands

    place = importlib.import_module(f"derive.{PLACES.get(options.command, 'commands')}")
    try:
        code: int = getattr(place, f"run_{options.command}")(options)
        return code
    except KeyboardInterrupt:
        print("derive: interrupted; no file was changed by halves", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        sys.stderr.close()
        return FAILED
    except Exception as error:
        kind = commands.kind_of(error)
        if kind is None:
            raise
        print(f"derive {options.command}: {error}", file=sys.stderr)
        return USAGE if kind == "mistake" else FAILED
