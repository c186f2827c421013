"""What a NumPy module says otherwise than its kernels: records for NamedTuples, and small helpers written out."""

from __future__ import annotations

import ast
import pickle
from typing import Any, NamedTuple

import pytest
from emit_standin import SAMPLE, THEORY
from hypothesis import given
from hypothesis import strategies as st
from test_emit import scene_of

from derive.emit.errors import EmitError
from derive.emit.kernel_files import read_kernels
from derive.emit.kernels.records import Record
from derive.emit.module import emit_module
from derive.emit.pieces import Piece
from derive.emit.records import as_records
from derive.emit.style import expression, wrap
from derive.emit.written_out import write_out
from derive.measure.loading import load
from generated import parallel_numpy


class Named(NamedTuple):
    """Made by typing."""

    first: Any
    second: Any
    third: Any


class Kept(Record):
    """The same as a record."""

    __slots__ = ()

    first: Any
    second: Any
    third: Any


@given(st.tuples(st.floats(allow_nan=False), st.integers(), st.text()), st.sampled_from(Named._fields), st.floats(0, 1))
def test_a_record_is_as_a_named_tuple(values, name, other):
    """Fields, places, equality, hash, text, changed copies; and it goes through a file."""
    named: Any = Named(*values)
    record: Any = Kept(values)
    assert record == named
    assert hash(record) == hash(named)
    assert (record.first, record.second, record.third) == tuple(record) == values
    assert repr(record) == repr(named).replace("Named", "Kept")
    assert record._fields == named._fields
    assert record._replace(**{name: other}) == named._replace(**{name: other})
    assert type(record._replace(**{name: other})) is Kept
    assert pickle.loads(pickle.dumps(record)) == record


def test_a_record_cannot_be_changed():
    record: Any = Kept((1, 2, 3))
    with pytest.raises(AttributeError):
        record.first = 4
    with pytest.raises(AttributeError):
        record.other = 4


def test_results_are_records_and_no_module_makes_classes_by_typing():
    """The public results too: they print their fields, and can be taken apart."""
    assert "NamedTuple" not in vars(parallel_numpy)
    found = parallel_numpy.equilibria(0.5, 0.2, 3.0, 2.0)[0]
    assert repr(found).startswith("Equilibrium(tip_angle=")
    shape: Any = parallel_numpy.shape(found, 3.0)
    theta, curvature, y, z = shape
    assert (theta, y) == (pytest.approx(found.tip_angle), pytest.approx(found.y))
    assert abs(curvature) < 1e-12
    assert z == pytest.approx(found.z)


def test_every_record_of_the_kernels_has_its_places():
    """No NamedTuple there has more fields than a record can have, or a method."""
    for stem, text in read_kernels().items():
        for node in ast.parse(text).body:
            if isinstance(node, ast.ClassDef) and [ast.unparse(base) for base in node.bases] == ["NamedTuple"]:
                fields: list[Any] = [line for line in node.body if isinstance(line, ast.AnnAssign)]
                assert len(fields) <= len(Record._places._fields), (stem, node.name)
                assert all(isinstance(line, (ast.AnnAssign, ast.Expr)) for line in node.body), (stem, node.name)


def piece(text, kind="function", names=()):
    """A piece of a module."""
    node: Any = ast.parse(text).body[0]
    fields = tuple(n.target.id for n in node.body if isinstance(n, ast.AnnAssign)) if kind == "class" else ()
    return Piece(node.name, "file", kind, node, names={name: name for name in names}, parameters=fields)


def written(body):
    """What becomes of a function's one line, with a record Point of two fields."""
    pieces = {
        "Record": piece("class Record(tuple):\n    pass", "class"),
        "Point": piece("class Point(NamedTuple):\n    x: int\n    y: int", "class"),
        "f": piece(f"def f(a, b, pair):\n    return {body}", names=("Point",)),
    }
    as_records(list(pieces), pieces)
    return ast.unparse(pieces["f"].node.body[0]).removeprefix("return ")


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Point(a, b)", "Point((a, b))"),
        ("Point(y=a, x=b)", "Point((b, a))"),
        ("Point(a, y=Point(a, b))", "Point((a, Point((a, b))))"),
        ("Point(*pair)", "Point(pair)"),
        ("Point(*(one for one in pair))", "Point((one for one in pair))"),
        ("Point(a, *pair)", "Point((a, *pair))"),
        ("type(a)(*pair)", "type(a)(pair)"),
        ("tuple(pair)", "tuple(pair)"),
    ],
)
def test_calls_of_a_record(before, after):
    assert written(before) == after


