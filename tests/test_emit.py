"""The emitter by itself, on small kernels and a few formulas typed in."""

from __future__ import annotations

import ast
import hashlib
import os
import subprocess
import sys
from pathlib import Path

import mpmath
import pytest
from emit_standin import FORMULAS, SAMPLE, THEORY
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Integer, Rational, pi, sqrt, symbols

from derive.emit.committed import formulas_text
from derive.emit.constants import parse_constant
from derive.emit.errors import EmitError, SceneError
from derive.emit.module import emit_module
from derive.emit.printer import formula_function
from derive.emit.proof import check_names, prove_formulas
from derive.emit.scene import load_scene, parse_scene
from derive.emit.style import expression, wrap
from derive.measure.loading import load
from derive.resources import shipped_scenes
from derive.theory.claims import Formula
from derive.theory.functions import RC, RF, RJ
from generated import force_only_mpmath, parallel_mpmath

HEAD = '[scene]\nname = "sample"\ncase = "parallel"\noutputs = ["equilibria", "shape"]\n'
RANDOM = symbols("a b c d", positive=True)


def scene_of(case="parallel", constants="", outputs='["equilibria", "shape"]'):
    return parse_scene(f'[scene]\nname = "sample"\ncase = "{case}"\noutputs = {outputs}\n[constants]\n{constants}')


def emitted(case="parallel", backend="numpy", constants="", kernels=None, **options):
    return emit_module(THEORY, scene_of(case, constants), backend, kernels={**SAMPLE, **(kernels or {})}, **options)


# Scenes


def test_shipped_scenes_are_read():
    scenes = {name: load_scene(path) for name, path in shipped_scenes().items()}
    assert {"field_only", "force_only", "parallel"} <= set(scenes)
    assert all(scene.name == name for name, scene in scenes.items())
    assert scenes["force_only"].folded["eta"] == 0
    assert "eta" not in scenes["force_only"].parameters
    assert "beta" not in scenes["field_only"].parameters


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        (HEAD.replace("case", "caze"), 3, "possible: backends, case, name, outputs, title"),
        (HEAD.replace('"parallel"', '"paralel"'), 3, "did you mean 'parallel'"),
        (HEAD.replace('"shape"', '"shapes"'), 4, "possible: equilibria, folds, literal, shape, sweep"),
        (HEAD + 'backends = ["fortran"]\n', 5, "possible: mpmath, numpy"),
        (HEAD + "title = 3\n", 5, "must be a string"),
        (HEAD + "[constants]\nlenght = 80\n", 6, "did you mean 'length'"),
        (HEAD + '[constants]\nlength = "0"\n', 6, "length > 0"),
        (HEAD + '[constants]\n\nbeta = "-1/2"\n', 7, "beta >= 0"),
        (HEAD + "[constants]\nlength = 0.1\n", 6, "as a string"),
        (HEAD + '[constants]\nlength = "3*tau"\n', 6, "'tau' at character 3"),
        (HEAD + '[constants]\nlength = "__import__(1)"\n', 6, "possible: integers, decimals, pi"),
        (HEAD.replace("parallel", "force_only") + '[constants]\neta = "1"\n', 6, "already fixes eta = 0"),
        (HEAD + "[constant]\n", 5, "possible: constants, scene"),
        (HEAD + "outputs = [\n", 5, "is not TOML"),
        ('[scene]\nname = "x"\n', 1, "lacks case, outputs"),
        (HEAD.replace("sample", "../x"), 2, "lower-case letters"),
    ],
)
def test_scene_error_names_line_and_choices(text, line, says):
    with pytest.raises(SceneError) as caught:
        parse_scene(text, "my.toml")
    assert str(caught.value).startswith(f"my.toml:{line}: ")
    assert says in str(caught.value)


def test_scene_file_that_is_missing(tmp_path):
    with pytest.raises(SceneError, match="cannot be read"):
        load_scene(tmp_path / "none.toml")


@pytest.mark.parametrize(
    ("text", "value"),
    [("80", Integer(80)), ("3*pi/4", 3 * pi / 4), ("-0.1", Rational(-1, 10)), ("1e-3*(2-1/3)", Rational(1, 600))],
)
def test_constants_are_exact(text, value):
    assert parse_constant(text) == value


