"""Claim files: begun, drafted from LaTeX, read and judged."""
