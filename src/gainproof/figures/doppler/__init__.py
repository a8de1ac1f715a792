"""Example 1 of kosuge-doppler as figures: draws of its noise, error ellipses, detection rates."""
