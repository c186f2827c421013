"""The head of an emitted module: where it is valid, what it imports, what it exports."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from derive.emit.backends import External
from derive.emit.pieces import Piece
from derive.emit.scene import CASES, Scene


def domain_text(scene: Scene) -> str:
    """Where the module is valid, in its remaining parameters."""
    bounds = {"beta": "beta >= 0", "eta": "eta >= 0", "length": "length > 0"}
    bounds |= {name: f"any {name}" for name in ("clamp_angle", "field_angle")}
    return ", ".join(bounds[name] for name in scene.parameters if name in bounds) or "no parameter is left"


def case_text(scene: Scene) -> str:
    """The load case, and the load that it has not."""
    absent = [f"{name} = {value}" for name, value in CASES[scene.case].items() if name != "field_angle"]
    return ", ".join([scene.case.replace("_", " "), *absent])


def public_names(scene: Scene, pieces: Mapping[str, Piece], names: Iterable[str]) -> list[str]:
    """The outputs and the classes of the interface, in the order that the linter wants."""
    classes = [name for name in names if pieces[name].kind == "class" and pieces[name].section == "interface"]
    found = {*scene.functions, *(name for name in classes if not name.startswith("_"))}
    return sorted(found, key=lambda name: (not name.isupper(), not name[0].isupper(), name))


def fill(items: list[str], width: int = 110) -> list[str]:
    """Items with commas, in lines."""
    lines = [""]
    for index, item in enumerate(items):
        text = item + ("," if index < len(items) - 1 else "")
        if lines[-1] and len(lines[-1]) + len(text) + 1 > width:
            lines.append("")
        lines[-1] = f"{lines[-1]} {text}".strip()
    return [line for line in lines if line]


def export_lines(names: list[str]) -> list[str]:
    """``__all__`` as text."""
    quoted = [f'"{name}"' for name in names]
    line = f"__all__ = [{', '.join(quoted)}]"
    return [line] if len(line) <= 120 else ["__all__ = [", *(f"    {name}," for name in quoted), "]"]


def import_lines(found: list[External], packages: Iterable[str]) -> list[list[str]]:
    """Import statements in groups: the standard library, then the backend's package."""
    groups: list[list[str]] = [[], []]
    plain = [e for e in found if e.name is None]
    for external in plain:
        alias = f" as {external.alias}" if external.alias != external.module else ""
        groups[external.module.split(".")[0] in packages].append(f"import {external.module}{alias}")
    for module in sorted({e.module for e in found if e.name is not None}):
        members = sorted((e for e in found if e.module == module and e.name), key=_isort)
        names = [f"{e.name} as {e.alias}" if e.alias != e.name else str(e.name) for e in members if e.alias == e.name]
        if names:
            groups[module.split(".")[0] in packages] += from_import(module, names)
        renamed = [e for e in members if e.alias != e.name]
        groups[module.split(".")[0] in packages] += [f"from {module} import {e.name} as {e.alias}" for e in renamed]
    return [group for group in groups if group]


def _isort(external: External) -> tuple[bool, bool, str]:
    name = external.name or ""
    return (not name.isupper(), not name[:1].isupper(), name)


def from_import(module: str, names: list[str]) -> list[str]:
    """One import statement as lines."""
    line = f"from {module} import {', '.join(names)}"
    return [line] if len(line) <= 120 else [f"from {module} import (", *(f"    {name}," for name in names), ")"]
