"""The approximations that emitted code evaluates: which function, how far the table reaches, and what comes after."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from mpmath import mp, mpf

from galileo_sym.multiprecision import mp_value
from galileo_sym.primitives import coefficient_text
from galileo_sym.primitives.fit import PER_BINADE, fit, pieces_up_to

DEGREE = 11
TOLERANCE = 2.0**-60
_FOLDER = Path(__file__).parent / "coefficients" / "scaled"


@dataclass(frozen=True)
class Far:
    """Behaviour beyond the table: 2**shift * x**power * (1 + correction * x**-order), power from -2 to 1."""

    power: int
    shift: int
    correction: float
    order: int


@dataclass(frozen=True)
class Table:
    """A tabulated function of x in [0, x_max].

    ``name`` is the emitted one; ``value`` maps mpf to mpf; ``far`` is None where the caller never goes beyond x_max;
    ``doc`` says what is tabulated.
    """

    name: str
    value: object
    x_max: float
    far: Far | None
    doc: str

    @property
    def count(self):
        """Number of pieces."""
        return pieces_up_to(self.x_max)


def _of(name, sign=1):
    return lambda x: mp_value(name, sign * x)


def _over_root(name, sign=1):
    """An offset of W over its leading term p, at p = sqrt(2 x); 1 at 0."""
    return lambda p: sign * mp_value(name, p**2 / 2) / p if p else mpf(1)


# x_max: where the terms that the far form leaves out fall below 2**-57 of the value.
TABLES = {
    table.name: table
    for table in (
        Table("phi1m", _of("phi1", -1), 43.0, Far(-1, 0, 0.0, 1), "phi1(-z) = (1 - exp(-z))/z"),
        Table("phi2m", _of("phi2", -1), 43.0, Far(-1, 0, -1.0, 1), "phi2(-z) = (z - 1 + exp(-z))/z^2"),
        Table(
            "descent_factor",
            _of("descent_factor"),
            9.0,
            Far(1, -1, 2.0, 2),
            "tau/p with tau - 1 + exp(-tau) = p^2/2",
        ),
        Table(
            "flight_factor",
            _of("flight_factor"),
            43.0,
            Far(0, -1, 1.0, 1),
            "T/(2 b) with T = (1 + b)(1 - exp(-T))",
        ),
        Table(
            "range_factor",
            _of("range_factor"),
            43.0,
            Far(-1, -1, 0.0, 1),
            "(1 - exp(-T))/(2 b) with T = (1 + b)(1 - exp(-T))",
        ),
        Table(
            "range_loss",
            _of("range_loss"),
            47.0,
            Far(-2, -1, 0.0, 1),
            "-d/db of (1 - exp(-T))/(2 b) with T = (1 + b)(1 - exp(-T))",
        ),
        Table(
            "grown_balance",
            lambda x: mp.exp(x) * mp_value("range_balance", x),
            47.0,
            None,
            "b exp(b - T)/(T - b) with T = (1 + b)(1 - exp(-T))",
        ),
        Table("best_angle", _of("best_angle"), 1023.0, None, "asin(a/(exp(s) - 1)) with 1 + (s - 1) exp(s) = a^2"),
        Table("best_time", _of("best_time"), 1023.0, None, "s/a with 1 + (s - 1) exp(s) = a^2"),
        Table(
            "max_range_factor",
            _of("max_range_factor"),
            1023.0,
            None,
            "sqrt(1 - (1 + s) exp(-s))/a with 1 + (s - 1) exp(s) = a^2",
        ),
        Table("acot", _of("acot"), 16383.0, Far(-1, 0, -1.0 / 3.0, 2), "acot(x)"),
        Table("phi0m", _of("exp", -1), 0.75, None, "exp(-z), z below log(2)"),
        Table("wright_omega", _of("wright_omega"), 1535.0, None, "w with w + log(w) = y"),
        Table("principal", _of("branch_factor"), 3.0, None, "exp(-W0(x)) at sqrt(2 (1 + e x))"),
        Table("w0_offset", _over_root("w0_offset"), 11.0, None, "(1 + W0(-exp(-1 - x)))/sqrt(2 x) at sqrt(2 x)"),
        Table(
            "wm1_offset", _over_root("wm1_offset", -1), 47.0, None, "-(1 + W-1(-exp(-1 - x)))/sqrt(2 x) at sqrt(2 x)"
        ),
        Table("log1p", _of("log1p"), 1.0, None, "log(1 + x)"),
    )
}

# Sine and cosine at i/64 up to pi/4 and half a step more, each as the sum of three doubles.
ANGLE_STEPS = 64
ANGLE_COUNT = 51

# The same for vectors, which pick out of 16: multiples of a step of few bits up to pi/4 and half a step more.
TURN_STEP = 13 / 256
TURN_COUNT = 16


def split(value, parts):
    """Return a real number as an unevaluated sum of doubles, each the rest rounded."""
    result = []
    for _ in range(parts):
        result.append(float(value))
        value = value - mpf(result[-1])
    return tuple(result)


def fitted(name):
    """Return the pieces of a table, fitted now."""
    table = TABLES[name]
    return fit(table.value, table.x_max, DEGREE, TOLERANCE)


def path_of(name):
    """Return where the committed coefficients of a table are."""
    return _FOLDER / f"{name}.txt"


def to_text(name, fitted_pieces):
    """Return the committed form of the pieces of a table."""
    head = [
        f"{name}: {TABLES[name].doc}",
        f"made by `python -m galileo_sym.primitives.remake scaled/{name}`; {PER_BINADE} pieces a binade of 1 + x,"
        f" degree {DEGREE}",
    ]
    return coefficient_text.to_text(head, fitted_pieces)


@cache
def pieces(name):
    """Return the committed pieces of a table; their ``error`` is not kept, and 0.

    Raises
    ------
    FileNotFoundError
        If they were never made: run ``python -m galileo_sym.primitives.remake``.
    """
    return coefficient_text.read(path_of(name))


@cache
def angle_rows():
    """Return ((sin parts, cos parts), ...) at i/64, three doubles each."""
    with mp.workdps(70):
        return tuple(
            (split(mp.sin(mpf(i) / ANGLE_STEPS), 3), split(mp.cos(mpf(i) / ANGLE_STEPS), 3)) for i in range(ANGLE_COUNT)
        )


@cache
def turn_rows():
    """Return ((sin, its rest, cos, its rest), ...) at the multiples of `TURN_STEP`."""
    with mp.workdps(70):
        angles = [mpf(i * TURN_STEP) for i in range(TURN_COUNT)]
        return tuple((*split(mp.sin(angle), 2), *split(mp.cos(angle), 2)) for angle in angles)


@cache
def series_rows(name, count):
    """Return Taylor coefficients from d**2 on, three doubles each: ``sinc``, sin(d)/d - 1, or ``cosm1``, cos(d) - 1."""
    offset = {"sinc": 1, "cosm1": 0}[name]
    with mp.workdps(70):
        return tuple(split((-1) ** k / mp.factorial(2 * k + offset), 3) for k in range(1, count + 1))


@cache
def pair_rows(name, count):
    """Return series coefficients as two doubles, from k = 0 on.

    ``atanh``: 1/(2 k + 1); ``growth``: 1/(k + 1)!; ``decay_series``: (-1)**k/(k + 2)!, phi2(-s) in powers of s.
    """
    term = {
        "atanh": lambda k: mpf(1) / (2 * k + 1),
        "growth": lambda k: 1 / mp.factorial(k + 1),
        "decay_series": lambda k: (-1) ** k / mp.factorial(k + 2),
    }[name]
    with mp.workdps(70):
        return tuple(split(term(k), 2) for k in range(count))


@cache
def constants():
    """Return the constants emitted code needs: pi/2, log(2), e and 1/e as sums of doubles.

    The first part of log(2) has 32 bits, so that its product with an exponent is exact.
    """
    with mp.workdps(70):
        head = mpf(int(mp.log(2) * 2**32)) / 2**32
        return {
            "half_pi": split(mp.pi / 2, 4),
            "log_2": (float(head), *split(mp.log(2) - head, 2)),
            "e": split(mp.e, 2),
            "inverse_e": split(mp.exp(-1), 3),
        }
