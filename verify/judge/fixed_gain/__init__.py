"""Filters with any fixed gains: where they are stable, their steady variances and lags, found from
transition, measurement and gains alone.
"""
