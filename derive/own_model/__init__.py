"""A user's own model: what it must be like, and which method derives it."""
