"""Scenes of any load case: formulas for any field angle specialised to it, array instances, what is not asked for."""

from __future__ import annotations

import ast
import json
import re
from dataclasses import replace
from math import pi

import mpmath
import numpy as np
import pytest
from scenes_standin import INSTANCES, KERNELS, THEORY, angle, field_angle, half, middle
from sympy import Add, Rational, Symbol, cos, nan, sin, sqrt
from sympy import pi as exact_pi

from derive.emit.backends import EACH, EACH_FUNCTIONS, FUNCTIONS
from derive.emit.committed import emit_kernels
from derive.emit.contents import Size, items, size
from derive.emit.errors import EmitError, SceneError
from derive.emit.left_out import explain_scene
from derive.emit.module import emit_module
from derive.emit.proof import prove_module
from derive.emit.scene import CASES, OUTPUTS, load_scene, parse_scene
from derive.emit.substitute import substitute
from derive.measure.imports import import_times
from derive.measure.loading import load
from derive.resources import shipped_scenes
from derive.theory.symbols import beta, eta

ROD = {"beta": 0.7, "eta": 1.3, "length": 2.5, "clamp_angle": 2.1, "field_angle": 0.4}


def scene_of(case, constants="", outputs='["equilibria", "shape"]'):
    """A scene of the stand-in kernels, which have 'literal' for any load case."""
    head = f'[scene]\nname = "sample"\ncase = "{case}"\n'
    wanted = json.loads(outputs)
    plain = json.dumps([output for output in wanted if output != "literal"] or ["equilibria"])
    scene = parse_scene(f"{head}outputs = {plain}\n[constants]\n{constants}")
    return replace(scene, outputs=tuple(wanted) if "literal" in wanted else scene.outputs)


def emitted(case="oblique", backend="numpy", constants="", kernels=None, outputs='["equilibria", "shape"]'):
    scene, sources = scene_of(case, constants, outputs), {**KERNELS, **(kernels or {})}
    return emit_module(THEORY, scene, backend, kernels=sources, instances=INSTANCES)


# Scenes


def test_every_scene_of_the_design_is_there():
    scenes = {path.stem: load_scene(path) for path in shipped_scenes().values()}
    assert set(scenes) == {*CASES, "remote_control", "bifurcation"}
    assert all(scene.name == name for name, scene in scenes.items())
    assert scenes["oblique"].folded == {}
    remote, second = scenes["remote_control"], scenes["bifurcation"]
    assert remote.folded == {"length": 80, "clamp_angle": exact_pi / 2, "field_angle": exact_pi / 2}
    assert remote.outputs == ("equilibria", "sweep")
    assert second.folded == {"length": 80, "clamp_angle": 3 * exact_pi / 4, "field_angle": 0}
    assert second.outputs == ("equilibria", "sweep", "folds")


@pytest.mark.parametrize("output", OUTPUTS[:2] + OUTPUTS[3:])
def test_an_output_is_there_only_if_it_is_asked_for(output):
    text = emitted(outputs=f'["{output}"]').text
    defined = {node.name for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}
    assert defined & set(OUTPUTS) == {output}


def test_an_equilibrium_carries_only_what_the_outputs_read():
    both, alone = emitted().text, emitted(outputs='["equilibria"]').text
    assert "kept: Any" in both
    assert "kept" not in alone
    assert "bottom" not in alone
    assert "Any" not in alone
    assert "opposite" not in alone
    expected, got = (load(text).equilibria(**ROD)[0].tip_angle for text in (both, alone))
    assert got == expected


def test_a_sweep_needs_a_parameter():
    constants = "beta = 1\neta = 1\nlength = 1\nclamp_angle = 1"
    assert scene_of("parallel", constants).parameters == ()
    with pytest.raises(SceneError, match=r"scene:4: every parameter is folded: nothing is left to sweep"):
        scene_of("parallel", constants, '["sweep"]')


