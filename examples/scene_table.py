"""The table of docs/solver.md: how large each emitted module is, and how long it takes to import, beside the full one.

python examples/scene_table.py

The full module is that of the scene `oblique`: it folds nothing and has every output that any field angle has. Sizes
are those of the files in generated/; the tests compare them. Import times are measured, in fresh interpreters.
"""

from __future__ import annotations

from collections.abc import Mapping

from verdict_tables import ROOT, put

from derive.emit.backends import BACKENDS
from derive.emit.contents import size
from derive.measure.imports import ImportTime, import_times
from derive.resources import shipped_scenes

FULL = "oblique"
REPEATS = 15
HEAD = "| module | functions | lines | bytes | of the full one's | import, ms | from … to |"


def texts() -> dict[str, str]:
    """The emitted modules by name: of each backend the full one first, then the others by size."""
    found: dict[str, str] = {}
    for backend in BACKENDS:
        names = {scene: f"{scene}_{backend}" for scene in shipped_scenes()}
        read = {scene: (ROOT / "generated" / f"{name}.py").read_text(encoding="utf-8") for scene, name in names.items()}
        order = sorted(read, key=lambda scene, read=read: (scene != FULL, -len(read[scene].encode())))
        found |= {names[scene]: read[scene] for scene in order}
    return found


def sizes(modules: Mapping[str, str]) -> list[str]:
    """The columns that do not depend on a machine, as the rows of the table begin."""
    rows, found = [], {name: size(text) for name, text in modules.items()}
    for name, here in found.items():
        whole = found[f"{FULL}_{name.rsplit('_', 1)[1]}"]
        share = f"{100 * here.bytes / whole.bytes:.0f} %"
        rows.append(f"| {name} | {here.functions} | {here.lines:,} | {here.bytes:,} | {share} |")
    return rows


def table(modules: Mapping[str, str], times: Mapping[str, ImportTime]) -> list[str]:
    """The lines of the table."""
    measured = [f" {one.median:.1f} | {one.least:.1f} … {one.most:.1f} |" for one in (times[name] for name in modules)]
    rows = [row + rest for row, rest in zip(sizes(modules), measured, strict=True)]
    return [HEAD, "|---|" + "---:|" * (HEAD.count("|") - 2), *rows]


def main() -> None:
    """Measure, and write the table."""
    modules = texts()
    packages = {name: (*backend.packages, "math")[0] for name, backend in BACKENDS.items()}
    times = import_times({name: (packages[name.rsplit("_", 1)[1]], text) for name, text in modules.items()}, REPEATS)
    put("scenes", table(modules, times))


if __name__ == "__main__":
    main()
