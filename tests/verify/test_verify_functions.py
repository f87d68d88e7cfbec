"""The table of verified functions agrees with the catalogue of emitted ones; verify itself never imports that."""

import subprocess
import sys

import pytest

from galileo_sym import catalogue
from galileo_sym.verify.functions import FUNCTIONS


def test_every_emitted_function_is_verified():
    assert set(FUNCTIONS) == set(catalogue.FUNCTIONS)


@pytest.mark.parametrize("name", list(FUNCTIONS))
def test_arguments_outputs_and_force_sets_are_those_of_the_catalogue(name):
    verified, emitted = FUNCTIONS[name], catalogue.FUNCTIONS[name]
    assert (verified.positional, verified.keywords) == (tuple(emitted.positional), tuple(emitted.keywords))
    assert verified.outputs == tuple(output.name for output in emitted.outputs)
    emitted_sets = {force_set or "all": tuple(forces) for force_set, (forces, _) in emitted.variants.items()}
    assert verified.force_sets == emitted_sets


def test_absent_forces():
    distance = FUNCTIONS["chord.distance"]
    assert distance.absent_forces("free") == ("mu", "gamma")
    assert distance.absent_forces("drag") == ("mu",)
    assert distance.absent_forces("friction_drag") == ()
    assert distance.arguments("friction_drag") == ("t", "theta", "g", "mu", "gamma")
    assert FUNCTIONS["projectile.best_angle"].absent_forces("all") == ()


def test_references_do_not_import_what_they_check():
    script = (
        "import sys, galileo_sym.verify.reference, galileo_sym.verify.measure\n"
        "bad = [m for m in sys.modules if m.startswith(('sympy', 'galileo_sym.primitives', 'galileo_sym.codegen',"
        " 'galileo_sym.catalogue', 'galileo_sym.generated', 'galileo_sym.chord',"
        " 'galileo_sym.lambert', 'galileo_sym.projectile'))]\n"
        "print(bad)\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
