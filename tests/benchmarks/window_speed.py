"""Start of the window, redraws of the dragged history, gaps of the event loop while a study runs.

python3 run.py bench --window
"""

import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.xvfb import display  # noqa: E402

START = """
import time; start = time.perf_counter()
import sys; sys.path.insert(0, sys.argv[1])
from app.quick_imports import quicken
quicken()
from PySide6.QtCore import QStandardPaths
QStandardPaths.setTestModeEnabled(True)
from app import start as program
application, window = program.make([])
program.show(window); application.processEvents()
shown = time.perf_counter() - start
window.session.open(program.EXAMPLE); application.processEvents()
print(shown, time.perf_counter() - start)
window.close()
"""


def start_times(place: str, variables: dict[str, str]) -> None:
    """Measure the start in processes of this environment."""
    times = []
    for _ in range(6):
        found = subprocess.run([sys.executable, "-P", "-c", START, str(ROOT)], check=True,
                               capture_output=True, text=True, env=variables)  # fmt: skip
        times.append([float(word) for word in found.stdout.split()])
    shown, usable = (min(row[k] for row in times[1:]) for k in (0, 1))
    print(f"{place}: window visible {shown:.2f} s, on the example and usable {usable:.2f} s")


def main() -> None:
    with display() as variables:
        if isinstance(variables, str):
            print(f"Xvfb: {variables}")
        else:
            start_times("Xvfb", variables)
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    start_times("offscreen", dict(os.environ))

    from PySide6.QtCore import QStandardPaths, QTimer

    QStandardPaths.setTestModeEnabled(True)
    from app import start as program
    from core.study.journal import Memory
    from tests.benchmarks.screenshots import settle

    application, window = program.make([])
    program.show(window)
    window.session.open(program.EXAMPLE)
    settle(application, lambda: window.records.motions)
    gaps, last = [], [time.perf_counter()]

    def beat() -> None:
        now = time.perf_counter()
        gaps.append(now - last[0])
        last[0] = now

    timer = QTimer()
    timer.timeout.connect(beat)
    for round_ in ("first run, kernels loaded on the way", "second run"):
        gaps.clear()
        last[0] = time.perf_counter()
        timer.start(5)
        window.session.result = None
        window.finished_runs = Memory()
        window.run()
        settle(application, lambda: window.job is None)
        timer.stop()
        longest = sorted(gaps)[-3:]
        print(
            f"{round_}: longest gaps of the event loop {', '.join(f'{1e3 * g:.0f}' for g in longest)} ms"
        )
    window.tabs.setCurrentIndex(1)
    settle(application, lambda: True)
    histories = window.pages["histories"].content
    start, draws = time.perf_counter(), 120
    for k in range(draws):
        histories.slider.setValue(600 + 5 * k)
        application.processEvents()
    print(
        f"dragged multiplier: {draws / (time.perf_counter() - start):.0f} histories integrated and drawn per second"
    )
    window.finished_runs = Memory()
    window.run()
    settle(application, lambda: window.bar.maximum() > 0, 20.0)
    start = time.perf_counter()
    window.cancel()
    settle(application, lambda: window.job is None)
    print(f"cancelled after {1e3 * (time.perf_counter() - start):.0f} ms")
    window.session.saved = window.session.case
    window.close()
