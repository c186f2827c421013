"""Wrong variants of printed formulas: one small change of the printed tree at a time.

A checker must be seen to fail. No mutant is made that would state less than the original and be true for that: of what
is only compared by size or order nothing is changed but the relation, or the order; of what tends to a limit, not the
sign; of a single term that is said to be 0, not the powers, primes and indices. An exchanged symbol is one of its type:
the nearest two in spelling or in the order of the conventions with which the statement has a meaning.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from derive.check.changes import OTHER_SIGN, TURNED, at, exchanges, own_changes, positions, put
from derive.paper import tree as t
from derive.paper.errors import ReadError
from derive.paper.ledger import Record
from derive.paper.printer import to_latex
from derive.paper.reader import parse

NEAREST = 2  # symbols for which one is exchanged in one place
EQUALITIES = {"=", "->"}
LESS = ("number", "power", "prime", "index")  # kinds that leave 0 at 0
MATHS = (t.SCALAR, t.VECTOR, t.TENSOR)
ZERO = t.Number(0)

Variant = tuple[str, t.Statement]


@dataclass(frozen=True)
class Mutant:
    """A changed statement of a formula.

    change: its kind. number: of the statement. statement: as the reader reads its LaTeX; None if the reader's types
    forbid it, for the reason given.
    """

    change: str
    number: int
    latex: str
    statement: t.Statement | None
    reason: str = ""


class Mutants:
    """The mutants of a formula, each once, and none that the formula prints itself."""

    def __init__(self, record: Record) -> None:
        self.scope = str(record.scope)
        self.printed = parse(record.latex, self.scope)
        self._seen: set[tuple[int, object]] = set()

    def changed(self) -> Iterator[Mutant]:
        """Those that change operations, numbers and indices, in printed order."""
        for number, statement in enumerate(self.printed):
            for change, variant in variants(statement, self.scope):
                mutant = self._new(change, number, variant)
                if mutant:
                    yield mutant

    def exchanged(self) -> Iterator[Iterator[Mutant]]:
        """Those that exchange a symbol: for each place where one stands all that may stand there, nearest first."""
        for number, statement in enumerate(self.printed):
            for n, side in enumerate(statement.sides):
                for path, node in positions(side) if _free(statement, n) else ():
                    yield self._exchanged(number, n, path, node)

    def _exchanged(self, number: int, n: int, path: tuple[int, ...], node: t.Node) -> Iterator[Mutant]:
        statement = self.printed[number]
        for change, new in exchanges(node, self.scope):
            mutant = self._new(change, number, with_side(statement, n, put(statement.sides[n], path, new)))
            if mutant:
                yield mutant

    def _new(self, change: str, number: int, variant: t.Statement) -> Mutant | None:
        """As it is printed and read; None if it cannot be printed, or is no new one."""
        mutant = read_back(change, number, variant, self.scope)
        key = (number, mutant and (mutant.statement or mutant.latex))
        if mutant is None or key in self._seen or mutant.statement in self.printed:
            return None
        self._seen.add(key)
        return mutant


def mutants(record: Record) -> list[Mutant]:
    """All mutants of a formula; of exchanged symbols the nearest."""
    source = Mutants(record)
    found = list(source.changed())
    for each in source.exchanged():
        found += [one for one, _ in zip(each, range(NEAREST), strict=False)]
    return found


def read_back(change: str, number: int, changed: t.Statement, scope: str) -> Mutant | None:
    """The mutant as it is printed and read; None if it cannot be printed."""
    try:
        latex = to_latex(changed, scope)
    except (KeyError, ValueError):
        return None
    try:
        read = parse(latex, scope)
    except ReadError as error:
        return Mutant(change, number, latex, None, error.message)
    return Mutant(change, number, latex, read[0]) if len(read) == 1 else None


def with_side(statement: t.Statement, n: int, side: t.Node) -> t.Statement:
    """The statement with another side."""
    return replace(statement, sides=(*statement.sides[:n], side, *statement.sides[n + 1 :]))


def variants(statement: t.Statement, scope: str) -> Iterator[Variant]:
    """A statement with one change, of a node, of a side's sign, or of a relation; not of a symbol."""
    for n in range(len(statement.sides)):
        for change, mutant in _of_side(statement, n, scope) if _free(statement, n) else ():
            yield change, with_side(statement, n, mutant)
    for operators in relations(statement):
        yield "relation", replace(statement, operators=operators)


def relations(statement: t.Statement) -> Iterator[tuple[str, ...]]:
    """The relations of a statement with one turned over."""
    for n, operator in enumerate(statement.operators):
        if operator in TURNED:
            yield (*statement.operators[:n], TURNED[operator], *statement.operators[n + 1 :])


def _either(statement: t.Statement) -> Iterator[t.Node]:
    """The signs ± and ∓, and what takes them for its rows."""
    for side in statement.sides:
        for node in side.walk():
            if isinstance(node, t.Stack) or (isinstance(node, t.Signed) and node.sign in OTHER_SIGN):
                yield node


def _free(statement: t.Statement, n: int) -> bool:
    """May a side be changed? Not if it is only compared by size or order: half the changes would say less."""
    side, beside = statement.sides[n], [k for k in (n - 1, n) if 0 <= k < len(statement.operators)]
    others = {k: statement.sides[k + 1 if k == n else k] for k in beside}
    return any(
        statement.operators[k] in EQUALITIES and (isinstance(side, t.BigO) or not isinstance(other, t.BigO))
        for k, other in others.items()
    )


def _of_side(statement: t.Statement, n: int, scope: str) -> Iterator[tuple[str, t.Node]]:
    side = statement.sides[n]
    vanishes = not isinstance(side, t.Sum) and ZERO in statement.sides
    alone = len(list(_either(statement))) == 1  # ± alone says what ∓ alone says
    for path, node in positions(side):
        for change, new in own_changes(node, scope):
            other = isinstance(node, t.Signed) and isinstance(new, t.Signed)
            fraction = change == "prime" and path and isinstance(at(side, path[:-1]), t.Derivative)
            if not (vanishes and change in LESS) and not (alone and other) and not fraction:
                yield change, put(side, path, new)
    tends = n == 0 and statement.operators[0] == "->"  # −b → 0 says what b → 0 says
    plain = side.type in MATHS and not isinstance(side, t.Signed | t.BigO | t.Stack | t.Cases)
    if plain and not tends and ZERO not in statement.sides:
        yield "sign", t.Signed("-", side)
