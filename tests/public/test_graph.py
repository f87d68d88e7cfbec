"""The graph of premises: no circle, grounded, connected; drawn the same way every time."""

import os
import subprocess
import sys
from xml.etree import ElementTree as ET

import pytest
from sympy import Eq

from galileo_sym import graph
from galileo_sym.ledger import ONE, POSITIVE, Chapter, Domain, Ledger, Notation

# Mathematics proved from no premise: double angles, moves of result (3), power series, the primitives (at 0, a slope).
IDENTITIES = (
    *("chord.eq7", "chord.eq8", "projectile.res3.step1", "projectile.thm1.factor"),
    *("stable.at-zero.", "stable.range_loss"),
)
BOX = "{http://www.w3.org/2000/svg}rect"


def row(identifier, *premises, verdict="proved"):
    return {"id": identifier, "chapter": "c", "label": "l", "premises": list(premises), "verdict": verdict}


@pytest.fixture(scope="module")
def rows():
    """Rows of the ledger as if all were proved that is derived: nothing is derived here."""
    entries = Ledger.load().values()
    return [row(e.id, *e.premises, verdict="proved" if e.declaration.function else e.kind) for e in entries]


def test_every_chain_ends_in_a_law_a_definition_or_an_identity(rows):
    ends = graph.grounds(rows)
    assert {r["id"] for r in rows if not r["premises"]} <= set().union(*ends.values())
    assert [i for i in ends["identity"] if not i.startswith(IDENTITIES)] == []
    assert {"chord.law.friction", "projectile.law.drag.y"} <= set(ends["law"])


def test_no_entry_stands_alone(rows):
    assert graph.alone(rows) == []
    assert graph.alone([row("a"), row("b"), row("c", "b")]) == ["a"]


def test_each_box_stands_to_the_right_of_its_premises(rows):
    level = graph.levels(rows)
    assert all(level[p] < level[r["id"]] for r in rows for p in r["premises"])
    assert graph.levels([row("a"), row("b", "a"), row("c", "a", "b")]) == {"a": 0, "b": 1, "c": 2}


def test_a_circle_is_refused():
    notation = Notation("small")
    p = notation.symbol("p", ONE, "a number", positive=True)
    chapter = Chapter("stable.small", notation, "a chapter of the tests")
    for own, other in (("a", "b"), ("b", "a")):
        statement = Eq(p, 2 * p, evaluate=False)
        chapter.derive(f"stable.{own}", statement, Domain({p: POSITIVE}), premises=(f"stable.{other}",))(lambda e: e)
    with pytest.raises(ValueError, match=r"derived from itself: stable\.[ab] <- stable\.[ab] <- stable\.[ab]"):
        Ledger([chapter])


def test_the_drawings_hold_every_entry_and_every_premise(rows):
    text = graph.dot(rows)
    assert text.count(" -> ") == sum(len(r["premises"]) for r in rows)
    assert all(f'"{r["id"]}" [' in text for r in rows)
    drawn = ET.fromstring(graph.svg(rows))
    assert len(drawn.findall(f".//{BOX}")) == len(rows)
    corners = [(box.get("x"), box.get("y")) for box in drawn.iter(BOX)]
    assert len(set(corners)) == len(corners)


def test_what_is_not_proved_is_drawn_in_another_colour():
    drawn = ET.fromstring(graph.svg([row("a", verdict="law"), row("b", "a"), row("c", "a", verdict="refuted")]))
    assert [box.get("fill") for box in drawn.iter(BOX)] == [graph.COLOURS["law"], graph.COLOURS["proved"], graph.FAILED]


def test_the_drawing_is_the_same_in_every_process(tmp_path):
    code = "import sys; from galileo_sym import graph; graph.write([{r}], sys.argv[1])"
    text = code.format(r=", ".join(map(repr, (row("a"), row("b", "a"), row("c", "a", "b"), row("d", "z")))))
    for seed in ("1", "2"):
        subprocess.run(
            [sys.executable, "-c", text, tmp_path / seed], check=True, env={**os.environ, "PYTHONHASHSEED": seed}
        )
    for name in ("derivations.dot", "derivations.svg"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "2" / name).read_bytes()


def test_without_igraph_the_text_is_written_and_the_lack_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(graph, "find_spec", lambda name: None)
    told = graph.write([row("a"), row("b", "a")], tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["derivations.dot"]
    assert any("needs the package igraph" in line for line in told)
