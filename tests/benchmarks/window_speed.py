"""Start of the window, redraws of the dragged history, gaps of the event loop while a study runs and while all
figures are exported, the cost of a key typed with forty records.

python3 run.py bench --window
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.benchmarks.screenshots import settle
from tests.benchmarks.small import small_case
from tests.xvfb import display

ROOT = Path(__file__).resolve().parents[2]

START = """
import time; start = time.perf_counter()
import sys; sys.path.insert(0, sys.argv[1])
from app.look.quick_imports import quicken
quicken()
from PySide6.QtCore import QStandardPaths
QStandardPaths.setTestModeEnabled(True)
from app.shell import start as program
application, window = program.make([])
program.show(window); application.processEvents()
shown = time.perf_counter() - start
window.session.open(program.EXAMPLE); application.processEvents()
assert window.isVisible() and window.tree.rows and window.session.case.wall
print(shown, time.perf_counter() - start)
window.close()
"""


def start_times(place: str, variables: dict[str, str], times_started: int) -> None:
    """Measure the start in processes of this environment, the first one apart."""
    times = []
    for _ in range(times_started):
        found = subprocess.run(
            [sys.executable, "-P", "-c", START, str(ROOT)], check=True, capture_output=True, text=True, env=variables
        )
        times.append([float(word) for word in found.stdout.split()])
    shown, usable = (min(row[k] for row in times[1:] or times) for k in (0, 1))
    print(f"{place}: window visible {shown:.2f} s, on the example and usable {usable:.2f} s")


def drag(application, window, draws: int) -> float:
    """Drag the multiplier of the tab Histories; returns seconds for each history integrated and drawn."""
    from PySide6.QtCore import QEvent, QObject

    page = window.pages["histories"]
    window.navigator.show_page("histories")
    settle(application, lambda: page.isVisible() and page.made is not None)
    tab = page.content
    assert tab.isVisible() and tab.run is not None, "the tab Histories shows no run"
    painted: list[int] = []

    class Watch(QObject):
        def eventFilter(self, watched, event) -> bool:
            if event.type() == QEvent.Type.Paint:
                painted.append(event.type())
            return False

    watch, view = Watch(), tab.rotation.plot.getViewWidget().viewport()
    view.installEventFilter(watch)
    integrated = []
    start = time.perf_counter()
    for k in range(draws):
        tab.slider.setValue(600 + 5 * k)
        application.processEvents()
        integrated.append(tab.history)
    seconds = time.perf_counter() - start
    view.removeEventFilter(watch)
    assert len({id(history) for history in integrated}) == draws, "not every multiplier was integrated"
    assert len(painted) >= draws, f"{len(painted)} of {draws} were drawn"
    return seconds / draws


RECORDS = 40


def case_of_many_records(folder: Path, count: int) -> Path:
    """A wall under so many motions of 20 s, a demand with its spectrum."""
    import numpy as np

    draw, samples = np.random.default_rng(1), 2000
    lines = ['[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nbase_z_m = 0.0\nmechanism = "two_sided"']
    for k in range(count):
        values = 0.15 * draw.standard_normal(samples) * np.hanning(samples)
        (folder / f"motion_{k}.txt").write_text("\n".join(f"{value:.6f}" for value in values))
        lines.append(f'[[record]]\nfile = "motion_{k}.txt"\nunit = "g"\ntime_step_s = 0.01\nkind = "artificial"')
    lines.append("[analysis]\nq_step = 0.05\n[demand]\nag_g = 0.2")
    lines.append('[demand.spectrum]\ncode = "EN1998"\ntype = 1\nsoil = "B"\n')
    path = folder / "many.toml"
    path.write_text("\n".join(lines))
    return path


def typed(application, window, keys: int) -> dict[str, list[float]]:
    """Seconds of this thread for each key typed, by what is in front: forms of the input, pages of the result. The
    paint that follows is counted; every second key makes the result stale, the others give it back."""
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest

    from app.input.fields import NumberField

    found: dict[str, list[float]] = {}
    height = window.walls.fields["height_m"]
    for name in (*window.stages.input.areas, *window.pages):
        field = height
        if name in window.pages:
            window.navigator.show_page(name)
        else:
            window.navigator.show_input(name)
            visible = [
                one
                for one in window.stages.input.forms.currentWidget().findChildren(NumberField)
                if one.isVisible() and one.isEnabled()
            ]
            field = height if height in visible else next(iter(visible), height)
        settle(application, lambda: not getattr(window.pages["note"].made, "is_setting", False))
        field.editor.setFocus()
        field.editor.end(False)
        before, spent = field.editor.text(), []
        for k in range(2 * keys):
            start = time.thread_time()
            QTest.keyClick(field.editor, Qt.Key.Key_1 if k % 2 == 0 else Qt.Key.Key_Backspace)
            application.processEvents()
            seconds = time.thread_time() - start
            assert (field.editor.text() == before) == (k % 2 == 1), f"{field.key} took no key"
            time.sleep(0.012)  # the paint comes by a timer of Qt
            start = time.thread_time()
            application.processEvents()
            spent.append(seconds + time.thread_time() - start)
        found[name] = spent
    return found


def print_typed(application, window, small: bool) -> None:
    """Run a case of forty records, then type."""
    with tempfile.TemporaryDirectory() as folder:
        count = 2 if small else RECORDS
        window.session.open(case_of_many_records(Path(folder), count))
        settle(application, lambda: len(window.records.motions) == count and not window.records.pending)
        window.run()
        settle(application, lambda: window.runner.job is None)
        assert window.session.result is not None
        for name, spent in typed(application, window, 1 if small else 10).items():
            spent.sort()
            print(
                f"a key typed, {count} records, {name} in front: "
                f"median {1e3 * spent[len(spent) // 2]:.1f} ms, worst {1e3 * spent[-1]:.1f} ms"
            )


def main(options: argparse.Namespace) -> None:
    """Print the figures."""
    times_started = 1 if options.small else 6
    if not options.small:
        with display() as variables:
            if isinstance(variables, str):
                print(f"Xvfb: {variables}")
            else:
                start_times("Xvfb", variables, times_started)
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    start_times("offscreen", dict(os.environ, PYTHONPATH=str(ROOT)), times_started)

    from PySide6.QtCore import QStandardPaths, QTimer
    from shiboken6 import isValid

    QStandardPaths.setTestModeEnabled(True)
    from app.shell import start as program
    from app.views.figure_file import FigureSize
    from core.study.journal import Memory

    application, window = program.make([])
    program.show(window)
    with tempfile.TemporaryDirectory() as folder:
        window.session.open(small_case(Path(folder)) if options.small else program.EXAMPLE)
        settle(application, lambda: window.records.motions and not window.records.pending)
        gaps: list[tuple[float, float]] = []
        last = [(time.perf_counter(), time.thread_time())]

        def beat() -> None:
            """The second of a gap is the time of this thread: on a busy machine it says what the first does not."""
            now = time.perf_counter(), time.thread_time()
            gaps.append((now[0] - last[0][0], now[1] - last[0][1]))
            last[0] = now

        def begin() -> None:
            gaps.clear()
            last[0] = time.perf_counter(), time.thread_time()
            timer.start(5)

        def longest() -> str:
            wall, own = (", ".join(f"{1e3 * g:.0f}" for g in sorted(one)[-3:]) for one in zip(*gaps, strict=True))
            return f"longest gaps of the event loop {wall} ms, of its own time {own} ms"

        timer = QTimer()
        timer.timeout.connect(beat)

        def run() -> None:
            window.session.result = None
            window.runner.finished_runs = Memory()
            window.run()
            assert window.runner.job is not None, "the study did not start"

        for round_ in ("first run, kernels loaded on the way", "second run"):
            begin()
            run()
            settle(application, lambda: window.runner.job is None)
            timer.stop()
            assert window.session.result is not None and window.runner.finished_runs.analyses > 0
            print(f"{round_}: {longest()}")
        window.preparation.begin()  # as the program does when it starts
        settle(application, lambda: window.preparation.job is None)
        folder_of_figures = Path(folder) / "figures"
        folder_of_figures.mkdir()
        began = time.perf_counter()
        begin()
        window.files.export_figures(folder_of_figures, FigureSize())
        settle(application, lambda: window.runner.job is None)
        timer.stop()
        count, seconds = len(list(folder_of_figures.iterdir())), time.perf_counter() - began
        assert count >= 5, "the figures were not written"
        print(f"{count} figures of 300 dpi exported in {seconds:.1f} s: {longest()}")
        each = drag(application, window, 5 if options.small else 120)
        print(f"dragged multiplier: {1.0 / each:.0f} histories integrated and drawn per second")
        if options.small:  # else it may be over before it is cancelled
            window.session.edit_section("analysis", q_step=1e-4)
        for _ in range(9):
            run()
            job = window.runner.job
            settle(application, lambda: window.stages.bar.maximum() > 0 or window.runner.job is None)
            if window.runner.job is job:
                break
        assert job is not None and window.runner.job is job, "the study was finished before it could be cancelled"
        start = time.perf_counter()
        window.runner.cancel()
        settle(application, lambda: window.runner.job is None)
        free = time.perf_counter() - start
        settle(application, lambda: not isValid(job) or job.isFinished())
        ended = time.perf_counter() - start
        assert window.session.result is None, "it was not cancelled"
        print(f"cancelled after {1e3 * free:.0f} ms, its thread ended after {1e3 * ended:.0f} ms")
        print_typed(application, window, options.small)
        window.session.saved = window.session.case
        window.close()
