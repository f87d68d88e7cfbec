"""Tests of one group run in one process; without that what they share is made in each."""

import os

import pytest


@pytest.mark.skipif("PYTEST_XDIST_WORKER" not in os.environ, reason="one process runs all tests")
@pytest.mark.xdist_group("groups")
def test_groups_are_kept_together(request):
    """The runner sees groups by the end of a test's id; pytest 9.2 with pytest-xdist 3.8 spreads them silently."""
    assert request.node.nodeid.endswith("@groups")
