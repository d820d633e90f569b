"""The window of the frozen program tried from inside: open, run, export, close, by the steps of a user.

packaging/smoke.py starts it with RIBALTA_SMOKE, the folder of what it leaves: workbook, figures, a picture of the
window, and times.json with the seconds since the start of the process.
"""

import faulthandler
import json
import os
import time
import traceback
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from app.shell.window import MainWindow


def settle(application, ready, seconds: float = 180.0) -> None:
    """Let events pass until `ready()`. Raises TimeoutError."""
    end = time.monotonic() + seconds
    while not ready():
        if time.monotonic() > end:
            raise TimeoutError
        application.processEvents()
        time.sleep(0.002)


def drive(application, window: "MainWindow", folder: Path, times: dict) -> None:
    from app.views.figure_file import FigureSize

    start = float(os.environ["RIBALTA_SMOKE_START"])
    settle(application, lambda: window.records.motions and not window.records.pending)
    window.run()
    settle(application, lambda: window.runner.job is None and window.session.result is not None)
    times["result"] = time.time() - start
    window.grab().save(str(folder / "window.png"))
    window.files.export(folder / "window.xlsx")
    settle(application, lambda: window.runner.job is None and (folder / "window.json").exists())
    window.files.export_figures(folder, FigureSize())
    (folder / "times.json").write_text(json.dumps(times), encoding="ascii")
    if "RIBALTA_SMOKE_FAULT" in os.environ:
        faulthandler._sigsegv()  # type: ignore[attr-defined]
    window.session.saved = window.session.case
    window.close()


def _or_end(step, *given) -> None:
    """A step that fails ends the process: a dialog would wait for somebody."""
    try:
        step(*given)
    except BaseException:
        traceback.print_exc()
        os._exit(1)


def main(folder: str) -> int:
    from app.look.quick_imports import quicken

    quicken()
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from app import __main__ as program
    from app.shell import start

    show, times = start.show, {}

    def refused(*words) -> None:  # a dialog would wait for somebody
        raise AssertionError(words[-1])

    for asked in ("warning", "question", "critical"):
        setattr(start.QMessageBox, asked, refused)

    def shown(window) -> None:
        show(window)
        application = QApplication.instance()
        assert application is not None, "no application of Qt shows the window: see show in app/shell/start.py"
        application.processEvents()
        times["window"] = time.time() - float(os.environ["RIBALTA_SMOKE_START"])
        QTimer.singleShot(0, lambda: _or_end(drive, application, window, Path(folder), times))

    start.show = shown
    return program.main([os.environ["RIBALTA_SMOKE_CASE"]])
