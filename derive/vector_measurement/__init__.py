"""Steady states with position and velocity measured: spectral factorisation and what follows."""
