"""Jobs of the window: left at once, nothing of them arrives, what is finished is used again."""

import threading
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QMessageBox

from core.study.journal import MemoryJournal
from tests.app.driving import Held, run, settle


def two_walls(opened) -> None:
    """A second wall beside that of the case, nothing of either computed before."""
    wall = opened.session.case.wall[0]
    opened.session.edit(replace(opened.session.case, wall=(wall, replace(wall, name="second", height_m=5.5))))
    opened.runner.finished_runs = MemoryJournal()


def run_until_cancelled(opened, application, signal) -> None:
    """Run the case; the first of this signal of the runner cancels it."""
    signal.connect(opened.runner.cancel)
    opened.run()
    settle(application, lambda: opened.runner.job is None)
    signal.disconnect(opened.runner.cancel)


def test_that_a_job_that_cannot_stop_is_left_at_once_and_nothing_of_it_arrives(opened, application):
    from app.work.worker import RUNNING_JOBS

    goes_on, arrived = threading.Event(), []
    opened.runner.start(lambda job: goes_on.wait(60), arrived.append)
    left = opened.runner.job
    opened.runner.cancel()
    assert opened.runner.job is None and opened.word.text() == "Cancelled."
    assert opened.run_action.isEnabled()
    run(application, opened)  # another runs beside it
    assert opened.session.result is not None and left in RUNNING_JOBS
    goes_on.set()
    settle(application, lambda: left not in RUNNING_JOBS)
    assert arrived == []


@pytest.mark.shows("window.reuse")
def test_that_finished_runs_are_used_again(opened, application, monkeypatch):
    from core.study import wall_tasks

    opened.runner.finished_runs = MemoryJournal()
    run(application, opened)
    first = opened.session.result
    opened.session.edit(replace(opened.session.case, title="another"))
    monkeypatch.setattr(wall_tasks, "incremental_dynamic_analyses", lambda *_: pytest.fail("again"))
    run(application, opened)
    assert opened.session.result is not first
    assert opened.session.result.walls == first.walls


def test_that_an_export_cancelled_before_it_writes_leaves_no_file(opened, application, tmp_path, monkeypatch):
    from app.work.worker import RUNNING_JOBS
    from core.report.workbook import WorkbookReport

    run(application, opened)
    held = Held(monkeypatch, WorkbookReport, "content")
    (tmp_path / "out").mkdir()
    opened.files.export(tmp_path / "out" / "small.xlsx")
    held.await_call()
    opened.runner.cancel()
    held.let_go()
    settle(application, lambda: not RUNNING_JOBS)
    assert list((tmp_path / "out").iterdir()) == []


def test_that_an_export_that_writes_is_not_said_to_be_cancelled(opened, application, tmp_path, monkeypatch):
    from core import atomic_write

    run(application, opened)
    held = Held(monkeypatch, atomic_write, "write")
    opened.files.export(tmp_path / "small.xlsx")
    held.await_call()
    opened.runner.cancel()
    assert opened.runner.job is not None
    held.let_go()
    settle(application, lambda: opened.runner.job is None)
    assert (tmp_path / "small.xlsx").exists() and (tmp_path / "small.json").exists()


def test_that_kernels_of_a_method_chosen_later_are_made_ready_and_a_failure_is_said(opened, application, monkeypatch):
    from core.study import run as study

    asked = []

    def warm(case, motion):
        asked.append(case.analysis.method)
        if case.analysis.method == "rk4":
            raise RuntimeError("no compiler")

    monkeypatch.setattr(study, "warm_kernels", warm)
    opened.preparation.begin()
    settle(application, lambda: opened.preparation.job is None)
    opened.session.edit_section("analysis", method="rk4")
    settle(application, lambda: opened.preparation.job is None)
    assert asked == ["auto", "rk4"]
    assert "no compiler" in opened.word.text()
    opened.session.edit_section("analysis", q_step=0.03)
    assert opened.preparation.job is None


def test_that_another_case_opens_with_its_first_wall(opened, application):
    opened.walls.duplicate()
    assert opened.walls.current == 1
    opened.files.open(opened.session.path)
    assert opened.walls.current == 0


def test_that_a_window_closed_while_files_are_written_goes_when_they_are_there(
    opened, application, tmp_path, monkeypatch
):
    from core import atomic_write

    run(application, opened)
    held = Held(monkeypatch, atomic_write, "write")
    opened.files.export(tmp_path / "small.xlsx")
    held.await_call()
    assert not opened.close() and opened.isVisible()
    held.let_go()
    settle(application, lambda: not opened.isVisible())
    assert (tmp_path / "small.xlsx").exists()


def test_that_a_failed_export_keeps_a_closing_window_open_to_say_so(opened, application, tmp_path, monkeypatch):
    from core import atomic_write
    from core.errors import OutputError

    said = []
    run(application, opened)

    def full(files):
        raise OutputError("picture_not_made")

    held = Held(monkeypatch, atomic_write, "write", full)
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    opened.files.export(tmp_path / "small.xlsx")
    held.await_call()
    opened.close()
    held.let_go()
    settle(application, lambda: opened.runner.job is None)
    assert said == ["The picture cannot be created."] and opened.isVisible()


def test_that_a_finished_job_is_kept_by_nobody(opened, application):
    import gc
    import weakref

    from app.work.worker import RUNNING_JOBS

    class Result:
        pass

    held = []
    opened.runner.start(lambda job: Result(), lambda result: held.append(weakref.ref(result)))
    settle(application, lambda: opened.runner.job is None and not RUNNING_JOBS)
    gc.collect()
    assert held[0]() is None


