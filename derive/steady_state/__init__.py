"""Steady states by spectral factorisation; methods, no filter family in them."""
