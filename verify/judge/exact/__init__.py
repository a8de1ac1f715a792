"""Exact decisions about algebraic expressions: towers of radicals, cells, balls."""
