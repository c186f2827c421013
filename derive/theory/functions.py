"""Elliptic functions and integrals as SymPy functions: what they are, and how they differentiate.

They are names with derivatives, nothing more: proving lives in ``check``, computing in the emitted kernels.

- ``wp(u, g2, g3)``, ``wp_prime``, ``wzeta``, ``wsigma``: Weierstrass functions of invariants g₂, g₃ (DLMF 23.2).
- ``wlog_sigma(u, g2, g3)``: ln σ, continued.
- ``half_period(n, g2, g3)`` and ``perimeter_point(c, g2, g3)``: where, on the rectangle of half-periods.
- ``RF(x, y, z)``, ``RC(x, y)``, ``RJ(x, y, z, p)``, ``RD(x, y, z)``: Carlson's symmetric integrals (DLMF 19.16).
"""

from __future__ import annotations

from typing import Any

from sympy import Expr, Function, Rational, S, default_sort_key
from sympy.core.function import ArgumentIndexError


class wp(Function):  # noqa: N801 - the standard name of the function
    """Weierstrass ℘(u; g₂, g₃), DLMF 23.2(ii)."""

    nargs = 3

    @classmethod
    def eval(cls, *args: Any) -> Expr | None:
        """Infinite at 0."""
        return S.ComplexInfinity if args[0] == 0 else None

    def fdiff(self, argindex: int = 1) -> Expr:
        """℘′ for the first argument; derivatives in the invariants are not provided."""
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return wp_prime(*self.args)


class wp_prime(Function):  # noqa: N801 - the standard name of the function
    """The derivative ℘′(u; g₂, g₃)."""

    nargs = 3

    @classmethod
    def eval(cls, *args: Any) -> Expr | None:
        """Infinite at 0."""
        return S.ComplexInfinity if args[0] == 0 else None

    def fdiff(self, argindex: int = 1) -> Expr:
        """℘″ = 6℘² − g₂/2 (DLMF 23.3.12)."""
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return 6 * wp(*self.args) ** 2 - self.args[1] / 2


class wzeta(Function):  # noqa: N801 - the standard name of the function
    """Weierstrass ζ(u; g₂, g₃), with ζ′ = −℘ (DLMF 23.2.8)."""

    nargs = 3

    @classmethod
    def eval(cls, *args: Any) -> Expr | None:
        """Infinite at 0."""
        return S.ComplexInfinity if args[0] == 0 else None

    def fdiff(self, argindex: int = 1) -> Expr:
        """−℘."""
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return -wp(*self.args)


class wsigma(Function):  # noqa: N801 - the standard name of the function
    """Weierstrass σ(u; g₂, g₃), with σ′ = ζσ (DLMF 23.2.8)."""

    nargs = 3

    @classmethod
    def eval(cls, *args: Any) -> Expr | None:
        """0 at 0."""
        return S.Zero if args[0] == 0 else None

    def fdiff(self, argindex: int = 1) -> Expr:
        """ζσ."""
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return wzeta(*self.args) * wsigma(*self.args)


class wlog_sigma(Function):  # noqa: N801 - named like the functions above
    """A logarithm of σ(u; g₂, g₃), continuous along lines parallel to the real axis; its derivative is ζ."""

    nargs = 3

    def fdiff(self, argindex: int = 1) -> Expr:
        """ζ."""
        if argindex != 1:
            raise ArgumentIndexError(self, argindex)
        return wzeta(*self.args)


class half_period(Function):  # noqa: N801 - a constant of the lattice, named like the functions above
    """ωₙ for real e₁ > e₂ > e₃: ω₁ > 0, ω₃/i > 0 and ω₂ = ω₁ + ω₃, so that ℘(ωₙ) = eₙ (DLMF 23.3(i), 23.5(ii))."""

    nargs = 3


class perimeter_point(Function):  # noqa: N801 - named like the functions above
    """The point with ℘ = c, for real c, on the rectangle 0, ω₁, ω₂, ω₃, around which ℘ runs once through the reals."""

    nargs = 3


class RF(Function):
    """Carlson's R_F(x, y, z) = ½∫₀^∞ dt/√((t+x)(t+y)(t+z)), symmetric (DLMF 19.16.1)."""

    nargs = 3

    @classmethod
    def eval(cls, *args: Any) -> Expr | None:
        """Order the arguments: the function is symmetric."""
        ordered = tuple(sorted(args, key=default_sort_key))
        return None if ordered == tuple(args) else cls(*ordered)


class RC(Function):
    """Carlson's R_C(x, y) = ½∫₀^∞ dt/(√(t+x)(t+y)) (DLMF 19.16.6)."""

    nargs = 2

    @classmethod
    def eval(cls, x: Any, y: Any) -> Expr | None:
        """R_C(x, x) = x^{−1/2}."""
        return x ** Rational(-1, 2) if x == y else None


class RD(Function):
    """Carlson's R_D(x, y, z) = R_J(x, y, z, z), symmetric in x, y (DLMF 19.16.5)."""

    nargs = 3

    @classmethod
    def eval(cls, x: Any, y: Any, z: Any) -> Expr | None:
        """Order the first two arguments."""
        first, second = sorted((x, y), key=default_sort_key)
        return None if first == x else cls(first, second, z)


class RJ(Function):
    """Carlson's R_J(x, y, z, p) = (3/2)∫₀^∞ dt/(√((t+x)(t+y)(t+z))(t+p)) (DLMF 19.16.2)."""

    nargs = 4

    @classmethod
    def eval(cls, x: Any, y: Any, z: Any, p: Any) -> Expr | None:
        """Order the first three arguments; R_J(x, y, z, z) = R_D(x, y, z)."""
        ordered = sorted((x, y, z), key=default_sort_key)
        if p in ordered:
            ordered.remove(p)
            return RD(*ordered, p)
        return None if ordered == [x, y, z] else cls(*ordered, p)