# Formulas for any field angle


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
@pytest.mark.parametrize("case", list(CASES))
def test_every_load_case_is_a_special_case(case, backend):
    """The specialised module gives what the full one gives at the folded values, and its formulas are proved."""
    special, full = emitted(case, backend), emitted("oblique", backend)
    assert {proof.formula.removesuffix(EACH) for proof in prove_module(special)} >= {"moment", "strength", "slope"}
    values = {name: float(value) for name, value in special.scene.folded.items()}
    (expected,) = load(full.text).equilibria(**ROD | values)
    (got,) = load(special.text).equilibria(**{name: value for name, value in ROD.items() if name not in values})
    assert float(got.tip_angle) == pytest.approx(float(expected.tip_angle), rel=1e-14)


@pytest.mark.parametrize(
    ("case", "says"),
    [
        ("parallel", "return beta * sin(angle) + 0.5 * eta * sin(2 * angle)"),
        ("orthogonal", "return beta * sin(angle) - 0.5 * eta * sin(2 * angle)"),
        ("field_only", "return 0.5 * eta * sin(2 * angle)"),
        ("force_only", "return beta * sin(angle)"),
        ("oblique", "return beta * sin(angle) + 0.5 * eta * sin(2 * angle - 2 * field_angle)"),
    ],
)
def test_the_field_angle_is_folded_into_formulas(case, says):
    lines = function("moment", emitted(case).text)
    assert says in lines


def function(name, text):
    (node,) = [n for n in ast.parse(text).body if isinstance(n, ast.FunctionDef) and n.name == name]
    return ast.unparse(node)


def test_a_formula_of_its_own_load_case_stands_before_the_general_one():
    assert "cos(angle)" in function("slope", emitted("orthogonal").text)
    assert "cos(angle)" not in function("slope", emitted("parallel").text)


def test_a_formula_without_a_value_is_not_reached():
    assert "def opposite" in emitted("parallel").text
    assert "def opposite" not in emitted("force_only").text
    bare = KERNELS["api"].replace(" if eta > 0 else 0", "")
    with pytest.raises(EmitError, match="opposite, which the load case does not have"):
        emitted("force_only", kernels={"api": bare})


@pytest.mark.parametrize(
    ("expression", "values", "result"),
    [
        (sin(2 * (angle - field_angle)), {field_angle: exact_pi / 2}, -sin(2 * angle)),
        (cos(angle - field_angle), {field_angle: exact_pi / 2}, sin(angle)),
        (cos(2 * (middle - field_angle)), {field_angle: Rational(0)}, cos(2 * middle)),
        (beta * cos(field_angle) + eta * sin(field_angle), {field_angle: Rational(0)}, beta),
        (sqrt(beta**2 + eta**2), {beta: Rational(0)}, eta),
        (-beta / eta, {eta: Rational(0)}, nan),
        (-beta / eta, {beta: Rational(0)}, Rational(0)),
        (eta * beta + angle * eta, {eta: Rational(1, 3)}, beta / 3 + angle / 3),
    ],
)
def test_values_are_substituted_exactly(expression, values, result):
    assert substitute(expression, values) in (result, result.doit())


def test_no_product_is_multiplied_out_and_no_root_is_split():
    """3·(a − b) stays one product of a difference, √(x/2) one root: SymPy's own substitution changes both."""
    product = eta * (angle - middle) * (1 + beta * half)
    assert substitute(product, {eta: Rational(3), beta: Rational(0)}).args == (3, angle - middle)
    assert isinstance(product.subs({eta: 3, beta: 0}), Add)
    other = Symbol("other", real=True)
    root = substitute(sqrt(other * eta + beta), {eta: Rational(1, 2), beta: Rational(0)})
    assert root.is_Pow
    assert root.base == other / 2


