"""What is approximated by polynomials on pieces: the function, the offset of its partition, the degree.

The offset is about the distance from 0 of the nearest singularity, and the last piece ends where the terms that the
form beyond it leaves out are below 2^-60. Where the offset is 0 the pieces are those of x itself, from some x > 0 on.
"""

from dataclasses import dataclass
from importlib import resources

from mpmath import mp, mpf

from galileo_sym.multiprecision import mp_value
from galileo_sym.primitives import coefficient_text
from galileo_sym.primitives.pieces import COUNT, Partition, fit_piece

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
    fraction_bits: int = 2

    @property
    def partition(self):
        """The pieces."""
        return Partition(self.offset, self.start, self.fraction_bits)


def _of(name, sign=1):
    return lambda x: mp_value(name, sign * x)


def _w0_ratio(q):
    """W0(x)/x at x = q^2 - 1/e: smooth at the branch point q = 0, and at x = 0."""
    with mp.extradps(30):
        value = mp.exp(-mp.lambertw(q * q - 1 / mp.e).real)
    return +value


def _wm1_branch(q):
    """-W-1(x) at x = q^2 - 1/e: smooth at the branch point q = 0."""
    with mp.extradps(30):
        value = -mp.lambertw(q * q - 1 / mp.e, -1).real if q else mpf(1)
    return +value


def _wm1_middle(m):
    """-W-1(-m): between the branch point and 0 it needs neither root nor logarithm."""
    return -mp.lambertw(-m, -1).real


def _rise_factor(p):
    """(1 - exp(-tau))/p: 1 + W0(-exp(-1 - x)) over p = sqrt(2 x)."""
    return -mp.expm1(-p * mp_value("descent_factor", p)) / p if p else mpf(1)


def _fall_factor(p):
    """sigma/p, sigma - log(1 + sigma) = p^2/2: -(1 + W-1(-exp(-1 - x))) over p = sqrt(2 x)."""
    with mp.extradps(30):
        value = (-1 - mp.lambertw(-mp.exp(-1 - p * p / 2), -1).real) / p if p else mpf(1)
    return +value


def _fall_log(y):
    """log(1 + sigma), sigma - log(1 + sigma) = exp(y): so close to y for large y that sigma is exp(y) + this."""
    with mp.extradps(30):
        p = mp.sqrt(2 * mp.exp(y))
        value = mp.log1p(p * _fall_factor(p))
    return +value


def _max_range_factor(a):
    """sqrt(1 - (1 + s) exp(-s))/a, 1 + (s - 1) exp(s) = a^2, where the best sine is a/(exp(s) - 1)."""
    if not a:
        return mpf(1)
    with mp.extradps(30):
        y = a / mp_value("best_sine", a)
        value = mp.sqrt((y - mp.log1p(y)) / (1 + y)) / a
    return +value


def _grown_balance(b):
    """The range balance without its decay: for large b nearly b/e."""
    return mp.exp(b) * mp_value("range_balance", b)


def _grown_loss(b):
    """The range loss without its decay: 1/2 at infinity."""
    return (1 + b) ** 2 * mp_value("range_loss", b)


def _first(value, fraction_bits):
    """Return the number of the piece that begins at a value, where the offset is 0."""
    return Partition(0.0, 0, fraction_bits).number(value)


APPROXIMATIONS = {
    approximation.name: approximation
    for approximation in (
        Approximation("phi1m", _of("phi1", -1), 1.75, 15, "(1 - exp(-z))/z"),
        Approximation("phi1m_tail", _of("phi1", -1), 1.75, 14, "phi1m, continued", COUNT),
        Approximation("phi2m", _of("phi2", -1), 1.75, 15, "(z - 1 + exp(-z))/z^2"),
        Approximation("phi2m_tail", _of("phi2", -1), 1.75, 14, "phi2m, continued", COUNT),
        Approximation("descent_factor", _of("descent_factor"), 0.625, 14, "tau/p, tau - 1 + exp(-tau) = p^2/2"),
        Approximation("flight_factor", _of("flight_factor"), 0.75, 16, "T/(2 b), T = (1 + b)(1 - exp(-T))", 0, 1),
        Approximation("range_factor", _of("range_factor"), 0.5, 14, "(1 - exp(-T))/(2 b), T = (1 + b)(1 - exp(-T))"),
        Approximation("range_tail", _of("range_factor"), 0.5, 14, "range_factor, continued", COUNT),
        Approximation("best_sine", _of("best_sine"), 1.0, 13, "a/(exp(s) - 1), 1 + (s - 1) exp(s) = a^2"),
        Approximation("best_angle", _of("best_angle"), 1.0, 13, "asin(a/(exp(s) - 1)), 1 + (s - 1) exp(s) = a^2"),
        Approximation("max_range_factor", _max_range_factor, 0.5, 14, "sqrt(1 - (1 + s) exp(-s))/a, s as in best_sine"),
        Approximation("w0_ratio", _w0_ratio, 0.3125, 15, "W0(x)/x, x = q^2 - 1/e"),
        Approximation("wm1_branch", _wm1_branch, 1.0, 14, "-W-1(x), x = q^2 - 1/e", fraction_bits=5),
        Approximation("wm1_middle", _wm1_middle, 0.0, 14, "-W-1(-m)", _first(2.0**-7, 2)),
        Approximation("rise_factor", _rise_factor, 0.625, 16, "(1 - exp(-tau))/p, tau - 1 + exp(-tau) = p^2/2"),
        Approximation("sine", mp.sin, 0.125, 10, "sin(x)"),
        Approximation("arctangent", mp.atan, 0.25, 13, "arctan(x)"),
        Approximation("arctangent_tail", mp.atan, 0.25, 13, "arctan(x), continued", COUNT),
        Approximation("fall_factor", _fall_factor, 1.0, 12, "sigma/p, sigma - log(1 + sigma) = p^2/2"),
        Approximation("fall_tail", _fall_factor, 1.0, 13, "fall_factor, continued", COUNT - 1),
        Approximation("fall_log", _fall_log, 0.0, 13, "log(1 + sigma), sigma - log(1 + sigma) = e^y", _first(4.0, 2)),
        Approximation("log", mp.log, 0.0, 9, "log(m)", _first(2.0, 4), 4),
        Approximation("grown_loss", _grown_loss, 0.5, 16, "(1 + b)^2 times the slope of -range_factor"),
        Approximation("grown_loss_tail", _grown_loss, 0.5, 15, "grown_loss, continued", COUNT),
        Approximation("grown_balance", _grown_balance, 0.5, 17, "b exp(b - T)/(T - b) with T = (1 + b)(1 - exp(-T))"),
        Approximation("grown_balance_tail", _grown_balance, 0.5, 13, "grown_balance, continued", COUNT),
        Approximation("omega_start", _of("wright_omega"), 2.0, 13, "w with w + log(w) = y, y from 0"),
        Approximation("omega", _of("wright_omega"), 0.0, 15, "w with w + log(w) = y", _first(3.0, 1), 1),
        Approximation("omega_tail", _of("wright_omega"), 0.0, 14, "omega, continued", _first(512.0, 1), 1),
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
    """Return the committed form of the pieces of an approximation."""
    approximation = APPROXIMATIONS[name]
    head = [
        f"{name}: {approximation.doc}",
        f"made by `python -m galileo_sym.primitives.remake {name}`; offset {approximation.offset!r},"
        f" degree {approximation.degree}",
    ]
    return coefficient_text.to_text(head, pieces)


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
    return coefficient_text.read(path_of(name))
