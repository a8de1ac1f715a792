"""One formula in, verdict out: `gainproof ask` and `gainproof.ask`."""
