"""Error against run time: tasks, the ways to do them, how they are timed, kept and compared."""
