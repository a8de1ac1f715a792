"""Verdicts in words, and the snapshots they are compared with."""
