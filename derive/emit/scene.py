"""Scenes: which load case, which constants are folded, which outputs are wanted, on which backends.

A scene file is TOML and strict: an unknown key or value is an error that names file and line, and what is possible.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sympy import Expr, Integer, pi, srepr

from derive.emit.backends import BACKENDS
from derive.emit.constants import parse_constant
from derive.emit.errors import SceneError, choices
from derive.emit.scene_source import Source

# Scene parameters, by the names they have in every kernel, and the sign that their domain gives them.
PARAMETERS = {
    "beta": "nonnegative",
    "eta": "nonnegative",
    "length": "positive",
    "clamp_angle": "real",
    "field_angle": "real",
}
# Load cases and the parameters that each fixes by itself.
CASES: dict[str, dict[str, Expr]] = {
    "parallel": {"field_angle": Integer(0)},
    "orthogonal": {"field_angle": pi / 2},
    "field_only": {"beta": Integer(0), "field_angle": Integer(0)},
    "force_only": {"eta": Integer(0), "field_angle": Integer(0)},
    "oblique": {},
}
# The load case that fixes nothing: every other is a special case of it.
GENERAL_CASE = "oblique"
# What a scene can ask for; each is a function of the interface.
OUTPUTS = ("equilibria", "shape", "sweep", "folds", "literal")
# The load cases for which the article has formulas, so that there is an output 'literal'.
ARTICLE_CASES = ("parallel", "orthogonal", "field_only", "force_only")
_KEYS: dict[str, Any] = {"name": str, "title": str, "case": str, "outputs": list, "backends": list}
_REQUIRED = ("name", "case", "outputs")


@dataclass(frozen=True)
class Scene:
    """One thing to emit.

    name: of the modules, before the backend's. title: their first line. case: the load case, a key of CASES. outputs:
    of OUTPUTS. backends: of BACKENDS. constants: what the file folds; ``folded`` is that and what the load case
    implies.
    """

    name: str
    title: str
    case: str
    outputs: tuple[str, ...]
    backends: tuple[str, ...]
    constants: Mapping[str, Expr]

    @property
    def folded(self) -> dict[str, Expr]:
        """Every parameter that is a constant in this scene, in the order of PARAMETERS."""
        values = {**CASES[self.case], **self.constants}
        return {name: values[name] for name in PARAMETERS if name in values}

    @property
    def parameters(self) -> tuple[str, ...]:
        """The parameters that remain."""
        return tuple(name for name in PARAMETERS if name not in self.folded)

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions of the interface that the outputs are: folds come with the exchanges of folds as β grows."""
        found = list(self.outputs)
        if "folds" in found and "beta" in self.parameters:
            found.insert(found.index("folds") + 1, "exchanges")
        return tuple(found)

    def canonical(self) -> str:
        """What identifies the scene, for the digest of a module."""
        folded = ", ".join(f"{name}={srepr(value)}" for name, value in self.folded.items())
        return "\n".join([self.name, self.title, self.case, ",".join(self.outputs), folded])


def load_scene(path: Path) -> Scene:
    """Read the scene file at a path; SceneError names file, line and mend."""
    try:
        text = Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise SceneError(str(path), f"cannot be read ({error.strerror}); give the path of a scene file") from error
    except UnicodeDecodeError as error:
        raise SceneError(str(path), f"is not UTF-8 text (byte {error.start})") from error
    return parse_scene(text, str(path))


def parse_scene(text: str, label: str = "scene") -> Scene:
    """The scene that ``text`` writes; SceneError for what is wrong in it. ``label`` names the file in errors."""
    source = Source(text, label)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        line = re.search(r"at line (\d+)", str(error))
        number = line[1] if line else str(max(len(source.lines), 1))
        raise SceneError(f"{label}:{number}", f"is not TOML: {error}") from error
    _check_keys(data, {"scene", "constants"}, source)
    table: Any = data.get("scene")
    if not isinstance(table, dict):
        raise source.error("the table [scene] is missing", "", "scene")
    _check_types(table, source)
    case = _one_of(table["case"], CASES, "case", source)
    outputs = _some_of(table["outputs"], OUTPUTS, "outputs", source)
    if "literal" in outputs and case not in ARTICLE_CASES:
        known = ", ".join(ARTICLE_CASES)
        message = f"the article has no formulas for case '{case}', so there is no output 'literal'; it has: {known}"
        raise source.error(message, "scene", "outputs")
    if "folds" in outputs:
        _check_folds(case, data.get("constants", {}), source)
    scene = Scene(
        name=_name(table["name"], source),
        title=str(table.get("title", table["name"])),
        case=case,
        outputs=outputs,
        backends=_some_of(table.get("backends", list(BACKENDS)), tuple(BACKENDS), "backends", source),
        constants=_constants(data.get("constants", {}), case, source),
    )
    if "sweep" in scene.outputs and not scene.parameters:
        raise source.error("every parameter is folded: nothing is left to sweep; drop 'sweep'", "scene", "outputs")
    return scene


