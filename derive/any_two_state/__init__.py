"""The steady state of any two states with the first of them measured, by one factorisation."""
