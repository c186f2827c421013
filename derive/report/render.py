"""The templates of the report. They place text; everything else is decided before. LaTeX keeps its braces."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from derive.resources import templates_folder


def environment() -> Environment:
    """An environment whose marks are no LaTeX: ``<< value >>`` and ``<% statement %>``."""
    return Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        autoescape=False,  # values are LaTeX already
        variable_start_string="<<",
        variable_end_string=">>",
        block_start_string="<%",
        block_end_string="%>",
        comment_start_string="<#",
        comment_end_string="#>",
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def render(template: str, context: Mapping[str, Any]) -> str:
    """The text of a template with a context."""
    return environment().get_template(template).render(context)
