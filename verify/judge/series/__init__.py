"""Expansions of expressions in powers of a small positive number, with other symbols in the
coefficients.
"""
