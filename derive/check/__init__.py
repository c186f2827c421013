"""The one place where theory and print meet: prove, refute, and say which."""