MIRRORED = '''
"""Motion, and its mirror image."""
from dataclasses import dataclass

from derive.emit.kernels.arithmetic import cos
from derive.emit.kernels.formulas import moment


@dataclass(frozen=True)
class Case:
    """A case."""

    tilt: float
    angle: float


def motion(beta, eta, field_angle, angle):
    """Both ways."""
    return bend(beta, eta, field_angle, angle) + 3 * bend(beta, eta, -field_angle, -angle)


def bend(beta, eta, alpha, angle):
    """One way."""
    case = Case(alpha, angle)
    return value(beta, eta, case.tilt, case) + (cos(case.tilt) if case.tilt != 0 else 1)


def value(beta, eta, turned, case):
    """The moment."""
    return moment(beta, eta, turned, case.angle)


def motion_each(beta, eta, field_angle, angle):
    """Not asked for."""
'''


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
@pytest.mark.parametrize("case", list(CASES))
def test_a_value_that_every_call_gives_spreads(case, backend):
    """An angle that is passed on as it is and mirrored: gone where it is 0, kept where its sign counts."""
    scene, sources = scene_of(case, outputs='["equilibria"]'), {**KERNELS, "motion": MIRRORED, "motion_each": MIRRORED}
    special = emit_module(THEORY, scene, backend, kernels=sources, instances={})
    full = emit_module(THEORY, scene_of("oblique", outputs='["equilibria"]'), backend, kernels=sources, instances={})
    assert prove_module(special)
    folded = {name: float(value) for name, value in scene.folded.items()}
    (expected,) = load(full.text).equilibria(**ROD | folded)
    (got,) = load(special.text).equilibria(**{name: value for name, value in ROD.items() if name not in folded})
    assert float(got.tip_angle) == pytest.approx(float(expected.tip_angle), rel=1e-14)
    gone = [name not in special.text for name in ("alpha", "tilt", "turned", "cos")]
    assert gone == [case not in ("orthogonal", "oblique")] * 4


SCALED = '''
"""Motion in units in which the force and the field are of order one."""
from typing import NamedTuple

from derive.emit.kernels.arithmetic import cos, frexp, ldexp, pi, sqrt
from derive.emit.kernels.formulas import moment


class Rod(NamedTuple):
    """A rod in those units; side: -1 for its mirror image."""

    beta: float
    eta: float
    length: float
    field_angle: float
    side: int


def motion(beta, eta, field_angle, angle, size):
    """Both ways."""
    scale = frexp(beta + eta + 1)[1] + 3
    field = principal(field_angle)
    rod = Rod(ldexp(beta, scale), ldexp(eta, scale), ldexp(size, -scale), field, 1)
    image = Rod(rod.beta, rod.eta, rod.length, reflected(field), -1)
    return both(rod, angle) - 3 * both(image, -angle)


def principal(field_angle):
    """The field angle where it is small."""
    if field_angle == 0 or field_angle == pi / 2:
        return field_angle
    return field_angle - 2 * pi


def reflected(field_angle):
    """The other side."""
    if field_angle == 0 or field_angle == pi / 2:
        return field_angle
    return -field_angle


def both(rod, angle):
    """One way."""
    beta, eta, length = rod.beta, rod.eta, rod.length
    return turned(beta, eta, rod.field_angle, length, angle) * rod.side


def turned(beta, eta, field_angle, length, angle):
    """The moment and a little of everything."""
    tilt = cos(field_angle) if eta > 0 else 1
    clamp_angle = ldexp(angle, 1)
    return moment(beta, eta, field_angle, clamp_angle) * length + tilt * sqrt(beta + eta + length)


def motion_each(beta, eta, field_angle, angle):
    """Not asked for."""
'''


@pytest.mark.parametrize("constants", ["", 'length = "80"', 'length = "80"\nclamp_angle = "pi/2"', 'eta = "1/10"'])
@pytest.mark.parametrize("case", list(CASES))
def test_a_name_that_is_given_something_else_is_no_folded_constant(case, constants):
    """Kernels may say ``length`` for a length in other units; zeros, and angles that stay, are folded all the same."""
    if case == "force_only" and "eta" in constants:
        return
    api = KERNELS["api"].replace("clamp_angle) / length, (", "clamp_angle, length) / length, (")
    math = KERNELS["arithmetic"].replace("import cos,", "import cos, frexp, ldexp,")
    sources = {**KERNELS, "motion": SCALED, "motion_each": SCALED, "api": api, "arithmetic": math}
    scene = scene_of(case, constants, '["equilibria"]')
    special = emit_module(THEORY, scene, "numpy", kernels=sources, instances={})
    full = emit_module(THEORY, scene_of("oblique", outputs='["equilibria"]'), "numpy", kernels=sources, instances={})
    assert prove_module(special)
    folded = {name: float(value) for name, value in scene.folded.items()}
    (expected,) = load(full.text).equilibria(**ROD | folded)
    (got,) = load(special.text).equilibria(**{name: value for name, value in ROD.items() if name not in folded})
    assert float(got.tip_angle) == pytest.approx(float(expected.tip_angle), rel=1e-13)
    assert ("field_angle" in special.text.split('"""', 2)[2]) == (case == "oblique")
    assert ("def reflected" in special.text) == (case == "oblique")


