"""From the magnetic energy of a Kirchhoff rod to proved formulas and verified solvers."""
