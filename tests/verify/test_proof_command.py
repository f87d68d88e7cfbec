"""The committed bounds: of the C that is emitted, rounded up, above every sample; and what the command refuses."""

import json
import shutil
from fractions import Fraction

import numpy as np
import pytest
from kernels_of_one import EMITTED, KERNELS, kernels_of, spoiled

from galileo_sym.libraries import NoCompilerError, find_compiler
from galileo_sym.primitives.kernels import KERNELS as KERNELS_BY_NAME
from galileo_sym.verify.native import NativeLibrary
from galileo_sym.verify.proof import command, table
from galileo_sym.verify.proof.bounds import Proved, prove
from galileo_sym.verify.proof.dispatch import primitives
from galileo_sym.verify.proof.emitted import RefusedSource, parse
from galileo_sym.verify.proof.frame_forms import FORMS
from galileo_sym.verify.proof.references import CLOSED, NoReference, reference
from galileo_sym.verify.proof.samples import errors, points

PROOFS = command.proofs(command.sources_in(table.folder()))
NAMES = [name for name, proof in PROOFS.items() if proof]
NAME = "descent_factor"
COUNT = 120
KNOWN_VALUES = {
    "phi2m": (1e-9, 0.5),
    "best_sine": (1e-9, 0.5**0.5),
    "best_angle": (1e-9, np.pi / 4),
    "w0_ratio": (1e-9, np.e),
    "sin": (1e-9, 1e-9),
    "arctan": (1e-9, 1e-9),
    "w0": (1e-9, 1e-9),
    "wm1": (-2 * np.exp(-2), -2.0),
    "w0_offset": (1e-18, 2e-18**0.5),
    "wm1_offset": (1e-18, -(2e-18**0.5)),
}
SIGN = ("gs_add(s_rest, s_lo)", "gs_sub(s_lo, s_rest)")

try:
    COMPILER, REASON = find_compiler(), ""
except NoCompilerError as cause:
    COMPILER, REASON = None, f"no C compiler: {cause}"
needs_compiler = pytest.mark.skipif(COMPILER is None, reason=REASON)


def special(folder, target):
    """Compile the primitives alone, in plain C, from a copy of their sources: every version has the same bits."""
    target.mkdir()
    for path in [folder / "special.c", *folder.glob("*.h")]:
        shutil.copy(path, target)
    return NativeLibrary(target, [*COMPILER, "-DGS_PORTABLE"])


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    return special(EMITTED, tmp_path_factory.mktemp("special") / "c")


@pytest.fixture(scope="module")
def proved():
    return prove(parse(KERNELS), NAME)


@pytest.fixture
def known():
    return table.read()


@pytest.fixture
def generated(tmp_path, monkeypatch):
    """A copy of the emitted C, its committed bounds and their page, which the command takes for the installed ones."""
    folder = tmp_path / "generated"
    shutil.copytree(EMITTED, folder / "c")
    for source, target in ((table.json_path(), "certificates/proofs.json"), (table.page_path(), "../docs/proofs.md")):
        (folder / target).parent.mkdir()
        shutil.copy(source, folder / target)
    monkeypatch.setattr(table, "folder", lambda: folder)
    return folder


def spoil(generated, old, new, name="galileo_kernels.h"):
    path = generated / "c" / name
    path.write_text(spoiled(path.read_text(encoding="utf-8"), old, new), encoding="utf-8")


def test_the_committed_bounds_are_of_this_c(known):
    assert command.stale(known, table.folder(), table.page_path().read_text(encoding="utf-8")) == []


def test_every_primitive_is_proved_within_what_the_readme_says(known):
    assert known["not proved"] == []
    assert set(known["primitives"]) == set(KERNELS_BY_NAME)
    assert max(record["total"] for record in known["primitives"].values()) <= 0.55


def test_the_proof_gives_the_committed_bounds_again(known, proved):
    assert table.entry(proved) == known["primitives"][NAME]


