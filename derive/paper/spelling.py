"""The canonical spelling of a printed symbol: accents braced, subscripts braced and first, spaces gone."""

from __future__ import annotations

from collections.abc import Callable

from lark import Token, Tree

from .errors import ReadError

Complain = Callable[[int, str], ReadError]
_LABEL_FONTS = ("\\mathrm", "\\mathsf")
_TRANSPOSE = r"\mathsf{T}"


def is_label(argument: Tree[Token] | Token) -> bool:
    """Is this superscript a label like ``^\\mathrm{u}``, part of the symbol's name?"""
    first = _first(argument)
    return isinstance(first, Tree) and first.data == "accent" and first.children[0] in _LABEL_FONTS


def is_transpose(argument: Tree[Token] | Token, error: Complain) -> bool:
    """Is this superscript the sign of the transpose?"""
    return is_label(argument) and spelling(argument, error) == _TRANSPOSE


def _first(tree: Tree[Token] | Token) -> Tree[Token] | Token:
    """What a braced argument holds, if it holds one thing."""
    while isinstance(tree, Tree) and tree.data in ("arg", "sum", "chain", "factor") and len(tree.children) == 1:
        tree = tree.children[0]
    return tree


def spelling(tree: Tree[Token] | Token, error: Complain, powers: bool = False) -> str:
    """The canonical spelling of a factor without its primes and powers; ReadError if it is no symbol.

    powers: take every superscript for a part of the name, as in the inverse of a function or an upper index.
    """
    if isinstance(tree, Token):
        return str(tree)
    if tree.data == "accent":
        return f"{tree.children[0]}{{{spelling(tree.children[1], error)}}}"
    if tree.data == "factor":
        base, *scripts = tree.children
        scripted = [script for script in scripts if isinstance(script, Tree)]
        lower = [_script(part, error) for part in scripted if part.data == "subscript"]
        upper = [_script(part, error) for part in scripted if part.data == "superscript"
                 if powers or (is_label(part.children[0]) and not is_transpose(part.children[0], error))]  # fmt: skip
        return "".join([spelling(base, error, powers), *lower, *upper])
    if tree.data in ("arg", "sum", "chain", "braces"):
        return "".join(spelling(part, error, powers) for part in tree.children)
    raise error(tree.meta.start_pos, "this cannot be part of a symbol's name")


def _script(part: Tree[Token], error: Complain) -> str:
    mark = "_" if part.data == "subscript" else "^"
    return f"{mark}{{{spelling(part.children[0], error)}}}"