def test_that_the_accuracy_statement_survives_a_save(opened, application, monkeypatch, accuracy):
    from core.study import wall_tasks

    run(application, opened)
    held = Held(monkeypatch, wall_tasks, "make_accuracy_statement", lambda *_: accuracy)
    opened.runner.state_accuracy(opened.navigator.shown)
    held.await_call()
    opened.files.save()
    held.let_go()
    settle(application, lambda: opened.runner.job is None)
    assert opened.session.result.walls[0].accuracy is accuracy


def test_that_results_saved_after_the_run_name_the_file(opened, application, tmp_path):
    import hashlib

    opened.session.edit(replace(opened.session.case, title="another"))
    run(application, opened)
    path = tmp_path / "elsewhere" / "saved.toml"
    path.parent.mkdir()
    opened.session.save(path)
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    assert not opened.session.stale
    assert opened.session.result.case.sha256 == digest
    # a title decides no number: the result goes on with it
    opened.session.edit(replace(opened.session.case, title="not run"))
    opened.session.save()
    assert not opened.session.stale
    assert opened.session.result.case.sha256 == hashlib.sha256(path.read_bytes()).hexdigest() != digest


def test_that_the_memory_of_runs_is_bounded_and_takes_many_threads():
    from core.study.journal import MemoryJournal

    memory = MemoryJournal(most=1000)

    def add(first: int) -> None:
        for k in range(2000):
            memory.add(f"{first} {k}", {"analyses": 1, "outcomes": "0" * 30})

    threads = [threading.Thread(target=add, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert memory.size == 30 * len(memory.found) <= 1000


def test_that_the_clock_goes_on_while_nothing_is_told_and_the_time_left_shrinks(opened, application, monkeypatch):
    from app.work import runner

    said, now = [], [100.0]
    monkeypatch.setattr(runner.time, "monotonic", lambda: now[0])
    opened.runner.progressed.connect(lambda *words: said.append(words[2]))
    goes_on = threading.Event()
    opened.runner.start(lambda job: goes_on.wait(60), lambda _: None)
    opened.runner._tick()
    assert said == []  # nothing is known yet
    opened.runner._told_at = 0.0
    opened.runner._progressed(3, 10, 20.0)
    for now[0], words in ((103.0, "3 of 10, 3 s, about 17 s left"), (119.9, "3 of 10, 20 s, about 1 s left")):
        opened.runner._tick()
        assert said[-1] == words
    goes_on.set()
    settle(application, lambda: opened.runner.job is None)
    assert not opened.runner.ticks.isActive()


def test_that_the_walls_a_cancelled_run_has_finished_stay_until_the_input_changes(opened, application):
    two_walls(opened)
    run_until_cancelled(opened, application, opened.runner.found)
    tab = opened.pages["walls"].content
    assert opened.navigator.page == "walls" and tab.words.text().startswith("Cancelled, walls finished: ")
    assert tab.table.rowCount() == 1 and not opened.stages.veil.isVisible()
    opened.navigator.show_stage("input")
    opened.navigator.show_page("walls")
    assert tab.table.rowCount() == 1
    opened.session.edit_wall(0, height_m=6.0)
    opened.navigator.show_page("walls")
    again = opened.pages["walls"].content
    assert "Cancelled" not in again.words.text() and again.table.rowCount() == 0


def test_that_a_wall_that_is_judged_is_read_while_others_run(opened, application):
    two_walls(opened)
    seen = []

    def look() -> None:
        if opened.runner.finished_results and not seen:
            opened.walls.select(0)
            opened.navigator.show_page("check")
            tab = opened.pages["check"].content
            seen.append((tab.heading.text(), opened.stages.veil.isVisible(), sorted(opened.runner.finished_results)))

    opened.runner.judged.connect(look)
    run(application, opened)
    opened.runner.judged.disconnect(look)
    ((heading, veiled, rows),) = seen
    assert rows == [0] and not veiled
    opened.navigator.pick(opened.navigator.results_of()[0][0])
    assert heading == opened.pages["check"].content.heading.text() != ""


def test_that_no_wall_of_an_earlier_input_is_read_as_judged(opened, application):
    """Edited while it runs: its answer is covered, the tree says nothing of it, and a cancel leaves nothing."""
    two_walls(opened)
    seen = []

    def edit() -> None:
        row = next(iter(opened.runner.finished_results))
        opened.walls.select(row)
        opened.navigator.show_page("check")
        opened.session.edit_wall(row, thickness_m=0.2)
        application.processEvents()
        covered = opened.stages.veil.isVisible() or opened.pages["check"].made is None
        seen.append((covered, opened.navigator._finished))
        opened.runner.cancel()

    opened.runner.judged.connect(edit)
    opened.run()
    settle(application, lambda: opened.runner.job is None)
    opened.runner.judged.disconnect(edit)
    assert set(seen) == {(True, None)}
    opened.navigator.show_page("walls")
    assert "Cancelled" not in opened.pages["walls"].content.words.text() and not opened.navigator.parts


def test_that_a_wall_a_cancelled_run_has_judged_is_opened_from_the_table(opened, application):
    two_walls(opened)
    run_until_cancelled(opened, application, opened.runner.judged)
    tab = opened.pages["walls"].content
    tab._picked(tab.finished_rows.index(0))
    assert opened.navigator.page == "check" and not opened.stages.veil.isVisible()
    assert opened.pages["check"].content.heading.text().startswith("w: ")
    opened.set_choice("theme", "dark")
    opened.navigator.show_page("walls")
    assert opened.pages["walls"].content.words.text().startswith("Cancelled, walls finished: ")
