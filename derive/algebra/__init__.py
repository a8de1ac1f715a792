"""Exact algebra in towers of radicals, and the certificates written from it."""
