"""Tests of the kernels beside this folder: pytest, NumPy and mpmath, nothing else."""
