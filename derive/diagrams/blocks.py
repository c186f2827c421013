"""The equilibria at many values, in blocks that any executor computes and a folder keeps.

A block is a request and nothing else: what it needs is sent with it, so that it may run in another process or on
another machine on which this project is installed, and be run again when that is lost.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, as_completed
from dataclasses import asdict, astuple, dataclass
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

from derive.cache import write_atomically
from derive.diagrams.states import State, rows
from derive.measure.loading import load

BLOCK = 128  # values
Rows = list[list[State]]


@dataclass(frozen=True)
class Block:
    """Values of a parameter of one rod.

    module: the name of a shipped module, or empty and text: that of an emitted one. parameter: what varies, over the
    values. fixed: the other parameters, name and value.
    """

    module: str
    text: str
    parameter: str
    values: tuple[float, ...]
    fixed: tuple[tuple[str, float], ...]

    def key(self) -> str:
        """What tells this request from any other; the module counts by its text."""
        digest = hashlib.sha256(repr((asdict(self), source(self.module))).encode())
        return digest.hexdigest()[:32]


def source(module: str) -> str:
    """The text of a shipped module."""
    place = import_module(module).__file__ if module else None
    return Path(place).read_text(encoding="utf-8") if place else ""


@lru_cache(maxsize=8)
def module_of(name: str, text: str) -> ModuleType:
    """The module of a block; a process makes it once."""
    return import_module(name) if name else load(text)


def solve(block: Block) -> Rows:
    """The equilibria at each value of a block."""
    return rows(module_of(block.module, block.text), block.parameter, block.values, dict(block.fixed))


def blocks(
    module: str, text: str, parameter: str, values: Sequence[float], fixed: Mapping[str, float]
) -> Iterator[Block]:
    """The values of a parameter in blocks of BLOCK; module, text and fixed as in a ``Block``."""
    for start in range(0, len(values), BLOCK):
        part = tuple(values[start : start + BLOCK])
        yield Block(module, text, parameter, part, tuple(sorted(fixed.items())))


class Store:
    """A folder of solved blocks; none if there is no folder. What cannot be read is computed anew."""

    def __init__(self, folder: Path | None) -> None:
        self.folder = folder

    def get(self, block: Block) -> Rows | None:
        """The rows of a block that is there."""
        if self.folder is None:
            return None
        try:
            data = json.loads((self.folder / f"{block.key()}.json").read_text(encoding="utf-8"))
            return [[State(*state) for state in row] for row in data]
        except (OSError, ValueError, TypeError):
            return None

    def put(self, block: Block, found: Rows) -> None:
        """Keep a block, whole or not at all; OSError if the folder cannot take it."""
        if self.folder is not None:
            write_atomically(
                self.folder / f"{block.key()}.json", json.dumps([[astuple(state) for state in row] for row in found])
            )


def solved(
    todo: Sequence[Block],
    store: Store,
    executor: Executor | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> dict[Block, Rows]:
    """The rows of all blocks todo: from the store, and what is missing from the executor, or here if there is none.

    executor: any of ``concurrent.futures``, or with its interface. progress: called with the number of blocks done and
    of all.
    """
    found = {block: kept for block in todo if (kept := store.get(block)) is not None}
    rest = [block for block in todo if block not in found]
    progress(len(found), len(todo))
    for block, result in results(rest, executor):
        store.put(block, result)
        found[block] = result
        progress(len(found), len(todo))
    return found


def rows_of(future: Future[Rows], block: Block) -> Rows:
    """What a future found; where that was lost with the worker that had it, the block is solved here.

    A cluster may tell of a block as done, and then of its rows as neither here nor an error. An error of the block
    itself comes again.
    """
    try:
        return future.result()
    except BrokenExecutor:
        raise
    except Exception:  # whatever an executor makes of what it has lost
        return solve(block)


def results(todo: Sequence[Block], executor: Executor | None) -> Iterator[tuple[Block, Rows]]:
    """The blocks todo with their rows, as they come from the executor, or one after another if there is none."""
    if executor is None:
        yield from ((block, solve(block)) for block in todo)
        return
    futures: dict[Future[Rows], Block] = {executor.submit(solve, block): block for block in todo}
    try:
        for future in as_completed(futures):
            yield futures[future], rows_of(future, futures[future])
    finally:
        for future in futures:
            future.cancel()