@needs_compiler
@pytest.mark.parametrize("name", NAMES)
def test_no_sample_is_above_the_proved_bound(library, name):
    worst, lines = command.refuted(name, PROOFS[name].points, table.proved_bound(name), library, COUNT, 7)
    assert worst > 0.4
    assert lines == []


@needs_compiler
def test_a_sample_above_the_proved_bound_is_found(generated, tmp_path):
    spoil(generated, *SIGN)
    library = special(generated / "c", tmp_path / "spoiled")
    worst, lines = command.refuted(NAME, PROOFS[NAME].points, table.proved_bound(NAME), library, COUNT, 7)
    assert worst > 0.75
    assert len(lines) == 1


def test_a_wrong_or_missing_value_is_no_small_error():
    assert errors("phi1m", np.array([1.0, 1.0]), np.array([0.6321205588285577, 0.632])) == pytest.approx(
        [0.0, 1e12], abs=1.1e12
    )
    with pytest.raises(NoReference, match="no definition"):
        errors("phi9", np.array([1.0]), np.array([1.0]))


def test_a_value_far_below_the_least_double_is_0():
    assert errors("exp_minus", np.array([1e300, 1e300]), np.array([0.0, 5e-324])) == [0.0, 1.0]


def test_samples_lie_in_every_bank_and_beyond():
    served = primitives(parse(KERNELS))["flight_factor"]
    x = points(served, 400, 1)
    for bank in served.banks:
        assert ((x >= float(bank.begin)) & (x < float(bank.end))).sum() > 50
    assert (x >= float(served.far_from)).sum() > 50
    assert (x < 1e-9).any()


@pytest.mark.parametrize("name", sorted(CLOSED))
def test_references_have_known_values(name):
    x, value = KNOWN_VALUES.get(name, (1e-9, 1.0))
    assert float(reference(name, x)) == pytest.approx(value, rel=1e-8)


def test_every_number_is_rounded_up():
    row = Proved("gs_f_near", 0, Fraction(0), Fraction(1), Fraction(1, 3000), *[Fraction(1, 3)] * 2, Fraction(2, 3))
    shown = table.entry([row])["rows"][0]
    numbers = [shown[part] for part in ("approximation", "rounding", "total", "pair")]
    assert numbers == [3.34e-4, 0.3334, 0.3334, 0.667]


def test_the_bound_of_a_primitive_is_that_of_plain_arguments(known):
    rows = known["primitives"]["range_factor"]["rows"]
    plain = [row["total"] for row in rows if not row["function"].endswith("_pair")]
    assert table.proved_bound("range_factor") == max(plain) < max(row["total"] for row in rows)
    with pytest.raises(KeyError):
        table.proved_bound("phi9")


@pytest.mark.parametrize("name", [*table.SOURCES, *table.SERVED])
def test_check_refuses_another_c(generated, capsys, name):
    assert command.main(["--check"]) == 0
    path = generated / name
    path.write_bytes(path.read_bytes() + b"\n")
    assert command.main(["--check"]) == 1
    assert f"{name} has changed" in capsys.readouterr().err


def test_check_refuses_bounds_of_another_proof(generated, capsys):
    path = table.json_path()
    path.write_text(path.read_text().replace('"galileo_sym/verify/proof": "', '"galileo_sym/verify/proof": "0'))
    assert command.main(["--check"]) == 1
    assert "galileo_sym/verify/proof has changed" in capsys.readouterr().err


def test_check_refuses_what_it_cannot_parse(generated, capsys):
    spoil(generated, "gs_mul(q2, d)", "q2 * d")
    assert command.main(["--check"]) == 1
    assert "no operation of the vector header" in capsys.readouterr().err


def _without(known):
    del known["primitives"][NAME]


def _too_large(known):
    known["primitives"][NAME]["rows"][3]["total"] = 0.7501


def _not_a_number(known):
    known["primitives"][NAME]["rows"][3]["total"] = float("nan")


