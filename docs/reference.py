"""Write the reference of the Python interface from the docstrings, as HTML (needs the extra `docs`).

python docs/reference.py [FOLDER]

FOLDER: where the pages go, build/reference unless told; begin with its index.html.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build" / "reference"
# What a user calls; the rest of the modules is described in docs/architecture.md.
SOLVERS = tuple(f"generated.{path.stem}" for path in sorted((ROOT / "generated").glob("*_numpy.py")))
MODULES = (
    "derive.theory.chain",
    "derive.theory.claims",
    "derive.theory.energy",
    "derive.theory.load_case",
    "derive.paper.ledger",
    "derive.paper.reader",
    "derive.check.judge",
    "derive.check.printed",
    "derive.check.verdicts",
    "derive.emit.scene",
    "derive.emit.module",
    "derive.emit.proof",
    "derive.emit.backends",
    "derive.measure.reference",
    "derive.diagrams.blocks",
    *SOLVERS,
    "generated.parallel_mpmath",  # the other twins differ from theirs as this one does
)
# Names with a colon after them, at the beginning of a sentence: arguments and fields, with their meaning.
NAME = r"(?:``)?[a-z]\w*(?:``)?"
NAMED = re.compile(rf"(?:(?<=\. )|(?<=\.\n)|^)({NAME}(?:, {NAME})*):\s", re.MULTILINE)
EMPHASIS = re.compile(r"(?<!\w)\*\w[\w ]*\*(?!\w)")


def markdown(docstring: str) -> str:
    """A docstring as Markdown: names with a colon begin a list, what is quoted is code, all else is plain text."""
    return "\n\n".join(map(paragraph, re.split(r"\n\s*\n", docstring)))


def paragraph(text: str) -> str:
    """One paragraph; lines are kept where some are indented, which go on with the line before."""
    if re.search(r"^ {4}", text, re.MULTILINE):
        return "  \n".join(map(plain, re.sub(r"\n {4,}", " ", text).splitlines()))
    first, *rest = NAMED.split(text)
    named = zip(rest[::2], rest[1::2], strict=True)
    items = [f"- `{name.replace('`', '')}`: {plain(meaning)}" for name, meaning in named]
    return "\n\n".join(part for part in (plain(first), "\n".join(items)) if part)


def plain(text: str) -> str:
    """Text in one line, in which only what stands between backquotes or single asterisks is marked."""
    parts = re.split(rf"(``?[^`]+``?|{EMPHASIS.pattern})", " ".join(text.split()))
    return "".join(part if n % 2 else re.sub(r"([\\*_<>\[\]#|])", r"\\\1", part) for n, part in enumerate(parts))


def write(folder: Path) -> list[Path]:
    """Write all pages; ImportError without pdoc."""
    import pdoc

    pdoc.render.configure(docformat="markdown", footer_text="magnetic-rods", show_source=False)
    pdoc.render.env.filters["to_markdown"] = markdown
    pdoc.pdoc(*MODULES, output_directory=folder)
    return sorted(folder.rglob("*.html"))


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    try:
        pages = write(folder)
    except ImportError:
        sys.exit("pdoc is not installed; pip install 'magnetic-rods[docs]'")
    print(f"{len(pages)} pages; begin with {folder / 'index.html'}")
