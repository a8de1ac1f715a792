"""How we know: certificates checked again, independent oracles, and the judge of published formulas."""
