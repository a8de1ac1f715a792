"""gainproof: steady-state gains of tracking filters, derived, proved, printed and judged.

Three folders lie under this name: `gainproof.derive` (what is true, and why), `gainproof.generated`
(NumPy kernels) and `gainproof.verify` (how we know). Importing `gainproof` imports none of them.
"""

from gainproof.version import VERSION as __version__

__all__ = ["__version__"]
