"""Write the tables of README.md about verdicts between their markers.

derive --json result.json && derive check --mutants --json mutants.json
python examples/readme_tables.py result.json mutants.json

The table of errors and times is written by measure_table.py, that of hard rods by hard_table.py.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

from verdict_tables import errata_table, mutant_table, verdict_table

README = Path(__file__).resolve().parent.parent / "README.md"


def replace(text: str, name: str, lines: list[str]) -> str:
    """The text with new lines between the markers of a table."""
    pattern = rf"(<!-- {name} -->\n).*?(<!-- end {name} -->)"
    return re.sub(pattern, lambda match: match[1] + "\n".join([*lines, match[2]]), text, flags=re.DOTALL)


if __name__ == "__main__":
    text = README.read_text(encoding="utf-8")
    result, mutants = (json.loads(Path(name).read_text(encoding="utf-8")) for name in sys.argv[1:3])
    for name, lines in {
        "verdicts": verdict_table(result),
        "errata": errata_table(result),
        "mutants": mutant_table(mutants),
    }.items():
        text = replace(text, name, lines)
    README.write_text(text, encoding="utf-8")
