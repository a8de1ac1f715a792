"""Formulas and sentences as LaTeX and as text."""
