"""The report as one HTML file: what was found, what was derived, and the modules, with links between them."""
