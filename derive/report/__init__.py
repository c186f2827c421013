"""What was found, to read: derived formulas in the article's letters, and the report in LaTeX."""
