"""Dimensions: sides, terms, entries, arguments and definitions must agree before anything else is
asked. What decides is `formula`; `claim` says of which formulas of a claim it is asked, `declared`
of what a file declares itself.
"""
