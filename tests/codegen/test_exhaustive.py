"""The exhaustive run: its committed result is of the present code, its reference is right, and it finds faults."""

import json
import re
import shutil
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from galileo_sym.primitives.kernels import KERNELS

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))

from exhaustive import certain, emitted, hard_cases, libraries, results, run, same_bits, singles, sweep, wc_files  # noqa: E402

INPUTS = 1 << 32
REFERENCE_ERROR = Fraction(1, 2**64)  # as in reference.h
BRANCH = 0.36787944117144233  # 1/e


WEAKENED = {  # (file, pattern of what is there, what replaces it, primitive and span in which it shows)
    "a coefficient's last bits": (
        "galileo_kernels.h",
        r"(gs_phi1m_c0\) = \{\s+\S+ 0x1\.\w{9})\w{4}",
        r"\g<1>0000",
        "phi1m",
        "3f000000:3f020000",
    ),
    "negative arguments let pass": (
        "galileo_kernels.h",
        r"return gs_refuse_negative\(x, (gs_select\(beyond, tail, r\)), lo\);",
        r"return \1;",
        "phi1m",
        "bf000000:bf000100",
    ),
    "the low part dropped": (  # at 3d8d6b23 the double is a midpoint of floats
        "galileo_singles.h",
        r"(gs_arctan_value\(wide, &lo\);\n    return )gs_to_odd\(hi, lo\);",
        r"\g<1>hi;",
        "arctan",
        "3d8d6b00:3d8d6c00",
    ),
}
SPOILED = {  # in the AVX2 version alone
    "a product rounded": (r"(_mm256_)fmsub_pd\(a, b, c\)", r"\1sub_pd(_mm256_mul_pd(a, b), c)"),
    "a wrong operation": (r"_mm256_mul_pd\(a, b\)", "_mm256_add_pd(a, b)"),
}


def sizes_up_to(x):
    """How many floats lie in [0, x]."""
    nearest = np.float32(x)
    return int((nearest if float(nearest) <= x else np.nextafter(nearest, np.float32(0))).view(np.uint32)) + 1


def nan_due(name):
    """How many floats, NaN included, are outside of the domain; -0 is in it with 0."""
    least, greatest = KERNELS[name].domain
    assert least <= 0.0 <= greatest
    return INPUTS - sizes_up_to(abs(least)) - sizes_up_to(greatest)


def arguments_of(name, rng):
    """Numbers all over the domain, tiny ones and those next to its ends among them."""
    anywhere = [2.0 ** rng.uniform(-200, 200, 96), rng.uniform(0, 80, 96)]
    found = {
        "exp_minus": [2.0 ** rng.uniform(-200, 9, 96), rng.uniform(0, 104, 96)],
        "sin": [2.0 ** rng.uniform(-200, 0, 96), np.pi / 2 - 2.0 ** rng.uniform(-54, 0, 96)],
        "arctan": [*anywhere, -(2.0 ** rng.uniform(-10, 10, 64))],
        "w0": [*anywhere, -BRANCH * 2.0 ** rng.uniform(-198, 0, 64), 2.0 ** rng.uniform(-53, -2, 64) - BRANCH],
        "wm1": [-BRANCH * 2.0 ** rng.uniform(-198, 0, 96), 2.0 ** rng.uniform(-53, -2, 96) - BRANCH],
    }
    x = np.concatenate(found.get("sin" if name == "cos" else name, anywhere))
    return np.array([a for a in x if wc_files.within(name, a)])


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    return libraries.compile_reference(tmp_path_factory.mktemp("reference") / "reference.so")


@pytest.fixture(scope="module")
def tested(tmp_path_factory):
    target = tmp_path_factory.mktemp("tested") / "tested.so"
    return libraries.compile_tested(emitted.c_folder(), target, quickly=True)


@pytest.fixture
def compiled_once(monkeypatch, reference):
    """Runs within this process take the reference that is compiled already."""
    monkeypatch.setattr(libraries, "compile_reference", lambda target, shift=None: reference)


def small_copy(folder):
    """A copy of the emitted C with little to compile."""
    shutil.copytree(emitted.c_folder(), folder)
    for source in (folder / "galileo_blocks.h", *folder.glob("special*.c")):
        text = source.read_text(encoding="utf-8")
        few = re.sub(r"^GS_(LOOPS|BLOCKS|PUBLIC)\((?!phi1m|arctan).*\n", "", text, flags=re.MULTILINE)
        few = few.replace("static GS_RARE void", "static inline void")  # of which the unused are nothing to warn of
        source.write_text(few, encoding="utf-8")
    return folder


