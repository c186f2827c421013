"""The derivation checks itself: a sign flipped in any line of a theory script breaks a claim, or the script stops.

Each trial runs in a process of its own: one script is compiled with one sign flipped, the whole chain is derived from
it, and every claim is tried at random points. A fixed sample of the flips is tried here, spread over all the scripts.
A Domain says where a claim is tried, not what it says: a claim may well hold on the flipped domain too, so signs
inside one are left alone.
"""

from __future__ import annotations

import ast
import copy
import importlib.abc
import importlib.util
import multiprocessing
import sys
from pathlib import Path

import pytest

import derive.theory

FOLDER = Path(derive.theory.__file__).parent
# Records and letters; chain only calls the others.
PLAIN = {"__init__", "claims", "symbols", "letters", "chain"}
SCRIPTS = sorted(path.stem for path in FOLDER.glob("*.py") if path.stem not in PLAIN)
SAMPLE = 48


def signs(tree):
    """Every binary plus and minus and every unary minus, in a fixed order."""
    hypotheses = {id(part) for node in ast.walk(tree) if is_domain(node) for part in ast.walk(node)}
    for node in ast.walk(tree):
        if id(node) in hypotheses:
            continue
        binary = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)
        unary = isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub)
        if unary or (binary and not is_text(node.left) and not is_text(node.right)):
            yield node


def is_domain(node):
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Domain"


def is_text(node):
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def flipped(script, number):
    """The script's syntax tree with one sign flipped, and the line where."""
    tree = ast.parse((FOLDER / f"{script}.py").read_text(encoding="utf-8"))
    node = list(signs(tree))[number]
    if isinstance(node, ast.BinOp):
        node.op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
    else:
        inner = copy.deepcopy(node.operand)
        node.operand = ast.UnaryOp(ast.USub(), inner)
    return ast.fix_missing_locations(tree), node.lineno


class Flipped(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Imports one theory script from the flipped tree."""

    def __init__(self, script, tree):
        self.name, self.tree = f"derive.theory.{script}", tree

    def find_spec(self, name, path=None, target=None):
        return importlib.util.spec_from_loader(name, self) if name == self.name else None

    def exec_module(self, module):
        exec(compile(self.tree, f"{self.name} (flipped)", "exec"), module.__dict__)


class BrokenError(Exception):
    """A claim does not survive the flip; the message says which."""


def trial(task):
    """What stops a flipped derivation: the name of a refuted claim or of an exception; empty if nothing does.

    Claims of the flipped script's own section are tried as soon as they are asserted, for one of them breaks most often
    and the rest of the chain need not be derived then.
    """
    script, number = task
    tree, line = flipped(script, number)
    for name in [name for name in sys.modules if name.startswith("derive.")]:
        del sys.modules[name]
    sys.meta_path.insert(0, Flipped(script, tree))
    from derive.theory.chain import derive_all
    from derive.theory.claims import Notebook

    own = script.split("_")[0]

    class Watched(Notebook):
        def claim(self, *args, **options):
            made = super().claim(*args, **options)
            if made.id.startswith(own):
                survives(made)
            return made

    try:
        for claim in derive_all(book=Watched()).book.claims.values():
            if not claim.id.startswith(own):
                survives(claim)
    except BrokenError as broken:
        return script, line, str(broken)
    except Exception as error:
        return script, line, f"stopped by {type(error).__name__}"
    return script, line, ""


def survives(claim):
    """Nothing, or BrokenError."""
    from derive.check.judge import _refuted
    from derive.check.prepare import prepared

    try:
        tried = _refuted(prepared(claim))
    except Exception as error:
        raise BrokenError(f"stopped by {type(error).__name__} in {claim.id}") from error
    if tried.counterexample:
        raise BrokenError(f"refutes {claim.id}")
    if not tried.points:
        raise BrokenError(f"leaves {claim.id} undefined")


def tasks():
    """A fixed sample of all flips, evenly spread."""
    found = [
        (script, number)
        for script in SCRIPTS
        for number in range(len(list(signs(ast.parse((FOLDER / f"{script}.py").read_text(encoding="utf-8"))))))
    ]
    return found[:: max(1, len(found) // SAMPLE)]


@pytest.mark.long
def test_a_flipped_sign_breaks_a_claim():
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["sympy", "mpmath"])  # what no flip changes is imported once
    with context.Pool(2, maxtasksperchild=1) as pool:
        outcomes = list(pool.imap_unordered(trial, tasks(), chunksize=1))
    survivors = [f"{script}.py:{line}" for script, line, outcome in outcomes if not outcome]
    assert not survivors
    assert sum(outcome.startswith("refutes") for _, _, outcome in outcomes) > len(outcomes) / 2
