"""Signs flipped in the scripts of the theory: what they break. Run as a script it tries a sample and prints JSON.

The derivation as it stands is run once. Each trial is then a fork of that process: one script is compiled with one sign
flipped, it and all that imports it is loaded anew, and the chain is derived from the first step that this touches; what
the steps before give is not derived again. A claim that comes out as it was, in functions that are as they were, is
the main job's to prove; every other is tried at random points as soon as it is asserted, for one of them breaks most
often and the rest of the chain need not be derived then.

A Domain says where a claim is tried, not what it says: a claim may well hold on the flipped domain too, so signs inside
one are left alone.
"""

from __future__ import annotations

import ast
import copy
import importlib.abc
import importlib.util
import itertools
import json
import multiprocessing
import sys
from pathlib import Path

import derive.theory
from derive.check import judge, prepare  # noqa: F401 (loaded once, for all trials)
from derive.theory import chain
from derive.theory.claims import Notebook

FOLDER = Path(derive.theory.__file__).parent
# Records and letters; chain only calls the others.
PLAIN = {"__init__", "claims", "symbols", "letters", "chain"}
SCRIPTS = sorted(path.stem for path in FOLDER.glob("*.py") if path.stem not in PLAIN)
SAMPLE = 48
FORK = multiprocessing.get_context("fork")
# The steps of the derivation in their order: a module, and its function that takes a notebook last.
STEPS = {"derive.theory.equilibrium": "derive_section2", **{f"derive.theory.{step}": "derive" for step in chain.STEPS}}


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


def touched(name):
    """The loaded modules of the project that import one, directly or through others; and itself."""
    loaded = {one for one in sys.modules if one.startswith("derive.")}
    users = {one: imported(sys.modules[one]) for one in loaded}
    found, new = set(), {name}
    while new:
        found |= new
        new = {one for one in loaded - found if users[one] & new}
    return found


def imported(module):
    """Full names of what a module imports, inside its functions too."""
    tree = ast.parse(Path(module.__file__).read_text(encoding="utf-8"))
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = importlib.util.resolve_name("." * node.level + (node.module or ""), module.__package__)
            names.update([base, *(f"{base}.{alias.name}" for alias in node.names)])
    return names


def load_anew(names):
    """Forget modules, also as attributes of their packages, so that the next import runs them again."""
    for name in names:
        package, _, own = name.rpartition(".")
        del sys.modules[name]
        vars(sys.modules[package]).pop(own, None)


class Chain:
    """The derivation as it stands: what each step gives, which claims it adds, and all claims by id."""

    def __init__(self):
        self.given = {}
        for name, function in STEPS.items():
            setattr(sys.modules[name], function, self.kept(name, getattr(sys.modules[name], function)))
        self.claims = chain.derive_all().book.claims

    def kept(self, name, derive):
        """A step that keeps what it gives, the first time."""

        def step(*given, **options):
            book = options.get("book") or given[-1]
            before = len(book.claims)
            result = derive(*given, **options)
            self.given.setdefault(name, (result, list(book.claims.values())[before:]))
            return result

        return step

    def repeat(self, names):
        """Let the steps before the first of some modules give what they gave, and write their claims once more."""
        for name in itertools.takewhile(lambda name: name not in names, STEPS):
            setattr(sys.modules[name], STEPS[name], repeated(*self.given[name]))


def repeated(result, claims):
    def step(*given, **options):
        for claim in claims:
            (options.get("book") or given[-1]).claim(**vars(claim))
        return result

    return step


class BrokenError(Exception):
    """A claim does not survive the flip; the message says which."""


def trial(task, whole):
    """What stops a flipped derivation: the name of a refuted claim or of an exception; empty if nothing does."""
    script, number = task
    tree, line = flipped(script, number)

    class Watched(Notebook):
        def claim(self, *args, **options):
            made = super().claim(*args, **options)
            if made != whole.claims.get(made.id):
                survives(made)
            return made

    names = touched(f"derive.theory.{script}")
    whole.repeat(names)
    load_anew(names)
    sys.meta_path.insert(0, Flipped(script, tree))
    try:
        importlib.import_module("derive.theory.chain").derive_all(book=Watched())
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


def forked(function, *given):
    """A function begun in a fork of this process; what is given back waits for what it gives, or raises EOFError."""
    here, there = FORK.Pipe(duplex=False)
    FORK.Process(target=lambda: there.send(function(*given))).start()
    there.close()
    return here.recv


def main():
    """Try the sample, two at a time, and print script, line and what broke of each."""
    whole, asked = Chain(), tasks()
    hands = [forked(lambda share: [forked(trial, task, whole)() for task in share], asked[hand::2]) for hand in (0, 1)]
    print(json.dumps([outcome for hand in hands for outcome in hand()]))


if __name__ == "__main__":
    main()
