"""Estimation from linear models: what holds for every number of measurements and unknowns."""
