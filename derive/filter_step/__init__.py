"""One step of fixed-gain filters: prediction over an interval, then a position observed."""
