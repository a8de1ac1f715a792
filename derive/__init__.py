"""What is true, and why: models, derivations, certificates, printed kernels. SymPy lives here.

Nothing is computed on import. `gainproof.derive.catalogue` lists every subject; a subject is
built on demand and leaves this package only as plain data: expression graphs, models and
certificates.
"""
