"""What a researcher asks for: rods in physical units, fields that reach a target, branches and their diagrams."""