# A kernel that goes on in other units under the parameters' own names, and one that counts on in them.
REBOUND = SCALED.replace(
    SCALED[SCALED.index("def motion(") : SCALED.index("def principal(")],
    '''def motion(beta, eta, field_angle, angle, length):
    """Both ways."""
    scale = frexp(beta + eta + 1)[1] + 3
    field = principal(field_angle)
    beta, length = ldexp(beta, scale), ldexp(length, -scale)
    rod = Rod(beta, ldexp(eta, scale), length, field, 1)
    image = Rod(rod.beta, rod.eta, rod.length, reflected(field), -1)
    return both(rod, angle) - 3 * both(image, -angle) + longer(length, beta)


def longer(length, beta):
    """The sum of some lengths."""
    total = sum(length for length in (length, 2 * length))
    length *= 3
    length, first = pair(length, beta)
    return total + length - first


def pair(one, other):
    """Both, halved."""
    return one / 2, other / 2


''',
)


@pytest.mark.parametrize("backend", ["numpy", "mpmath"])
@pytest.mark.parametrize("constants", ["", 'length = "80"', 'beta = "1/3"\nlength = "80"', 'eta = "1/10"'])
@pytest.mark.parametrize("case", list(CASES))
def test_a_parameter_that_a_kernel_binds_anew_is_no_folded_constant(case, constants, backend):
    if any(f"{name} =" in constants for name in CASES[case]):
        return
    api = KERNELS["api"].replace("clamp_angle) / length, (", "clamp_angle, length) / length, (")
    files = {"motion": REBOUND, "motion_each": REBOUND.replace("angle):", "angle, length):"), "api": api}
    for name, module in (("arithmetic", "math"), ("arithmetic_mpmath", "mpmath")):
        files[name] = KERNELS[name].replace(f"from {module} import cos,", f"from {module} import cos, frexp, ldexp,")
    wanted, sources = '["equilibria"]', {**KERNELS, **files}
    special = emit_module(THEORY, scene_of(case, constants, wanted), backend, kernels=sources, instances={})
    full = emit_module(THEORY, scene_of("oblique", outputs=wanted), backend, kernels=sources, instances={})
    folded = {name: float(value) for name, value in scene_of(case, constants).folded.items()}
    (expected,) = load(full.text).equilibria(**ROD | folded)
    (got,) = load(special.text).equilibria(**{name: value for name, value in ROD.items() if name not in folded})
    assert float(got.tip_angle) == pytest.approx(float(expected.tip_angle), rel=1e-13)


@pytest.mark.parametrize("change", ["length = 2 * length", "length *= 2", "length, _ = divmod(length, 2)"])
def test_an_output_that_binds_a_folded_parameter_anew_is_named_with_its_line(change):
    api = KERNELS["api"].replace("    bottom = ", f"    {change}\n    bottom = ", 1)
    line = api.splitlines().index(f"    {change}") + 1
    place = re.escape(f"kernels/api.py:{line} (equilibria)")
    with pytest.raises(EmitError, match=rf"{place}.*'length'.*length = 80.*another name"):
        emitted("parallel", constants='length = "80"', kernels={"api": api}, outputs='["equilibria"]')


def test_a_check_of_a_folded_parameter_leaves_with_it():
    api = KERNELS["api"].replace("    bottom = ", "    length = float(length)\n    bottom = ", 1)
    module = emitted("parallel", constants='length = "80"', kernels={"api": api}, outputs='["equilibria"]')
    assert "float(length)" not in module.text
    assert "/ 80.0" in module.text


