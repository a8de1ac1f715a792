"""Files: found, read within limits, written whole."""
