"""Statements with exponentials, angles, symbolic powers and open sums, decided by way of algebraic
ones.

Each such function value becomes a variable of its own. What holds for every value of the new
variables holds for those that the functions take: enough to prove, never enough to refute.
"""
