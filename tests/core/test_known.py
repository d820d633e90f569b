"""What the rules of a case hold to be there."""

import pytest

from core.known import known


def test_that_what_is_there_is_itself_and_what_is_missing_is_a_fault():
    assert known(0.0) == 0.0 and known("") == ""
    with pytest.raises(TypeError):
        known(None)
