"""Bounds of the scaled layer's tables: above every sample, and raised or refused where the C is spoiled."""

import json
import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp, mpf

from galileo_sym.generated import _primitives, _tables
from galileo_sym.verify.proof import scaled_command, table
from galileo_sym.verify.proof.approximation import Unproved as UnprovedApproximation
from galileo_sym.verify.proof.emitted import RefusedSource
from galileo_sym.verify.proof.references import CLOSED
from galileo_sym.verify.proof.replay import Unproved
from galileo_sym.verify.proof.scaled_bounds import table_bounds
from galileo_sym.verify.proof.scaled_source import read

FOLDER = table.folder()
TEXTS = [(FOLDER / name).read_text(encoding="utf-8") for name in scaled_command.SOURCES]
SCALED = read(*TEXTS)
COMMITTED = json.loads(scaled_command.json_path().read_text(encoding="utf-8"))
SAMPLES = 300
ABSOLUTE = {"log1p": 1 / 16}  # up to where the value may vanish


def _time(b):
    y = 1 + b
    return y + mp.lambertw(-y * mp.exp(-y)).real


def _best_time(a):
    return (1 + mp.lambertw((a * a - 1) / mp.e).real) / a


# by Lambert W and derivatives in multiprecision, which neither the tables nor their proof use
REFERENCES = {
    **{name: CLOSED[name] for name in ("phi1m", "phi2m", "descent_factor", "flight_factor", "range_factor")},
    **{name: CLOSED[name] for name in ("best_angle", "max_range_factor")},
    "best_time": _best_time,
    "range_loss": lambda b: -mp.diff(CLOSED["range_factor"], b),
    "grown_balance": lambda b: b * mp.exp(b - _time(b)) / (_time(b) - b),
    "acot": mp.acot,
    "phi0m": lambda z: mp.exp(-z),
    "wright_omega": lambda y: mp.lambertw(mp.exp(y)).real,
    "log1p": mp.log1p,
    "w0_offset": CLOSED["rise_factor"],
    "wm1_offset": CLOSED["fall_factor"],
    "principal": lambda q: mp.exp(-mp.lambertw((q * q / 2 - 1) / mp.e).real),
}


def test_the_committed_bounds_are_of_this_c():
    """The remedy is `make prove`."""
    text = scaled_command.page_path().read_text(encoding="utf-8")
    assert scaled_command.stale(COMMITTED, FOLDER, text) == []


@pytest.mark.parametrize("name", SCALED.tables)
def test_no_sample_exceeds_the_proved_bound(name):
    """Of the NumPy look-up, whose bits are those of C."""
    found = SCALED.tables[name]
    rng = random.Random(name)
    x = np.array([rng.uniform(0, float(found.end)) for _ in range(SAMPLES)] + [2.0**-k for k in range(1, 40)])
    x = x[x < float(found.end)]
    x_lo = x * np.array([rng.uniform(-1, 1) * 2.0**-54 for _ in x])
    hi, lo = _primitives._lookup(_tables.TABLES[name], x, x_lo)
    with mp.workdps(90):
        worst = mpf(0)
        for at, rest, *value in zip(x, x_lo, hi, lo, strict=True):
            true = REFERENCES[name](mpf(float(at)) + mpf(float(rest)))
            missed = abs(mpf(float(value[0])) + mpf(float(value[1])) - true)
            worst = max(worst, missed if at < ABSOLUTE.get(name, 0) else missed / true)
    assert COMMITTED["tables"][name]["pair"] / 2**8 <= worst <= COMMITTED["tables"][name]["pair"]


def _few(tables, name, *numbers):
    return replace(tables.tables[name], pieces=tuple(tables.tables[name].pieces[i] for i in numbers))


def _worst(scaled, name, *numbers):
    return max(row.pair for row in table_bounds(scaled.lookup, _few(scaled, name, *numbers)))


