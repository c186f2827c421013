"""Formulas as Python: one row an operation, the factored structure kept, every order decided here.

SymPy's own code printers fold exact numbers into floats and order terms by internal keys; here a number stays exact
(0.25 where a double holds it, a quotient of integers elsewhere), terms come in the order of the formula's arguments.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

from sympy import Add, Expr, Integer, Mul, Pow, Rational, S, Symbol, cse, symbols
from sympy.core.function import Function

from derive.emit.backends import EACH_FUNCTIONS, FUNCTIONS
from derive.emit.errors import EmitError
from derive.theory.claims import Formula

SYMMETRIC = {"RF": 3, "RJ": 3, "RD": 2}  # how many leading arguments may be put in any order
_LARGEST_DYADIC = 64  # 0.015625 is still pleasant to read
_LONGEST_LETTER = 2  # a sentence may begin with a letter of the article, which keeps its case
_MULTIPLIED_OUT = 3  # x * x * x, but x**4

Call = ast.Call
Row = Callable[["Printer", Any], ast.expr]


class Printer:
    """Turns expressions in the given argument names into syntax trees; a table names the functions to call."""

    def __init__(self, arguments: tuple[Symbol, ...], functions: Mapping[str, tuple[str, str]] = FUNCTIONS) -> None:
        self.rank = {symbol: index for index, symbol in enumerate(arguments)}
        self.functions = functions

    def call(self, name: str, *arguments: ast.expr) -> ast.Call:
        """A call of a function of the theory."""
        if name not in self.functions:
            raise EmitError(f"no kernel evaluates {name}; possible: {', '.join(self.functions)}")
        return ast.Call(ast.Name(self.functions[name][1], ast.Load()), list(arguments), [])

    def print(self, expr: Expr) -> ast.expr:
        """The tree of ``expr``; an operation without a row is an EmitError."""
        for kind, row in ROWS:
            if isinstance(expr, kind):
                return row(self, expr)
        raise EmitError(f"no row in the printer's table for {type(expr).__name__} in {expr}; add one to printer.ROWS")

    def key(self, expr: Expr) -> tuple[Any, ...]:
        """Numbers, then symbols, then compounds, by the arguments they hold, then by text."""
        held = sorted(self.rank.get(symbol, len(self.rank)) for symbol in expr.free_symbols)
        kind = 0 if expr.is_Number else 1 if expr.is_Symbol else 2
        return (kind, held, str(expr))


def _number(printer: Printer, value: Rational) -> ast.expr:
    if value < 0:
        return ast.UnaryOp(ast.USub(), _number(printer, -value))
    if value.q == 1:
        return ast.Constant(int(value.p))
    if value.q & (value.q - 1) == 0 and value.q <= _LARGEST_DYADIC:
        return ast.Constant(float(value))
    return ast.BinOp(ast.Constant(int(value.p)), ast.Div(), ast.Constant(int(value.q)))


def _symbol(printer: Printer, symbol: Symbol) -> ast.expr:
    if symbol not in printer.rank:
        raise EmitError(f"a formula holds '{symbol}', which is none of its arguments {[s.name for s in printer.rank]}")
    return ast.Name(symbol.name, ast.Load())


def _sum(printer: Printer, expr: Add) -> ast.expr:
    terms = sorted(expr.args, key=lambda term: (term.could_extract_minus_sign(), *printer.key(term)))
    tree = printer.print(terms[0])
    for term in terms[1:]:
        minus = term.could_extract_minus_sign() and not isinstance(term, Add)
        tree = ast.BinOp(tree, ast.Sub() if minus else ast.Add(), printer.print(_negative(term) if minus else term))
    return tree


def _negative(term: Expr) -> Expr:
    """−term with its factors as they stand."""
    if isinstance(term, Mul) and term.args[0].is_Rational:
        coefficient, rest = -term.args[0], term.args[1:]
        factors = rest if coefficient == 1 else (coefficient, *rest)
        return factors[0] if len(factors) == 1 else Mul(*factors, evaluate=False)
    return -term


def _product(printer: Printer, expr: Mul) -> ast.expr:
    sign, over, under = 1, [], []
    for factor in sorted(expr.args, key=printer.key):
        if factor.is_Rational:
            sign, factor = (-sign, -factor) if factor < 0 else (sign, factor)
            over += [factor] if _short(factor) else [Integer(factor.p)]
            under += [] if _short(factor) else [Integer(factor.q)]
        elif isinstance(factor, Pow) and factor.exp.is_Rational and factor.exp < 0:
            under.append(Pow(factor.base, -factor.exp, evaluate=False) if factor.exp != -1 else factor.base)
        else:
            over.append(factor)
    over = [factor for factor in over if factor != 1] or [S.One]
    trees = [printer.print(factor) for factor in over]
    if sign < 0:
        trees[0] = ast.UnaryOp(ast.USub(), trees[0])
    tree = _chain(trees)
    return ast.BinOp(tree, ast.Div(), _chain([printer.print(factor) for factor in under])) if under else tree


def _short(value: Rational) -> bool:
    return value.q & (value.q - 1) == 0 and value.q <= _LARGEST_DYADIC


def _chain(trees: list[ast.expr]) -> ast.expr:
    """a * b * c, with a factor that is itself a product flattened into the chain."""
    flat = [factor for tree in trees for factor in _factors(tree)]
    return reduce(lambda left, right: ast.BinOp(left, ast.Mult(), right), flat)


def _factors(tree: ast.expr) -> list[ast.expr]:
    if isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.Mult):
        return [*_factors(tree.left), tree.right]
    return [tree]


def _power(printer: Printer, expr: Pow) -> ast.expr:
    base, exponent = expr.base, expr.exp
    if exponent == Rational(1, 2):
        return printer.call("sqrt", printer.print(base))
    if exponent.is_Rational and exponent < 0:
        return ast.BinOp(ast.Constant(1), ast.Div(), printer.print(Pow(base, -exponent)))
    if exponent.is_Rational and exponent.q == 2:
        whole = printer.print(Pow(base, exponent - Rational(1, 2)))
        return ast.BinOp(whole, ast.Mult(), printer.call("sqrt", printer.print(base)))
    tree = printer.print(base)
    if exponent.is_Integer and exponent <= _MULTIPLIED_OUT and isinstance(base, Symbol):
        return _chain([printer.print(base) for _ in range(int(exponent))])
    return ast.BinOp(tree, ast.Pow(), printer.print(exponent))


def _function(printer: Printer, expr: Function) -> ast.expr:
    name = type(expr).__name__
    count = SYMMETRIC.get(name, 0)
    arguments = [*sorted(expr.args[:count], key=printer.key), *expr.args[count:]]
    return printer.call(name, *(printer.print(argument) for argument in arguments))


# One row an operation, the first that fits.
ROWS: tuple[tuple[Any, Row], ...] = (
    (Rational, _number),
    (Symbol, _symbol),
    (type(S.Pi), lambda printer, expr: ast.Name(printer.functions["pi"][1], ast.Load())),
    (Add, _sum),
    (Mul, _product),
    (Pow, _power),
    (Function, _function),
)


def formula_function(formula: Formula, *, common: bool = False, elementwise: bool = False) -> ast.FunctionDef:
    """The function that evaluates ``formula``, on arrays if ``elementwise``.

    With ``common``, repeated subexpressions become local names.
    """
    steps, result = _common(formula) if common else ([], formula.expression)
    names = (*formula.arguments, *(name for name, _ in steps))
    printer = Printer(names, EACH_FUNCTIONS if elementwise else FUNCTIONS)
    body: list[ast.stmt] = [ast.Expr(ast.Constant(_docstring(formula)))]
    for name, value in steps:
        body.append(ast.Assign([ast.Name(name.name, ast.Store())], printer.print(value)))
    body.append(ast.Return(printer.print(result)))
    arguments = [ast.arg(symbol.name) for symbol in formula.arguments]
    signature = ast.arguments([], arguments, None, [], [], None, [])
    return ast.FunctionDef(formula.name, signature, body, [])


def _common(formula: Formula) -> tuple[list[tuple[Symbol, Expr]], Expr]:
    """Repeated subexpressions, in an order of our own: SymPy's depends on the form of the whole."""
    taken = {symbol.name for symbol in formula.arguments}
    names = (symbol for symbol in symbols("t1:100") if symbol.name not in taken)
    steps, (result,) = cse([formula.expression], symbols=names, order="canonical")
    return steps, result


def _docstring(formula: Formula) -> str:
    """Meaning, then the equations it stands for and the claim that proves it."""
    meaning = formula.doc.strip().rstrip(".")
    first, _, rest = meaning.partition("\n")
    word = first.split(" ")[0]
    if word.isascii() and word.isalpha() and len(word) > _LONGEST_LETTER and word not in FUNCTIONS:
        first = first[0].upper() + first[1:]
    source = (
        f"Equation {formula.source}; proved as {formula.claim}." if formula.source else f"Proved as {formula.claim}."
    )
    lines = [f"{first}.", *(["", *(line.strip() for line in rest.splitlines())] if rest else []), "", source]
    return "\n".join(lines)
