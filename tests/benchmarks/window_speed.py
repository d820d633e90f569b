"""Start of the window, redraws of the dragged history, gaps of the event loop while a study runs and while all
figures are exported, the cost of a key typed with forty records, and with a place and 1 or 200 walls that of a key, of
the first view of each page, of opening and of the theme: time of the window's thread, in ms and in turns of a loop.

python3 run.py bench --window
python3 run.py bench --window --against OTHER_TREE     # the starts of both trees in turn
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.benchmarks.inputs import Command
from tests.benchmarks.screenshots import settle
from tests.benchmarks.short_case import short_case
from tests.xvfb import display

ROOT = Path(__file__).resolve().parents[2]

START = """
import time; start = time.perf_counter()
import sys; sys.path.insert(0, sys.argv[1])
try:
    from app.look.quick_imports import quicken
    quicken()
    from app.shell import start as program
except ImportError:  # before 0.10
    from app.quick_imports import quicken
    quicken()
    from app import start as program
from PySide6.QtCore import QStandardPaths
QStandardPaths.setTestModeEnabled(True)
application, window = program.make([])
program.show(window); application.processEvents()
shown = time.perf_counter() - start, time.process_time()
window.session.open(program.EXAMPLE); application.processEvents()
assert window.isVisible() and window.session.case.wall
print(*shown, time.perf_counter() - start, time.process_time())
window.close()
"""


def started(variables: dict[str, str], tree: Path = ROOT) -> list[float]:
    """Seconds of a start of the window of a tree, to its first show and to the example: of the clock, of the processor,
    twice."""
    command = [sys.executable, "-P", "-c", START, str(tree)]
    variables = variables | {"PYTHONPATH": str(tree)}
    found = subprocess.run(command, check=True, capture_output=True, text=True, env=variables, cwd=tree)
    return [float(word) for word in found.stdout.split()]


def start_times(place: str, variables: dict[str, str], times_started: int) -> None:
    """Measure the start in processes of this environment, the first one apart."""
    times = [started(variables) for _ in range(times_started)]
    shown, own, usable, own_usable = (min(row[k] for row in times[1:] or times) for k in range(4))
    print(
        f"{place}: window visible {shown:.2f} s (of the processor {own:.2f} s), "
        f"on the example and usable {usable:.2f} s ({own_usable:.2f} s)"
    )


def start_against(tree: Path, variables: dict[str, str], pairs: int) -> None:
    """The processor time of the starts of two trees, in turn."""
    times = []
    for k in range(pairs + 1):  # the first pair apart
        found = {one: started(variables, one) for one in ((ROOT, tree) if k % 2 else (tree, ROOT))}
        times += [(found[ROOT], found[tree])] if k else []
    for words, k in (("to the first show", 1), ("to the example", 3)):
        here, there = ([pair[n][k] for pair in times] for n in (0, 1))
        ratios = sorted(a / b for a, b in zip(here, there, strict=True))
        print(
            f"processor {words}: median {statistics.median(here):.3f} s, least {min(here):.3f} s, "
            f"{tree.name} {statistics.median(there):.3f} s and {min(there):.3f} s, "
            f"ratio {statistics.median(ratios):.3f} ({ratios[0]:.3f} to {ratios[-1]:.3f}, {pairs} pairs)"
        )


def turn() -> float:
    """Seconds of this thread that a loop of a million additions takes: by it machines compare."""

    def loop() -> float:
        start, total = time.thread_time(), 0
        for k in range(1_000_000):
            total += k
        return time.thread_time() - start

    return min(loop() for _ in range(3))


def said(*seconds: float) -> str:
    """Median and most of such times of this thread in ms, and in turns of the loop as it is just then."""
    one = turn()
    words = [f"{1e3 * each:.1f} ms ({each / one:.2f})" for each in (statistics.median(seconds), max(seconds))]
    return f"median {words[0]}, worst {words[1]}" if len(seconds) > 1 else words[0]


class Gaps:
    """Gaps between two turns of the event loop, while a timer of 5 ms beats."""

    def __init__(self):
        from PySide6.QtCore import QTimer

        self.gaps: list[tuple[float, float]] = []
        self.last = (0.0, 0.0)
        self.timer = QTimer()
        self.timer.timeout.connect(self._beat)

    def _beat(self) -> None:
        """The second of a gap is the time of this thread: on a busy machine it says what the first does not."""
        now = time.perf_counter(), time.thread_time()
        self.gaps.append((now[0] - self.last[0], now[1] - self.last[1]))
        self.last = now

    def begin(self) -> None:
        self.gaps = []
        self.last = time.perf_counter(), time.thread_time()
        self.timer.start(5)

    def end(self) -> str:
        """The longest of them."""
        self.timer.stop()
        wall, own = (", ".join(f"{1e3 * g:.0f}" for g in sorted(one)[-3:]) for one in zip(*self.gaps, strict=True))
        return f"longest gaps of the event loop {wall} ms, of its own time {own} ms"


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


WALLS = (1, 200)


def case_of_walls(folder: Path, count: int) -> Path:
    """So many walls at a place, under one motion of 6 s."""
    path = short_case(folder)
    walls = (
        f'[[wall]]\nname = "w{k}"\nheight_m = {4.0 + 0.01 * k:.2f}\nthickness_m = 0.4\nlength_m = 4.0\n'
        f'base_z_m = 0.0\nmechanism = "two_sided"\n'
        for k in range(count)
    )
    head = '[site]\nmunicipality = "L\'Aquila"\nprovince = "AQ"\n[demand.spectrum]\ncode = "NTC2018"\nsoil = "B"\n'
    head += 'topography = "T1"\n[building]\nheight_m = 14.0\nstoreys = 4\n[analysis]\nq_step = 0.05\n'
    records = path.read_text().partition("[[record]]")[2].partition("[analysis]")[0]
    path.write_text(f"{''.join(walls)}[[record]]{records}{head}")
    return path


def settled(application, window) -> None:
    """Its records are read, no note is being set."""
    settle(application, lambda: window.records.motions and not window.records.pending)
    settle(application, lambda: not getattr(window.pages["note"].made, "is_setting", False))


def own_time(application, act) -> float:
    """Seconds of this thread for what is done and for the events and the paint that follow."""
    start = time.thread_time()
    act()
    application.processEvents()
    spent = time.thread_time() - start
    for _ in range(2):
        time.sleep(0.012)  # the paint comes by a timer of Qt
        start = time.thread_time()
        application.processEvents()
        spent += time.thread_time() - start
    return spent


def typed(application, window, keys: int) -> dict[str, tuple[list[float], list[float]]]:
    """Seconds of this thread for each key typed, and for what follows when the hand rests after it, by what is in
    front: forms of the input, pages of the result. The paint that follows is counted; every second key makes the
    result stale, the others give it back."""
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest

    from app.input.number_fields import NumberField
    from app.look.case_views import TYPING_PAUSE_MS

    found = {}
    height, town = window.walls.fields["height_m"], window.demand.place.municipality
    places = {"municipality": "demand"} if window.session.case.site else {}
    for name in (*window.stages.input.areas, *places, *window.pages):
        field = height
        if name in window.pages:
            window.navigator.show_page(name)
        else:
            window.navigator.show_input(places.get(name, name))
            visible = [
                one
                for one in window.stages.input.forms.currentWidget().findChildren(NumberField)
                if one.isVisible() and one.isEnabled()
            ]
            field = town if name in places else height if height in visible else next(iter(visible), height)
        settled(application, window)
        field.editor.setFocus()
        field.editor.end(False)
        before, spent, rests = field.editor.text(), [], []
        for k in range(2 * keys):
            key = Qt.Key.Key_1 if k % 2 == 0 else Qt.Key.Key_Backspace
            spent.append(own_time(application, lambda key=key, to=field.editor: QTest.keyClick(to, key)))
            assert (field.editor.text() == before) == (k % 2 == 1), f"{field.key} took no key"
            time.sleep(1e-3 * TYPING_PAUSE_MS)
            rests.append(own_time(application, lambda: None))
        found[name] = spent, rests
    return found


def print_typed(application, window, words: str, keys: int) -> None:
    """Type into each form, and beside each page."""
    for name, (spent, rests) in typed(application, window, keys).items():
        print(f"a key typed, {words}, {name} in front: {said(*spent)}; the hand rests: {said(*rests)}")


def print_many_records(application, window, count: int, keys: int) -> None:
    """Run a case of so many records, then type."""
    with tempfile.TemporaryDirectory() as folder:
        window.session.open(case_of_many_records(Path(folder), count))
        settle(application, lambda: len(window.records.motions) == count and not window.records.pending)
        window.run()
        settle(application, lambda: window.runner.job is None)
        assert window.session.result is not None
        print_typed(application, window, f"{count} records", keys)


def print_walls(application, window, count: int, keys: int) -> None:
    """A case of so many walls at a place: opened, run, each page seen for the first time, typed into, in the other
    theme, kept for a crash."""
    with tempfile.TemporaryDirectory() as folder:
        path, words = case_of_walls(Path(folder), count), f"{count} walls with a place"

        def open_case() -> None:
            window.start_afresh(lambda: window.session.open(path))

        print(f"{words} opened: {said(own_time(application, open_case))}")
        settled(application, window)
        gaps = Gaps()
        gaps.begin()
        window.run()
        settle(application, lambda: window.runner.job is None, 600.0)
        print(f"{words}, a run: {gaps.end()}")
        assert window.session.result is not None and len(window.session.result.verdicts) == count
        for name, page in window.pages.items():
            window.navigator.show_input("wall")
            page.empty()
            window.navigator.fresh.discard(page)
            settled(application, window)
            seconds = own_time(application, lambda name=name: window.navigator.show_page(name))
            assert page.made is not None
            print(f"{words}, first view of {name}: {said(seconds)}")
        print_typed(application, window, words, keys)
        window.navigator.show_input("wall")
        for name in ("dark", "light"):
            seconds = own_time(application, lambda name=name: window.set_choice("theme", name))
            print(f"{words}, theme {name}: {said(seconds)}")
        window.session.edit_wall(0, height_m=4.5)
        print(f"{words}, kept for a crash: {said(own_time(application, window.session.autosave))}")
        window.session.undo()


def main(options: Command) -> None:
    """Print the figures."""
    if options.against is not None:
        start_against(
            options.against.resolve(),
            dict(os.environ, QT_QPA_PLATFORM="offscreen"),
            options.number(options.pairs or 7, 1),
        )
        return
    times_started = options.number(6, 1)
    with display() as variables:
        if isinstance(variables, str):
            print(f"Xvfb: {variables}")
        else:
            start_times("Xvfb", variables, times_started)
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    start_times("offscreen", dict(os.environ), times_started)
    print(f"a turn of the loop, in brackets below: a million additions in Python, {1e3 * turn():.0f} ms")

    from PySide6.QtCore import QStandardPaths
    from shiboken6 import isValid

    QStandardPaths.setTestModeEnabled(True)
    from app.shell import start as program
    from app.views.figure_file import FigureSize
    from core.study.journal import MemoryJournal

    application, window = program.make([])
    program.show(window)
    with tempfile.TemporaryDirectory() as folder:
        window.session.open(program.EXAMPLE)
        settle(application, lambda: window.records.motions and not window.records.pending)
        gaps = Gaps()

        def run() -> None:
            window.session.result = None
            window.runner.finished_runs = MemoryJournal()
            window.run()
            assert window.runner.job is not None, "the study did not start"

        for round_ in ("first run, kernels loaded on the way", "second run"):
            gaps.begin()
            run()
            settle(application, lambda: window.runner.job is None)
            longest = gaps.end()
            assert window.session.result is not None and window.session.result.analyses > 0
            print(f"{round_}: {longest}")
        window.preparation.begin()  # as the program does when it starts
        settle(application, lambda: window.preparation.job is None)
        folder_of_figures = Path(folder) / "figures"
        folder_of_figures.mkdir()
        began = time.perf_counter()
        gaps.begin()
        window.files.export_figures(folder_of_figures, FigureSize())
        settle(application, lambda: window.runner.job is None)
        longest = gaps.end()
        count, seconds = len(list(folder_of_figures.iterdir())), time.perf_counter() - began
        assert count >= 5, "the figures were not written"
        print(f"{count} figures of 300 dpi exported in {seconds:.1f} s: {longest}")
        each = drag(application, window, options.number(120, 5))
        print(f"dragged multiplier: {1.0 / each:.0f} histories integrated and drawn per second")
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
        print_many_records(application, window, options.number(RECORDS, 2), options.number(10, 1))
        for count in WALLS:
            print_walls(application, window, options.number(count, 3), options.number(5, 1))
        window.session.saved = window.session.case
        window.close()
