"""Walking and copying syntax trees is what the standard library does."""

from __future__ import annotations

import ast
import copy

import pytest

from derive.emit.kernel_files import read_kernels
from derive.emit.trees import copied, walk
from derive.emit.values import exact


@pytest.mark.parametrize("stem", ["api", "search", "arithmetic_mpmath"])
def test_a_kernel_is_walked_in_the_same_order_and_copied_whole(stem: str) -> None:
    tree = ast.parse(read_kernels()[stem])
    assert all(one is other for one, other in zip(walk(tree), ast.walk(tree), strict=True))
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
