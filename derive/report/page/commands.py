"""How each command of LaTeX is set: one row per kind of command, tried in order."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

from markupsafe import Markup

from derive.report.page import symbols as sy
from derive.report.page.elements import element, fence, fenced, letter, operator, row, scripted, space, table
from derive.report.page.tokens import SIZED, UnsetError

if TYPE_CHECKING:
    from derive.report.page.mathml import Setter

Way = Callable[["Setter", str], Markup]


def _letter(setter: Setter, name: str) -> Markup:
    return letter(sy.LETTERS[name], setter.style)


def _capital(setter: Setter, name: str) -> Markup:
    return letter(sy.CAPITALS[name], setter.style or "rm")


def _operator(setter: Setter, name: str) -> Markup:
    return operator(sy.OPERATORS[name])


def _large(setter: Setter, name: str) -> Markup:
    return operator(sy.LARGE[name])


def _named(setter: Setter, name: str) -> Markup:
    return element("mrow", space(sy.SPACES[","]), element("mi", name))


def _space(setter: Setter, name: str) -> Markup:
    return space(sy.SPACES[name])


def _fraction(setter: Setter, name: str) -> Markup:
    return element("mfrac", setter.argument(), setter.argument())


def _root(setter: Setter, name: str) -> Markup:
    if setter.next() != "[":
        return element("msqrt", setter.argument())
    setter.take()
    degree = row(setter.parts(closing="]"))
    setter.take("]")
    return element("mroot", setter.argument(), degree)


def _styled(setter: Setter, name: str) -> Markup:
    before, setter.style = setter.style, sy.STYLES[name]
    found = setter.argument()
    setter.style = before
    return found


def _alphabet(setter: Setter, name: str) -> Markup:
    said = setter.plain().strip() if setter.next() == "{" else setter.take()
    if len(said) != 1:
        raise UnsetError(f"\\{name} of {said}")
    return element("mi", sy.of_alphabet(said, name), mathvariant="normal")


def _text(setter: Setter, name: str) -> Markup:
    said = setter.plain()
    if "\\" in said.replace(r"\_", ""):
        raise UnsetError(said)
    around = space(sy.SPACES[","])  # so that words side by side, as factors, stay apart
    return element("mrow", around, element("mtext", said.replace(r"\_", "_")), around)


def _accent(setter: Setter, name: str) -> Markup:
    mark = operator(sy.ACCENTS[name], stretchy="true" if name == "overline" else "false")
    return scripted(setter.argument(), None, mark, limits=True)


def _bracketed(setter: Setter, name: str) -> Markup:
    opening = setter.bracket()
    parts = setter.parts()
    setter.take(r"\right")
    return fenced(opening, parts, setter.bracket())


def _sized(setter: Setter, name: str) -> Markup:
    """A bracket of a size; with the one that closes it, if that stands in the same group and cell."""
    token, said = setter.next(), setter.bracket()
    if token in sy.OPENING and setter.closes():
        parts = setter.parts(closing=SIZED)
        setter.take()
        return fenced(said, parts, setter.bracket())
    return fence(said, "prefix" if token in sy.OPENING else "postfix", sy.SIZES[name])


def _table(setter: Setter, name: str) -> Markup:
    kind = setter.plain()
    if kind not in sy.TABLES:
        raise UnsetError(kind)
    if kind == "array":
        setter.plain()
    rows = cells(setter)
    if setter.plain() != kind:
        raise UnsetError(kind)
    made = table(rows, "aligned" if kind == "split" else kind)
    return element("mrow", fence("{", "prefix"), made) if kind == "cases" else made


def cells(setter: Setter) -> list[list[Markup]]:
    """The cells of a table up to its end; a last row with nothing in it is none."""
    rows: list[list[Markup]] = [[]]
    while True:
        rows[-1].append(row(setter.parts()))
        token = setter.take()
        if token == r"\end":
            return rows[:-1] if rows[-1] == [element("mrow")] else rows
        if token == r"\\":
            rows.append([])
        elif token != "&":
            raise UnsetError(token)


COMMANDS: tuple[tuple[Collection[str], Way], ...] = (
    (sy.LETTERS, _letter),
    (sy.CAPITALS, _capital),
    (sy.OPERATORS, _operator),
    (sy.LARGE, _large),
    (sy.NAMED, _named),
    (sy.SPACES, _space),
    (("frac", "tfrac", "dfrac"), _fraction),
    (("sqrt",), _root),
    (sy.STYLES, _styled),
    (sy.ALPHABETS, _alphabet),
    (("text",), _text),
    (sy.ACCENTS, _accent),
    (("left",), _bracketed),
    (sy.SIZES, _sized),
    (("begin",), _table),
)
