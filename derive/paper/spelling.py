"""The canonical spelling of a printed symbol: accents braced, subscripts braced and first, spaces gone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

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
    if isinstance(tree, Tree) and tree.data == "factor":
        base, *scripts = tree.children
        lower, upper = _scripts(scripts, error, powers)
        return "".join([_inside(base, error), *lower, *upper])
    return _inside(tree, error)


def _inside(tree: Any, error: Complain) -> str:
    """The spelling of what a name is made of: there nothing is left out."""
    if isinstance(tree, Token):
        return str(tree)
    if tree.data == "accent":
        return f"{tree.children[0]}{{{_inside(tree.children[1], error)}}}"
    if tree.data == "factor":
        base, *scripts = tree.children
        if odd := [script for script in scripts if script.data not in ("subscript", "superscript")]:
            raise error(odd[0].meta.start_pos, "primes and values are no part of a name; write them outside the braces")
        lower, upper = _scripts(scripts, error, True)
        return "".join([_inside(base, error), *lower, *upper])
    if tree.data in ("arg", "sum", "chain", "braces"):
        return "".join(_inside(part, error) for part in tree.children)
    raise error(tree.meta.start_pos, "this cannot be part of a symbol's name")


def _scripts(scripts: Sequence[Any], error: Complain, powers: bool) -> tuple[list[str], list[str]]:
    """The subscripts, and the superscripts that belong to the name."""
    lower, upper = [], []
    for part in scripts:
        if part.data == "subscript":
            lower.append(f"_{{{_inside(part.children[0], error)}}}")
        elif part.data == "superscript" and (powers or is_label(part.children[0])):
            spelled = _inside(part.children[0], error)
            upper += [f"^{{{spelled}}}"] if powers or spelled != _TRANSPOSE else []
    return lower, upper
