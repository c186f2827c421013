"""Hills and wells where V is symmetric: no field, and a field along the force or across it."""

from __future__ import annotations

from derive.emit.kernels.arithmetic import atan2, pi, sqrt
from derive.emit.kernels.rests import Landscape, Rest, along


def no_field(beta):
    """The force alone."""
    return Landscape((along(beta, 0, 1), along(beta, 2, -1), along(beta, 4, 1)), False, True)


def parallel_single(beta, eta):
    """The field along a force that is not weaker: one hill, at 0."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    return Landscape((top, Rest(2, 0, pi, eta - beta, 1, 0), again), False, True)


def parallel_alone(eta):
    """The field without force: hills along and against it, wells across."""
    top, side, again = (Rest(quarters, 0, quarters * (pi / 2), eta, 1, 0) for quarters in (0, 2, 4))
    first, second = (Rest(quarters, 0, quarters * (pi / 2), -eta, -1, 0) for quarters in (1, 3))
    return Landscape((top, first, side, second, again), True, True)


def parallel_double(beta, eta):
    """The field along a weaker force: hills at 0 and, lower, at π."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), eta + beta, 1, 0) for quarters in (0, 4))
    side = Rest(2, 0, pi, eta - beta, 1, 0)
    lean = atan2(beta, sqrt((eta - beta) * (eta + beta)))
    softness = (eta - beta) * (eta + beta) / eta
    cosine = 2 * (beta / eta) * (beta / eta) - 1
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    first = Rest(1, lean, pi / 2 + lean, -softness, cosine, sine)
    second = Rest(3, -lean, 3 * (pi / 2) - lean, -softness, cosine, -sine)
    return Landscape((top, first, side, second, again), False, True)


def orthogonal_single(beta, eta):
    """The field across a force that is not weaker: one hill, at 0."""
    top, again = (Rest(quarters, 0, quarters * (pi / 2), beta - eta, -1, 0) for quarters in (0, 4))
    return Landscape((top, Rest(2, 0, pi, -beta - eta, -1, 0), again), False, True)


def orthogonal_double(beta, eta):
    """The field across a weaker force: two hills of the same height beside 0."""
    lean = atan2(sqrt((eta - beta) * (eta + beta)), beta)
    stiffness = (eta - beta) * (eta + beta) / eta
    cosine = 1 - 2 * (beta / eta) * (beta / eta)
    sine = -2 * (beta / eta) * sqrt((eta - beta) * (eta + beta)) / eta
    low = Rest(0, -lean, -lean, stiffness, cosine, -sine)
    high, again = Rest(0, lean, lean, stiffness, cosine, sine), low._replace(quarters=4, angle=2 * pi - lean)
    top, bottom = Rest(0, 0, 0, beta - eta, -1, 0), Rest(2, 0, pi, -beta - eta, -1, 0)
    return Landscape((low, top, high, bottom, again), True, True)
