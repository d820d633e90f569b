"""Work in a process of its own: its result, what it raises, and its bounds of time and memory."""

import os
import sys
import time

import pytest

from core.child import Refused, bounded


def test_that_the_result_is_that_of_the_work_and_what_it_raises_is_its_reason():
    assert bounded(divmod, 17, 5, seconds=20.0, megabytes=500) == (3, 2)
    with pytest.raises(Refused) as refused:
        bounded(int, "seventeen", seconds=20.0, megabytes=500)
    assert "seventeen" in refused.value.reason


def test_that_what_ends_its_process_or_has_no_end_takes_nothing_along(capfd):
    begun = time.monotonic()
    for work, given, seconds in ((os.abort, (), 20.0), (time.sleep, (60.0,), 0.5), (os._exit, (3,), 20.0)):
        with pytest.raises(Refused) as refused:
            bounded(work, *given, seconds=seconds, megabytes=500)
        assert refused.value.reason == ""
    assert time.monotonic() - begun < 30.0 and capfd.readouterr() == ("", "")


@pytest.mark.skipif(sys.platform == "win32", reason="the bound of time alone")
def test_that_more_memory_than_it_may_take_is_refused():
    with pytest.raises(Refused):
        bounded(bytes, 2_000_000_000, seconds=20.0, megabytes=500)