@pytest.mark.parametrize("call", ["Point(a)", "Point(a, b, a)", "Point(a, x=b)", "Point(a, z=b)"])
def test_a_record_must_be_given_all_its_fields(call):
    with pytest.raises(EmitError, match="Point must be given each of x, y, once"):
        written(call)


def test_defaults_of_fields_go_into_the_calls():
    pieces = {
        "Record": piece("class Record(tuple):\n    pass", "class"),
        "P": piece("class P(NamedTuple):\n    x: int\n    y: int = 2\n    z: int = 3", "class"),
        "f": piece("def f(a):\n    return [P(a), P(a, z=a), P(x=a)]", names=("P",)),
    }
    as_records(list(pieces), pieces)
    assert ast.unparse(pieces["f"].node.body[0]) == "return [P((a, 2, 3)), P((a, 2, a)), P((a, 2, 3))]"
    assert "=" not in ast.unparse(pieces["P"].node).replace("__slots__ =", "")


def test_a_record_has_no_methods():
    pieces = {
        "Record": piece("class Record(tuple):\n    pass", "class"),
        "P": piece("class P(NamedTuple):\n    x: int\n    def twice(self):\n        return 2 * self.x", "class"),
    }
    with pytest.raises(EmitError, match="a record has no methods"):
        as_records(list(pieces), pieces)


HELPERS = """
def pick(condition, yes, no):
    \"\"\"One or the other.\"\"\"
    return yes if condition else no

def larger(x, y):
    \"\"\"The larger one.\"\"\"
    return x if x > y else y

def any_of(condition):
    \"\"\"Whether it holds.\"\"\"
    return condition

def epsilon():
    \"\"\"The spacing.\"\"\"
    return 2.0**-52
"""


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("pick(a > 1, b, 0) + 1", "(b if a > 1 else 0) + 1"),
        ("pick(a > 1, pick(b, 1, 2), 3)", "(1 if b else 2) if a > 1 else 3"),
        ("larger(a, -b.c)", "a if a > -b.c else -b.c"),
        ("larger(a + b, 0)", "larger(a + b, 0)"),
        ("any_of(a > b) and b", "a > b and b"),
        ("not any_of(a != b)", "a == b"),
        ("not any_of(a > b)", "not a > b"),
        ("not any_of(a != b < 1)", "not a != b < 1"),
        ("4 * epsilon() ** 0.5", "4 * (2.0**-52) ** 0.5"),
        ("epsilon", "epsilon"),
    ],
)
def test_helpers_are_written_out(before, after):
    """Where that says no argument of some length twice."""
    helpers: list[Any] = ast.parse(HELPERS).body
    pieces = {node.name: Piece(node.name, "arithmetic", "function", node) for node in helpers}
    pieces["f"] = piece(f"def f(a, b):\n    return {before}")
    write_out(list(pieces), pieces)
    assert expression(pieces["f"].node.body[0]).removeprefix("return ") == after


def test_modules_with_records_give_the_same():
    """The kernels as they are, and with the base of records among them."""
    sources = SAMPLE | {"records": read_kernels()["records"]}
    one, other = (load(emit_module(THEORY, scene_of(), "numpy", kernels=k).text) for k in (SAMPLE, sources))
    rod = (0.7, 1.3, 2.5, 2.1)
    assert one.equilibria(*rod)[0].value == other.equilibria(*rod)[0].value
    assert type(other.equilibria(*rod)[0].rod).__mro__[1].__name__ == "Record"


def test_long_comprehensions_break_before_their_loops():
    text = (
        f"return [call(({'first, ' * 8}last)) for key, before, after in {'matched' * 4}(low, high) if before != after]"
    )
    lines = wrap(text, "    ")
    assert [line.split()[0] for line in lines] == ["return", "call((first,", "for", "if", "]"]
    assert ast.dump(ast.parse(" ".join(lines).strip())) == ast.dump(ast.parse(text))
