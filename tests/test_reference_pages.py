"""The reference of the Python interface: docstrings say what their names mean, and the pages are built from them."""

from __future__ import annotations

import dataclasses
import importlib.util
import inspect
import re
from pathlib import Path
from types import ModuleType

import pytest
from pages import ROOT


def script() -> ModuleType:
    """docs/reference.py as a module."""
    spec = importlib.util.spec_from_file_location("reference", ROOT / "docs" / "reference.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


REFERENCE = script()


def public(module: ModuleType) -> dict[str, object]:
    """The functions and classes that a module has of its own."""
    names = getattr(module, "__all__", None) or [name for name in vars(module) if not name.startswith("_")]
    found = {name: getattr(module, name) for name in names}
    return {name: one for name, one in found.items() if getattr(one, "__module__", "") == module.__name__}


def names_in(one: object) -> list[str]:
    """The fields of a data class, the parameters of a function."""
    if inspect.isclass(one):
        return [field.name for field in dataclasses.fields(one)] if dataclasses.is_dataclass(one) else []
    return list(inspect.signature(one).parameters) if inspect.isfunction(one) else []


@pytest.mark.parametrize("name", REFERENCE.MODULES)
def test_every_name_is_explained(name: str) -> None:
    module = importlib.import_module(name)
    found = public(module)
    assert found
    texts = {key: inspect.getdoc(one) or "" for key, one in found.items()}
    emitted = name.startswith("generated.")
    for key, one in found.items():
        assert texts[key], f"{name}.{key} has no docstring"
        # In an emitted module a name means the same everywhere.
        text = "\n".join(texts.values()) if emitted else texts[key]
        for said in names_in(one):
            assert re.search(rf"\b{said}\b", text), f"the docstring of {name}.{key} does not say what '{said}' is"


@pytest.mark.parametrize("name", [name for name in REFERENCE.MODULES if name.startswith("generated.")])
def test_functions_of_emitted_modules_say_what_is_refused(name: str) -> None:
    functions = {key: one for key, one in public(importlib.import_module(name)).items() if inspect.isfunction(one)}
    assert functions
    for key, one in functions.items():
        assert "Raises TypeError or ValueError" in " ".join((inspect.getdoc(one) or "").split()), f"{name}.{key}"


def test_docstrings_become_markdown() -> None:
    text = "A rod, 2*b*x < 3, in *one* plane.\n\nbeta: force, a_b.\ny, z: ``tip_y``\nand more. Other: no name.\n\nEnd."
    first, items, last = REFERENCE.markdown(text).split("\n\n")
    assert first == r"A rod, 2\*b\*x \< 3, in *one* plane."
    assert items == "- `beta`: force, a\\_b.\n- `y, z`: ``tip_y`` and more. Other: no name."
    assert last == "End."
    assert REFERENCE.markdown("Gives: x.\nOf:\n    one,\n    two\nBy: d") == "Gives: x.  \nOf: one, two  \nBy: d"


@pytest.mark.long
def test_the_pages_are_built(tmp_path: Path) -> None:
    pytest.importorskip("pdoc")
    pages = [str(page.relative_to(tmp_path)) for page in REFERENCE.write(tmp_path)]
    for name in REFERENCE.MODULES:
        assert f"{name.replace('.', '/')}.html" in pages
    text = (tmp_path / "generated" / "parallel_numpy.html").read_text(encoding="utf-8")
    assert "number of negative directions of the second variation" in text
    assert "index.html" in pages
