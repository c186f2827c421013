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

    packages: top-level packages that emitted code may import besides the standard library. builtins: builtin names
    that mean something else here. exact: numbers are kept exact, so constants are written inside functions, where the
    caller's precision holds. skipped: kernel-file suffixes of the other twins.
    """

    name: str
    title: str
    packages: tuple[str, ...]
    number: str
    exact: bool = False
    builtins: Mapping[str, External] = field(default_factory=dict)


BACKENDS: dict[str, Backend] = {
    "numpy": Backend("numpy", "NumPy, double precision", ("numpy",), "float"),
    "mpmath": Backend(
        "mpmath",
        "mpmath, any precision",
        ("mpmath",),
        "mpf",
        exact=True,
        builtins={"float": External("mpmath", "mpf", "mpf")},
    ),
}

# Functions of the theory: the kernel file and the name by which formulas call them. Formulas are evaluated on scalars
# and on arrays alike, so what has an elementwise form is called by it.
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

# The kernel file from which kernels import the formulas of a family; `derive emit` writes it.
FORMULA_FILES = {"solver": "formulas", "article": "article_formulas"}

# Sections of an emitted module, in order, and where the units of a kernel file go.
SECTIONS = {
    "constants": "Constants",
    "special": "Special functions",
    "formulas": "Formulas, as derived",
    "solver": "Solver",
    "interface": "Interface",
}
RESULTS = ("Equilibrium", "Shape", "Sweep")  # classes of what the outputs return, wherever a kernel defines them
FILE_SECTIONS = {
    **dict.fromkeys(("arithmetic", "array_arithmetic", "carlson", "carlson_each", "agm"), "special"),
    **dict.fromkeys(("inverses", "weierstrass"), "special"),
    "formulas": "formulas",
    "api": "interface",
}
