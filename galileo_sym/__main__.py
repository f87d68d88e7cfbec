"""``python -m galileo_sym``."""

import sys

from galileo_sym.cli import main

if __name__ == "__main__":
    sys.exit(main())
