"""Solver modules emitted from scenes, such as ``parallel_numpy``. Do not edit them."""
