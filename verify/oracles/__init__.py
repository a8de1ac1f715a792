"""Independent numerical runs that formulas and kernels are compared with.

Nothing here imports anything of this project outside this folder, calls code under test, or
retypes a formula under test: every oracle starts from matrices (or from samples, or from the
physical description of a noise) and reaches its numbers by a general method. Each module says
why it is independent and what its accuracy rests on.
"""
