"""What the rules of a case hold to be there."""

import pytest

from core.known import require_value


def test_that_what_is_there_is_itself_and_what_is_missing_is_a_fault():
    assert require_value(0.0) == 0.0 and require_value("") == ""
    with pytest.raises(TypeError):
        require_value(None)
