"""Kernels as C99, of the same graphs: the bits of the NumPy modules where no library rounds."""
