"""`python -m gainproof` is the command line too."""

import sys

from gainproof.start import main

if __name__ == "__main__":
    sys.exit(main())
