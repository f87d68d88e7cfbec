"""Certificates made with few points."""

import pytest
from verify_few_points import POINTS, verify


@pytest.fixture
def few_points(monkeypatch):
    """A certificate begins with so few points."""
    monkeypatch.setattr("galileo_sym.verify.run.DEFAULT_POINTS", POINTS)


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "certificates"


@pytest.fixture
def certified(folder, few_points):
    code, text = verify(folder, update=True)
    assert code == 0, text
    return folder
