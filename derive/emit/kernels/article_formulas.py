"""The article's own formulas for the load case 'parallel', and those that only another case has.

Emitted by `derive emit`: do not edit, change the theory. Kernels import these by name; when a scene is emitted, the
formulas of its own load case take their place.

Digest of the inputs: sha256 a7f13071a7203e70c8a385e63d429c5cc494321f9d61a1b92add0c9b0cf7e333
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

    Equation exsl13; proved as quartic.parallel.gamma.
    """
    return constant - 2 * beta * xi - eta * xi * xi


def article_root_a(beta, eta, constant):
    """ξ_a, a root of f̂.

    Equation exsl14; proved as quartic.parallel.root_a.
    """
    return -beta / eta - each_sqrt(beta * beta + eta * constant) / eta


def article_root_b(beta, eta, constant):
    """ξ_b, a root of f̂.

    Equation exsl14; proved as quartic.parallel.root_b.
    """
    return each_sqrt(beta * beta + eta * constant) / eta - beta / eta


def article_b(beta, eta, constant):
    """b = f′(a)/4 at a = 1.

    Equation exsl18; proved as weierstrass.parallel.constants.
    """
    return beta + 0.5 * eta - 0.5 * constant


def article_c(beta, eta, constant):
    """c = f″(a)/24 at a = 1, the value of ℘ at v.

    Equation exsl18; proved as weierstrass.parallel.constants.
    """
    return 0.5 * beta + 5 * eta / 12 - constant / 12


def article_g2(beta, eta, constant):
    """g₂ by the coefficients of f.

    Equation exsl21; proved as article.parallel.invariants.
    """
    return beta * beta + 3 * (eta / 6 + constant / 6) ** 2 + eta * constant


def article_g3(beta, eta, constant):
    """g₃ by the coefficients of f.

    Equation exsl21; proved as article.parallel.invariants.
    """
    return (beta * beta + eta * constant - (eta / 6 + constant / 6) ** 2) * (-eta / 6 - constant / 6)


def article_xi(b, c, u, g2, g3):
    """cos θ at u = u_o + s.

    Equation exsl22; proved as weierstrass.parallel.solution.
    """
    return 1 + b / (wp(u, g2, g3) - c)


def article_y(eta, b, v, u_o, s, g2, g3):
    """y at s, with ln σ continued along the rod.

    Equation exsl36; proved as article.parallel.y.
    """
    return (
        (
            wlog_sigma(v + u_o + s, g2, g3)
            + wlog_sigma(u_o - v, g2, g3)
            - wlog_sigma(u_o + s - v, g2, g3)
            - wlog_sigma(v + u_o, g2, g3)
        )
        / each_sqrt(eta)
        + s * (1 - 2 * wzeta(v, g2, g3) / each_sqrt(eta))
    )


def article_z(beta, eta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation exsl41; proved as shape.parallel.z.
    """
    return -near_asin((beta + eta * xi) / each_sqrt(beta * beta + eta * constant)) / each_sqrt(eta)


def article_z_above(beta, eta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation exhpf19; proved as shape.orthogonal.z_above.
    """
    return -near_acosh(-(beta - eta * xi) / each_sqrt(beta * beta + eta * constant)) / each_sqrt(eta)


def article_z_below(beta, eta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation exhpf19; proved as shape.orthogonal.z_below.
    """
    return near_acosh((beta - eta * xi) / each_sqrt(beta * beta + eta * constant)) / each_sqrt(eta)


def article_root_2(beta, constant):
    """ξ_2, a root of f̂.

    Equation slch4; proved as quartic.force_only.root_2.
    """
    return 0.5 * constant / beta


def article_xi_linear(beta, constant, u, g2, g3):
    """cos θ at u = u_o + s, linear in ℘.

    Equation slch11; proved as weierstrass.force_only.linear.
    """
    return constant / (6 * beta) + 2 * wp(u, g2, g3) / beta


def article_y_linear(beta, constant, u_o, s, g2, g3):
    """y at s, by a difference of ζ.

    Equation slch12; proved as shape.force_only.y.
    """
    return constant * s / (6 * beta) - 2 * (wzeta(u_o + s, g2, g3) - wzeta(u_o, g2, g3)) / beta


def article_z_linear(beta, constant, xi):
    """z as a function of ξ, up to a constant, where θ grows.

    Equation slch14; proved as shape.force_only.z.
    """
    return each_sqrt(constant - 2 * beta * xi) / beta
