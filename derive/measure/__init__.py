"""References that share no formula with the solvers, and error against run time."""
