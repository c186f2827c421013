"""Long formulas in lines: broken at relations and between terms, where the reader sees the same formula."""

from __future__ import annotations

from collections.abc import Iterator

from derive.paper import tree as t
from derive.paper.printer import to_latex

LINE = 58.0  # widths that fit in a line of the report, in letters
INDENT = 6.0  # of lines that go on, in letters
SIGNS = ("+", "-", r"\pm", r"\mp")


def in_lines(statement: t.Statement, scope: str) -> str:
    """The LaTeX of a statement; if it is longer than a line, broken between the terms of its sides."""
    whole = to_latex(statement, scope)
    if sum(map(width, statement.sides)) <= LINE:
        return whole
    first, *operators = relations(statement, scope)
    lines = [rf"{first} & {operators[0]}"]
    for number, side in enumerate(statement.sides[1:]):
        head = "" if number == 0 else rf"& {operators[number]}"
        start = width(statement.sides[0]) if number == 0 else 0.0
        broken = list(filled(side, scope, start))
        lines[-1:] = [f"{lines[-1]} {broken[0]}"] if number == 0 else [lines[-1], f"{head} {broken[0]}"]
        lines += [rf"& \quad {rest}" for rest in broken[1:]]
    return r"\begin{aligned} " + r" \\ ".join(lines) + r" \end{aligned}"


def relations(statement: t.Statement, scope: str) -> list[str]:
    """The first side, and the operators as they are printed."""
    first = to_latex(statement.sides[0], scope)
    zero = t.Number(0)
    blank = (to_latex(t.Statement((zero, zero), (operator,)), scope) for operator in statement.operators)
    return [first, *(text[1:-1].strip() for text in blank)]


def filled(side: t.Node, scope: str, start: float) -> Iterator[str]:
    """The lines of one side: terms for as long as they fit."""
    terms = side.terms if isinstance(side, t.Sum) else (side,)
    line, used = "", start
    for number, term in enumerate(terms):
        shown = to_latex(term, scope)
        if number and not shown.startswith(SIGNS):
            shown = f"+ {shown}"
        if line and used + width(term) > LINE:
            yield line
            line, used = "", INDENT
        line, used = f"{line} {shown}".strip(), used + width(term)
    yield line


def width(node: t.Node) -> float:
    """About how many letters a formula is wide."""
    parts = [width(part) for part in node.parts()]
    match node:
        case t.Number():
            return 0.6 * len(str(node.value))
        case t.Name():
            return 1.0 + 0.5 * (node.name.count("_") + bool(node.index))
        case t.Call():
            return 2.2 + sum(parts)
        case t.Quotient() | t.Stack() | t.Cases():
            return 0.4 + max(parts)
        case t.Power():
            return parts[0] + 0.7 * parts[1] + bracketed(node.base)
        case t.Product():
            return sum(parts) + sum(map(bracketed, node.factors))
        case t.Sum() | t.Cross() | t.Dot() | t.Outer():
            return sum(parts) + 1.8 * (len(parts) - 1)
    return 0.8 + sum(parts)


def bracketed(node: t.Node) -> float:
    """The width of the brackets that a factor needs."""
    return 1.0 if isinstance(node, t.Sum | t.Signed) else 0.0
