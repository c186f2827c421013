"""Emitted text back into formulas: the syntax tree of a module read into SymPy by a table, nothing evaluated.

The table is written apart from the printer's, and names mean what the module's own imports make them mean.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Expr, Rational, Symbol

from derive.emit.errors import EmitError
from derive.emit.trees import OPERATIONS
from derive.theory.functions import RC, RD, RF, RJ, wlog_sigma, wp, wp_prime, wsigma, wzeta

_PACKAGES = ("math", "numpy", "mpmath")
# Functions of the packages above, by their names there.
_PACKAGE_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "sqrt": sympy.sqrt,
    "sin": sympy.sin,
    "cos": sympy.cos,
    "atan": sympy.atan,
    "arctan": sympy.atan,
    "atan2": sympy.atan2,
    "arctan2": sympy.atan2,
    "asinh": sympy.asinh,
    "arcsinh": sympy.asinh,
    "abs": sympy.Abs,
}
# Functions that the module defines, or a kernel file takes from another.
_KERNEL_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "rf": RF,
    "rc": RC,
    "rj": RJ,
    "rd": RD,
    "near_asin": sympy.asin,
    "near_acosh": sympy.acosh,
    "wp": wp,
    "wp_prime": wp_prime,
    "wzeta": wzeta,
    "wsigma": wsigma,
    "wlog_sigma": wlog_sigma,
}
_KERNEL_FILES = ("carlson", "carlson_each", "inverses", "weierstrass")
_ARRAY_PREFIX, _ARRAY_SUFFIX = "each_", "_each"


@dataclass(frozen=True)
class ReadModule:
    """The functions of a module, and what its global names mean: 'math.sqrt', 'numpy', 'local'."""

    functions: Mapping[str, ast.FunctionDef]
    meaning: Mapping[str, str]


def read_module(text: str, label: str) -> ReadModule:
    """Parse a module."""
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        raise EmitError(f"{label}:{error.lineno}: the emitted text is not Python: {error.msg}") from error
    functions: dict[str, ast.FunctionDef] = {}
    meaning: dict[str, str] = {}
    for node in tree.body:
        if isinstance(node, ast.Import):
            found = {alias.asname or alias.name: alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found = {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found = {node.name: "local"}
            functions |= {node.name: node} if isinstance(node, ast.FunctionDef) else {}
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found = {target.id: "local" for target in targets if isinstance(target, ast.Name)}
        else:
            found = {}
        twice = [name for name in found if name in meaning]
        if twice:
            raise EmitError(f"{label}:{node.lineno}: '{twice[0]}' is defined twice")
        meaning |= found
    return ReadModule(functions, meaning)


def read_formula(module: ReadModule, name: str, symbols: Mapping[str, Symbol], label: str) -> Expr:
    """What the function ``name`` returns, in the given symbols; its locals are written out."""
    node = module.functions.get(name)
    if node is None:
        raise EmitError(f"{label}: the formula '{name}' is missing")
    return _Reader(module, dict(symbols), f"{label}:{node.lineno} ({name})").function(node)


class _Reader:
    """Reads one function."""

    def __init__(self, module: ReadModule, values: dict[str, Any], label: str) -> None:
        self.module, self.values, self.label = module, values, label

    def error(self, node: ast.AST, message: str) -> EmitError:
        text = ast.unparse(node)
        return EmitError(f"{self.label}: {message}: {text if len(text) < 80 else text[:77] + '...'}")

    def function(self, node: ast.FunctionDef) -> Expr:
        """A docstring, assignments to names, one return."""
        plain = node.args.args
        other = (node.args.posonlyargs, node.args.kwonlyargs, node.args.defaults, node.args.vararg, node.args.kwarg)
        if any(other) or node.decorator_list or [a.arg for a in plain] != list(self.values):
            raise self.error(node.args, f"the parameters must be {', '.join(self.values) or 'none'}")
        body = node.body[1:] if isinstance(node.body[0], ast.Expr) else node.body
        for line in body[:-1]:
            if not isinstance(line, ast.Assign) or len(line.targets) != 1 or not isinstance(line.targets[0], ast.Name):
                raise self.error(line, "a formula holds assignments and a return only")
            self.values[line.targets[0].id] = self.read(line.value)
        if not body or not isinstance(body[-1], ast.Return) or body[-1].value is None:
            raise self.error(node, "a formula ends with a return")
        return self.read(body[-1].value)

    def read(self, node: ast.expr) -> Any:
        """One expression."""
        match node:
            case ast.Constant(value=bool()):
                raise self.error(node, "a truth value in a formula")
            case ast.Constant(value=int() | float()):
                return Rational(str(node.value))
            case ast.Name() if node.id in self.values:
                return self.values[node.id]
            case ast.Name() if self.meaning(node) in [f"{package}.pi" for package in (*_PACKAGES, "arithmetic")]:
                return sympy.pi
            case ast.UnaryOp(op=ast.USub()):
                return -self.read(node.operand)
            case ast.BinOp() if type(node.op) in OPERATIONS:
                return OPERATIONS[type(node.op)](self.read(node.left), self.read(node.right))
            case ast.Call(keywords=[]):
                return self.call(node)
        raise self.error(node, "no row in the reader's table for")

    def meaning(self, node: ast.expr) -> str:
        """What a name or a module's attribute is: 'numpy.sqrt', 'local', or empty."""
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id not in self.values:
            return f"{self.module.meaning.get(node.value.id, '')}.{node.attr}"
        name = self.module.meaning.get(node.id, "") if isinstance(node, ast.Name) else ""
        return name.removeprefix("derive.emit.kernels.")

    def call(self, node: ast.Call) -> Any:
        """A function of a package, a Carlson integral, or mpf of a literal."""
        package, _, name = self.meaning(node.func).rpartition(".")
        if package == "mpmath" and name == "mpf" and len(node.args) == 1 and isinstance(node.args[0], ast.Constant):
            return Rational(str(node.args[0].value))
        arguments = [self.read(argument) for argument in node.args]
        if package in (*_PACKAGES, "arithmetic") and name in _PACKAGE_FUNCTIONS:
            return _PACKAGE_FUNCTIONS[name](*arguments)
        if package == "array_arithmetic" and name.removeprefix(_ARRAY_PREFIX) in _PACKAGE_FUNCTIONS:
            return _PACKAGE_FUNCTIONS[name.removeprefix(_ARRAY_PREFIX)](*arguments)
        own = node.func.id if isinstance(node.func, ast.Name) else ""
        if own == "abs" and own not in self.module.meaning:
            return sympy.Abs(*arguments)
        local = own if name == "local" else ""
        kernel = (local or (name if package in _KERNEL_FILES else "")).removesuffix(_ARRAY_SUFFIX)
        if kernel in _KERNEL_FUNCTIONS:
            return _KERNEL_FUNCTIONS[kernel](*arguments)
        raise self.error(node, "the reader's table has no such function")
