"""Terms in letters: of each input u = x - a, v = b - x and x itself, and roots of generators."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

Exponents = tuple[int, ...]
"""Twice the powers of every u, of every v, of every x, then powers of the generators' roots."""

Terms = Mapping[Exponents, Fraction]
"""Coefficients by exponents."""

BLOCKS = 3  # of letters of inputs: u, v, x
