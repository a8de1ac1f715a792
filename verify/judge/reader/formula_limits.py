"""Limits on a formula, all checked before or while its tokens are made, so that no formula can hang
the judge.
"""

MOST_CHARACTERS = 4000
MOST_DEPTH = 40
"""Brackets, braces and arguments inside one another."""
MOST_EXPONENT = 64
"""Size of the numerator and of the denominator of an exponent."""
MOST_DIGITS = 200
"""Digits of one number."""
MOST_SLASHES = 8
"""Slashes in one product, which nest."""
MOST_AMBIGUOUS_SLASHES = 6
"""Slashes before juxtaposed factors in one formula: the readings are their combinations."""
MOST_READINGS = 64
MOST_NAME_CHARACTERS = 80
"""Length of one symbol with its accents, primes and subscripts."""
MOST_PRINTED_CHARACTERS = 100_000
"""A graph shares nodes and can stand for a text exponentially longer than itself."""
MOST_ENTRIES = 600
"""Separators of entries in all matrices of one formula."""
MOST_ORDER = 8
"""Order of a derivative."""