@pytest.mark.parametrize("text", ["", "1/0", "2**3", "3pi", "1e999", "(1", "nan", True, 0.5, "9" * 300])
def test_bad_constants(text):
    with pytest.raises(ValueError, match=r"."):
        parse_constant(text)


# Slicing and specialising


def test_slice_leaves_out_what_is_not_reached():
    module = emitted()
    assert "def unreached" not in module.text
    assert "arc_y" in module.left_out
    alone = emit_module(THEORY, scene_of(outputs='["shape"]'), "numpy", kernels=SAMPLE)
    assert "def solve" not in alone.text
    assert alone.formulas == ()
    check_names(alone.text, alone.path, "numpy")


def test_folded_field_goes_everywhere():
    text = emitted("force_only").text
    names = {n.id for n in ast.walk(ast.parse(text)) if isinstance(n, ast.Name)}
    arguments = {n.arg for n in ast.walk(ast.parse(text)) if isinstance(n, ast.arg)}
    assert "eta" not in names | arguments
    assert "def level" not in text
    assert "root_other" not in text
    assert "# at the clamp" in text  # comments of what was not changed stay


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
@pytest.mark.parametrize(
    ("case", "constants", "fixed"),
    [
        ("parallel", 'eta = "1/10"', {"eta": 0.1}),
        ("parallel", 'eta = "0"\nbeta = "2"', {"eta": 0.0, "beta": 2.0}),
        ("parallel", 'length = "80"\nclamp_angle = "3*pi/4"', {"length": 80.0, "clamp_angle": 0.75 * mpmath.pi}),
        ("force_only", "", {"eta": 0.0}),
        ("force_only", 'length = "1/3"\nbeta = "0"', {"eta": 0.0, "beta": 0.0, "length": 1 / 3}),
    ],
)
def test_specialised_agrees_with_full(case, constants, fixed, backend):
    full, special = load(emitted(backend=backend).text), load(emitted(case, backend, constants).text)
    rod = {"beta": 0.7, "eta": 1.3, "length": 2.5, "clamp_angle": 2.1} | {k: float(v) for k, v in fixed.items()}
    (expected,) = full.equilibria(**rod)
    (got,) = special.equilibria(**{k: v for k, v in rod.items() if k not in fixed})
    assert float(got.value) == pytest.approx(float(expected.value), rel=1e-14)
    assert float(special.shape(got, 0.4)) == pytest.approx(float(full.shape(expected, 0.4)), rel=1e-14)


def test_checks_of_arguments_survive_folding():
    with pytest.raises(ValueError, match="must not be negative"):
        load(emitted("force_only").text).equilibria(-1.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("root_other(eta, 1 + xi, 1 - xi)", "cos_bottom(beta, eta)", "cos_bottom, which the load case does not have"),
        ("total = drive", "total = level(*[beta, eta]) + drive", "write them out"),
        ("total = drive", "total = max(map(level, [beta], [eta])) + drive", "passed on as a value"),
    ],
)
def test_kernels_that_cannot_be_folded_are_refused(old, new, says):
    kernels = {name: SAMPLE[name].replace(old, new) for name in ("search", "api")}
    with pytest.raises(EmitError, match=r".") as caught:
        emitted("force_only", kernels=kernels)
    assert says in str(caught.value)
    assert "kernels/" in str(caught.value)


def test_docstrings_describe_what_is_there():
    described = {
        scene: ast.get_docstring(function("equilibria", emitted(scene))) for scene in ("parallel", "force_only")
    }
    assert "eta: the field,\n     in its units.\n" in described["parallel"]
    assert described["force_only"] == "All results.\n\nbeta: the force.\nlength: > 0.\n\nRaises ValueError."
    assert "Load case: force only, eta = 0." in emitted("force_only").text
    shortened = emitted(constants='length = "80"')
    assert "length: " not in ast.get_docstring(function("equilibria", shortened))