def weakened(folder, file, pattern, becomes):
    """A small copy with one change."""
    small_copy(folder)
    text, changes = re.subn(pattern, becomes, (folder / file).read_text(encoding="utf-8"), count=1)
    assert changes == 1
    (folder / file).write_text(text, encoding="utf-8")
    return folder


def test_every_primitive_has_been_tried():
    """At all inputs: `make exhaustive`."""
    assert set(results.kept()["exhaustive"]) == set(KERNELS)


@pytest.mark.parametrize("name", KERNELS)
def test_the_committed_run_is_of_the_present_code(name):
    """All inputs, none at fault."""
    assert not results.stale(name), f"the result for {name} is of other code: run `make exhaustive`"
    row = results.kept()["exhaustive"][name]
    assert results.faults(row) == 0
    assert row["refused"] == nan_due(name)
    assert row["right"] + row["by_arb"] + row["refused"] == INPUTS


@pytest.mark.parametrize("name", KERNELS)
def test_the_committed_comparison_is_of_the_present_code(name):
    """At least 10^8 inputs, in more than one version, none differing."""
    assert not results.stale(name, "same_bits"), f"the comparison of {name} is of other code: run `make same-bits`"
    row = results.kept()["same_bits"][name]
    assert row["binary64"] + row["binary32"] >= 10**8
    assert len(row["versions"]) > 1
    assert row["differing"] == 0


@pytest.mark.parametrize("name", KERNELS)
def test_the_quick_functions_were_held_to_those_by_pairs(name):
    assert not results.stale(name, "singles"), f"the comparison of {name} is of other code: run `make singles`"
    row = results.kept()["singles"][name]
    assert row["differing"] == 0
    assert max(row["inputs"].values()) == INPUTS


def test_a_quick_function_with_other_bits_is_found(tmp_path, monkeypatch):
    folder = tmp_path / "c"
    shutil.copytree(emitted.c_folder(), folder)
    header = folder / "galileo_lean.h"
    text = header.read_text()
    spoiled = re.sub(r"(gs_phi1m_lean0\) = \{\s+\S+ 0x1\.\w{5})\w{8}", r"\g<1>00000000", text, count=1)
    assert spoiled != text
    header.write_text(spoiled)
    library = libraries.compile_tested(folder, tmp_path / "spoiled.so", quickly=True)
    half = 0x3F000000 // singles.STRETCH  # floats from 0.5 on lie in the second piece
    assert singles.differing(library, "phi1m", "plain", half).size > 0
    assert singles.differing(library, "phi2m", "plain", half).size == 0


def test_the_page_says_what_was_found():
    assert results.PAGE.read_text(encoding="utf-8") == results.page(results.kept())


def test_a_result_goes_stale_with_its_own_sources_alone(tmp_path):
    """Its coefficients and the operations it uses, not another primitive's, nor a comment."""
    other = weakened(tmp_path / "a", *WEAKENED["a coefficient's last bits"][:3])
    common = weakened(tmp_path / "b", "galileo_vector.h", r"return a \* b;", "return b * a;")
    new = r"static int gs_new(void) { return 1; }\n\g<0>"
    unused = weakened(tmp_path / "c", "galileo_vector.h", "#elif GS_LANES == 4", new)
    commented = weakened(tmp_path / "d", "galileo_vector.h", r"/\* GS_LANES", "/* Say GS_LANES")
    assert emitted.digest("phi1m", other) != emitted.digest("phi1m")
    assert emitted.digest("phi2m", other) == emitted.digest("phi2m")
    assert emitted.digest("phi2m", common) != emitted.digest("phi2m")
    assert emitted.digest("phi2m", unused) == emitted.digest("phi2m")
    assert emitted.digest("phi2m", commented) == emitted.digest("phi2m")


