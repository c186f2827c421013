"""Letters of Section 2, in SI units, and the few vector operations that its scripts share.

Vectors are 3 × 1 matrices of components. A letter that varies along the rod is a function of s; the components of a
vector are in a frame that the script names. Vectors that move with the rod are written in the frame (d₁, d₂, d₃).
"""

from __future__ import annotations

from sympy import Expr, Function, ImmutableMatrix, Matrix, Symbol, cos, eye, sin

from derive.theory.symbols import s

# The units of mass, length, time and current, as scale factors.
mass, length, time, current = (Symbol(name, positive=True) for name in ("mass", "length", "time", "current"))

mu0 = Symbol("mu_0", positive=True)  # permeability of vacuum, N/A²
nu = Symbol("nu", positive=True)  # number of particles per unit reference volume, 1/m³
V = Symbol("V_Pi", positive=True)  # volume of a particle, m³
A = Symbol("A", positive=True)  # area of the cross section, m²
field = Symbol("h_a", positive=True)  # modulus of the applied field, A/m
EI = Symbol("EI", positive=True)  # bending stiffness, N m²
GJ = Symbol("GJ", positive=True)  # torsional stiffness, N m²

chi = Symbol("chi", real=True)  # susceptibility along the particle in excess of the transverse one
chi_tilde = Symbol("chi_tilde", real=True)  # transverse susceptibility to the applied field
chi_par = Symbol("chi_par", positive=True)  # susceptibility of the material along a
chi_perp = Symbol("chi_perp", positive=True)  # and across a
N_par = Symbol("N_par", positive=True)  # demagnetizing factor along a
N_perp = Symbol("N_perp", positive=True)  # and across a

eps = Symbol("epsilon", real=True)  # bookkeeping parameter: thickness over length, kthr7
X1, X2 = Symbol("X_1", real=True), Symbol("X_2", real=True)  # section coordinates over epsilon
w = Symbol("w", real=True)  # alignment d₃·e of the rod with the field
eta_tilde = Symbol("eta_tilde", real=True)  # magnetic couple modulus, N
tau_tilde = Symbol("tau_tilde", real=True)  # the same of permanently magnetized particles: the couple is τ̃ d₃ × e
tau = Symbol("tau", real=True)  # τ̃/(EI)

SI = {
    mu0: mass * length / (time * current) ** 2,
    nu: 1 / length**3,
    V: length**3,
    A: length**2,
    field: current / length,
}  # units of the letters that an energy per unit length may hold

e1, e2, e3 = (ImmutableMatrix(eye(3)[:, i]) for i in range(3))  # a frame, in its own components


def vector(name: str) -> ImmutableMatrix:
    """Three real symbols name_1, name_2, name_3, as a column."""
    return ImmutableMatrix([Symbol(f"{name}_{i}", real=True) for i in (1, 2, 3)])


def vector_of(name: str, *arguments: Symbol) -> ImmutableMatrix:
    """Three real functions of the arguments (of s if none is given), as a column."""
    return ImmutableMatrix([Function(f"{name}_{i}", real=True)(*(arguments or (s,))) for i in (1, 2, 3)])


def angle(name: str) -> Symbol:
    """An angle, real."""
    return Symbol(name, real=True)


def unit(polar: Expr, azimuth: Expr) -> Matrix:
    """The unit vector of polar angle (from the third axis) and azimuth."""
    return Matrix([sin(polar) * cos(azimuth), sin(polar) * sin(azimuth), cos(polar)])


def rotation(axis: Matrix, turn: Expr) -> Matrix:
    """The rotation by an angle about a unit axis (Rodrigues), 3 × 3."""
    skew = Matrix.hstack(*(axis.cross(e) for e in (e1, e2, e3)))
    return eye(3) + sin(turn) * skew + (1 - cos(turn)) * skew * skew


def gradient(expr: Expr, variables: Matrix) -> Matrix:
    """Partial derivatives with respect to the components, as a column."""
    return Matrix([expr.diff(x) for x in variables])


def first_order(expr: Matrix | Expr) -> Matrix | Expr:
    """The part of order 0 and 1 in epsilon."""
    return expr.subs(eps, 0) + eps * expr.diff(eps).subs(eps, 0)
