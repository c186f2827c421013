"""Write what `derive measure` found into the README, between its markers `measure`.

derive measure --out measurements
python examples/measure_table.py measurements/measure.json [README.md]
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from verdict_tables import replace

from derive.measure.bench.tables import readme_rows

README = Path(__file__).resolve().parent.parent / "README.md"


def main(source: Path, readme: Path = README) -> str:
    """The table, written; what is wrong as one line, if something is."""
    try:
        found = json.loads(source.read_text(encoding="utf-8"))
        records, mode = found["records"]["tasks"], found["about"]["mode"]
    except (OSError, ValueError, KeyError, TypeError):
        return f"{source}: no result of `derive measure`; give the measure.json of its folder"
    lines, missing = readme_rows(records)
    if mode != "full" or missing:
        return f"{source}: lacks {', '.join(missing) or 'a full run'}; run `derive measure` without --quick and --only"
    text = readme.read_text(encoding="utf-8")
    if "<!-- measure -->" not in text or "<!-- end measure -->" not in text:
        return f"{readme}: has no lines <!-- measure --> and <!-- end measure --> to put the table between"
    readme.write_text(replace(text, "measure", lines), encoding="utf-8")
    return ""


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    sys.exit(main(*map(Path, sys.argv[1:])) or 0)
