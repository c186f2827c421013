"""Write what `derive measure` found into the README and docs/measure.md, between their markers, and pictures to docs.

derive measure --out measurements
python examples/measure_table.py measurements/measure.json [README.md docs/measure.md]
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

from verdict_tables import replace

from derive.measure.bench import ratios
from derive.measure.bench.tables import readme_rows

ROOT = Path(__file__).resolve().parent.parent
README, GUIDE = ROOT / "README.md", ROOT / "docs" / "measure.md"
# Pictures of a run, and what they are called beside the guide.
PICTURES = {
    "T1.svg": "measure-T1.svg",
    "T2-parallel.svg": "measure-T2.svg",
    "atlas-loads_parallel.svg": "atlas-loads.svg",
    "atlas-stiff.svg": "atlas-stiff.svg",
}


def main(source: Path, readme: Path = README, guide: Path = GUIDE) -> str:
    """The tables and pictures, written; what is wrong as one line, if something is."""
    try:
        found = json.loads(source.read_text(encoding="utf-8"))
        records, mode = found["records"]["tasks"], found["about"]["mode"]
    except (OSError, ValueError, KeyError, TypeError):
        return f"{source}: no result of `derive measure`; give the measure.json of its folder"
    lines, missing = readme_rows(records)
    if mode != "full" or missing:
        return f"{source}: lacks {', '.join(missing) or 'a full run'}; run `derive measure` without --quick and --only"
    pages = ((readme, "measure", lines), (guide, "ratios", ratios.table(records)))
    for page, name, _ in pages:
        text = page.read_text(encoding="utf-8")
        if f"<!-- {name} -->" not in text or f"<!-- end {name} -->" not in text:
            return f"{page}: has no lines <!-- {name} --> and <!-- end {name} --> to put the table between"
    for page, name, rows in pages:
        page.write_text(replace(page.read_text(encoding="utf-8"), name, rows), encoding="utf-8")
    for drawn, name in PICTURES.items():
        if (source.parent / drawn).exists():  # there are none without the extra `pictures`
            shutil.copyfile(source.parent / drawn, guide.parent / name)
    return ""


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    sys.exit(main(*map(Path, sys.argv[1:])) or 0)
