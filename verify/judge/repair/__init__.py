"""The nearest true formula: what a misprint, or a slip, made of it."""
