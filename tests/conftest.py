"""One ledger for a test process: what one test has derived, the next one need not."""

import os

import pytest

from galileo_sym import catalogue
from galileo_sym.store import FOLDER


@pytest.fixture(scope="session", autouse=True)
def no_verdicts_of_earlier_runs(tmp_path_factory):
    """Commands run by the tests keep their verdicts and compiled C in a folder of the session's own."""
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "kept"  # the workers share it
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(FOLDER, str(folder))
        yield


@pytest.fixture(scope="session")
def ledger():
    """The ledger of both papers, that which is emitted from; entries derive on access."""
    return catalogue.ledger()


def pytest_addoption(parser):
    parser.addoption(
        "--all-mutants", action="store_true", help="wrong premises for every entry, not for the quick ones"
    )
