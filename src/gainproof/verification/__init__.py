"""`gainproof run`: everything derived, compared, checked and judged, and the report on it."""
