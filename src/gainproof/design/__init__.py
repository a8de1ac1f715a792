"""The named fixed-gain filters side by side, for a lag, a tracking index, a gain or given gains.

`named_filters` is the list of them, `sheet` makes the numbers, `page` the table; `curves` and
`drawing` the plot of variance against lag. NumPy is all that the numbers need.
"""
