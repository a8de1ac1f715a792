"""Stable forms: from a derived expression to a graph that loses no digits to subtraction.

    stable({"alpha": expression}, [Input("tracking_index", "Lambda")])

reads an expression of square roots over positive inputs, and looks for a form of sums, products,
quotients and roots of positive terms: differences of roots multiplied by their conjugate, common
factors drawn out, polynomials written with coefficients of one sign. Of several ways to write it
down the one with the smallest proved bound is taken. `coordinates` says what is positive on a
domain, `signed_factors` looks for products of factors of one sign, `difference_polynomials` and
`graph_nodes` write them down, `candidates` and `ranking` compare, `function_atoms` and
`function_rewriting` put functions in, and `certificate` holds the proof that nothing but the form
changed.
"""

from gainproof.derive.stable_form.root_tower import NoReading
from gainproof.derive.stable_form.search import StableForm, stable

__all__ = ["NoReading", "StableForm", "stable"]