def _check_folds(case: str, constants: Any, source: Source) -> None:
    """Folds are found over a range of η, which must then be a parameter."""
    if "eta" in CASES[case]:
        possible = ", ".join(name for name, fixed in CASES.items() if "eta" not in fixed)
        message = f"case '{case}' has no field, and folds are found as it grows; drop 'folds', or choose: {possible}"
        raise source.error(message, "scene", "outputs")
    if isinstance(constants, dict) and "eta" in constants:
        message = f"eta = {constants['eta']} is folded, and folds are found as it grows; drop it, or drop 'folds'"
        raise source.error(message, "constants", "eta")


def _check_keys(data: dict[str, Any], possible: set[str], source: Source) -> None:
    for key, value in data.items():
        if key not in possible:
            place = (key, "") if isinstance(value, dict) else ("", key)
            raise source.error(f"unknown table or key '{key}'{choices(key, possible)}", *place)


def _check_types(table: Any, source: Source) -> None:
    for key, value in table.items():
        if key not in _KEYS:
            raise source.error(f"unknown key '{key}' in [scene]{choices(key, _KEYS)}", "scene", key)
        if not isinstance(value, _KEYS[key]):
            kind = {str: "a string", list: "a list of strings"}[_KEYS[key]]
            raise source.error(f"'{key}' must be {kind}, not {value!r}", "scene", key)
        if isinstance(value, str) and (not value.isprintable() or '"' in value or "\\" in value):
            raise source.error(f"'{key}' may hold printable characters only, no quotes or backslashes", "scene", key)
    missing = [key for key in _REQUIRED if key not in table]
    if missing:
        raise source.error(f"[scene] lacks {', '.join(missing)}; required: {', '.join(_REQUIRED)}", "scene")


def _name(name: str, source: Source) -> str:
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        raise source.error(f"name '{name}' must be lower-case letters, digits and underscores", "scene", "name")
    return name


def _one_of(value: str, possible: Any, key: str, source: Source) -> str:
    if value not in possible:
        raise source.error(f"unknown {key} '{value}'{choices(value, possible)}", "scene", key)
    return value


def _some_of(values: list[Any], possible: tuple[str, ...], key: str, source: Source) -> tuple[str, ...]:
    for value in values:
        if value not in possible:
            raise source.error(f"unknown value {value!r} in {key}{choices(str(value), possible)}", "scene", key)
    if not values or len(set(values)) != len(values):
        raise source.error(f"{key} must name at least one of {', '.join(possible)}, each once", "scene", key)
    return tuple(value for value in possible if value in values)


def _constants(table: Any, case: str, source: Source) -> dict[str, Expr]:
    if not isinstance(table, dict):
        raise source.error("[constants] must be a table", "", "constants")
    implied = CASES[case]
    possible = [name for name in PARAMETERS if name not in implied]
    for key in table:
        if key in implied:
            raise source.error(f"case '{case}' already fixes {key} = {implied[key]}; remove it", "constants", key)
        if key not in possible:
            raise source.error(f"unknown constant '{key}'{choices(key, possible)}", "constants", key)
    return {key: _constant(key, table[key], source) for key in possible if key in table}


def _constant(key: str, text: Any, source: Source) -> Expr:
    try:
        value = parse_constant(text)
    except ValueError as error:
        raise source.error(f"bad constant {key}: {error}", "constants", key) from error
    sign = PARAMETERS[key]
    if (sign == "positive" and not value > 0) or (sign == "nonnegative" and not value >= 0):
        bound = "> 0" if sign == "positive" else ">= 0"
        raise source.error(f"{key} = {value} lies outside its domain {key} {bound}", "constants", key)
    return value
