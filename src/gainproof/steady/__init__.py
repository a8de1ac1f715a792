"""Steady states of models in numbers, with proved errors (`gainproof steady`)."""
