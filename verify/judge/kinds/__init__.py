"""The kinds of claims: one file a kind, each saying what has to be decided."""
