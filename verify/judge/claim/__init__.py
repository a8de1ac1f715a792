"""Claim files: their records, and how TOML becomes them, field by field."""
