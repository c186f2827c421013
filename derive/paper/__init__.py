"""What the article prints: formulas as data, the conventions of its symbols, the LaTeX reader."""
