"""Mutation campaign: formulas broken on purpose, an evaluator that shares nothing with the judge, a
score.
"""
