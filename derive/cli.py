"""The command line. It reads arguments and shows errors; the work is done in `commands` and below."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence

from derive.options import NUMBERS, USAGE, parser, refuse

FAILED, INTERRUPTED = 1, 130
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
    options, rest = parser().parse_known_args(given)
    if rest:
        refuse(f"derive {options.command}", f"'{rest[0]}' is nothing that it knows")
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
