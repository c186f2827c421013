"""Polynomials of lower degree that differ from given ones by less than rounding, by Chebyshev polynomials."""

from __future__ import annotations

import numpy as np


def shortened(coefficients, allowed):
    """Polynomials, a column each, of least degree that differ from the given ones by no more than allowed in [−1, 1].

    Chebyshev polynomials are at most 1 there, so those of high degree go as long as their coefficients sum to less.
    The constant terms stay apart: they are large, and would be rounded with every sum.
    """
    of_powers, of_chebyshev = chebyshev(len(coefficients))
    parts = of_powers[1:].T @ coefficients[1:]
    tails = np.cumsum(abs(parts[::-1]), axis=0).max(axis=1)
    kept = max(2, len(parts) - int(np.searchsorted(tails, allowed, side="right")))
    short = of_chebyshev[:kept, :kept].T @ parts[:kept]
    short[0] += coefficients[0]
    return short


def cut(terms, degree):
    """The matrix by which a polynomial's terms become those of one of a degree near it in [−1, 1], and below them the
    coefficients of the Chebyshev polynomials by which the two differ."""
    of_powers, of_chebyshev = chebyshev(terms)
    kept = degree + 1
    return np.concatenate((of_chebyshev[:kept, :kept].T @ of_powers.T[:kept], of_powers.T[kept:]))


def chebyshev(size):
    """Powers by Chebyshev polynomials and these by powers, a row for each (DLMF 18.9.1)."""
    of_powers, of_chebyshev = np.eye(size), np.eye(size)
    for n in range(1, size - 1):
        # xT_k = (T_{k+1} + T_{k−1})/2, and xT_0 = T_1.
        of_powers[n + 1] = 0
        of_powers[n + 1, 1:] = of_powers[n, :-1] / 2
        of_powers[n + 1, 1] += of_powers[n, 0] / 2
        of_powers[n + 1, :-1] += of_powers[n, 1:] / 2
        of_chebyshev[n + 1] = -of_chebyshev[n - 1]
        of_chebyshev[n + 1, 1:] += 2 * of_chebyshev[n, :-1]
    return of_powers, of_chebyshev