def function(name, module):
    return next(n for n in ast.parse(module.text).body if isinstance(n, ast.FunctionDef) and n.name == name)


def test_import_time_work_is_refused():
    with pytest.raises(EmitError, match="no work when imported"):
        emitted(kernels={"search": SAMPLE["search"] + "\nprint(1)\n"})


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_a_constant_record_is_written_where_it_is_used(backend):
    """Constants stand before classes: one that is built by a class would not be found there."""
    search = SAMPLE["search"].replace("def solve", "NONE = Rod(0, 0, 1)\n\n\ndef solve")
    search = search.replace("total = drive * drive", "total = NONE.length - 1 + drive * drive")
    module = emitted(backend=backend, kernels={"search": search})
    assert "Rod(0, 0, 1).length" in module.text
    rod = (0.7, 1.3, 2.5, 2.1)
    (got,), (expected,) = (load(one.text).equilibria(*rod) for one in (module, emitted(backend=backend)))
    assert float(got.value) == pytest.approx(float(expected.value), rel=1e-15)


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
def test_one_name_of_two_modules_keeps_its_alias(backend):
    """log and a complex log beside each other; in mpmath both are the same function."""
    files = {
        "arithmetic": SAMPLE["arithmetic"].replace(
            "from math import cos", "from cmath import log as c_log\nfrom math import cos, log"
        ),
        "arithmetic_mpmath": SAMPLE["arithmetic_mpmath"].replace("import cos,", "import cos, log, log as c_log,"),
        "search": SAMPLE["search"]
        .replace("import cos, pi", "import c_log, cos, log, pi")
        .replace("total = drive", "total = log(2) - abs(c_log(2)) + drive"),
    }
    module = emitted(backend=backend, kernels=files)
    check_names(module.text, module.path, backend)
    assert ("c_log" in module.text) == (backend == "numpy")
    (got,), (expected,) = (load(one.text).equilibria(0.7, 1.3, 2.5, 2.1) for one in (module, emitted(backend=backend)))
    assert float(got.value) == pytest.approx(float(expected.value), rel=1e-14)


# The mpmath twin


def test_precision_is_local_and_real():
    twin = load(emitted(backend="mpmath").text)
    rod = {"beta": "0.7", "eta": "1.3", "length": "2.5", "clamp_angle": "2.1"}
    before = mpmath.mp.dps
    (low,), (high,) = twin.equilibria(**rod, dps=30), twin.equilibria(**rod, dps=60)
    assert mpmath.mp.dps == before
    with mpmath.workdps(60):
        assert 0 < abs(low.value - high.value) < mpmath.mpf("1e-28")
        assert twin.equilibria(**rod)[0].value == high.value


def accurate_rods():
    """Two rods of each of two modules, their inputs exact in binary or given to 100 digits; none is near cancelling."""
    with mpmath.workdps(100):
        angle = mpmath.mp.pi * 3 / 4
    paper = {"length": 80, "clamp_angle": angle}
    other = {"length": 2, "clamp_angle": mpmath.mpf("2.25")}
    return [
        (parallel_mpmath, {**paper, "beta": mpmath.mpf(1) / 4096, "eta": mpmath.mpf(1) / 2048}),
        (parallel_mpmath, {**other, "beta": mpmath.mpf("0.5"), "eta": 3}),
        (force_only_mpmath, {**paper, "beta": mpmath.mpf(1) / 1024}),
        (force_only_mpmath, {**other, "beta": 2}),
    ]


@pytest.mark.parametrize(("module", "rod"), accurate_rods())
def test_fifty_digits_are_fifty_digits(module, rod):
    low, high = module.equilibria(**rod, dps=50), module.equilibria(**rod, dps=80)
    assert len(low) == len(high) >= 1
    with mpmath.workdps(100):
        for one, other in zip(low, high, strict=True):
            for name in ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy"):
                exact = getattr(other, name)
                # What is a sum of terms of either sign is as good as these.
                size = abs(exact) + (abs(other.gamma) * rod["length"] if name == "energy" else 0)
                assert abs(getattr(one, name) - exact) < size * mpmath.mpf("1e-48"), name


