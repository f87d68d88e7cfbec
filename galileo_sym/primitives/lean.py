"""The primitives in plain double arithmetic, for results in binary32: what keeps the rest of each rounding is left out.

Lines come from those that compute with pairs; approximations are those of fewer terms that a bank's own are fitted by.
"""

from functools import cache

from mpmath import mp, mpf

from galileo_sym.primitives.approximations import APPROXIMATIONS, coefficients
from galileo_sym.primitives.lines import Line, left_of, used
from galileo_sym.primitives.pieces import COUNT, solve

TOLERANCE = 2.0**-35  # 2^-12 of a unit in the last place of binary32
_DIGITS = 60
_CHECKS = 12
DEGREES = {
    **dict.fromkeys(("phi1m", "phi1m_tail", "phi2m", "phi2m_tail", "range_factor", "range_tail"), 8),
    **dict.fromkeys(("max_range_factor", "omega", "w0_ratio", "wm1_branch"), 8),
    **dict.fromkeys(("descent_factor", "arctangent", "best_sine", "best_angle"), 7),
    **dict.fromkeys(("grown_loss", "grown_loss_tail", "grown_balance", "grown_balance_tail"), 7),
    "flight_factor": 10,
    "rise_factor": 9,
    **dict.fromkeys(("wm1_middle", "arctangent_tail", "fall_log"), 8),
    "fall_factor": 6,
    "sine": 6,
    "log": 5,
}


@cache
def _interpolation(degree):
    """Chebyshev nodes in [-1, 1], and the matrix that makes coefficients of the values there."""
    nodes = [mp.cos(mp.pi * (2 * j + 1) / (2 * (degree + 1))) for j in range(degree + 1)]
    return nodes, mp.matrix([[node**k for k in range(degree + 1)] for node in nodes]) ** -1


def _about_the_middle(piece, half, degree):
    """Coefficients on a piece of which the centre is the middle."""
    nodes, inverse = _interpolation(degree)
    scaled = inverse * mp.matrix([piece.value(piece.centre + half * node) for node in nodes])
    return [scaled[k] / half**k for k in range(degree + 1)]


def _from_an_end(piece, lower, upper, degree):
    """Coefficients on a piece that begins at 0, where the value is kept, or is about as long as far from 0."""
    known = {} if piece.centre else {0: piece.value(mpf(0))}
    free = [k for k in range(degree + 1) if k not in known]
    found = known | solve(piece.value, lower, upper, mpf(piece.centre), known, free)
    return [found[k] for k in range(degree + 1)]


def _fit(piece, lower, upper, degree):
    """Coefficients of fewer terms on a piece, and the largest relative difference found."""
    centre, half = mpf(piece.centre), (mpf(upper) - lower) / 2
    exact = (
        _about_the_middle(piece, half, degree) if lower + half == centre else _from_an_end(piece, lower, upper, degree)
    )
    rounded = [float(c) for c in exact]
    points = [lower + (mpf(upper) - lower) * (2 * j + 1) / (2 * _CHECKS) for j in range(_CHECKS)]
    worst = max(abs(mp.polyval(rounded[::-1], x - centre) / piece.value(x) - 1) for x in points)
    return rounded, worst


@cache
def columns(bank):
    """Return {column: values by piece} of an approximation of fewer terms.

    Raises
    ------
    ArithmeticError
        If a piece errs by more than `TOLERANCE` from the full approximation: the degree is too low.
    """
    partition, degree = APPROXIMATIONS[bank].partition, DEGREES[bank]
    rows = []
    with mp.workdps(_DIGITS):
        for index, piece in enumerate(coefficients(bank)):
            row, worst = _fit(piece, *partition.bounds(index), degree)
            if worst > TOLERANCE:
                raise ArithmeticError(f"{bank}: piece {index} errs by 2^{mp.log(worst, 2)}: raise the degree {degree}")
            rows.append(row)
    assert len(rows) == COUNT
    return {f"lean{k}": tuple(row[k] for row in rows) for k in range(degree + 1)}


def near_lines(bank):
    """Return the lines that evaluate an approximation of fewer terms at x, by Horner's rule."""
    partition, degree = APPROXIMATIONS[bank].partition, DEGREES[bank]
    lines = [
        Line("u", "add", ("x", partition.offset)),
        Line("i", "piece", ("u", partition.first, partition.drop)),
        Line("d", "sub", ("x", ("pick", "centre"))),
        Line(f"q{degree}", "pick", (("pick", f"lean{degree}"),)),
    ]
    for k in range(degree - 1, -1, -1):
        lines.append(Line(f"q{k}" if k else "r", "fma", (f"q{k + 1}", "d", ("pick", f"lean{k}"))))
    return lines


def _is_rest(line, made):
    """Whether a line is what a rounding leaves: of a sum, a product, a quotient, a root, or of a number in a table."""
    picked = line.operands[0] if line.operation == "copy" else None
    if line.operation in ("rest", "sum_rest") or (isinstance(picked, tuple) and picked[1].endswith("_lo")):
        return True
    if line.operation != "product_rest":
        return False
    a, b, c = line.operands
    product, quotient = made.get(c), made.get(a)
    return (product is not None and product.operation == "mul" and product.operands == (a, b)) or (
        quotient is not None and quotient.operation in ("div", "sqrt")
    )


def plain(served):
    """Return the lines that compute ``r`` alone on a range, in plain arithmetic."""
    return served.fewer or _without_rests(served.lines)


def _without_rests(lines):
    """What is left of lines for x + x_lo without rests."""
    zero, instead, found, made = {"x_lo"}, {}, [], {}
    for given in lines:
        if given.name == "lo":
            continue
        line = Line(given.name, given.operation, tuple(instead.get(o, o) for o in given.operands))
        made[line.name] = line
        if line.operation in ("near", "near_pair"):
            bank, x, *_ = line.operands
            zero.add(f"{line.name}_lo")
            found.append(Line(line.name, f"{bank}_lean", (x,)))
            continue
        left = None if _is_rest(line, made) or all(o in zero for o in line.operands) else left_of(line, zero)
        if isinstance(left, Line):
            found.append(left)
        elif line.name == "r":
            found.append(Line("r", "copy", (left,)))
        elif left is None:
            zero.add(line.name)
        else:
            instead[line.name] = left
    return used(found)


def banks(lines):
    """Return the names of the approximations that plain lines call."""
    return tuple(line.operation.removesuffix("_lean") for line in lines if line.operation.endswith("_lean"))
