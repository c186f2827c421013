"""What differs between the twins, as data: where names come from, and how exact numbers are written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class External:
    """A name of the standard library, NumPy or mpmath. ``name`` None is the module itself; ``alias`` its local name."""

    module: str
    name: str | None
    alias: str

    @property
    def qualified(self) -> str | None:
        """The dotted form in which emitted code says it, where that is not the plain name."""
        return f"{MODULE_ALIASES[self.module]}.{self.name}" if self.name and self.module in MODULE_ALIASES else None


# Names of these modules are always written with the module's alias, so that np.sqrt and math.sqrt can share a module.
MODULE_ALIASES = {"numpy": "np"}


@dataclass(frozen=True)
class Backend:
    """One twin. A kernel file ``<file>_<backend>.py`` stands before ``<file>.py``, name by name.

    name: suffix of modules and kernel files. title: for the first line of a module. packages: top-level packages that
    emitted code may import besides the standard library. number: the name of its numbers' type. builtins: builtin names
    that mean something else here. exact: numbers are kept exact, so constants are written inside functions, where the
    caller's precision holds. elementwise: there are arrays; where there are none, what is wanted of an array instance
    is taken from the scalar one.
    """

    name: str
    title: str
    packages: tuple[str, ...]
    number: str
    exact: bool = False
    elementwise: bool = True
    builtins: Mapping[str, External] = field(default_factory=dict)


BACKENDS: dict[str, Backend] = {
    "numpy": Backend("numpy", "NumPy, double precision", ("numpy",), "float"),
    "mpmath": Backend(
        "mpmath",
        "mpmath, any precision",
        ("mpmath",),
        "mpf",
        exact=True,
        elementwise=False,
        builtins={"float": External("mpmath", "mpf", "mpf")},
    ),
}

# Functions of the theory: the kernel file and the name by which formulas call them on scalars; no file: a builtin.
FUNCTIONS: dict[str, tuple[str, str]] = {
    "RF": ("carlson", "rf"),
    "RC": ("carlson_each", "rc"),
    "RJ": ("carlson_each", "rj"),
    "RD": ("carlson_each", "rd"),
    "sqrt": ("arithmetic", "sqrt"),
    "sin": ("arithmetic", "sin"),
    "cos": ("arithmetic", "cos"),
    "atan": ("arithmetic", "atan"),
    "atan2": ("arithmetic", "atan2"),
    "asinh": ("arithmetic", "asinh"),
    "Abs": ("", "abs"),
    "pi": ("arithmetic", "pi"),
}
# The same on arrays. A formula that holds a function without a row here has no array instance.
EACH_FUNCTIONS: dict[str, tuple[str, str]] = {
    "RC": ("carlson_each", "rc"),
    "RJ": ("carlson_each", "rj"),
    "RD": ("carlson_each", "rd"),
    "sqrt": ("array_arithmetic", "each_sqrt"),
    "sin": ("array_arithmetic", "each_sin"),
    "cos": ("array_arithmetic", "each_cos"),
    "atan": ("array_arithmetic", "each_atan"),
    "atan2": ("array_arithmetic", "each_atan2"),
    "asinh": ("array_arithmetic", "each_asinh"),
    "Abs": ("array_arithmetic", "each_abs"),
    "asin": ("inverses", "near_asin"),
    "acosh": ("inverses", "near_acosh"),
    "wp": ("weierstrass", "wp"),
    "wp_prime": ("weierstrass", "wp_prime"),
    "wzeta": ("weierstrass", "wzeta"),
    "wsigma": ("weierstrass", "wsigma"),
    "wlog_sigma": ("weierstrass", "wlog_sigma"),
    "pi": ("arithmetic", "pi"),
}

EACH = "_each"  # suffix of functions and formulas of an array instance, and of their files
# Kernel files on scalars that are wanted on arrays too, and the file of that instance: it is emitted beside them, with
# ``array_arithmetic`` for ``arithmetic`` and a suffix to every function (see ``instances``).
_ON_ARRAYS = (
    "arcs",
    "arrivals",
    "basins",
    "ground",
    "landscape",
    "levels",
    "motion",
    "oblique_rests",
    "pieces",
    "potential",
    "range_kinds",
    "rates",
    "rests",
    "swing",
    "symmetric_landscapes",
    "turning",
)
ARRAY_INSTANCES = {stem: stem + EACH for stem in _ON_ARRAYS}
FORMULAS = ("formulas", f"formulas{EACH}")  # the files of the solver's formulas, on scalars and on arrays
# The kernel files from which kernels import formulas, their family, and whether they are on arrays; all are emitted.
FORMULA_FILES = {FORMULAS[0]: ("solver", False), FORMULAS[1]: ("solver", True), "article_formulas": ("article", True)}
# Names of ``arithmetic`` that are scalars in both.
SHARED = ("epsilon", "inf", "pi")

# Sections of an emitted module, in order, and where the units of a kernel file go.
SECTIONS = {
    "constants": "Constants",
    "special": "Special functions",
    "formulas": "Formulas, as derived",
    "solver": "Solver",
    "interface": "Interface",
}
# Classes of what the outputs return, wherever a kernel defines them.
RESULTS = ("Equilibrium", "Shape", "Sweep", "Fold", "Exchange")
# By what a result is known to the caller. Its other fields are carried for further outputs.
KNOWN_BY = {"Equilibrium": ("tip_angle", "clamp_curvature", "gamma", "y", "z", "energy", "index")}
FILE_SECTIONS = {
    **dict.fromkeys(("arithmetic", "array_arithmetic", "carlson", "carlson_each", "agm"), "special"),
    **dict.fromkeys(("inverses", "weierstrass"), "special"),
    **dict.fromkeys(FORMULA_FILES, "formulas"),
    "api": "interface",
}
