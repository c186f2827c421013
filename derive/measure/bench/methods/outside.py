"""Packages from PyPI whose licence keeps them out of this project: run in a process of their own, if installed.

Nothing here imports them; the worker is told a module and a function, and is given points by a pipe. So a time holds
the pipe's round trip, some 0.1 ms. Set up: `pyweierstrass` (mpmath's theta functions) takes half-periods, and its
points one by one; `elliptic-functions` (NumPy) takes the three half-period values and an array.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from derive.measure.bench.cells import PEER, Cell, Method, Problem
from derive.measure.bench.families import Plan

WORKER = """
import importlib, json, sys
import numpy
asked = json.loads(sys.stdin.readline())
function = getattr(importlib.import_module(asked["module"]), asked["function"])
lattice, points = asked["lattice"], numpy.array(asked["points"])
if asked["each"]:
    pair = (lattice[0], 1j * lattice[1])
    call = lambda: [function(x, pair) for x in asked["points"]]
else:
    call = lambda: function(points, *lattice)
print("ready", flush=True)
for line in sys.stdin:
    found = call()
    print(json.dumps([[complex(x).real, complex(x).imag] for x in found]) if line == "show\\n" else "", flush=True)
"""


class Outside:
    """A function of such a package at fixed points: the first call gives the values, later ones only compute them."""

    def __init__(self, module: str, function: str, lattice: Sequence[float], points: Sequence[float]) -> None:
        self.shown = False
        pipe, command = subprocess.PIPE, [sys.executable, "-c", WORKER]
        self.process = subprocess.Popen(
            command, stdin=pipe, stdout=pipe, stderr=subprocess.DEVNULL, text=True, encoding="utf-8"
        )
        asked = {"module": module, "function": function, "lattice": list(lattice), "points": list(points)}
        self._ask(json.dumps({**asked, "each": len(lattice) == 2}))

    def _ask(self, line: str) -> str:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            self.close()
            raise RuntimeError("the package's process has ended")
        return answer

    def __call__(self) -> list[float] | None:
        """Compute all values once."""
        answer = self._ask("go" if self.shown else "show")
        if self.shown:
            return None
        self.shown = True
        return [real for real, _ in json.loads(answer)]

    def close(self) -> None:
        """End the process."""
        if self.process.stdin is not None:
            self.process.stdin.close()
        if self.process.stdout is not None:
            self.process.stdout.close()
        self.process.wait(timeout=10)


def cells(module: str, functions: Mapping[str, str], lattice: str, problem: Problem, plan: Plan) -> Iterator[Cell]:
    """lattice: what a package takes, "half_periods" (and points one by one) or "values" (and arrays)."""
    if problem.task == "T5":
        given = problem.inputs
        each = lattice == "half_periods"
        points = given.u[given.sample].tolist() if each else given.u.tolist()
        start = partial(Outside, module, functions[given.kind], getattr(given, lattice), points)
        yield Cell("doubles", start, 1e-10, share=len(points) / problem.units)


METHODS = (
    Method(
        "pyweierstrass",
        PEER,
        partial(cells, "pyweierstrass.weierstrass", {"p": "wp", "zeta": "wzeta", "sigma": "wsigma"}, "half_periods"),
        ("pyweierstrass",),
    ),
    Method(
        "elliptic-functions",
        PEER,
        partial(
            cells,
            "elliptic",
            {"p": "weierstrassP", "zeta": "weierstrassZeta", "sigma": "weierstrassSigma"},
            "values",
        ),
        ("elliptic",),
    ),
)
