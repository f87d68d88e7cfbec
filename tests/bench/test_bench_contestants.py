"""Contestants: what they compute is right within their class; what is missing is said."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from galileo_sym.bench.accuracy import judge, take
from galileo_sym.bench.cases import SPECIAL, TYPICAL, cases
from galileo_sym.bench.contestants import References, ours
from galileo_sym.bench.peers import build
from galileo_sym.bench.peers.source import MARK, source, symbol_of
from galileo_sym.bench.printed import printed, symbols
from galileo_sym.libraries import NoCompilerError, find_compiler

pytest.importorskip("scipy")  # an extra
from galileo_sym.bench.typed import SCIPY, Lambdified, SciPy

pytestmark = pytest.mark.xdist_group("catalogue")

POINTS = 8
ANY_DRAG = 1e8  # ulp: what printed formulas may lose on typical inputs
OWN = """
#include <math.h>
#include <stddef.h>
static double newton(double w, double x) {
    for (int j = 0; j < 60; j++) { double e = exp(w), f = w * e - x, s = e * (w + 1); if (s != 0) w -= f / s; }
    return w;
}
static double W0(double x) { return newton(x > 1 ? log(x) : 0.5 * x, x); }
static double Wm1(double x) { double l = log(-x); return newton(l - log(-l), x); }
"""


@pytest.fixture(scope="module")
def missing():
    return []


@pytest.fixture(scope="module")
def contestants(missing):
    return [*ours(missing.append), Lambdified(), SciPy()]


def limit(one, case):
    if isinstance(one, (Lambdified, SciPy)):
        return ANY_DRAG
    return 2.0 if case.paper == SPECIAL and not one.single else 1.0


def test_each_is_right_within_its_class(contestants):
    for case in cases().values():
        samples = {single: take(case, POINTS, single) for single in (False, True)}
        for one in contestants:
            typed = isinstance(one, (Lambdified, SciPy))
            if not one.serves(case) or (typed and case.stratum != TYPICAL):
                continue
            error = judge(one.results(case, samples[one.single].arguments), samples[one.single])
            assert error.ulp <= limit(one, case), (case.key, one.name)
            assert typed or not error.lost, (case.key, one.name)


def test_ours_are_all_there_or_said_to_be_missing(contestants, missing):
    names = {one.name for one in contestants}
    assert {"NumPy", "NumPy, float32", References.name, "lambdify", "SciPy"} <= names
    assert ({"C", "C, float32"} <= names) != bool(missing)


def test_numbers_serve_as_arrays_do(contestants):
    case = cases()["chord.distance friction_drag"]
    arguments = case.points(POINTS) | {"g": 9.81, "mu": 0.1, "gamma": 0.5}
    full = {name: np.broadcast_to(x, POINTS).copy() for name, x in arguments.items()}
    for one in contestants:
        if one.serves(case) and one.takes_numbers(case):
            found = one.prepare(case, arguments)()
            expected = one.prepare(case, full)()
            assert np.array_equal(np.ravel(found), np.ravel(expected)), one.name


def test_printed_formulas_are_in_the_arguments_alone():
    for case in cases().values():
        forms = printed(case.full_name, case.force_set)
        assert len(forms) in (0, len(case.outputs))
        assert {s.name for form in forms for s in form.free_symbols} <= set(symbols(case)), case.key
    without = {case.key for case in cases().values() if not printed(case.full_name, case.force_set)}
    assert without == {
        "projectile.range_slope_k free",
        "projectile.launch_angles drag",
        "projectile.launch_angles drag tiny-drag",
    }


def test_what_scipy_has_are_cases():
    assert set(SCIPY) <= {(case.full_name, case.force_set) for case in cases().values()}


# --- peers -----------------------------------------------------------------------------------------------------------


def test_a_source_has_every_kernel_and_no_mark():
    """In Rust; C is compiled below."""
    kernels = build.kernels_of(cases().values())
    text = source(build.HERE / "lambert_w.rs", kernels)
    assert MARK not in text
    assert len({symbol_of(case) for case in kernels}) == len(kernels) > 40
    assert all(text.count(f" {symbol_of(case)}(") == 1 for case in kernels)
    assert all((build.HERE / peer.template).read_text().count(f"\n{MARK}\n") == 1 for peer in build.PEERS)


def test_compiled_formulas_are_the_printed_ones(tmp_path):
    """With a W of the test's own in the place of another library's."""
    try:
        compiler = find_compiler()
    except NoCompilerError as cause:
        pytest.skip(str(cause))
    (tmp_path / "own.c").write_text(OWN + MARK)
    names = ("chord.descent_time drag", "chord.position friction", "projectile.best_angle", "lambert.wm1")
    chosen = [cases()[name] for name in names]
    text = source(tmp_path / "own.c", chosen)
    peer = build.Peer("own", "own.c", (*compiler, "-O1", "-fPIC", "-shared"), ("-lm",), "")
    compiled = build.Compiled(peer, build.with_compiler(peer, text, tmp_path), chosen)
    for case in chosen:
        sample = take(case, POINTS)
        assert compiled.serves(case)
        assert judge(compiled.results(case, sample.arguments), sample).ulp <= ANY_DRAG
    assert not compiled.serves(cases()["chord.distance drag"])


def test_missing_peers_are_said_with_what_to_install(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    said = []
    assert build.peers([cases()["lambert.w0"]], said.append) == []
    assert [sentence.split(":")[0] for sentence in said] == [peer.name for peer in build.PEERS]
    assert all("install" in sentence for sentence in said)


def test_a_peer_that_does_not_compile_is_said(monkeypatch):
    failing = build.Peer("none", "gsl.c", ("false",), (), "install something")
    monkeypatch.setattr(build, "PEERS", (failing,))
    said = []
    assert build.peers([cases()["lambert.w0"]], said.append) == []
    assert "none: false exits with 1" in said[0]
    assert not list(Path(build.cache_folder() / "peers").glob("*.so"))
