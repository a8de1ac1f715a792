"""Matrix statements for every size: formulas in noncommuting letters, and proofs found for them."""