# Array instances


def test_tables_of_functions_agree():
    """Every function has a scalar form, but those that only the article's own formulas call."""
    alone = {name for name in EACH_FUNCTIONS if name not in FUNCTIONS}
    assert {EACH_FUNCTIONS[name][0] for name in alone} == {"inverses", "weierstrass"}
    assert all(row[0] != "array_arithmetic" for row in FUNCTIONS.values())


def test_an_instance_is_the_same_code_on_arrays():
    module = load(emitted().text)
    found = module.equilibria(**ROD)[0]
    places = np.linspace(-3.0, 3.0, 7)
    together = module.shape(found, places)
    apart = [module.motion(ROD["beta"], ROD["eta"], ROD["field_angle"], place) for place in places.tolist()]
    assert together == pytest.approx(apart, rel=1e-15)
    assert all(type(value) is float for value in apart)


def test_scalars_are_computed_by_math_and_arrays_by_numpy():
    text = emitted().text
    assert "np." not in function("motion", text) + function("moment", text) + function("wave", text)
    assert "np.maximum(" in function("motion_each", text)
    assert "np.sin(" in function("moment_each", text)
    assert "np.where(np.abs(place) < 2.0 ** (-52)" in function("wave_each", text)
    assert "Wave(" in function("motion_each", text)
    assert "def motion" not in emitted(outputs='["literal"]').text
    assert "def motion(" not in emitted(outputs='["shape"]').text


def test_both_instances_of_a_formula_are_proved():
    assert {"moment", "moment_each"} <= {proof.formula for proof in prove_module(emitted())}


def test_the_mpmath_twin_has_no_array_instances():
    module = emitted(backend="mpmath")
    assert EACH not in module.text
    with mpmath.workdps(30):
        found = load(module.text).equilibria(**ROD)[0]
        assert load(module.text).shape(found, mpmath.mpf(2)) != 0


def test_instances_are_kernel_files_to_import():
    texts = emit_kernels(THEORY, KERNELS, INSTANCES)
    assert set(texts) == {"formulas", "formulas_each", "motion_each", "waves_each"}
    assert "from derive.emit.kernels.waves import STEPS" in texts["waves_each"]
    assert "# A comment that stays." in texts["waves_each"]
    assert (
        "from derive.emit.kernels.formulas_each import moment_each, slope_each, strength_each" in texts["motion_each"]
    )
    assert "from derive.emit.kernels.waves import Wave\n" in texts["motion_each"]
    assert "from derive.emit.kernels.waves_each import wave_each" in texts["motion_each"]
    assert "each_sin" in texts["formulas_each"]
    assert "each_" not in texts["formulas"]
    assert emit_kernels(THEORY, KERNELS, INSTANCES) == texts
    changed = {**KERNELS, "motion": KERNELS["motion"].replace("max(swell, 0)", "swell")}
    assert emit_kernels(THEORY, changed, INSTANCES)["motion_each"] != texts["motion_each"]


@pytest.mark.parametrize(
    ("file", "old", "new", "says"),
    [
        (
            "waves",
            "import epsilon, pi, sin, where",
            "import epsilon, floor as where, pi, sin",
            "floor, which has no array",
        ),
        ("waves", "return where(abs(place)", "return where(min(place)", "add each_min to kernels/array_arithmetic.py"),
    ],
)
def test_what_has_no_array_form_is_named(file, old, new, says):
    assert old in KERNELS[file]
    with pytest.raises(EmitError, match=r".") as caught:
        emitted(kernels={file: KERNELS[file].replace(old, new)})
    assert says in str(caught.value)
    assert f"kernels/{file}.py" in str(caught.value)


def test_a_marked_file_that_is_missing_is_named():
    with pytest.raises(EmitError, match=r"kernels/absent\.py is to have an array instance"):
        emit_kernels(THEORY, KERNELS, {"absent": "absent_each"})


def test_angles_are_those_of_the_load_case():
    assert load(emitted("orthogonal").text).equilibria(0.7, 1.3, 2.5, pi / 2)


