"""The dated page of a benchmark: targets, times and errors, growth, and what was missing."""

from . import report
from .contestants import References
from .core import ARRAYS, BASE

_HEAD = """\
# Run time against error

Made by `make bench` on {date}; not written by hand. {machine}, vector code: {vectors}; load {load} at the start;
Python {python}, {compiler}, {versions}.

{picture}One run of {rounds} interleaved rounds: every contestant once a round, the order rotated; {points} doubles in
cache, medians. × exp is the time over that of `numpy.exp` on as many doubles in the same round ({exp} ns an element);
shared machines are noisy, so compare these. "Spread" is the widest distance of quartiles in a line, as a share of the
median. Errors are sampled maxima at {sample} other points, so lower bounds, in ulp of the format; "lost" is the share
of points without a number where there is one, or with one where there is none. Inputs are drawn as `galileo-sym verify`
draws them ("typical" unless the case says so); a special function's evenly over its usual arguments.

Contestants: the emitted C through {way}, and the emitted NumPy code, in both formats; the references of
`galileo_sym.verify` (ball arithmetic, mpmath for special functions; {most} elements); `sympy.lambdify` of the printed
formulas, or of what follows from them by a derivative; SciPy's own functions and its bracketing solver; and the printed
formulas compiled with other libraries' Lambert W, for this processor.
"""


def _markdown(headings, *lines):
    return "\n".join(["| " + " | ".join(cells) + " |" for cells in (headings, ["---"] * len(headings), *lines)])


def page(document, drawing):
    """The page of a `Document`, as Markdown; `drawing` is the file of the plot, or None."""
    stamp = dict(document.stamp)
    known = {name: stamp.pop(name) for name in ("date", "machine", "load", "python", "compiler", "vectors")}
    exp = sorted(row.ns.median for row in document.rows if (row.contestant, row.layout) == (BASE, ARRAYS))
    head = _HEAD.format(
        **known,
        picture=f"![Time an element against the largest error]({drawing})\n\n" if drawing else "",
        versions=", ".join(f"{name} {text}" for name, text in stamp.items()),
        **document.size._asdict(),
        exp=report.number(exp[len(exp) // 2]),
        way=document.way,
        most=References.most,
    )
    parts = [head.rstrip(), *(f"## {title}\n\n{_markdown(*lines)}" for title, lines in report.tables(document).items())]
    if document.notes:
        parts.append("## Missing\n\n" + "\n".join(f"- {sentence}" for sentence in document.notes))
    return "\n\n".join(parts) + "\n"
