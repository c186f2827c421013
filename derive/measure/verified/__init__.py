"""The number of equilibria of a rod, proved by ball arithmetic; shares no code with the solvers."""
