"""`derive figures`: the article's figures and our own, each as a vector and a bitmap."""

from __future__ import annotations

import argparse
from collections.abc import Collection
from pathlib import Path

from derive import output, show
from derive.diagrams.plotting import library
from derive.numbers import MistakeError


def run_figures(options: argparse.Namespace) -> int:
    """Draw the figures that are asked for; all files are written, or none."""
    from derive.report import figures

    names, formats = chosen("figure", options.names, figures.FIGURES), chosen_formats(options.format, figures.FORMATS)
    folder = options.out or Path("figures")
    output.must_be_usable(folder)
    library()
    files: dict[Path, str | bytes] = {}
    for name in names:
        drawn = figures.draw(name, formats)
        files |= {folder / f"{name}.{kind}": content for kind, content in drawn.items()}
    output.write_all(files)
    for path in files:
        show.console().print(str(path), highlight=False, soft_wrap=True)
    return 0


def chosen(what: str, asked: list[str], possible: Collection[str]) -> tuple[str, ...]:
    """What is asked for, each once, or all; MistakeError for a name that is none."""
    for name in asked:
        if name not in possible:
            raise MistakeError(f"{name!r} is no {what}; possible: {', '.join(possible)}")
    return tuple(dict.fromkeys(asked)) or tuple(possible)


def chosen_formats(text: str, possible: tuple[str, ...]) -> tuple[str, ...]:
    """The formats in a list with commas."""
    return chosen("format", [part.strip() for part in text.split(",")], possible)
