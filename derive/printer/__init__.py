"""From an expression graph to a NumPy module with a proved error bound; needs no SymPy."""
