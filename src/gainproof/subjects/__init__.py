"""Subjects of the catalogue and of own files: derived, printed, checked."""
