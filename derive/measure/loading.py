"""Importing a module from its text, as Python imports it from a file, and leaving no file behind."""

from __future__ import annotations

import importlib.util
import sys
import tempfile
from pathlib import Path
from types import ModuleType


def load(text: str, name: str = "emitted") -> ModuleType:
    """The module that ``text`` is, from a temporary folder that is gone afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{name}.py"
        path.write_text(text, encoding="utf-8")
        spec = importlib.util.spec_from_file_location(f"_{name}_under_test", path)
        if spec is None or spec.loader is None:
            raise ImportError(name)
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module  # dataclasses look their module up there
        try:
            spec.loader.exec_module(module)
        finally:
            del sys.modules[spec.name]
        module.__dict__["__text__"] = text
        return module


def text_of(module: ModuleType) -> str:
    """The text of a module that was loaded here, so that another process can load it too."""
    return str(module.__dict__["__text__"])
