"""Bring your own energy: from the magnetostatic energy of any particles to a proved solver, or to why there is none."""

from derive.own_energy.chain import OwnSolver, solver

__all__ = ["OwnSolver", "solver"]
