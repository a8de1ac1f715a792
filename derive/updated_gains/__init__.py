"""Gains that follow the tracking index to first order, and what becomes of filters that do so."""
