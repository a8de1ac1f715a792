"""Figures of the sources drawn anew from the kernels, as tables and as pictures.

The numbers of a figure (`table`) need NumPy alone; a picture (`canvas`) needs Matplotlib, the
extra `figures`.
"""
