"""Values at any precision against the closed forms at a precision that survives their cancellation."""

import pytest
from mpmath import mp, mpf

from galileo_sym.primitives import mp_value

MAGNITUDES = ["1e-300", "1e-150", "1e-20", "3e-5", "0.04", "0.7", "1", "2.5", "9", "42", "1e4", "1e150", "1e300"]


def _descent(p):
    c = p**2 / 2
    return (1 + c + mp.lambertw(-mp.exp(-1 - c)).real) / p


def _flight(b):
    return (1 + b + mp.lambertw(-(1 + b) * mp.exp(-1 - b)).real) / (2 * b)


def _range(b):
    return (1 - mp.exp(-2 * b * _flight(b))) / (2 * b)


def _balance(b):
    w = mp.lambertw(-(1 + b) * mp.exp(-1 - b)).real
    return -b * w / ((1 + b) * (1 + w))


def _largest(a):
    s = 1 + mp.lambertw((a**2 - 1) / mp.e).real
    return mp.sqrt(1 - (1 + s) * mp.exp(-s)) / a


def _best(a):
    if a == 1:
        return 1 / (mp.e - 1)
    w = mp.lambertw((a**2 - 1) / mp.e).real
    return a * w / (a**2 - 1 - w)


CLOSED = {
    "phi1": lambda z: (mp.exp(z) - 1) / z,
    "phi2": lambda z: (mp.exp(z) - 1 - z) / z**2,
    "descent_factor": _descent,
    "flight_factor": _flight,
    "range_factor": _range,
    "range_balance": _balance,
    "range_loss": lambda b: _range(b) * (1 - _balance(b)) / b,
    "max_range_factor": _largest,
    "best_sine": _best,
    "best_angle": lambda a: mp.asin(_best(a)),
    "w0_offset": lambda x: 1 + mp.lambertw(-mp.exp(-1 - x)).real,
    "wm1_offset": lambda x: 1 + mp.lambertw(-mp.exp(-1 - x), -1).real,
    "branch_factor": lambda r: mp.exp(-mp.lambertw((r**2 / 2 - 1) / mp.e).real),
    "best_time": lambda a: (1 + mp.lambertw((a**2 - 1) / mp.e).real) / a,
}


@pytest.mark.parametrize("name", CLOSED)
@pytest.mark.parametrize("size", MAGNITUDES)
def test_value(name, size):
    with mp.workdps(40):
        x = -mpf(size) if name.startswith("phi") else mpf(size)
        value = mp_value(name, x)
        spare = (7 if abs(x) < 1 else 1) * abs(int(mp.log10(abs(x))))
        with mp.workdps(80 + spare):
            exact = CLOSED[name](x)
        assert abs(value / exact - 1) < mpf(10) ** -38


def test_logarithm_and_omega():
    with mp.workdps(40):
        assert abs(mp_value("log1p", mpf("1e-30")) / mpf("1e-30") - 1) < mpf("1e-29")
        w = mp_value("wright_omega", mpf(5))
        assert abs(w + mp.log(w) - 5) < mpf("1e-38")


def test_negative_arguments_are_refused():
    with pytest.raises(ValueError, match="defined for arguments >= 0"):
        mp_value("descent_factor", -1)
