"""Jobs of the window: left at once, nothing of them arrives, what is finished is used again."""

import threading
from dataclasses import replace

import pytest

from tests.app.driving import run, settle


def test_that_a_job_that_cannot_stop_is_left_at_once_and_nothing_of_it_arrives(opened, application):
    from app.worker import RUNNING

    goes_on, arrived = threading.Event(), []
    opened.start(lambda job: goes_on.wait(60), arrived.append)
    left = opened.job
    opened.cancel()
    assert opened.job is None and opened.word.text() == "Cancelled."
    assert opened.run_action.isEnabled()
    run(application, opened)  # another runs beside it
    assert opened.session.result is not None and left in RUNNING
    goes_on.set()
    settle(application, lambda: left not in RUNNING)
    assert arrived == []


def test_that_finished_runs_are_used_again(opened, application, monkeypatch):
    from core import study

    run(application, opened)
    first = opened.session.result
    opened.session.edit(replace(opened.session.case, title="another"))
    monkeypatch.setattr(study, "incremental_dynamic_analysis", lambda *_: pytest.fail("again"))
    run(application, opened)
    assert opened.session.result is not first
    assert opened.session.result.walls == first.walls


def test_that_an_export_cancelled_before_it_writes_leaves_no_file(
    opened, application, tmp_path, monkeypatch
):
    from app.worker import RUNNING
    from core.report import workbook

    run(application, opened)
    reached, goes_on = threading.Event(), threading.Event()
    real = workbook.content

    def slow(*arguments):
        reached.set()
        goes_on.wait(60)
        return real(*arguments)

    monkeypatch.setattr(workbook, "content", slow)
    (tmp_path / "out").mkdir()
    opened.files.export(tmp_path / "out" / "small.xlsx")
    assert reached.wait(60)
    opened.cancel()
    goes_on.set()
    settle(application, lambda: not RUNNING)
    assert list((tmp_path / "out").iterdir()) == []


def test_that_an_export_that_writes_is_not_said_to_be_cancelled(
    opened, application, tmp_path, monkeypatch
):
    from core.report import atomic

    run(application, opened)
    reached, goes_on = threading.Event(), threading.Event()
    real = atomic.write

    def slow(files):
        reached.set()
        goes_on.wait(60)
        real(files)

    monkeypatch.setattr(atomic, "write", slow)
    opened.files.export(tmp_path / "small.xlsx")
    assert reached.wait(60)
    opened.cancel()
    assert opened.job is not None
    goes_on.set()
    settle(application, lambda: opened.job is None)
    assert (tmp_path / "small.xlsx").exists() and (tmp_path / "small.json").exists()


def test_that_kernels_of_a_method_chosen_later_are_made_ready_and_a_failure_is_said(
    opened, application, monkeypatch
):
    from core import study

    asked = []

    def warm(case, motion):
        asked.append(case.analysis.method)
        if case.analysis.method == "rk4":
            raise RuntimeError("no compiler")

    monkeypatch.setattr(study, "warm", warm)
    opened.keep_warm()
    settle(application, lambda: opened.warming is None)
    opened.session.edit_section("analysis", method="rk4")
    settle(application, lambda: opened.warming is None)
    assert asked == ["auto", "rk4"]
    assert "no compiler" in opened.word.text()
    opened.session.edit_section("analysis", q_step=0.03)
    assert opened.warming is None


def test_that_another_case_opens_with_its_first_wall(opened, application):
    opened.walls.duplicate()
    assert opened.walls.current == 1
    opened.files.open(opened.session.path)
    assert opened.walls.current == 0
