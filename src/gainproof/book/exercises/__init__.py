"""Sheets of derivations with one planted error each: refuted, while every other line is proved."""
