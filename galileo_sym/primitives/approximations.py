"""What is approximated by polynomials on pieces: the function, the offset of its partition, the degree.

The offset is about the distance from 0 of the nearest singularity, and the last piece ends where the terms that the
form beyond it leaves out are below 2^-60.
"""

from dataclasses import dataclass
from importlib import resources

from mpmath import mp, mpf

from galileo_sym.primitives.multiprecision import mp_value
from galileo_sym.primitives.pieces import COUNT, Partition, Piece, fit_piece

TOLERANCE = 2.0**-58
_FOLDER = resources.files("galileo_sym.primitives") / "coefficients"


@dataclass(frozen=True)
class Approximation:
    """A function of x in [begin, end), smooth there.

    ``name`` is the emitted one; ``value`` maps mpf to mpf; ``doc`` says what it is.
    """

    name: str
    value: object
    offset: float
    degree: int
    doc: str
    start: int = 0

    @property
    def partition(self):
        """The pieces."""
        return Partition(self.offset, self.start)


def _of(name, sign=1):
    return lambda x: mp_value(name, sign * x)


def _w0_ratio(q):
    """W0(x)/x at x = (q^2/2 - 1)/e: smooth at the branch point q = 0, and at x = 0."""
    with mp.extradps(30):
        x = (q * q / 2 - 1) / mp.e
        value = mp.exp(-mp.lambertw(x).real)
    return +value


def _rise_factor(p):
    """(1 - exp(-tau))/p: 1 + W0(-exp(-1 - x)) over p = sqrt(2 x)."""
    return -mp.expm1(-p * mp_value("descent_factor", p)) / p if p else mpf(1)


def _fall_factor(p):
    """sigma/p, sigma - log(1 + sigma) = p^2/2: -(1 + W-1(-exp(-1 - x))) over p = sqrt(2 x)."""
    with mp.extradps(30):
        value = (-1 - mp.lambertw(-mp.exp(-1 - p * p / 2), -1).real) / p if p else mpf(1)
    return +value


APPROXIMATIONS = {
    approximation.name: approximation
    for approximation in (
        Approximation("phi1m", _of("phi1", -1), 3.0, 15, "(1 - exp(-z))/z"),
        Approximation("phi2m", _of("phi2", -1), 3.0, 15, "(z - 1 + exp(-z))/z^2"),
        Approximation("descent_factor", _of("descent_factor"), 0.625, 14, "tau/p, tau - 1 + exp(-tau) = p^2/2"),
        Approximation("flight_factor", _of("flight_factor"), 1.0, 14, "T/(2 b), T = (1 + b)(1 - exp(-T))"),
        Approximation("range_factor", _of("range_factor"), 1.0, 15, "(1 - exp(-T))/(2 b), T = (1 + b)(1 - exp(-T))"),
        Approximation("flight_tail", _of("flight_factor"), 1.0, 14, "flight_factor, continued", COUNT),
        Approximation("range_tail", _of("range_factor"), 1.0, 14, "range_factor, continued", COUNT),
        Approximation("best_sine", _of("best_sine"), 1.0, 13, "a/(exp(s) - 1), 1 + (s - 1) exp(s) = a^2"),
        Approximation("best_angle", _of("best_angle"), 1.0, 13, "asin(a/(exp(s) - 1)), 1 + (s - 1) exp(s) = a^2"),
        Approximation("w0_ratio", _w0_ratio, 1.5, 16, "W0(x)/x, x = (q^2/2 - 1)/e"),
        Approximation("rise_factor", _rise_factor, 0.625, 16, "(1 - exp(-tau))/p, tau - 1 + exp(-tau) = p^2/2"),
        Approximation("fall_factor", _fall_factor, 1.0, 12, "sigma/p, sigma - log(1 + sigma) = p^2/2"),
    )
}


def fit(name):
    """Fit every piece of an approximation.

    Raises
    ------
    KeyError
        If there is none of that name.
    ArithmeticError
        If a piece errs by more than `TOLERANCE`: the degree is too low.
    """
    approximation = APPROXIMATIONS[name]
    pieces = [fit_piece(approximation.value, approximation.partition, i, approximation.degree) for i in range(COUNT)]
    worst = max(range(COUNT), key=lambda i: pieces[i].error)
    if pieces[worst].error > TOLERANCE:
        raise ArithmeticError(
            f"{name}: piece {worst} errs by {pieces[worst].error:.2e}, more than {TOLERANCE:.2e}: "
            f"raise the degree {approximation.degree}"
        )
    return tuple(pieces)


def to_text(name, pieces):
    """Return the committed form: one line a piece, in hexadecimal, so that nothing is rounded on the way."""
    approximation = APPROXIMATIONS[name]
    head = [
        f"# {name}: {approximation.doc}",
        f"# made by `python -m galileo_sym.primitives.remake {name}`; offset {approximation.offset!r},"
        f" degree {approximation.degree}",
        "# a line a piece: centre, c0, its rest, c1, its rest, c2, c3, ...",
    ]
    rows = [" ".join(v.hex() for v in (piece.centre, *piece.coefficients)) for piece in pieces]
    return "\n".join([*head, *rows]) + "\n"


def path_of(name):
    """Return where the committed coefficients of an approximation are."""
    return _FOLDER / f"{name}.txt"


def coefficients(name):
    """Return the committed pieces of an approximation; their ``error`` is not kept, and 0.

    Raises
    ------
    FileNotFoundError
        If they were never made: run ``python -m galileo_sym.primitives.remake``.
    """
    lines = path_of(name).read_text(encoding="utf-8").splitlines()
    rows = [[float.fromhex(v) for v in line.split()] for line in lines if not line.startswith("#")]
    return tuple(Piece(row[0], tuple(row[1:]), 0.0) for row in rows)
