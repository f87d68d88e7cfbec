"""Tables of NumPy's own exponential: long ones, since there a table costs no more for being long."""

from mpmath import mp, mpf

from galileo_sym.primitives.tables import split

FADINGS = 512  # steps of a halving
_DIGITS = 60
_STEP_BITS = 43  # after the point, of a step whose products with integers up to 2**19 are exact


def _cut(value, bits):
    """The multiple of 2**-bits below a real number, and the rest as a double."""
    head = mp.floor(mp.ldexp(value, bits))
    return float(mp.ldexp(head, -bits)), float(value - mp.ldexp(head, -bits))


def _text(name, values):
    rows = [" ".join(v.hex() for v in values[i : i + 4]) for i in range(0, len(values), 4)]
    return f"{name.upper()} = row(\n" + "\n".join(f'    "{row} "' for row in rows) + "\n)\n"


def module():
    """Return the source of the tables."""
    with mp.workdps(_DIGITS):
        step, step_lo = _cut(mp.log(2) / FADINGS, _STEP_BITS)
        fadings = float(FADINGS / mp.log(2))
        powers = [split(mpf(2) ** (-mpf(j) / FADINGS), 2) for j in range(FADINGS)]
    return (
        '"""Steps of a halving, and the exponential there, as sums of two doubles.\n\n'
        f'POWER holds 2**(-j/{FADINGS}).\n"""\n\nfrom ._lines import row\n\n'
        f"FADINGS = {FADINGS}\nFADINGS_A_UNIT = {fadings!r}\nFADING_STEP = {step!r}\nFADING_STEP_LO = {step_lo!r}\n"
        + "".join(_text(f"power{'_lo' * part}", [row[part] for row in powers]) for part in (0, 1))
    )
