"""Tables of NumPy's own sine, cosine and exponential: long ones, since there a table costs no more for being long."""

from mpmath import mp, mpf

from galileo_sym.primitives.tables import split

TURNS = 512  # steps of a quarter turn
FADINGS = 512  # steps of a halving
_DIGITS = 60
_FACTOR_BITS = 26  # of a number whose products with others of 26 bits are exact
_STEP_BITS = 43  # after the point, of a step whose products with integers up to 2**19 are exact


def _cut(value, bits):
    """The multiple of 2**-bits below a real number, and the rest as a double."""
    head = mp.floor(mp.ldexp(value, bits))
    return float(mp.ldexp(head, -bits)), float(value - mp.ldexp(head, -bits))


def _factor(value):
    """A double of few bits, and the rest."""
    return _cut(value, _FACTOR_BITS - int(mp.mag(value))) if value else (0.0, 0.0)


def columns():
    """Return {name: doubles} of the tables: what each holds says the text of `module`."""
    with mp.workdps(_DIGITS):
        centres = [split(i * mp.pi / (2 * TURNS), 2) for i in range(TURNS + 1)]
        sines = [_factor(mp.sin(i * mp.pi / (2 * TURNS))) for i in range(TURNS + 1)]
        powers = [split(mpf(2) ** (-mpf(j) / FADINGS), 2) for j in range(FADINGS)]
    pairs = {"centre": centres, "sine": sines, "power": powers}
    return {f"{name}{'_lo' * part}": [row[part] for row in rows] for name, rows in pairs.items() for part in (0, 1)}


def _text(name, values):
    rows = [" ".join(v.hex() for v in values[i : i + 4]) for i in range(0, len(values), 4)]
    return f"{name.upper()} = row(\n" + "\n".join(f'    "{row} "' for row in rows) + "\n)\n"


def module():
    """Return the source of the tables."""
    with mp.workdps(_DIGITS):
        step, step_lo = _cut(mp.log(2) / FADINGS, _STEP_BITS)
        turns, fadings = float(2 * TURNS / mp.pi), float(FADINGS / mp.log(2))
    return (
        '"""Steps of a quarter turn and of a halving, and sine and exponential there, as sums of two doubles.\n\n'
        f"CENTRE holds the multiples of pi/{2 * TURNS} up to pi/2, SINE their sines, the first parts of {_FACTOR_BITS} "
        f'bits; POWER 2**(-j/{FADINGS}).\n"""\n\nfrom ._lines import row\n\n'
        f"TURNS = {TURNS}\nTURNS_A_RADIAN = {turns!r}\n"
        f"FADINGS = {FADINGS}\nFADINGS_A_UNIT = {fadings!r}\nFADING_STEP = {step!r}\nFADING_STEP_LO = {step_lo!r}\n"
        + "".join(_text(name, values) for name, values in columns().items())
    )
