"""The accuracy table of README.md, made from the certificates: `--write` renews it, otherwise it is checked."""

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
BEGIN, END = "<!-- accuracy: made by tools/accuracy_table.py -->\n", "<!-- end of accuracy -->\n"
FORCES = ("free", "friction", "drag", "friction_drag")


def largest(strata):
    """The largest error measured over all strata."""
    return max(record["measured"] for record in strata.values())


def rows():
    """A row for each certificate (PAPER.FUNCTION.json): function, then the largest error for each set of forces."""
    for path in sorted((ROOT / "generated" / "certificates").glob("*.*.json")):
        certificate = json.loads(path.read_text(encoding="utf-8"))
        sets = certificate["force_sets"]
        if set(sets) <= set(FORCES):
            cells = [f"≥ {largest(sets[f]):.3f}" if f in sets else "" for f in FORCES]
        else:  # a function of one number has one kernel
            cells = [f"≥ {max(map(largest, sets.values())):.3f}", "", "", ""]
        yield [f"`{certificate['function']}`", *cells], certificate


def table():
    """The table as Markdown, with its source in the line below it."""
    made = list(rows())
    points = sum(r["points"] for _, c in made for s in c["force_sets"].values() for r in s.values())
    dates = sorted({c["date"] for _, c in made})
    lines = ["| function | no force | friction | drag | both |", "|---|---|---|---|---|"]
    lines += ["| " + " | ".join(cells) + " |" for cells, _ in made]
    lines += [
        "",
        f"Sampled maxima in ulp over {points} points, both back ends (`generated/certificates/`, {dates[-1]}).",
    ]
    return "\n".join(lines) + "\n"


def main() -> int:
    """Write or check; 1 if the table in README.md is not that of the certificates."""
    text = README.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    renewed = before + BEGIN + table() + END + after
    if "--write" in sys.argv:
        README.write_text(renewed, encoding="utf-8")
        return 0
    if renewed != text:
        print(
            "README.md: the accuracy table is not that of the certificates; run python tools/accuracy_table.py --write"
        )
    return int(renewed != text)


if __name__ == "__main__":
    sys.exit(main())
