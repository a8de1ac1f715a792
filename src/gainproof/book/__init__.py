"""The book: derivations, judged sources, kernels and documentation as a static site."""
