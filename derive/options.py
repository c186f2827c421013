"""The commands of the command line with their options, a function for each."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import NoReturn

USAGE = 2
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


class Parser(argparse.ArgumentParser):
    """One that says in a line what is wrong, as the commands do, and where help is."""

    def error(self, message: str) -> NoReturn:
        """Exit with the code of a mistake."""
        refuse(self.prog, message)


def refuse(command: str, message: str) -> NoReturn:
    """Say a mistake in one line, and exit with its code."""
    print(f"{command}: {message}; '{command} --help' shows what is possible", file=sys.stderr)
    sys.exit(USAGE)


def parser() -> argparse.ArgumentParser:
    """All commands and their options."""
    top = Parser(prog="derive", description="From the magnetic energy of a rod to verified solvers.")
    commands = top.add_subparsers(dest="command", metavar="COMMAND")
    common = Parser(add_help=False)
    common.add_argument("--no-cache", action="store_true", help="compute everything anew and keep nothing")
    common.add_argument("--jobs", type=int, default=0, metavar="N", help="processes (default: one per core)")
    common.add_argument("--json", type=Path, metavar="FILE", help="write the result as JSON, too")
    both = [common]
    all_options(commands.add_parser("all", parents=both, help="the main job (also with no command)"))
    check_options(
        commands.add_parser(
            "check", parents=both, help="judge the derivation and the printed formulas", epilog=CHECK_CODES
        )
    )
    emit_options(commands.add_parser("emit", parents=both, help="write proved solver modules"))
    report_options(
        commands.add_parser(
            "report", parents=both, help="write what was derived and found as one HTML page, and as LaTeX and PDF"
        )
    )
    explain_options(commands.add_parser("explain", parents=both, help="the chain from a formula back to the energy"))
    solve_options(commands.add_parser("solve", parents=both, help="all equilibria of one rod"))
    measure_options(commands.add_parser("measure", parents=both, help="error against run time, for us and for others"))
    sweep_options(commands.add_parser("sweep", parents=both, help="complete branches over one parameter", epilog=SWEEP))
    figures_options(
        commands.add_parser("figures", help="draw the article's figures, the set of folds and a turning field")
    )
    return top


def all_options(add: argparse.ArgumentParser) -> None:
    """The main job."""
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the modules (default: generated)")


def check_options(add: argparse.ArgumentParser) -> None:
    """Verdicts."""
    add.add_argument("--paper", type=Path, metavar="FILE", help="read the formulas from a LaTeX source")
    add.add_argument("--only", action="append", default=[], metavar="ID", help="only this formula; may be repeated")
    add.add_argument("--mutants", action="store_true", help="judge wrong variants of all: each must fail")


def emit_options(add: argparse.ArgumentParser) -> None:
    """Modules."""
    add.add_argument("scenes", nargs="*", metavar="SCENE.toml", help="scene file or name (default: all shipped)")
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the modules (default: generated)")
    add.add_argument("--check", action="store_true", help="write nothing; exit 1 with a diff on drift")
    add.add_argument(
        "--explain", action="store_true", help="write nothing; what each module leaves out, why, and what that saves"
    )


def report_options(add: argparse.ArgumentParser) -> None:
    """Page, LaTeX and PDF."""
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the report (default: generated)")
    add.add_argument("--paper", type=Path, metavar="FILE", help="judge a LaTeX source (needs --out)")
    add.add_argument("--mutants", type=Path, metavar="FILE", help="score of `derive check --mutants --json FILE`")
    add.add_argument("--measured", type=Path, metavar="FILE", help="errors and times of `derive measure --json FILE`")
    add.add_argument(
        "--no-page", action="store_true", help="only LaTeX and PDF: what the modules leave out takes minutes"
    )
    add.add_argument("--pdf", action="store_true", help="fail where pdflatex is missing (else no PDF is written)")
    add.add_argument("--check", action="store_true", help="write nothing; exit 1 with a diff where the LaTeX drifts")


def explain_options(add: argparse.ArgumentParser) -> None:
    """What is explained."""
    what = "printed label, claim, formula, or a line of an emitted module"
    add.add_argument("what", metavar="ID|MODULE:LINE", help=what)


def solve_options(add: argparse.ArgumentParser) -> None:
    """One rod."""
    add.add_argument("scene", nargs="?", metavar="SCENE", help="shipped scene, or a scene file; none with --rod")
    add.add_argument("--rod", type=Path, metavar="FILE", help="rod, particles and loads in physical units (TOML)")
    add.add_argument("--degrees", action="store_true", help="angles in degrees, given and shown")
    add.add_argument("--max-index", type=int, metavar="N", help="leave out what is less stable; 0: stable ones only")
    proof = "prove how many there are by ball arithmetic; exit 1 unless as many are found (extra: certified)"
    add.add_argument("--count", action="store_true", help=proof)
    add.add_argument("--csv", type=Path, metavar="FILE", help="write the shapes: s, theta, curvature, y, z")
    add.add_argument("--points", type=int, default=201, metavar="N", help="places along a rod in the CSV (default 201)")
    add.add_argument("--plot", type=Path, metavar="FILE", help="draw the equilibria (.svg, .png or .pdf)")
    add.add_argument("--target", metavar="y=X", help="find what brings the tip to y=X, z=X or angle=X")
    add.add_argument("--vary", choices=VARIED, default="eta", help="what is varied for it (default: the field)")
    add.add_argument("--range", metavar="LOW:HIGH", help="the range in which it is sought")
    for name in NUMBERS:
        add.add_argument(f"--{name}", metavar="X", help="a number; multiples of pi as in 3*pi/4")


def measure_options(add: argparse.ArgumentParser) -> None:
    """Errors and times."""
    add.add_argument("--quick", action="store_true", help="smaller runs, kept only with --out; times say little")
    add.add_argument("--only", action="append", default=[], metavar="PART", help="T1 … V, growth, atlas, stability")
    add.add_argument("--out", type=Path, metavar="DIR", help="records to go on from, tables, pictures (measurements)")


def sweep_options(add: argparse.ArgumentParser) -> None:
    """Branches."""
    add.add_argument("scene", metavar="SCENE", help="shipped scene, or a scene file")
    for name in NUMBERS:
        add.add_argument(f"--{name}", metavar="X", help="a number, a range low:high:points, or numbers with commas")
    for name, what in (("csv", "every point of every branch"), ("npz", "the same as arrays"), ("plot", "a picture")):
        add.add_argument(f"--{name}", type=Path, metavar="FILE", help=what)
    shown = ("y", "z", "tip_angle", "energy", "clamp_curvature")
    add.add_argument("--show", choices=shown, default="y", help="what the picture shows (default: y)")
    add.add_argument("--store", type=Path, metavar="DIR", help="keep what is computed, and go on from what is there")
    add.add_argument("--dask", metavar="ADDRESS", help="compute on the Dask cluster of this scheduler")


def figures_options(add: argparse.ArgumentParser) -> None:
    """Pictures."""
    add.add_argument("names", nargs="*", metavar="NAME", help="figure (default: all); a wrong name lists them")
    add.add_argument("--out", type=Path, metavar="DIR", help="folder for the files (default: figures)")
    add.add_argument("--format", default="svg,png", metavar="LIST", help="of svg, png, pdf (default: svg,png)")
