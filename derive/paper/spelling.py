"""The canonical spelling of a printed symbol: accents braced, subscripts braced, spaces gone."""

from __future__ import annotations

from collections.abc import Callable

from lark import Token, Tree

from .errors import ReadError

Complain = Callable[[int, str], ReadError]
_LABEL_FONTS = ("\\mathrm", "\\mathsf")


def is_label(argument: Tree[Token] | Token) -> bool:
    """Is this superscript a label like ``^\\mathrm{u}``, part of the symbol's name?"""
    first = argument.children[0] if isinstance(argument, Tree) else argument
    return isinstance(first, Tree) and first.data == "accent" and first.children[0] in _LABEL_FONTS


def spelling(tree: Tree[Token] | Token, error: Complain) -> str:
    """The canonical spelling of a factor without its primes and powers; ReadError if it is no symbol."""
    if isinstance(tree, Token):
        return str(tree)
    if tree.data == "accent":
        return f"{tree.children[0]}{{{spelling(tree.children[1], error)}}}"
    if tree.data == "factor":
        return "".join(_script(part, error) if number else spelling(part, error)
                       for number, part in enumerate(tree.children))  # fmt: skip
    if tree.data in ("arg", "sum", "chain", "braces"):
        return "".join(spelling(part, error) for part in tree.children)
    raise error(tree.meta.start_pos, "this cannot be part of a symbol's name")


def _script(part: Tree[Token] | Token, error: Complain) -> str:
    if isinstance(part, Tree) and part.data == "subscript":
        return f"_{{{spelling(part.children[0], error)}}}"
    if isinstance(part, Tree) and part.data == "superscript" and is_label(part.children[0]):
        return f"^{{{spelling(part.children[0], error)}}}"
    return ""
