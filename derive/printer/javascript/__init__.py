"""Kernels as JavaScript, of the same graphs: the doubles of NumPy where no library rounds.

Classic scripts that a page opened from a folder can load: they add to one global object.
"""
