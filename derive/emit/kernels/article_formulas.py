"""The article's own formulas, of the first load case that has them.

Emitted by `derive emit`: do not edit, change the theory. Kernels import these by name; when a scene is emitted, they
are specialised to it, and a formula that its load case has of its own takes their place.

Digest of the inputs: sha256 f3d03593114d5801855e7018179ef09d05457fe05d17ec32eccc828578278994
"""

from __future__ import annotations

from derive.emit.kernels.array_arithmetic import each_sqrt
from derive.emit.kernels.inverses import near_acosh, near_asin
from derive.emit.kernels.weierstrass import wlog_sigma, wp, wzeta


def article_sense():
    """The sense of the field: 1 if it bends the rod, −1 if it straightens it, 0 without a field.

    Equation exsl13; proved as article.parallel.sense.
    """
    return 1


def article_constant(eta, gamma):
    """The constant of f̂: γ.

    Equation exsl8; proved as article.parallel.constant.
    """
    return gamma


def article_levels(beta, eta, constant, xi):
    """f̂(ξ), the square of the curvature.

    Equation exsl13; proved as article.parallel.levels.
    """
    return constant - 2 * beta * xi - eta * xi * xi


def article_root_a(beta, eta, constant):
    """ξ_a, a root of f̂.

    Equation exsl14; proved as article.parallel.root_a.
    """
    return -beta / eta - each_sqrt(beta * beta + eta * constant) / eta


def article_root_b(beta, eta, constant):
    """ξ_b, a root of f̂.

    Equation exsl14; proved as article.parallel.root_b.
    """
    return each_sqrt(beta * beta + eta * constant) / eta - beta / eta


def article_b(beta, eta, constant):
    """b = f′(a)/4 at a = 1.

    Equation exsl18; proved as article.parallel.b.
    """
    return beta + 0.5 * eta - 0.5 * constant


def article_c(beta, eta, constant):
    """c = f″(a)/24 = ℘(v) at a = 1.

    Equation exsl18; proved as article.parallel.c.
    """
    return 0.5 * beta + 5 * eta / 12 - constant / 12


def article_g2(beta, eta, constant):
    """The invariant g₂ of ℘.

    Equation exsl21; proved as article.parallel.g2.
    """
    return beta * beta + 3 * (eta / 6 + constant / 6) ** 2 + eta * constant


def article_g3(beta, eta, constant):
    """The invariant g₃ of ℘.

    Equation exsl21; proved as article.parallel.g3.
    """
    return (beta * beta + eta * constant - (eta / 6 + constant / 6) ** 2) * (-eta / 6 - constant / 6)


def article_xi(b, c, u, g2, g3):
    """cos θ at u = u_o + s.

    Equation exsl22; proved as article.parallel.xi.
    """
    return 1 + b / (wp(u, g2, g3) - c)


def article_logarithm(v, u_o, s, g2, g3):
    """by how much ln σ(u + v)/σ(u − v) grows from the clamp to s, continued along the rod.

    Equation exsl36; proved as article.parallel.logarithm.
    """
    return (
        wlog_sigma(v + u_o + s, g2, g3)
        + wlog_sigma(u_o - v, g2, g3)
        - wlog_sigma(u_o + s - v, g2, g3)
        - wlog_sigma(v + u_o, g2, g3)
    )


def article_y(eta, b, v, s, logarithm, g2, g3):
    """y at s, with ln σ continued along the rod.

    Equation exsl36; proved as article.parallel.y.
    """
    return s * (1 - 2 * wzeta(v, g2, g3) / each_sqrt(eta)) + logarithm / each_sqrt(eta)


def article_z(beta, eta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation exsl41; proved as article.parallel.z.
    """
    return -near_asin((beta + eta * xi) / each_sqrt(beta * beta + eta * constant)) / each_sqrt(eta)


def article_z_above(beta, eta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation exhpf19; proved as article.orthogonal.z_above.
    """
    return -near_acosh(-(beta - eta * xi) / each_sqrt(beta * beta + eta * constant)) / each_sqrt(eta)


def article_z_below(beta, eta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation exhpf19; proved as article.orthogonal.z_below.
    """
    return near_acosh((beta - eta * xi) / each_sqrt(beta * beta + eta * constant)) / each_sqrt(eta)


def article_root_2(beta, constant):
    """ξ_2, a root of f̂.

    Equation slch4; proved as article.force_only.root_2.
    """
    return 0.5 * constant / beta


def article_xi_linear(beta, constant, u, g2, g3):
    """cos θ at u = u_o + s, linear in ℘.

    Equation slch11; proved as article.force_only.xi_linear.
    """
    return constant / (6 * beta) + 2 * wp(u, g2, g3) / beta


def article_y_linear(beta, constant, u_o, s, g2, g3):
    """y at s, by a difference of ζ.

    Equation slch12; proved as article.force_only.y_linear.
    """
    return constant * s / (6 * beta) - 2 * (wzeta(u_o + s, g2, g3) - wzeta(u_o, g2, g3)) / beta


def article_z_linear(beta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation slch14; proved as article.force_only.z_linear.
    """
    return each_sqrt(constant - 2 * beta * xi) / beta
