"""Derivations, verdicts and sheets in notebooks: what shows itself there, and notebook files."""