@pytest.mark.parametrize("module", [parallel_mpmath, force_only_mpmath])
def test_the_callers_precision_is_left_alone(module):
    rod = {"beta": 1, "eta": 2, "length": 1, "clamp_angle": 1}
    rod = {name: rod[name] for name in rod if name != "eta" or module is parallel_mpmath}
    with mpmath.workdps(23):
        (found, *_) = module.equilibria(**rod, dps=50)
        module.shape(found, 0.5, dps=40)
        module.sweep(**rod, dps=30)
        assert mpmath.mp.dps == 23
        for call in (
            lambda: module.equilibria(**{**rod, "beta": "nan"}, dps=50),
            lambda: module.shape(found, 2, dps=50),
            lambda: module.sweep(**{**rod, "length": [1, -1]}, dps=50),
        ):
            with pytest.raises(ValueError, match=r"must"):
                call()
            assert mpmath.mp.dps == 23


# Printing and reading back


def random_expressions():
    leaves = st.sampled_from([*RANDOM, Integer(2), Integer(-3), Rational(1, 3), Rational(-5, 8), Rational(7, 96)])

    def grow(inner):
        pair = st.tuples(inner, inner)
        return st.one_of(
            pair.map(lambda p: p[0] + p[1]),
            pair.map(lambda p: p[0] * p[1]),
            pair.map(lambda p: p[0] - p[1] / 3),
            inner.map(lambda e: 1 / (e**2 + 1)),
            inner.map(lambda e: sqrt(e**2 + 2)),
            inner.map(lambda e: (e**2 + 1) ** Rational(-3, 2)),
            st.tuples(inner, st.integers(2, 5)).map(lambda p: p[0] ** p[1]),
            pair.map(lambda p: RF(p[0] ** 2 + 1, p[1], 1)),
            pair.map(lambda p: RC(p[0] ** 2 + 1, p[1] ** 2 + 2)),
        )

    return st.recursive(leaves, grow, max_leaves=8)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(random_expressions(), st.booleans())
def test_printed_formulas_read_back(expression, common):
    formula = Formula("f", RANDOM, expression, "test.f", "Random")
    text = ast.unparse(ast.fix_missing_locations(formula_function(formula, common=common)))
    head = "from derive.emit.kernels.arithmetic import sqrt\nfrom derive.emit.kernels.carlson import rf, rc\n"
    (proof,) = prove_formulas(f"{head}\n{text}", [formula], "text.py")
    assert proof.method


def test_numbers_are_printed_exactly():
    a, b = RANDOM[:2]
    formula = Formula("f", (a, b), -(a**2) / 4 + Rational(1, 3) * b / a - Rational(1, 3), "test.f", "Numbers")
    text = ast.unparse(ast.fix_missing_locations(formula_function(formula)))
    assert text.endswith("return b / (3 * a) - 1 / 3 - 0.25 * a * a")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("return eta * minus - 2 * beta", "return eta * minus + 2 * beta"),
        ("return beta + eta * xi_tip", "return beta + eta"),
        ("0.25 * eta", "0.2500001 * eta"),
        ("def tip_gap(beta, eta, minus)", "def tip_gap(beta, minus, eta)"),
        ("def tip_gap(", "def tip_gop("),
        ("return rf(x_plus", "return sqrt(x_plus) + rf(x_plus"),
        ("return rf(x_plus, x_minus, x_other)", "return __import__('os').getpid()"),
        ("return eta * minus - 2 * beta", "return eta * minus - 2 * beta if eta else 0"),
        ("import numpy as np", "import numpy as np\nimport os"),
        ("def tip_gap(", "def tip_gap(beta, eta, minus):\n    return 0\n\n\ndef tip_gap("),
    ],
)
def test_tampered_text_is_refused(old, new):
    module = emitted()
    text = module.text.replace(old, new, 1)
    assert text != module.text
    with pytest.raises(EmitError, match=r"tampered\.py"):
        prove_all(text, module.formulas)


def prove_all(text, formulas):
    prove_formulas(text, formulas, "tampered.py")
    check_names(text, "tampered.py", "numpy")


