"""Emission: reproducible, complete, checked, whole or not at all."""

import hashlib
import json
import os
import re
import subprocess
import sys

import pytest

from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.codegen import emit as emission
from galileo_sym.codegen.emit import WrongVersion, build, check, default_directory, emit

pytestmark = pytest.mark.xdist_group("projectile")  # whose results are what is emitted

_DIGEST = (
    "import hashlib; from galileo_sym.codegen.emit import build;"
    "print(hashlib.sha256(repr(sorted(build().items())).encode()).hexdigest())"
)


@pytest.fixture(scope="module", autouse=True)
def files():
    """What is built, once for all tests of this module."""
    once = build()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(emission, "build", lambda: dict(once))
        yield once


@pytest.fixture(scope="module")
def emitted(files, tmp_path_factory):
    directory = tmp_path_factory.mktemp("emitted") / "generated"
    assert all(line.startswith("missing: ") for line in emit(directory))
    return directory


def test_committed_files_are_what_is_emitted():
    assert check() == []


_SAID = re.compile(r"within ([\d.]+) ulp at every point sampled \(claimed bound: (\d) ulp; generated/certificates\)")


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_header_claims_what_the_certificates_hold(files, name):
    """What was measured is said beside the claim, which is the bound of the certificates."""
    said = FUNCTIONS[name].accuracy
    assert " ".join(f"Measured: {said}.".split()) in " ".join(
        files["c/galileo.h"].decode().replace("\n *", "\n").split()
    )
    measured, bound = map(float, _SAID.match(said).groups())
    certificate = json.loads((default_directory() / f"certificates/{name}.json").read_text())
    records = [record for strata in certificate["force_sets"].values() for record in strata.values()]
    assert max(record["measured"] for record in records) <= measured <= 1.0
    assert {record["bound"] for record in records} == {bound}


def test_the_same_bytes_under_another_hash_seed(files):
    here = hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest()
    other = "4242" if os.environ.get("PYTHONHASHSEED") != "4242" else "4243"
    environment = {**os.environ, "PYTHONHASHSEED": other}
    done = subprocess.run([sys.executable, "-c", _DIGEST], env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == here


def test_a_second_emission_changes_nothing(emitted):
    assert check(emitted) == []
    assert emit(emitted) == []


@pytest.mark.parametrize("name", ["chord.py", "c/tables.c", "manifest.json"])
def test_a_changed_byte_is_found_and_mended(emitted, name):
    path = emitted / name
    whole = path.read_bytes()
    path.write_bytes(whole[:-2] + bytes([whole[-2] ^ 1]) + whole[-1:])
    assert check(emitted) == [f"differs: {name}"]
    assert emit(emitted) == [f"differs: {name}"]
    assert path.read_bytes() == whole


def test_a_missing_file_is_found_and_mended(emitted):
    (emitted / "c" / "galileo.h").unlink()
    assert check(emitted) == ["missing: c/galileo.h"]
    emit(emitted)
    assert check(emitted) == []


def test_a_stale_file_is_found_and_removed_but_certificates_stay(emitted):
    (emitted / "c" / "old.c").write_text("int x;\n")
    (emitted / "certificates").mkdir()
    kept = emitted / "certificates" / "chord.distance.json"
    kept.write_text("{}")
    assert check(emitted) == ["stale: c/old.c"]
    emit(emitted)
    assert not (emitted / "c" / "old.c").exists()
    assert kept.read_text() == "{}"


def test_an_interrupted_emission_leaves_the_old_files_whole(emitted, monkeypatch):
    before = {p: p.read_bytes() for p in emitted.rglob("*") if p.is_file()}
    changed = emitted / "projectile.py"
    changed.write_text("old\n")

    def interrupt(source, target):
        raise KeyboardInterrupt

    monkeypatch.setattr(emission.os, "replace", interrupt)
    with pytest.raises(KeyboardInterrupt):
        emit(emitted)
    assert changed.read_text() == "old\n"
    assert all(p.read_bytes() == data for p, data in before.items() if p != changed)
    assert [p.name for p in emitted.parent.iterdir()] == ["generated"]
    monkeypatch.undo()
    emit(emitted)


def test_other_versions_are_refused(monkeypatch):
    monkeypatch.setattr(emission.sympy, "__version__", "1.13.0")
    with pytest.raises(WrongVersion, match=r"sympy 1\.13\.0 instead of 1\.14\.0.*pip install"):
        build()


def test_manifest_names_every_file_and_nothing_of_this_machine(files):
    manifest = json.loads(files["manifest.json"])
    assert set(manifest) == {"generator", "pinned", "sha256"}
    assert set(manifest["sha256"]) == set(files) - {"manifest.json"}
    for name, digest in manifest["sha256"].items():
        assert hashlib.sha256(files[name]).hexdigest() == digest


def test_every_file_says_what_it_was_generated_from(files):
    for name, data in files.items():
        if name != "manifest.json":
            assert b"enerated by galileo-sym from " in data.split(b"\n", 1)[0]


def test_every_kernel_names_its_ledger_entry_its_equations_and_its_cost(files):
    source = files["chord.py"].decode()
    assert "stable.chord.descent_time.friction_drag, the stable form of chord.eq43" in source
    assert source.count("Operations: ") == 21
    assert files["c/chord.c"].decode().count("Operations: ") == 21


STANDARD = ("import numpy", "from .", "from functools", "from math", "from typing")


def test_numpy_modules_import_numpy_alone(files):
    for name, data in files.items():
        if name.endswith(".py"):
            imports = [line for line in data.decode().splitlines() if line.startswith(("import ", "from "))]
            assert all(line.startswith(STANDARD) for line in imports)
