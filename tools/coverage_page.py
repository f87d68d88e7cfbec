"""docs/coverage.md, made by `galileo-sym derive --coverage`: `--write` renews it, otherwise it is checked."""

import sys
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

from galileo_sym.cli import main as galileo_sym

PAGE = Path(__file__).resolve().parent.parent / "docs" / "coverage.md"
HEAD = """\
# What is derived, and what the print has wrong

Made by `python tools/coverage_page.py --write` from `galileo-sym derive --coverage`. "Given" are laws and definitions
that the inventory calls so; anything else (checked in numbers only, refuted, missing) must be 0. Figures are drawn, not
derived. A verdict is that of the corrected statement; the form as printed is refuted, or was not false but lacks a
condition. [errata.md](errata.md) tells each erratum at length.

"""


def main() -> int:
    """Derive everything, and write or check the page."""
    with redirect_stdout(StringIO()) as printed:
        code = galileo_sym(["derive", "--coverage"])
    if code:
        print("galileo-sym derive: not everything holds; its own output says what")
        return code
    text = HEAD + printed.getvalue()
    if "--write" in sys.argv[1:]:
        PAGE.write_text(text, encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != text:
        print("docs/coverage.md is not what is derived: run `python tools/coverage_page.py --write`")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
