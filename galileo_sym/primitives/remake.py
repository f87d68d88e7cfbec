"""Make the committed coefficients again: ``python -m galileo_sym.primitives.remake [--check] [NAME ...]``.

The same bytes on every machine: all is done in multiprecision and rounded once. `--check` writes nothing, and exits
with 1 if a file is not what is made now.
"""

import argparse
import sys

from galileo_sym.files import write_whole
from galileo_sym.primitives import approximations, tables

# how each is fitted, written, and where; those of the scaled layer by "scaled/" and their name
MADE = {name: (approximations.fit, name, approximations) for name in approximations.APPROXIMATIONS}
MADE |= {f"scaled/{name}": (tables.fitted, name, tables) for name in tables.TABLES}


def main(arguments=None):
    """Remake, or check, the files of the approximations and tables named, or of all."""
    parser = argparse.ArgumentParser(prog="python -m galileo_sym.primitives.remake", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="an approximation or table; all by default")
    parser.add_argument("--check", action="store_true", help="write nothing, say what differs")
    options = parser.parse_args(arguments)
    unknown = sorted(set(options.names) - set(MADE))
    if unknown:
        parser.error(f"no approximation {', '.join(unknown)}; there are {', '.join(MADE)}")
    differs = 0
    for name in options.names or MADE:
        fit, own, module = MADE[name]
        pieces = fit(own)
        text, path = module.to_text(own, pieces), module.path_of(own)
        same = path.is_file() and path.read_text(encoding="utf-8") == text
        differs += not same
        if not same and not options.check:
            write_whole(path, text.encode())
        print(f"{name}: {'same' if same else 'differs'}; largest error found {max(p.error for p in pieces):.2e}")
    return int(options.check and differs > 0)


if __name__ == "__main__":
    sys.exit(main())
