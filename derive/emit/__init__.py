"""From a scene to a standalone solver module: slicing, printing, reading back."""
