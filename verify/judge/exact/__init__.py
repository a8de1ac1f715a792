"""Exact decisions about algebraic expressions: towers of radicals, cells of one parameter, balls."""
