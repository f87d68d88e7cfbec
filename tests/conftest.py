"""One ledger for a test process: what one test has derived, the next one need not."""

import pytest

from galileo_sym.ledger import Ledger


@pytest.fixture(scope="session")
def ledger():
    """The ledger of both papers; entries derive on access."""
    return Ledger.load()


def pytest_addoption(parser):
    parser.addoption(
        "--all-mutants", action="store_true", help="wrong premises for every entry, not for the quick ones"
    )
