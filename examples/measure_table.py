"""Write what `derive measure` found into the README and the guides, between their markers, and pictures to docs.

derive measure --out measurements
python examples/measure_table.py measurements/measure.json [README.md docs]
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

from verdict_tables import replace

from derive.measure.bench import atlas, growth, ratios, stability
from derive.measure.bench.tables import markdown, readme_rows

ROOT = Path(__file__).resolve().parent.parent
README, GUIDES = ROOT / "README.md", ROOT / "docs"
# Pictures of a run, and what they are called beside the guides.
PICTURES = {
    "T1.svg": "measure-T1.svg",
    "T2-parallel.svg": "measure-T2.svg",
    "atlas-loads_parallel.svg": "atlas-loads.svg",
    "atlas-stiff.svg": "atlas-stiff.svg",
}
WORST = 12  # formulas in the guide
FAMILIES = ("tasks", "growth", "atlas", "stability")


def main(source: Path, readme: Path = README, guides: Path = GUIDES) -> str:
    """The tables and pictures, written; what is wrong as one line, if something is."""
    try:
        found = json.loads(source.read_text(encoding="utf-8"))
        records, mode = found["records"], found["about"]["mode"]
        rows, missing = readme_rows(records["tasks"])
    except (OSError, ValueError, KeyError, TypeError):
        return f"{source}: no result of `derive measure`; give the measure.json of its folder"
    missing += [family for family in FAMILIES if not records.get(family)]
    if mode != "full" or missing:
        return f"{source}: lacks {', '.join(missing) or 'a full run'}; run `derive measure` without --quick and --only"
    pages = (
        (readme, "measure", rows),
        (guides / "measure.md", "ratios", ratios.table(records["tasks"])),
        (guides / "measure.md", "growth", markdown(growth.HEAD, growth.rows(records["growth"]))),
        (guides / "extremes.md", "atlas", markdown(atlas.HEAD, atlas.rows(records["atlas"]))),
        (guides / "extremes.md", "stability", markdown(stability.HEAD, stability.rows(records["stability"])[:WORST])),
    )
    for page, name, _ in pages:
        text = page.read_text(encoding="utf-8")
        if f"<!-- {name} -->" not in text or f"<!-- end {name} -->" not in text:
            return f"{page}: has no lines <!-- {name} --> and <!-- end {name} --> to put the table between"
    for page, name, lines in pages:
        page.write_text(replace(page.read_text(encoding="utf-8"), name, lines), encoding="utf-8")
    for drawn, name in PICTURES.items():
        if (source.parent / drawn).exists():  # there are none without the extra `pictures`
            shutil.copyfile(source.parent / drawn, guides / name)
    return ""


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    sys.exit(main(*map(Path, sys.argv[1:])) or 0)
