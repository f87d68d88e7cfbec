"""One ledger for a test process: what one test has derived, the next one need not."""

import pytest

from galileo_sym.ledger import Ledger
from galileo_sym.store import FOLDER


@pytest.fixture(scope="session", autouse=True)
def no_verdicts_of_earlier_runs(tmp_path_factory):
    """Commands run by the tests keep their verdicts in a folder of the session's own."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(FOLDER, str(tmp_path_factory.mktemp("kept")))
        yield


@pytest.fixture(scope="session")
def ledger():
    """The ledger of both papers; entries derive on access."""
    return Ledger.load()


def pytest_addoption(parser):
    parser.addoption(
        "--all-mutants", action="store_true", help="wrong premises for every entry, not for the quick ones"
    )
