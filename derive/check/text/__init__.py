"""The claims of the running text, judged: one judge for each form; ``judge`` has the table of them."""
