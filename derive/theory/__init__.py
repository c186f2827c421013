"""The derivation, section by section, from the magnetic energy to the closed forms. SymPy only."""
