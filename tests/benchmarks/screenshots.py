"""Pictures of every tab, light and dark, Italian and English, at 1280x800 and 1920x1080.

python3 run.py bench --screenshots [--output DIR]
"""

import io
import os
import time
from pathlib import Path

from tests.benchmarks.inputs import Command
from tests.benchmarks.made_by import save_picture

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "resources" / "cases"
SIZES = ((1280, 800), (1920, 1080))


def settle(application, ready, seconds: float = 120.0) -> None:
    """Let events pass until `ready()`. Raises TimeoutError."""
    end = time.monotonic() + seconds
    while not ready():
        if time.monotonic() > end:
            raise TimeoutError
        application.processEvents()
        time.sleep(0.01)
    for _ in range(5):
        application.processEvents()


def begin():
    """(application, window) off screen."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtCore import QStandardPaths
    from PySide6.QtGui import QCursor

    QStandardPaths.setTestModeEnabled(True)
    from app.shell import start as program

    application, window = program.make([])
    QCursor.setPos(-50, -50)  # it begins at (10, 10), where some runs put it over a button, which it lights up
    window.show()
    return application, window


def run(application, window, case: Path) -> None:
    """Open a case and run it."""
    window.session.open(case)
    settle(application, lambda: window.records.motions and not window.records.pending)
    window.run()
    settle(application, lambda: window.session.result is not None and window.runner.job is None)


def end(window) -> None:
    window.session.saved = window.session.case
    window.close()


def image_of(widget):
    """What a widget shows, an image of PIL."""
    from PIL import Image
    from PySide6.QtCore import QBuffer, QIODevice

    content = QBuffer()
    content.open(QIODevice.OpenModeFlag.WriteOnly)
    assert widget.grab().save(content, "PNG"), "no picture"
    image = Image.open(io.BytesIO(content.data().data())).convert("RGB")
    assert len(image.getcolors(image.width * image.height) or ()) > 10, "the picture shows nothing"
    return image


def main(options: Command) -> None:
    """Write pictures of every tab."""
    from app.views.note_tab import NoteTab

    folder = options.folder()
    application, window = begin()
    run(application, window, CASES / "verdict.toml")
    window.runner.state_accuracy(window.navigator.shown)
    settle(application, lambda: window.runner.job is None)
    for language in options.few(("en", "it")):
        window.set_choice("language", language)
        for theme in options.few(("light", "dark")):
            window.set_choice("theme", theme)
            settle(application, lambda: window.records.motions)
            for width, height in options.few(SIZES):
                window.resize(width, height)
                for name in (*window.stages.input.areas, *window.pages):
                    window.navigator.show_page(name) if name in window.pages else window.navigator.show_input(name)
                    note = window.pages["note"].made
                    settle(application, lambda note=note: not (isinstance(note, NoteTab) and note.is_setting))
                    save_picture(image_of(window), folder / f"{name}_{language}_{theme}_{width}.png")
    end(window)