def test_a_name_means_what_the_imports_make_it():
    formula = Formula("f", RANDOM[:1], sqrt(RANDOM[0]), "test.f", "A root")
    honest = "from math import sqrt\n\n\ndef f(a):\n    return sqrt(a)\n"
    assert prove_formulas(honest, [formula], "text.py")
    for text in (honest.replace("import sqrt", "import exp as sqrt"), honest.replace("math", "cmath")):
        with pytest.raises(EmitError, match="no such function"):
            prove_formulas(text, [formula], "text.py")


def test_equal_but_rewritten_text_is_proved():
    module = emitted()
    text = module.text.replace("return eta * minus - 2 * beta", "double = beta + beta\n    return minus * eta - double")
    assert prove_formulas(text, module.formulas, "rewritten.py")


def test_kernel_formulas_are_emitted():
    text = formulas_text(THEORY)
    general = [formula for formula in FORMULAS if formula.case == "oblique"]
    assert len(prove_formulas(text, general, "formulas.py")) == len(general)
    assert "rj(x_plus, x_minus, x_other, x_other + 0.25 * eta * plus * minus)" in text
    assert RJ(*symbols("x y z p")).has(RJ)


def test_common_subexpressions_on_request():
    text = emitted(common=True).text
    assert prove_formulas(text, emitted(common=True).formulas, "common.py")


# Determinism and layout


def test_same_bytes_for_every_hash_seed():
    script = (
        "from emit_standin import THEORY, SAMPLE\n"
        "from derive.emit.committed import formulas_text\n"
        "from derive.emit.module import emit_module\n"
        "from derive.emit.scene import parse_scene\n"
        "import hashlib\n"
        "text = formulas_text(THEORY)\n"
        "for case in ('parallel', 'force_only'):\n"
        "    for backend in ('numpy', 'mpmath'):\n"
        '        scene = parse_scene(f\'[scene]\\nname="x"\\ncase="{case}"\\noutputs=["equilibria", "shape"]\')\n'
        "        text += emit_module(THEORY, scene, backend, kernels=SAMPLE, common=True).text\n"
        "print(hashlib.sha256(text.encode()).hexdigest())\n"
    )
    here = Path(__file__).resolve().parent
    found = set()
    for seed in ("0", "1", "4242"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": f"{here.parent}{os.pathsep}{here}"}
        run = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
        )
        found.add(run.stdout)
    assert len(found) == 1


def test_digest_follows_the_inputs():
    one, other = emitted(), emitted(kernels={"search": SAMPLE["search"] + "\n# changed\n"})
    assert one.digest != other.digest
    assert one.digest in one.text
    assert emitted().text == one.text
    assert len(one.digest) == len(hashlib.sha256(b"").hexdigest())


def test_long_lines_are_broken():
    text = "return " + " + ".join(f"first_{k} * second_{k}" for k in range(12))
    lines = wrap(text, "    ")
    assert max(map(len, lines)) <= 120
    assert ast.dump(ast.parse("def f():\n" + "\n".join(lines))) == ast.dump(ast.parse(f"def f():\n    {text}"))
    call = "value = function(" + ", ".join(f"argument_{k}" for k in range(30)) + ")"
    assert ast.dump(ast.parse("\n".join(wrap(call, "")))) == ast.dump(ast.parse(call))


@pytest.mark.parametrize(
    "text", ["x, y = (f(a, b) for a, b in zip(u, v))", "x = (a, b)", "return (a, (b, c))", "x = tuple((a for a in b))"]
)
def test_statements_are_printed_as_they_are_meant(text):
    body = ast.parse(f"def f():\n    {text}").body[0].body[0]
    again = ast.parse(f"def f():\n    {expression(body)}").body[0].body[0]
    assert ast.dump(again) == ast.dump(body)


# The house rules


def test_no_text_is_evaluated():
    """Emitted text is imported from a file, numbers are parsed: nothing of the project is run by exec or eval."""
    package = Path(__file__).resolve().parent.parent / "derive"
    for path in package.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            called = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
            assert called not in ("exec", "eval", "compile", "__import__"), f"{path.name}:{node.lineno}"
