"""Ordinary, tested Python from which the emitter takes the functions that a scene reaches."""
