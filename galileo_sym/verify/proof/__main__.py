"""`python -m galileo_sym.verify.proof`."""

import sys

from .command import main

sys.exit(main())
