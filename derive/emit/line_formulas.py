"""Which formulas stand behind the lines of an emitted module, read from its text once for all lines."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection
from functools import cached_property
from typing import Any

from derive.emit.backends import EACH
from derive.emit.scene import GENERAL_CASE


class LineFormulas:
    """The formulas behind the lines of one module; known: the names of formulas there may be."""

    def __init__(self, text: str, known: Collection[str]) -> None:
        self.functions = {node.name: node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}
        self.known = {*known, *(name + EACH for name in known)}
        self._inside: dict[str, list[ast.stmt]] = {}

    @cached_property
    def mentioned(self) -> dict[str, set[str]]:
        """The functions of the module that each of them names."""
        return {name: names(node) & self.functions.keys() for name, node in self.functions.items()}

    def function(self, line: int) -> ast.FunctionDef | None:
        """The function in which a line stands."""
        return next((node for node in self.functions.values() if covers(node, line)), None)

    def at(self, line: int) -> set[str]:
        """The formulas behind a line; none if it stands in no function, or in one that calls no formula.

        Within a formula's function, that formula; elsewhere those that the innermost statement names, or else its
        function, or else what they reach.
        """
        here = self.function(line)
        found = set() if here is None else {here.name} & self.known or self._called(here, line)
        return {name.removesuffix(EACH) for name in found}

    def _called(self, here: ast.FunctionDef, line: int) -> set[str]:
        statement = min(self._statements(here, line), key=lambda node: (node.end_lineno or line) - node.lineno)
        reached: set[str] = set()
        for node in (statement, here):
            found = names(node)
            if found & self.known:
                return found & self.known
            reached |= found & self.functions.keys()
        waiting = list(reached)
        while waiting:
            new = self.mentioned[waiting.pop()] - reached
            reached |= new
            waiting.extend(new - self.known)  # what a formula calls is no formula
        return reached & self.known

    def _statements(self, here: ast.FunctionDef, line: int) -> list[ast.stmt]:
        if here.name not in self._inside:
            self._inside[here.name] = [node for node in ast.walk(here) if isinstance(node, ast.stmt)]
        return [node for node in self._inside[here.name] if covers(node, line)]


def names(node: ast.AST) -> set[str]:
    """The names in a part of a module."""
    return {part.id for part in ast.walk(node) if isinstance(part, ast.Name)}


def covers(node: ast.stmt, line: int) -> bool:
    """True if the line is one of the node's."""
    return node.lineno <= line <= (node.end_lineno or line)


def load_case(text: str) -> str:
    """The load case that the header of a module names; empty without one."""
    case = re.search(r"^Load case: ([\w ]+)[.,]", text, re.MULTILINE)
    return case[1].replace(" ", "_") if case else ""


def stood_for(formulas: Collection[Any], names: Collection[str], case: str) -> list[Any]:
    """The formulas that a module of a load case evaluates under some names: its own, or else those of any case."""
    named = [f for f in formulas if f.name in names]
    if not case:
        return named
    own = {f.name for f in named if f.case == case}
    return [f for f in named if f.case == (case if f.name in own else GENERAL_CASE)]
