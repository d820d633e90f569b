"""The ground of the tests of the search."""

import pytest


@pytest.fixture(scope="session")
def ground(reference):
    return reference("standard")[0]
