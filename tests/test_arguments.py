"""The arguments of the public functions: one clear error each, that names the argument, before any work."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from derive.emit.backends import ARRAY_INSTANCES, SHARED
from derive.emit.kernel_files import parse_kernel, read_kernels
from derive.emit.kernels import (
    api,
    arithmetic,
    arithmetic_mpmath,
    array_arithmetic,
    array_arithmetic_mpmath,
    blocks,
)
from derive.emit.kernels.arguments import Given, all_real, common_shape, index_limit
from derive.emit.kernels.spans import span
from generated import field_only_numpy, parallel_mpmath, parallel_numpy

NAMES = ("beta", "eta", "length", "clamp_angle", "field_angle")
GOOD = (1.0, 1.0, 2.0, 1.0, 0.0)
RIGHT = dict(zip(NAMES[:4], GOOD, strict=False))
NO_NUMBERS = ("2", b"2", True, 1j, None, [1.0], (1,), {}, np.array([1.0]), np.True_, np.complex64(1), ...)
NO_NUMBERS += (np.ma.masked, np.ma.masked_array(1.0), (0.5, 1.0), np.ones((30, 2)))  # the last has a text of many lines
NOT_FINITE = (math.nan, math.inf, -math.inf, np.float64("nan"), 10**400, 10**5000)


def with_(name, value):
    return tuple(value if one == name else good for one, good in zip(NAMES, GOOD, strict=True))


# One rod


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("value", NO_NUMBERS, ids=lambda value: " ".join(repr(value).split())[:30])
def test_what_is_no_number_is_a_type_error(name, value):
    with pytest.raises(TypeError, match=rf"^{name} must be a real number, got ") as caught:
        api.equilibria(*with_(name, value))
    assert "\n" not in str(caught.value)


def test_what_is_masked_is_no_array():
    masked = np.ma.masked_array([0.5, 1.0], mask=[False, True])
    with pytest.raises(TypeError, match=r"^eta must be a number or an array without a mask, got masked_array.*\)$"):
        all_real("eta", masked)


def test_the_twin_takes_numbers_of_numpy_and_no_pairs():
    assert arithmetic_mpmath.real("eta", np.float32(0.5)) == arithmetic_mpmath.real("eta", np.int64(1)) / 2
    with pytest.raises(TypeError, match=r"^eta must be a real number, got \(0.5, 1.0\)$"):
        arithmetic_mpmath.real("eta", (0.5, 1.0))


@pytest.mark.parametrize("ends", [np.array(1.0), np.ones((30, 2)), 1.0, "ab"])
def test_a_range_is_a_pair(ends):
    with pytest.raises(TypeError, match=r"^eta must be a pair \(low, high\), got ") as caught:
        span("eta", ends)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    "value",
    NOT_FINITE,
    ids=lambda value: f"{type(value).__name__} {value if isinstance(value, float) else value.bit_length()}",
)
def test_what_is_not_finite_is_a_value_error(name, value):
    with pytest.raises(ValueError, match=rf"^{name} must be finite, got "):
        api.equilibria(*with_(name, value))


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("beta", -1e-300, "must not be negative"),
        ("eta", -1, "must not be negative"),
        ("length", 0, "must be positive"),
        ("length", -2.0, "must be positive"),
    ],
)
def test_what_is_outside_the_domain_is_a_value_error(name, value, says):
    with pytest.raises(ValueError, match=rf"^{name} {says}, got {value!r}$"):
        api.equilibria(*with_(name, value))


@pytest.mark.parametrize(
    "number", [1, Fraction(1), Decimal(1), np.float32(1), np.int8(1), np.array(1.0), mpmath.mpf(1)]
)
def test_every_kind_of_real_number_is_taken(number):
    found, wanted = (api.equilibria(*(value for _ in NAMES)) for value in (number, 1.0))
    assert [one.tip_angle for one in found] == [one.tip_angle for one in wanted]
    assert all(type(one.tip_angle) is float for one in found)


def test_zero_has_no_sign():
    (rod,), swept = api.equilibria(-0.0, -0.0, 1, 0, 0), api.sweep(np.array([-0.0] * 20), -0.0, 1, 0, 0)
    assert [math.copysign(1, value) for value in (rod.rod.beta, rod.rod.eta, *swept.gamma)] == [1] * 22


@pytest.mark.parametrize("value", [True, 1.5, 2.0, "1", [1], np.True_, math.nan], ids=repr)
def test_the_largest_index_is_an_integer(value):
    for function in (api.equilibria, api.sweep):
        with pytest.raises(TypeError, match=r"^max_index must be None or an integer"):
            function(*GOOD, max_index=value)


def test_the_largest_index_is_not_negative():
    assert [index_limit(value) for value in (None, 0, 3, np.int64(2))] == [None, 0, 3, 2]
    with pytest.raises(ValueError, match=r"^max_index must not be negative, got -1$"):
        api.equilibria(*GOOD, max_index=-1)


def test_the_largest_index_limits_the_answer():
    rod = (0.0, 1.0, 10.0, 3 * math.pi / 4)
    for module, arguments in ((api, (*rod, 0.0)), (parallel_numpy, rod), (parallel_mpmath, rod)):
        found = module.equilibria(*arguments)
        assert max(one.index for one in found) > 1
        for limit in (0, 1, 2, 99):
            wanted = [one.tip_angle for one in found if one.index <= limit]
            assert [one.tip_angle for one in module.equilibria(*arguments, max_index=limit)] == wanted
            assert list(module.sweep(*arguments, max_index=limit).tip_angle) == wanted


# The arithmetic of both twins


def test_the_twins_have_the_same_names():
    assert arithmetic.__all__ == arithmetic_mpmath.__all__
    assert set(array_arithmetic_mpmath.__all__) <= set(array_arithmetic.__all__)  # there are no array instances
    for module in (arithmetic, arithmetic_mpmath, array_arithmetic, array_arithmetic_mpmath):
        assert all(hasattr(module, name) for name in module.__all__)


def test_array_instances_have_their_arithmetic():
    """What an array instance needs of scalar arithmetic has an elementwise form."""
    each = {name.removeprefix("each_") for name in array_arithmetic.__all__}
    for stem in ARRAY_INSTANCES:
        kernel = parse_kernel(stem, read_kernels()[stem])
        used = {
            origin[1] for origin in kernel.imports.values() if isinstance(origin, tuple) and origin[0] == "arithmetic"
        }
        assert used - {*SHARED} <= each, stem


def test_arrays_compute_what_scalars_compute():
    x = np.array([0.1, 0.5, 0.9])
    for name in ("acos", "asin", "atan", "cos", "exp", "floor", "log", "sin", "sqrt"):
        one, each = getattr(arithmetic, name), getattr(array_arithmetic, f"each_{name}")
        assert each(x) == pytest.approx([one(value) for value in x.tolist()], rel=4e-16)
    assert array_arithmetic.each_pick(x > 0.3, 1, 2).tolist() == [arithmetic.pick(v > 0.3, 1, 2) for v in x]
    assert array_arithmetic.larger(x, 0.5).tolist() == [arithmetic.larger(v, 0.5) for v in x.tolist()]


# Many rods


@given(st.integers(0, 4), st.integers(0, 11), st.sampled_from([math.nan, math.inf, -math.inf]))
def test_a_sweep_names_the_first_bad_value(which, place, bad):
    values = np.ones((3, 4))
    values.ravel()[place] = bad
    values.ravel()[place + 1 :] = math.nan
    for form in (values, values.tolist()):
        with pytest.raises(ValueError, match=rf"^{NAMES[which]}\[{place}\] must be finite, got {bad!r}$"):
            api.sweep(*with_(NAMES[which], form))


@pytest.mark.parametrize(
    ("name", "values", "error", "says"),
    [
        ("beta", np.array([1, -2, -3]), ValueError, r"beta\[1\] must not be negative, got -2.0"),
        ("eta", [[1.0, 2.0], [3.0, -4.0]], ValueError, r"eta\[3\] must not be negative, got -4.0"),
        ("length", np.array([1.0, 0.0]), ValueError, r"length\[1\] must be positive, got 0.0"),
        ("length", -1.0, ValueError, r"length must be positive, got -1.0"),
        ("clamp_angle", np.array([1, 1j]), TypeError, r"clamp_angle\[0\] must be a real number"),
        ("clamp_angle", ["1", 2.0], TypeError, r"clamp_angle\[0\] must be a real number, got '1'"),
        ("clamp_angle", [0.5, True], TypeError, r"clamp_angle\[1\] must be a real number, got True"),
        ("field_angle", np.array([True]), TypeError, r"field_angle\[0\] must be a real number"),
        ("field_angle", np.array(["x"]), TypeError, r"field_angle\[0\] must be a real number, got 'x'"),
        ("field_angle", "0", TypeError, r"field_angle must be a real number, got '0'"),
        ("beta", [1.0, None], TypeError, r"beta\[1\] must be a real number, got None"),
        ("beta", [[1.0], [1.0, 2.0]], TypeError, r"beta\[0\] must be a real number, got \[1.0\]"),
        ("beta", [np.ones((2, 3)), np.ones((2, 4))], ValueError, r"beta must be a number or an array: its rows have"),
        ("beta", 10**400, ValueError, "beta must be finite"),
    ],
)
def test_what_cannot_be_swept(name, values, error, says):
    with pytest.raises(error, match=rf"^{says}"):
        api.sweep(*with_(name, values))


def test_arrays_that_do_not_broadcast():
    says = r"do not broadcast against one another: their shapes are beta \(3,\), eta \(2,\), length \(\)"
    with pytest.raises(ValueError, match=says):
        api.sweep(np.ones(3), np.ones(2), 1.0, 1.0, 0.0)
    with pytest.raises(ValueError, match=r"shapes are eta \(2,\), length \(3,\), clamp_angle \(\)$"):
        field_only_numpy.sweep(np.ones(2), np.ones(3), 1.0)


def test_what_is_broadcast():
    given = (1, np.arange(1, 4), [[1], [2]], Fraction(1, 2), np.float32(0))
    assert common_shape(Given(*(np.asarray(part, dtype=float) for part in given))) == (2, 3)
    found = api.sweep(*given)
    rods = [(1, eta, length, 0.5, 0) for length in (1, 2) for eta in (1, 2, 3)]
    wanted = [(case, one.tip_angle) for case, rod in enumerate(rods) for one in api.equilibria(*rod)]
    assert list(zip(found.case.tolist(), found.tip_angle.tolist(), strict=True)) == wanted
    assert api.sweep([], 1, 1, 1, 1).case.size == 0


def test_errors_come_before_any_work(monkeypatch):
    """With a solver that cannot be called, a bad last value is still what is said."""

    def solver(*rod):
        raise AssertionError(rod)

    monkeypatch.setattr(blocks, "all_equilibria", solver)
    with pytest.raises(AssertionError):
        api.sweep(*GOOD)
    with pytest.raises(ValueError, match=r"^eta\[2\]"):
        api.sweep(*with_("eta", [1.0, 2.0, -3.0]))
    with pytest.raises(TypeError, match=r"^max_index"):
        api.sweep(*GOOD, max_index="all")
    with pytest.raises(ValueError, match=r"broadcast"):
        api.sweep([1, 2], [1, 2, 3], 1, 1, 0)


# Shapes


@pytest.mark.parametrize(
    ("s", "error", "says"),
    [
        (-0.1, ValueError, r"s must lie in \[0, 2.0\], the rod, got -0.1"),
        (np.array([0.0, 1.0, 2.1]), ValueError, r"s\[2\] must lie in \[0, 2.0\], the rod, got 2.1"),
        (math.nan, ValueError, "s must be finite"),
        ([0.0, math.nan], ValueError, r"s\[1\] must be finite"),
        (1j, TypeError, "s must be a real number"),
        ("1", TypeError, "s must be a real number"),
        (np.array([True]), TypeError, r"s\[0\] must be a real number"),
    ],
)
def test_places_that_are_not_on_the_rod(s, error, says):
    (one, *_) = api.equilibria(*GOOD)
    with pytest.raises(error, match=rf"^{says}"):
        api.shape(one, s)


def test_a_shape_is_of_an_equilibrium():
    for module in (api, parallel_numpy, parallel_mpmath):
        with pytest.raises(TypeError, match=r"^equilibrium must be one that equilibria gives, got 1.5$"):
            module.shape(1.5, 0.5)


# The emitted modules, and the mpmath twin


@pytest.mark.parametrize("name", NAMES[:4])
def test_emitted_modules_name_their_arguments(name):
    for module in (parallel_numpy, parallel_mpmath):
        for function in (module.equilibria, module.sweep):
            with pytest.raises(ValueError, match=rf"^{name} must be finite"):
                function(**RIGHT | {name: math.nan})
            with pytest.raises(TypeError, match=rf"^{name} must be a real number"):
                function(**RIGHT | {name: 1j})
            with pytest.raises(TypeError, match=rf"^{name} must be a real number"):
                function(**RIGHT | {name: np.True_})
        with pytest.raises(TypeError, match=rf"^{name} must be a real number"):
            module.equilibria(**RIGHT | {name: np.array([1.0])})
        with pytest.raises(ValueError, match=rf"^{name}\[1\] must be finite"):
            module.sweep(**RIGHT | {name: [1, math.inf]})


@pytest.mark.parametrize("text", ["", "one", "1j", "1/0", "nan x"])
def test_the_twin_reads_numbers_only(text):
    with pytest.raises(TypeError, match=r"^eta must be a real number"):
        parallel_mpmath.equilibria(**RIGHT | {"eta": text})


def test_the_twin_refuses_sequences_of_different_lengths():
    with pytest.raises(ValueError, match=r"sequences must have one length: their lengths are beta 2, eta 3$"):
        parallel_mpmath.sweep([1, 2], [1, 2, 3], 1, 1)
    with pytest.raises(TypeError, match=r"^beta\[0\] must be a real number"):
        parallel_mpmath.sweep([[1, 2]], 1, 1, 1)
    assert parallel_mpmath.sweep([], 1, 1, 1).case == []


@pytest.mark.parametrize(
    ("dps", "error", "says"),
    [
        (14, ValueError, "dps must be from 15 to 1000 digits, got 14"),
        (1001, ValueError, "dps must be from 15 to 1000 digits, got 1001"),
        (30.0, TypeError, "dps must be None or an integer"),
        (True, TypeError, "dps must be None or an integer"),
        ("30", TypeError, "dps must be None or an integer"),
    ],
)
def test_digits_of_the_twin(dps, error, says):
    before = mpmath.mp.prec
    (one, *_) = parallel_mpmath.equilibria(**RIGHT)
    for call in (
        lambda: parallel_mpmath.equilibria(**RIGHT, dps=dps),
        lambda: parallel_mpmath.sweep(**RIGHT, dps=dps),
        lambda: parallel_mpmath.shape(one, 1, dps=dps),
    ):
        with pytest.raises(error, match=rf"^{says}"):
            call()
    assert mpmath.mp.prec == before


def test_the_digits_of_the_caller():
    with mpmath.workdps(10), pytest.raises(ValueError, match=r"^the precision of the caller, mp.dps, must be from 15"):
        parallel_mpmath.equilibria(**RIGHT)
    with mpmath.workdps(40):
        (found, *_) = parallel_mpmath.equilibria(**RIGHT)
    (same, *_) = parallel_mpmath.equilibria(**RIGHT, dps=40)
    assert found.tip_angle == same.tip_angle
