"""Filters with any gains: stability, variance, lag and the best gains, as derivations."""
