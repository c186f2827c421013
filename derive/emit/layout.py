"""Statements as lines of text: what was not changed keeps the kernel's own lines and comments, the rest is printed.

``stamp`` marks a fresh syntax tree; after specialising, a statement whose mark still fits is copied from its source.
"""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterator, Sequence
from inspect import cleandoc
from typing import Any

from derive.emit.style import expression, wrap
from derive.emit.trees import form, walk

_BODIES = ("body", "orelse", "finalbody", "handlers")
_INDENT = "    "
_MARK = "mark"


def stamp(tree: ast.AST) -> None:
    """Mark every statement with its present form, so that a later change can be seen."""
    for node in walk(tree):
        if isinstance(node, (ast.stmt, ast.excepthandler)):
            setattr(node, _MARK, alone(node))


def alone(node: ast.AST) -> tuple[Any, ...]:
    """What a statement says, without the statements inside it."""
    return (node.__class__, *[form(value) for name, value in ast.iter_fields(node) if name not in _BODIES])


def lines_of(node: ast.stmt, source: Sequence[str]) -> list[str]:
    """A module-level definition as lines."""
    return [line.rstrip() for line in _Layout(source).statement(node, "")]


class _Layout:
    """Prints statements, taking unchanged ones from the source."""

    def __init__(self, source: Sequence[str]) -> None:
        self.source = source

    def body(self, statements: Sequence[ast.stmt], indent: str) -> Iterator[str]:
        """A block; blank lines and comments above a statement stay with it."""
        for index, node in enumerate(statements):
            above = self.above(node)
            after_class_docstring = index == 1 and _begins_class(node) and _is_text(statements[0])
            if after_class_docstring or (above[:1] == [""] and (index or isinstance(node, ast.FunctionDef))):
                yield ""
            yield from (indent + line for line in above if line)
            yield from self.statement(node, indent)

    def above(self, node: ast.stmt) -> list[str]:
        """Comments directly above a statement, after an empty string if a blank line is above them."""
        if not hasattr(node, _MARK):
            return []
        found: list[str] = []
        at = _first_line(node) - 2
        while at >= 0 and self.source[at].strip().startswith("#"):
            found.insert(0, self.source[at].strip())
            at -= 1
        return ["", *found] if at >= 0 and not self.source[at].strip() else found

    def statement(self, node: Any, indent: str) -> Iterator[str]:
        """One statement with what is inside it."""
        yield from self.header(node, indent)
        if not hasattr(node, "body"):
            return
        deeper = indent + _INDENT
        yield from self.body(node.body, deeper)
        for handler in getattr(node, "handlers", []):
            yield from self.statement(handler, indent)
        yield from self.alternative(node, indent)
        if getattr(node, "finalbody", []):
            yield f"{indent}finally:"
            yield from self.body(node.finalbody, deeper)

    def alternative(self, node: Any, indent: str) -> Iterator[str]:
        """The else part; a lone if in it becomes elif."""
        orelse = getattr(node, "orelse", [])
        if (
            isinstance(node, ast.If)
            and len(orelse) == 1
            and isinstance(orelse[0], ast.If)
            and not self.above(orelse[0])[1:]
        ):
            first, *rest = list(self.statement(orelse[0], indent))
            yield f"{indent}elif{first.strip().removeprefix('el').removeprefix('if')}"
            yield from rest
        elif orelse:
            yield f"{indent}else:"
            yield from self.body(orelse, indent + _INDENT)

    def header(self, node: Any, indent: str) -> Iterator[str]:
        """The statement itself, or the first line of a compound one."""
        if getattr(node, _MARK, None) == alone(node):
            first, last = _first_line(node) - 1, self.last_line(node)
            column = len(self.source[first]) - len(self.source[first].lstrip())
            for line in self.source[first:last]:
                yield indent + (line[column:] if not line[:column].strip() else line.lstrip()) if line.strip() else ""
        elif _is_text(node):
            yield from _docstring(node.value.value, indent)
        else:
            yield from self.printed(node, indent)

    def printed(self, node: Any, indent: str) -> Iterator[str]:
        """A changed statement, from its tree, with the comments of its source lines at the end."""
        for decorator in getattr(node, "decorator_list", []):
            yield f"{indent}@{expression(decorator)}"
        lines = wrap(_head(node), indent)
        notes = self.comments(node) if hasattr(node, _MARK) else []
        lines[-1] += "".join(f"  {note}" for note in notes)
        yield from lines

    def comments(self, node: Any) -> list[str]:
        """Comments at the ends of a statement's own source lines."""
        text = "\n".join(self.source[node.lineno - 1 : self.last_line(node)]) + "\n"
        found = []
        try:
            for token in tokenize.generate_tokens(io.StringIO(text.lstrip()).readline):
                if token.type == tokenize.COMMENT:
                    found.append(token.string)
        except (tokenize.TokenError, IndentationError):
            pass  # the header of a compound statement ends without its body
        return found

    def last_line(self, node: Any) -> int:
        """The last source line of a simple statement, or of a compound statement's header."""
        if not hasattr(node, "body") or not isinstance(node.body, list):
            return node.end_lineno
        at = max([node.lineno, *(n.end_lineno for n in _header_nodes(node))])
        while not self.source[at - 1].split("#")[0].rstrip().endswith(":"):
            at += 1
        return at


def _header_nodes(node: Any) -> Iterator[Any]:
    """Expressions in the header of a compound statement."""
    for name, value in ast.iter_fields(node):
        if name in _BODIES or name == "decorator_list":
            continue
        for item in value if isinstance(value, list) else [value]:
            if isinstance(item, ast.AST):
                yield from (n for n in walk(item) if hasattr(n, "end_lineno"))


def _begins_class(node: ast.stmt) -> bool:
    """Whether a statement is one that stands first in a class: a field or its slots."""
    slots = isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and node.targets[0].id == "__slots__"
    return slots or isinstance(node, ast.AnnAssign)


def _is_text(node: Any) -> bool:
    """Whether a statement is a docstring."""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def _first_line(node: Any) -> int:
    return min([node.lineno, *(d.lineno for d in getattr(node, "decorator_list", []))])


def _head(node: Any) -> str:
    """A statement on one line; of a compound one, its header."""
    if not hasattr(node, "body"):
        return expression(node)
    bare = type(node)(
        **{name: value for name, value in ast.iter_fields(node) if name not in ("decorator_list", *_BODIES)}
    )
    bare.body = [ast.Pass()]
    for name in ("orelse", "finalbody", "handlers", "decorator_list"):
        if name in node._fields:
            setattr(bare, name, [])
    if isinstance(node, ast.Try):
        return "try:"
    if isinstance(node, ast.ExceptHandler):
        kind = f" {expression(node.type)}" if node.type else ""
        return f"except{kind} as {node.name}:" if node.name else f"except{kind}:"
    text = ast.unparse(ast.fix_missing_locations(bare))
    return expression_text(text.rsplit("\n", 1)[0].strip())


def expression_text(header: str) -> str:
    """A compound statement's header; ast.unparse writes it with the style of the formatter but for quotes."""
    return header.replace("'", '"') if '"' not in header else header


def _docstring(text: str, indent: str) -> Iterator[str]:
    first, *rest = cleandoc(text).splitlines()
    if not rest:
        yield f'{indent}"""{first}"""'
        return
    yield f'{indent}"""{first}'
    yield from (indent + line if line else "" for line in rest)
    yield f'{indent}"""'