def _other(known):
    known["primitives"]["phi9"] = known["primitives"][NAME]


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (_without, f"{NAME} has no proved bound"),
        (_too_large, "0.7501 ulp, more than the 0.75 allowed"),
        (_not_a_number, "nan ulp, more than the 0.75 allowed"),
        (_other, "phi9 is proved and not emitted"),
    ],
)
def test_check_refuses_a_table_with_holes_or_bounds_too_large(known, change, why):
    change(known)
    faults = command.stale(known, table.folder(), table.page(known))
    assert [why in fault for fault in faults] == [True]


def test_check_refuses_a_missing_table_and_another_page(generated, known):
    assert command.stale(None, generated, "") == ["there is no table of proved bounds"]
    page = table.page(known).replace("0.5", "0.4", 1)
    assert command.stale(known, generated, page) == ["docs/proofs.md does not show the committed bounds"]


@needs_compiler
@pytest.mark.parametrize(
    ("file", "old", "new", "why"),
    [
        ("galileo_kernels.h", *SIGN, "more than the 0.75 allowed"),
        ("galileo_kernels.h", "gs_rest(c0, p, s)", "gs_rest(p, c0, s)", "gs_rest needs abs a >= abs b"),
        ("galileo_kernels.h", "gs_fma(x, gs_v_of(0x1.0000000000000p-1), y)", "y", "not the form that was bounded"),
        ("galileo_vector.h", "gs_add(gs_sub(a, s), b)", "gs_sub(gs_sub(a, s), b)", "gs_rest for all"),
    ],
)
def test_a_proof_that_fails_writes_nothing(generated, capsys, monkeypatch, file, old, new, why):
    monkeypatch.setattr(command, "_library", lambda folder: None)  # the proof alone must notice
    monkeypatch.setattr(command, "proofs", lambda sources, all_of=command.proofs: {NAME: all_of(sources)[NAME]})
    before = {path: path.read_bytes() for path in (table.json_path(), table.page_path())}
    spoil(generated, old, new, file)
    assert command.main([]) == 1
    assert why in capsys.readouterr().err
    assert before == {path: path.read_bytes() for path in before}


def test_a_whole_proof_is_written_and_then_holds(generated, monkeypatch, proved):
    monkeypatch.setattr(command, "_library", lambda folder: None)
    monkeypatch.setattr(command, "prove", lambda emitted, name: proved)
    monkeypatch.setattr(command, "proofs", lambda sources, all_of=command.proofs: {NAME: all_of(sources)[NAME]})
    written = table.json_path().read_bytes()
    assert command.main([NAME]) == 0
    assert table.json_path().read_bytes() == written
    assert command.main([]) == 0
    assert set(json.loads(table.json_path().read_text(encoding="utf-8"))["primitives"]) == {NAME}
    assert command.main(["--check"]) == 0


def test_functions_on_other_pieces_than_their_pairs_are_refused():
    text = kernels_of(NAME)
    begin = text.index("_near_pair(")
    other = text[:begin] + spoiled(text[begin:], "(gs_descent_factor_centre, i)", "(gs_descent_factor_c0, i)")
    with pytest.raises(RefusedSource, match="does not stand on the pieces"):
        prove(parse(other), NAME)


@pytest.mark.parametrize("arguments", [["phi9"], ["--check", NAME], ["--points", "0"]])
def test_bad_usage_exits_with_2(arguments):
    with pytest.raises(SystemExit) as stopped:
        command.main(arguments)
    assert stopped.value.code == 2


def test_a_primitive_that_the_proof_does_not_know_is_listed_and_said(generated, capsys, monkeypatch, known):
    monkeypatch.delitem(FORMS, "sin")
    record = known["primitives"].pop("sin")
    assert command.stale(known, table.folder(), table.page(known)) == ["the primitives that are not proved are others"]
    text = table.content(known["sha256"], known["primitives"], [*known["not proved"], "sin"])
    table.json_path().write_text(text, encoding="utf-8")
    table.page_path().write_text(table.page(table.read()), encoding="utf-8")
    assert "| sin | not proved |" in table.page_path().read_text(encoding="utf-8")
    assert command.main(["--check"]) == 0
    assert "sin              not proved" in capsys.readouterr().out
    assert record["total"] < table.LIMIT
