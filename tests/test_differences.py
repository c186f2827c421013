"""Where a repaired formula differs from the printed one."""

from __future__ import annotations

import pytest

from derive.check.differences import differences
from derive.paper.reader import parse


@pytest.mark.parametrize(
    ("scope", "old", "new", "expected"),
    [
        ("force_only", r"\gamma = 2 \beta \xi(\ell)", r"\gamma = 2 \beta \xi(s)", [(r"\xi (\ell)", r"\xi (s)")]),
        ("parallel", r"b = \beta - \frac{1}{2}", r"b = \beta + \frac{1}{2}", [(r"-\frac{1}{2}", r"\frac{1}{2}")]),
        ("parallel", r"a = b c + c", r"a = b b + c", [("bc", "bb")]),
        ("variation", r"\boldsymbol{d}_3 \times \boldsymbol{e} = \boldsymbol{0}",
         r"\boldsymbol{e} \times \boldsymbol{d}_3 = \boldsymbol{0}",
         [(r"\boldsymbol{d}_{3}\times\boldsymbol{e}", r"\boldsymbol{e}\times\boldsymbol{d}_{3}")]),
        ("parallel", "a > b", "a < b", []),
    ],
)  # fmt: skip
def test_the_smallest_parts_are_shown(scope, old, new, expected):
    (before,), (after,) = parse(old, scope), parse(new, scope)
    found = [tuple(plain(side) for side in pair) for pair in differences(before, after, scope)]
    assert found == [tuple(plain(side) for side in pair) for pair in expected]
    assert differences(before, before, scope) == []


def plain(latex):
    return latex.replace(r"\left", "").replace(r"\right", "").replace(" ", "")
