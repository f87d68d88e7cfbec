"""The printed formulas as a contender: shown beside the back ends, never judged."""

import io
import json

import numpy as np
import pytest

from galileo_sym import cli, commands
from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.typed_in import TypedIn, formulas
from galileo_sym.verify.run import run

pytest.importorskip("scipy")  # an extra: the contender is told apart from what is tested without it
pytestmark = pytest.mark.xdist_group("catalogue")


def test_every_closed_form_is_taken_from_the_ledger():
    """Each output of each variant, in nothing but the function's arguments."""
    for function in FUNCTIONS.values():
        if not TypedIn().serves(function.full_name):
            continue
        for force_set in function.variants:
            found = formulas(function, force_set)
            names = {argument.symbol for argument in function.arguments(force_set)}
            assert len(found) == len(function.outputs)
            for formula in found:
                assert {symbol.name for symbol in formula.free_symbols} <= names, (function.full_name, force_set)


def test_values_where_nothing_cancels():
    """Galileo's paradox, and a range with strong resistance, by hand."""
    time = FUNCTIONS["chord.descent_time"]
    arguments = {"theta": np.array([0.3]), "diameter": np.array([2.0]), "g": np.array([9.81])}
    assert TypedIn().evaluate(time, "free", arguments)[0] == pytest.approx((4 / 9.81) ** 0.5)
    flight = FUNCTIONS["projectile.flight_time"]
    arguments = {"theta": np.array([0.7]), "v": np.array([50.0]), "g": np.array([32.2]), "k": np.array([0.5])}
    (found,) = TypedIn().evaluate(flight, "drag", arguments)
    push = 1 + 0.5 * 50 * np.sin(0.7) / 32.2
    assert push * (1 - np.exp(-0.5 * found)) == pytest.approx(0.5 * found)


def test_it_is_shown_and_not_judged():
    """Half of its descent times at tiny drag are no numbers; verification holds all the same."""
    out = io.StringIO()
    code = run(
        ["chord.descent_time"],
        points=40,
        strata=["tiny-drag"],
        contenders=[TypedIn()],
        json_output=True,
        processes=1,
        out=out,
    )
    content = json.loads(out.getvalue())
    beside = [row for row in content["rows"] if row["compared"]]
    assert (code, content["held"]) == (0, True)
    assert len(beside) == 2
    assert all(row["measured"] > 1e10 and "no finite number" in row["verdict"] for row in beside)


def test_without_scipy(monkeypatch, capsys):
    """The option says what it needs."""
    monkeypatch.setattr(commands, "find_spec", lambda name: None)
    assert cli.main(["verify", "--typed-in"]) == 2
    assert "pip install scipy" in capsys.readouterr().err
