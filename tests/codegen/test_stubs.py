"""The stubs and docstrings of the public functions say what these are."""

import ast
import inspect
import re
from importlib import import_module
from pathlib import Path

import pytest

import galileo_sym.generated
from galileo_sym.catalogue import FUNCTIONS
from galileo_sym.generated._functions import FUNCTIONS as SERVED

GENERATED = Path(galileo_sym.generated.__file__).parent
PAPERS = ("chord", "lambert", "projectile")


def definitions(paper):
    """Every definition of a stub, in order."""
    tree = ast.parse((GENERATED / "stubs" / f"{paper}.pyi").read_text(encoding="utf-8"))
    return [node for node in tree.body if isinstance(node, ast.FunctionDef)]


@pytest.mark.parametrize("paper", PAPERS)
def test_stubs_have_the_signatures_of_the_functions(paper):
    module = import_module(f"galileo_sym.{paper}")
    found = definitions(paper)
    assert sorted({node.name for node in found}) == sorted(module.__all__)
    for node in found:
        expected = inspect.signature(getattr(module, node.name))
        told = ast.unparse(ast.fix_missing_locations(without_types(node.args)))
        assert f"({told})" == str(expected)


def without_types(arguments):
    for one in (*arguments.args, *arguments.kwonlyargs):
        one.annotation = None
    return arguments


def test_the_stub_of_the_extension_has_every_ufunc():
    text = (GENERATED / "_ufuncs.pyi").read_text(encoding="utf-8")
    told = re.findall(r"^(\w+): np\.ufunc$", text, re.MULTILINE)
    served = [name for row in SERVED.values() for names in row["ufuncs"].values() for name in names]
    assert len(set(told)) == len(told)
    assert set(served) <= set(told)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_docstrings_name_arguments_sources_and_bounds(name):
    row = FUNCTIONS[name]
    function = getattr(import_module(f"galileo_sym.{row.paper}"), row.name)
    for part in ("Parameters\n", "Returns\n", "Raises\n", "Notes\n"):
        assert part in function.__doc__
    assert re.search(r"[Cc]laimed bound|1 ulp", function.__doc__)
    assert "paper" in function.__doc__
    taken = [p for p in inspect.signature(function).parameters if p not in ("out", "where", "dtype", "casting")]
    assert taken == [*row.positional, *row.keywords, *row.forces]
    described = re.findall(r"^    ([\w, ]+) : array_like", function.__doc__, re.MULTILINE)
    assert {word for line in described for word in line.split(", ")} == set(taken)
