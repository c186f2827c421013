"""How the printer writes what has a form of its own: fractions, bars, integrals, limits, lists, stacks and cases."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from . import tree as t

if TYPE_CHECKING:
    from .printer import Printer

Layout = Callable[["Printer", Any], str]


def _quotient(printer: Printer, node: t.Quotient) -> str:
    return rf"\frac{{{printer.sum(node.above)}}}{{{printer.sum(node.below)}}}"


def _derivative(printer: Printer, node: t.Derivative) -> str:
    mark = r"\partial" if node.partial else "d"
    return rf"\frac{{{mark} {printer.row(node.of)}}}{{{mark} {printer.factor(node.by)}}}"


def _root(printer: Printer, node: t.Root) -> str:
    degree = "" if node.degree == 2 else f"[{node.degree}]"
    return rf"\sqrt{degree}{{{printer.sum(node.of)}}}"


def _norm(printer: Printer, node: t.Norm) -> str:
    return rf"\left| {printer.sum(node.of)} \right|"


def _varied(printer: Printer, node: t.Varied) -> str:
    return rf"\delta {printer.factor(node.of)}"


def _order(printer: Printer, node: t.BigO) -> str:
    return rf"O \left( {printer.sum(node.of)} \right)"


def _integral(printer: Printer, node: t.Integral) -> str:
    bounds = "" if node.region is None else f"_{{{printer.sum(node.region)}}}"
    if node.lower is not None and node.upper is not None:
        bounds = f"_{{{printer.sum(node.lower)}}}^{{{printer.sum(node.upper)}}}"
    by = " ".join(f"d {_differential(printer, one)}" for one in node.by)
    return rf"\int{bounds} {_integrand(printer, node.of)} \, {by}"


def _integrand(printer: Printer, node: t.Node) -> str:
    return printer.factor(node) if isinstance(node, t.Integral | t.Limit) or _ends_open(node) else printer.row(node)


def _ends_open(node: t.Node) -> bool:
    """Does a row end in what takes the rest of a row?"""
    return isinstance(node, t.Product) and isinstance(node.factors[-1], t.Integral | t.Limit)


def _differential(printer: Printer, node: t.Node) -> str:
    return printer.factor(node) if isinstance(node, t.Name) else printer.bracket(node)


def _limit(printer: Printer, node: t.Limit) -> str:
    return rf"\lim_{{{printer.sum(node.variable)} \to {printer.sum(node.point)}}} {printer.row(node.of)}"


def _maximum(printer: Printer, node: t.Maximum) -> str:
    index = ""
    if node.variable is not None and node.region is not None:
        index = rf"_{{{printer.sum(node.variable)} \in {printer.sum(node.region)}}}"
    return rf"\max{index} {_listed(printer, node.of)}"


def _listing(printer: Printer, node: t.Listing) -> str:
    return _listed(printer, node.items)


def _listed(printer: Printer, items: Sequence[t.Node]) -> str:
    return rf"\left\{{ {', '.join(printer.sum(item) for item in items)} \right\}}"


def _interval(printer: Printer, node: t.Interval) -> str:
    ends = f"{printer.sum(node.lower)}, {printer.sum(node.upper)}"
    if node.left_open and node.right_open:
        return rf"\left( {ends} \right)"
    return f"{']' if node.left_open else '['} {ends} {'[' if node.right_open else ']'}"


def _between(printer: Printer, node: t.Between) -> str:
    name = "" if node.variable is None else f"{printer.sum(node.variable)} = "
    lower, upper = printer.sum(node.lower), printer.sum(node.upper)
    return rf"\left[ {printer.sum(node.of)} \right]_{{{name}{lower}}}^{{{name}{upper}}}"


def _at(printer: Printer, node: t.At) -> str:
    if node.variable is None:
        return rf"{printer.factor(node.of)} \left( {printer.sum(node.value)} \right)"
    of = printer.factor(node.of) if isinstance(node.of, t.Call) else printer.bracket(node.of)
    return f"{of}|_{{{printer.sum(node.variable)} = {printer.sum(node.value)}}}"


def _stack(printer: Printer, node: t.Stack) -> str:
    rows = r" \\ ".join(printer.sum(row) for row in node.rows)
    return rf"\left. \begin{{matrix}} {rows} \end{{matrix}} \right\}}"


def _cases(printer: Printer, node: t.Cases) -> str:
    rows = r" \\ ".join(
        rf"{printer.sum(value)} \,, \quad \mathrm{{if}} \,\, {printer.chain(condition.sides, condition.operators)}"
        for value, condition in zip(node.values, node.conditions, strict=True)
    )
    return rf"\left\{{ \begin{{matrix}} {rows} \end{{matrix}} \right."


LAYOUTS: dict[type[t.Node], Layout] = {
    t.Quotient: _quotient, t.Derivative: _derivative, t.Root: _root, t.Norm: _norm, t.Varied: _varied,
    t.BigO: _order, t.Integral: _integral, t.Limit: _limit, t.Maximum: _maximum, t.Listing: _listing,
    t.Interval: _interval, t.Between: _between, t.At: _at, t.Stack: _stack, t.Cases: _cases,
}  # fmt: skip
