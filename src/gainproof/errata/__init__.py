"""Errata sheets of a source."""
