"""Kernels of a user's own expressions: inputs with domains and units, outputs by SymPy."""