@pytest.mark.parametrize("name", KERNELS)
def test_the_reference_errs_by_less_than_it_says(name, reference):
    """Held against the definition in Arb balls."""
    x = arguments_of(name, np.random.default_rng(5))
    tried = np.resize(x, libraries.LANES)
    hi, lo = np.empty_like(tried), np.empty_like(tried)
    hard_cases.Measure(name, None, reference).values(tried, hi, lo)
    assert x.size >= libraries.LANES // 2
    for a, head, rest in zip(tried, hi, lo, strict=True):
        value = Fraction(head) + Fraction(rest)
        below, above = sorted(value * (1 + sign * REFERENCE_ERROR) for sign in (1, -1))
        assert certain.sign(name, a, below) > 0 > certain.sign(name, a, above), a.hex()


@pytest.mark.parametrize("name", KERNELS)
def test_the_emitted_code_passes(name, tested, reference):
    """Zero and subnormal numbers, infinity, NaN, -0, and ordinary ones."""
    for first in (0, 0x3F800000, 0x7F7FF800, 0x80000000, 0xBEBC5000, 0xBF800000, 0xFF7FF800, 0xFFFFF000):
        found = sweep.block_result(name, tested, reference, first, 1 << 12)
        assert sum(found["counts"].values()) == 0
        assert found["right"] + found["refused"] + len(found["hard"]) == 1 << 12


def test_a_clean_run_exits_with_0(compiled_once, tmp_path, capsys):
    folder = small_copy(tmp_path / "c")
    assert run.main(["phi1m", "--span", "3f000000:3f020000", "--processes", "1", "--sources", str(folder)]) == 0
    assert " 0 wrong, 0 unsettled, 0 with other bits" in capsys.readouterr().out


@pytest.mark.parametrize(("file", "was", "becomes", "name", "span"), WEAKENED.values(), ids=WEAKENED)
def test_a_weakened_kernel_is_found(compiled_once, file, was, becomes, name, span, tmp_path, capsys):
    folder = weakened(tmp_path / "c", file, was, becomes)
    assert run.main([name, "--span", span, "--processes", "1", "--sources", str(folder)]) == 1
    assert f"  wrong: {name}(" in capsys.readouterr().out


def test_a_wrong_reference_is_noticed(tmp_path, capsys):
    """By 2^-30, which moves one value in about 2^6 across a midpoint."""
    call = ["phi1m", "--span", "3f000000:3f010000", "--processes", "1", "--sources", str(small_copy(tmp_path / "c"))]
    assert run.main([*call, "--shift", "0x1p-30"]) == 1
    assert "  wrong: phi1m(" in capsys.readouterr().out


def test_a_run_goes_on_where_it_stopped(tmp_path, monkeypatch, tested, reference):
    """A block that is done is not tried again; one of other sources is."""
    monkeypatch.setattr(sweep, "BLOCK", 1 << 12)
    state, span = tmp_path / "state.json", (0x3F800000, 0x3F802000)

    def found(sources="one"):
        return sweep.sweep("phi1m", tested, reference, sources, span, state)

    assert found()["right"] == 1 << 13
    kept = json.loads(state.read_text())
    kept["blocks"][str(span[0])]["right"] = 7
    state.write_text(json.dumps(kept))
    assert found()["right"] == (1 << 12) + 7
    assert found("other")["right"] == 1 << 13


@pytest.fixture
def spoiled(tmp_path):
    """Makes a copy of the emitted C with a change in the AVX2 version alone."""
    if "avx2" not in libraries.suffixes():
        pytest.skip("this machine has no AVX2: there is no other version to spoil")
    return lambda change: weakened(tmp_path / "c", "galileo_vector.h", *SPOILED[change])


def test_other_bits_in_one_version_are_found(compiled_once, spoiled, capsys):
    folder = spoiled("a product rounded")
    assert same_bits.main(["phi1m", "--count", "100000", "--sources", str(folder)]) == 1
    _, *examples = capsys.readouterr().out.splitlines()
    assert examples
    assert all("avx2 and " in example for example in examples)


def test_an_exhaustive_run_finds_them_too(compiled_once, spoiled, capsys):
    """Where there is a wider version that is judged."""
    if "avx512" not in libraries.suffixes():
        pytest.skip("this machine has no AVX-512: the AVX2 version is the one that is judged")
    folder = spoiled("a wrong operation")
    assert run.main(["phi1m", "--span", "3f000000:3f001000", "--processes", "1", "--sources", str(folder)]) == 1
    assert " 0 wrong, 0 unsettled, 256 with other bits" in capsys.readouterr().out
