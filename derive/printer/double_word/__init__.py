"""Kernels asked to be accurate: their graphs in double-words, and what these err by, proved."""
