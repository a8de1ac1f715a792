"""Packages of kernels that import nothing of gainproof: files, folder, tests."""
