"""The letters of the derivation, each declared once with its meaning and its assumptions.

All lengths, forces and fields are dimensionless from Section 3 on (unit of length √(I/A), of force EA, of
current √(EA/μ₀)); before that they carry the units named here.
"""

from __future__ import annotations

from sympy import Symbol

# Section 3: the plane problem.
beta = Symbol("beta", nonnegative=True)  # terminal force over bending stiffness, F·e_y/(EI)
eta = Symbol("eta", nonnegative=True)  # magnetic couple modulus over bending stiffness, η̃/(EI)
gamma = Symbol("gamma", real=True)  # constant of the first integral (exsl8)
gamma_bar = Symbol("gamma_bar", real=True)  # η − γ, used when the field is orthogonal to the force
alpha = Symbol("alpha", real=True)  # angle of the field from the y axis
s = Symbol("s", real=True)  # arc length from the clamp
ell = Symbol("ell", positive=True)  # length of the rod
xi = Symbol("xi", real=True)  # cos θ = y′
theta = Symbol("theta", real=True)  # angle from the y axis to the tangent d₃
sigma = Symbol("sigma", real=True)  # arc length from the tip, ℓ − s
u = Symbol("u")  # argument of the elliptic functions
v = Symbol("v")  # the point where ℘(v) = c, that is where ξ is infinite
