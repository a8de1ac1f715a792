"""What packages have beside kernels over arrays of other libraries than NumPy."""
