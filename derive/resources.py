"""Where the package's own data lie: templates and scenes, in a checkout and in an installed wheel alike."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def templates_folder() -> Path:
    """The folder of Jinja2 templates: ``templates/`` beside the package in a checkout, inside it in a wheel."""
    for folder in (_PACKAGE / "templates", _PACKAGE.parent / "templates"):
        if (folder / "module.py.jinja").is_file():
            return folder
    raise FileNotFoundError("the templates are missing: neither the package nor its parent folder holds 'templates/'")


def scenes_folder() -> Path:
    """The folder of the shipped scenes."""
    return _PACKAGE / "emit" / "scenes"


def kernels_folder() -> Path:
    """The folder of the kernels from which the emitter takes functions."""
    return _PACKAGE / "emit" / "kernels"


def shipped_scenes() -> dict[str, Path]:
    """The shipped scene files by name, in alphabetical order."""
    return {path.stem: path for path in sorted(scenes_folder().glob("*.toml"))}
