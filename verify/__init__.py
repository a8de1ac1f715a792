"""How we know: certificates re-checked exactly, independent oracles, the judge of claims."""
