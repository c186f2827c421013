"""What people use today, each set up as its expert would; one file for each, and none is imported unless measured."""
