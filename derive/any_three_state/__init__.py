"""The steady state of any three states with the first of them measured, by one factorisation."""
