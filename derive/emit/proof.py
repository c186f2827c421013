"""The proof of an emitted module: its formulas read back and proved, its names defined.

What it computes is compared with the references by `measure.agreement`. A module that fails either is not written.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable
from dataclasses import dataclass

from sympy import Expr, oo

from derive.check.judge import judge
from derive.check.verdicts import PROVED
from derive.emit.backends import BACKENDS
from derive.emit.errors import EmitError
from derive.emit.module import EmittedModule
from derive.emit.pieces import bound_names
from derive.emit.readback import read_formula, read_module
from derive.theory.claims import Claim, Domain, Equal, Formula

# Standard-library modules that emitted code may import.
STANDARD = frozenset(
    (
        "__future__",
        "math",
        "typing",
        "dataclasses",
        "functools",
        "itertools",
        "collections",
        "bisect",
        "operator",
        "cmath",
    )
)


@dataclass(frozen=True)
class FormulaProof:
    """How one emitted formula was proved equal to the registry's expression: the method; the claim it stands for."""

    formula: str
    claim: str
    method: str


def prove_module(module: EmittedModule) -> tuple[FormulaProof, ...]:
    """Prove a module, or raise EmitError with the place that fails."""
    proofs = prove_formulas(module.text, module.formulas, module.path)
    check_names(module.text, module.path, module.backend)
    return proofs


def prove_formulas(text: str, formulas: Iterable[Formula], label: str) -> tuple[FormulaProof, ...]:
    """Read all formulas back from the text of a module and prove each equal to its expression.

    label: names the module in errors. EmitError for a formula that is missing, unreadable, or not proved equal.
    """
    module = read_module(text, label)
    proofs = []
    for formula in formulas:
        read = read_formula(module, formula.name, {symbol.name: symbol for symbol in formula.arguments}, label)
        proofs.append(FormulaProof(formula.name, formula.claim, _equal(formula, read, label)))
    return tuple(proofs)


def _equal(formula: Formula, read: Expr, label: str) -> str:
    """The method by which ``read`` is proved equal to the formula's expression."""
    if read == formula.expression:
        return "same expression"
    # Two analytic expressions that agree for positive arguments agree wherever both are continued to.
    domain = Domain(dict.fromkeys(formula.arguments, (0, oo)))
    claim = Claim(f"emit.{formula.name}", "the emitted code says the formula", Equal(read, formula.expression), domain)
    verdict = judge(claim)
    if verdict.verdict != PROVED:
        detail = f" ({verdict.counterexample})" if verdict.counterexample else f" ({verdict.reason})"
        raise EmitError(
            f"{label}: '{formula.name}' is not proved equal to {formula.claim}: {verdict.verdict}{detail}; "
            f"the code says {read}, the theory {formula.expression}"
        )
    return verdict.method


def check_names(text: str, label: str, backend: str) -> None:
    """EmitError if the text of a module loads a name that is not defined, or imports what its backend may not.

    A backend may import its packages and STANDARD. label: names the module in errors.
    """
    module = read_module(text, label)
    tree = ast.parse(text)
    for node in ast.walk(tree):
        imported = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        imported += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        foreign = [name for name in imported if name.split(".")[0] not in STANDARD | set(BACKENDS[backend].packages)]
        if foreign:
            line = getattr(node, "lineno", 0)
            raise EmitError(f"{label}:{line}: imports {foreign[0]}, which an emitted module may not")
    known = set(module.meaning) | set(dir(builtins))
    for top in tree.body:
        local: set[str] = bound_names(top)
        for name in ast.walk(top):
            if isinstance(name, ast.Name) and isinstance(name.ctx, ast.Load) and name.id not in known | local:
                raise EmitError(f"{label}:{name.lineno}: '{name.id}' is not defined")