# What is left out, and why


def explained(case="oblique", backend="numpy", constants="", outputs='["equilibria", "shape"]', kernels=KERNELS):
    scene = scene_of(case, constants, outputs)
    found = explain_scene(THEORY, scene, backend, kernels=kernels, instances=INSTANCES)
    return found, {(one.kind, one.name): one.reason for one in found.absent}


def test_the_full_module_leaves_out_only_what_nothing_reaches():
    every = '["equilibria", "shape", "folds", "literal"]'
    idle = KERNELS["waves"] + '\n\ndef idle(x):\n    """Nobody calls it."""\n    return x\n'
    found, reasons = explained(outputs=every, kernels={**KERNELS, "waves": idle})
    assert items(found.text) == items(found.full_text)
    assert found.folded == {}
    written_out = {("function", "epsilon"): "what it computes stands in the place of its calls"}
    assert reasons == {("function", "idle"): "no output reaches it"} | written_out


def test_every_absence_has_its_reason():
    found, reasons = explained("force_only", constants='length = "2"', outputs='["equilibria"]')
    assert dict(found.folded["eta"]) == {"value": "0", "by": "the load case"}
    assert dict(found.folded["length"]) == {"value": "2", "by": "the scene"}
    assert reasons["parameter", "equilibria(length)"] == "folded: length = 2"
    assert reasons["parameter", "equilibria(eta)"] == "folded: eta = 0"
    assert reasons["parameter", "moment(eta)"] == "folded: eta = 0"
    assert reasons["parameter", "strength(half)"] == "decided by eta = 0"
    assert reasons["function", "opposite"] == "not wanted: output shape"  # only what it carries needs it
    assert reasons["field", "Equilibrium.kept"] == "not wanted: output shape"
    assert reasons["function", "motion_each"] == "not wanted: output shape"
    assert reasons["function", "folds"] == "not wanted: output folds"
    assert reasons["import", "numpy"] == "not wanted: output shape"
    assert found.size.functions < found.full_size.functions
    assert found.size.bytes == len(found.text.encode())


def test_a_branch_is_decided_by_the_constant_that_decides_it():
    _, reasons = explained("parallel", constants='beta = "1"\neta = "0"')
    assert reasons["function", "opposite"] == "decided by eta = 0"
    _, reasons = explained("field_only")
    assert ("function", "opposite") not in reasons or reasons["function", "opposite"] == "decided by beta = 0"


def test_what_is_present_is_not_said_to_be_absent():
    for case in CASES:
        for backend in ("numpy", "mpmath"):
            found, reasons = explained(case, backend)
            assert not set(items(found.text)) & set(reasons)
            gone = {name for kind, name in set(items(found.full_text)) - set(items(found.text)) if kind == "function"}
            assert gone <= {name for kind, name in reasons if kind == "function"}
            assert EACH not in "".join(name for _, name in reasons) or backend == "numpy"


def test_a_sizes_table_counts_what_is_there():
    assert size("import math\n\n\ndef f(ξ):\n    return ξ + 1.0\n") == Size(1, 5, 45)
    assert items("from math import pi\nA = 1\n\n\nclass B:\n    c: int\n\n\ndef d(e, *, f=1):\n    pass\n") == [
        ("import", "math.pi"),
        ("constant", "A"),
        ("class", "B"),
        ("field", "B.c"),
        ("function", "d"),
        ("parameter", "d(e)"),
        ("parameter", "d(f)"),
    ]


def test_import_times_are_of_the_module_alone():
    """A module that sleeps takes its sleep, one that does nothing takes next to nothing beside it."""
    slow = "import time\n\ntime.sleep(0.2)\n"
    times = import_times({"slow": ("numpy", slow), "idle": ("numpy", '"""Nothing."""\n')}, repeats=2)
    assert 200 <= times["slow"].least <= times["slow"].median <= times["slow"].most
    assert times["idle"].least < times["slow"].least
    with pytest.raises(ImportError, match="ZeroDivisionError"):
        import_times({"broken": ("numpy", "1 / 0\n")}, repeats=1)
