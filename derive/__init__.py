"""From the magnetic energy of a Kirchhoff rod to proved formulas and verified solvers."""

import os

# SymPy forgets what it worked out after a thousand results, and proofs ask again. Read when SymPy is first imported.
os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")