@pytest.mark.parametrize(("name", "column"), [("phi1m", 1), ("range_loss", 2), ("acot", 3), ("best_angle", 8)])
def test_a_spoiled_coefficient_raises_the_bound(name, column):
    """The last bits of one number in a row: of the anchor, its rest, the slope, a later coefficient."""
    few = _few(SCALED, name, 5)
    (piece, row), spoiled = few.pieces[0], Fraction(1, 2**52)
    changed = [*row]
    changed[column] += abs(row[column]) * spoiled if column != 2 else abs(row[1]) * Fraction(1, 2**57)
    changed[column] = Fraction(float(changed[column] * (1 if column < 8 else 1 + Fraction(1, 2**20))))
    _, c0, c0_lo, c1, c1_lo, *rest = changed
    other = replace(few, pieces=((replace(piece, coefficients=(c0 + c0_lo, c1 + c1_lo, *rest)), tuple(changed)),))
    honest = _worst(SCALED, name, 5)
    assert max(row.pair for row in table_bounds(SCALED.lookup, other)) > 4 * honest


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("value.lo + (row[2] +", "(row[2] +"),  # the rest of the last sum dropped
        ("(row[2] + (rise.lo + (", "(row[2] + ((slope.lo - slope.lo) + ("),  # the rest of the product dropped
        ("+ slope.hi * d.lo", "+ slope.lo * d.lo"),  # the low part of the argument dropped
        ("tail * d.hi + row[k]", "tail * d.hi - row[k]"),
    ],
)
def test_a_dropped_correction_raises_the_bound(old, new):
    """A look-up without it is not proved as good."""
    assert old in TEXTS[2]
    spoiled = read(*TEXTS[:2], TEXTS[2].replace(old, new))
    assert _worst(spoiled, "phi2m", 7) > 8 * _worst(SCALED, "phi2m", 7)


@pytest.mark.parametrize(
    ("text", "old", "new", "why"),
    [
        (2, "frexp(1.0 + x, &e)", "frexp(1.5 + x, &e)", "finds its piece in another way"),
        (2, "gs_two_sum(x - row[0], x_lo)", "gs_two_sum(x - row[1], x_lo)", "distance of x"),
        (2, "gs_two_sum(row[1], rise.hi)", "gs_fast_two_sum(rise.hi, row[1])", "needs abs a >= abs b"),
        (2, "tail * d.hi + row[k]", "tail / d.hi + row[k]", "outside the grammar"),
        (1, "{s, (a - (s - t)) + (b - t)}", "{s, (a - (s - t)) - (b - t)}", "gs_two_sum is"),
        (
            0,
            "const gs_table gs_phi1m_table = {phi1m_rows, 86",
            "const gs_table gs_phi1m_table = {phi1m_rows, 85",
            "own 86",
        ),
    ],
)
def test_another_source_is_refused(text, old, new, why):
    """With a message that says where."""
    texts = list(TEXTS)
    assert old in texts[text]
    texts[text] = texts[text].replace(old, new)
    with pytest.raises((RefusedSource, Unproved), match=why):
        _worst(read(*texts), "phi2m", 7)


def test_a_centre_that_is_another_is_not_proved():
    """The polynomial is then of another function."""
    few = _few(SCALED, "phi1m", 9)
    piece, row = few.pieces[0]
    moved = piece.centre + Fraction(1, 2**8)
    other = replace(few, pieces=((replace(piece, centre=moved), (moved, *row[1:])),))
    with pytest.raises(UnprovedApproximation, match="where less than"):
        table_bounds(SCALED.lookup, other)


def test_check_tells_what_is_stale():
    """Another look-up, another table, one missing, one too many, a bound above the limit, another page."""

    def faults(**changes):
        known = {**COMMITTED, **changes}
        return scaled_command.stale(known, FOLDER, scaled_command.page(known))

    tables = COMMITTED["tables"]
    others = {name: record for name, record in tables.items() if name != "acot"}
    assert scaled_command.stale(None, FOLDER, "") == ["there are no proved bounds of the scaled layer's tables"]
    assert faults(lookup="0") == ["gs_lookup has changed since its bounds were proved"]
    assert faults(tables=others) == ["the table acot has no proved bound"]
    assert faults(tables=tables | {"phi9": tables["acot"]}) == ["the table phi9 is proved and not emitted"]
    assert faults(tables=tables | {"acot": {**tables["acot"], "sha256": "0"}}) == [
        "the table acot has changed since its bound was proved"
    ]
    for bad in (2.0**-56, float("nan")):
        (fault,) = faults(tables=tables | {"acot": {**tables["acot"], "pair": bad}})
        assert "acot errs by up to" in fault
    assert scaled_command.stale(COMMITTED, FOLDER, "") == ["docs/table_proofs.md does not show the committed bounds"]


def test_unknown_tables_are_refused(capsys):
    """With the names there are."""
    with pytest.raises(SystemExit) as stopped:
        scaled_command.main(["phi9"])
    assert stopped.value.code == 2
    assert "no table phi9" in capsys.readouterr().err
