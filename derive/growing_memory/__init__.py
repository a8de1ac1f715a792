"""Growing-memory least squares: gains symbolic in the sample number."""
