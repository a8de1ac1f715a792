"""Pages of text: derivations, listings, the report of a run."""
