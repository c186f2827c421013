"""The fields at which equilibria of a rod appear or vanish, over the force: the set of folds, and where it changes.

python examples/fold_set.py [FILE.csv]

The rod is that of the article's second example. Every fold is to the last digits, however few forces are asked for.
FILE.csv: a row for each fold.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from generated.bifurcation_numpy import exchanges, folds

FORCES = (0.0002, 0.0003, 0.000304, 0.00031, 0.0004, 0.0005)
FIELDS = (0.0, 0.001)


def main(file: Path | None = None) -> None:
    """Print the folds at each force, and the forces at which the diagram over the field changes its aspect."""
    rows = [(beta, fold.eta, fold.y, fold.change) for beta in FORCES for fold in folds(beta, eta=FIELDS)]
    for beta in FORCES:
        found = [f"{eta:.9f} ({change:+d})" for at, eta, _, change in rows if at == beta]
        print(f"β = {beta:.6f}: {', '.join(found) or 'none'}")
    for one in exchanges(beta=(FORCES[0], FORCES[-1]), eta=FIELDS):
        print(f"{one.kind} at β = {one.beta:.9f}, η = {one.eta:.9f}")
    if file:
        np.savetxt(file, rows, delimiter=",", header="beta,eta,y,change", comments="")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
