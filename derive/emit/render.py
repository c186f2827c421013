"""Templates place text; every decision is made before. An unknown name in a template is an error."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, TemplateError

from derive.emit.errors import EmitError
from derive.resources import templates_folder


def environment() -> Environment:
    """The environment of all templates."""
    return Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        autoescape=False,  # the output is Python, not HTML
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def render(template: str, context: Mapping[str, Any]) -> str:
    """The text of ``template`` with ``context``."""
    try:
        return environment().get_template(template).render(context)
    except TemplateError as error:
        raise EmitError(f"templates/{template}: {type(error).__name__}: {error.message}") from error
