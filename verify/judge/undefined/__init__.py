"""Symbols that a source prints and never defines: what its own claims say they are."""
