"""Walking, copying, comparing and changing syntax trees is what the standard library does."""

from __future__ import annotations

import ast
import copy

import pytest

from derive.emit.kernel_files import read_kernels
from derive.emit.trees import Transformer, copied, form, walk
from derive.emit.values import exact


@pytest.mark.parametrize("stem", ["api", "search", "arithmetic_mpmath"])
def test_a_kernel_is_walked_in_the_same_order_and_copied_whole(stem: str) -> None:
    tree = ast.parse(read_kernels()[stem])
    silent = ast.expr_context | ast.operator | ast.unaryop | ast.boolop | ast.cmpop
    telling = [node for node in ast.walk(tree) if not isinstance(node, silent)]
    assert all(one is other for one, other in zip(walk(tree), telling, strict=True))
    new = copied(tree)
    assert ast.dump(new, include_attributes=True) == ast.dump(copy.deepcopy(tree), include_attributes=True)
    assert not {id(node) for node in ast.walk(new)} & {
        id(node) for node in ast.walk(tree) if not isinstance(node, ast.expr_context | ast.operator | ast.unaryop)
    }


def test_folded_values_and_marks_go_with_the_copy() -> None:
    node = ast.Return(exact(2))
    node.mark = "as it was"  # type: ignore[attr-defined]
    new = copied(node)
    assert new.value is not node.value
    assert new.value.value == 2  # type: ignore[union-attr]
    assert new.mark == "as it was"  # type: ignore[attr-defined]


CONTENTS = ("x + 1", "x - 1", "x + 1.0", "x + True", "y + 1", "f(x, y)", "f(x, y=y)", "f(*x)", "x < 1", "x <= 1", "-x")


def test_trees_are_alike_where_they_are_dumped_alike() -> None:
    trees = [ast.parse(text, mode="eval") for text in (*CONTENTS, *CONTENTS, "0.0", "-0.0", "x", "not x", "x or y")]
    for one in trees:
        for other in trees:
            assert (form(one) == form(other)) == (ast.dump(one) == ast.dump(other))


class Changes:
    """One change of each sort: a node for a node, several statements for one, none for one."""

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return ast.Constant(2) if node.id == "two" else node

    def visit_If(self, node: ast.If) -> list[ast.stmt]:
        self.generic_visit(node)  # type: ignore[attr-defined]  # of the other base
        return node.body

    def visit_Assert(self, node: ast.Assert) -> None:
        return None


class Ours(Changes, Transformer):
    pass


class Theirs(Changes, ast.NodeTransformer):
    pass


def test_changes_are_those_of_the_standard_library() -> None:
    text = "def f(two, *rest):\n    assert two\n    if rest:\n        x = -two\n        assert x\n    return two, x"
    ours, theirs = Ours().visit(ast.parse(text)), Theirs().visit(ast.parse(text))
    assert ast.unparse(ours) == ast.unparse(theirs)
    assert ast.unparse(ours) != text
