"""Progress: what is done of a stage, and the time the others of it take."""

import pytest

from app.progress import Pace, progress


def pace(*times):
    """A pace whose clock shows these times [s], one after the other, and then the last."""
    left = list(times)
    return Pace(lambda: left.pop(0) if len(left) > 1 else left[0])


def test_that_the_time_left_is_that_of_what_is_not_done_of_the_stage():
    counted = pace(10.0, 12.0, 14.0)
    assert counted.left(0, 9, "stage_runs") is None
    assert counted.left(1, 9, "stage_runs") is None  # it waited for the compiler
    assert counted.left(2, 9, "stage_runs") == pytest.approx(14.0)  # 2 s each, seven are left
    assert counted.left(3, 9, "stage_runs") == pytest.approx(12.0)


def test_that_runs_of_the_journal_say_nothing_of_the_time_left():
    counted = pace(100.0, 103.0)
    assert counted.left(20, 23, "stage_runs") is None
    assert counted.left(21, 23, "stage_runs") is None
    assert counted.left(22, 23, "stage_runs") == pytest.approx(3.0)


def test_that_a_new_stage_begins_anew_and_the_last_of_a_stage_leaves_nothing():
    """Checks take twenty times as long as runs: 21 runs in a second said "about 0 s left", then came 21."""
    counted = pace(0.0, 1.0, 50.0, 71.0)
    for done in range(3):
        counted.left(done, 3, "stage_runs")
    assert counted.sentence(0, 2, "stage_checks") == "checks of walls: 0 of 2"
    assert counted.sentence(1, 2, "stage_checks") == "checks of walls: 1 of 2"
    assert counted.left(2, 2, "stage_checks") == 0.0


@pytest.mark.parametrize("terminal", [True, False])
def test_that_progress_is_a_bar_on_a_terminal_and_leaves_nothing_there(
    capsys, monkeypatch, terminal
):
    monkeypatch.setattr("app.progress.cache.lacks_lanes", lambda: False)
    monkeypatch.setattr("sys.stderr.isatty", lambda: terminal, raising=False)
    monkeypatch.setattr("app.progress.BETWEEN_LINES", 0.0)
    with progress(False) as show:
        for done in range(5):
            show(done, 4, "stage_runs")
    said = capsys.readouterr().err
    assert "searches of q: 4 of 4" in said
    assert said.endswith("\r\x1b[K") == terminal and ("█" in said) == terminal
    with progress(True) as show:
        show(0, 4, "stage_runs")
    assert capsys.readouterr().err == ""
