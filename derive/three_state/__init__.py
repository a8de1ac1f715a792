"""Steady states of three kinematic states with measured position; methods, no family in them."""
