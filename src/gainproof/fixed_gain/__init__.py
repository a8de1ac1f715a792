"""Filters with any fixed gains: stability, variances, lags and poles, and steps of many tracks.

Gains are alpha, beta and, of three states, gamma, as in x + alpha r, v + beta r/T,
a + gamma r/T^2 with r what is observed less what is predicted. All numbers are dimensionless:
variances over that of the measurement, lags over a T^2 (or j T^3). They come from the printed
kernels `alpha_beta` and `alpha_beta_gamma`; NumPy is all that is imported.
"""
