"""Pictures of every tab, light and dark, Italian and English, at 1280x800 and 1920x1080.

python3 run.py bench --screenshots [--output DIR]

`--guide` beside it makes the pictures of resources/docs/guide and resources/docs/guida instead.
"""

import argparse
import os
import tempfile
import time
from pathlib import Path

from tests.benchmarks.small import small_case

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

    QStandardPaths.setTestModeEnabled(True)
    from app.shell import start as program

    application, window = program.make([])
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


def picture(widget, path: Path) -> None:
    """Save what a widget shows."""
    shown = widget.grab().toImage()
    points = ((x, y) for x in range(0, shown.width(), 7) for y in range(0, shown.height(), 7))
    assert len({shown.pixel(*point) for point in points}) > 10, f"{path.name} shows nothing"
    assert shown.save(str(path)), path


def main(options: argparse.Namespace) -> None:
    """Write the pictures. small : of one wall, in one language, theme and size"""
    options.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        small = small_case(Path(name)) if options.small else None
        (guide if options.guide else tabs)(options.output, small)


def tabs(folder: Path, small: Path | None) -> None:
    """Pictures of every tab. small : a case in place of the example"""
    from app.views.note_tab import NoteTab

    application, window = begin()
    run(application, window, small or CASES / "verdict.toml")
    if not small:
        window.runner.state_accuracy(window.navigator.shown)
        settle(application, lambda: window.runner.job is None)
    for language in ("en",) if small else ("it", "en"):
        window.set_choice("language", language)
        for theme in ("light",) if small else ("light", "dark"):
            window.set_choice("theme", theme)
            settle(application, lambda: window.records.motions)
            for width, height in SIZES[: 1 if small else 2]:
                window.resize(width, height)
                for name in (*window.stages.input.areas, *window.pages):
                    window.navigator.show_page(name) if name in window.pages else window.navigator.show_input(name)
                    note = window.pages["note"].made
                    settle(application, lambda note=note: not (isinstance(note, NoteTab) and note.is_setting))
                    picture(window, folder / f"{name}_{language}_{theme}_{width}.png")
    end(window)


GUIDE = (
    (
        "verdict.toml",
        0,
        (
            ("facade_wall", "wall"),
            ("facade_demand", "demand"),
            ("facade_overview", "walls"),
            ("facade_check", "check"),
            ("facade_histories", "histories"),
            ("facade_capacity", "capacity"),
        ),
    ),
    ("building.toml", -1, (("parapet_wall", "wall"), ("parapet_check", "check"), ("parapet_spectra", "spectra"))),
    ("facade.toml", -1, (("body_wall", "wall"),)),
)
"""(case, wall, pictures: (name, page or form)) of the guides."""


def guide(folder: Path, small: Path | None) -> None:
    """Pictures of the guides in both languages, light, in 128 colours. small : a case in place of the first example"""
    from PIL import Image

    application, window = begin()
    window.set_choice("theme", "light")
    for case, wall, pictures in GUIDE[: 1 if small else None]:
        run(application, window, small or CASES / case)
        for language in ("en",) if small else ("it", "en"):
            window.set_choice("language", language)
            window.resize(1280, 800)
            settle(application, lambda: window.records.motions and not window.records.pending)
            window.navigator.pick(wall % len(window.session.result.walls))
            for name, page in pictures:
                window.navigator.show_page(page) if page in window.pages else window.navigator.show_input(page)
                for key, section in window.walls.sections.items():  # of a body its shape
                    section.head.setChecked(key == "body" if name == "body_wall" else key in ("geometry", "mechanism"))
                live = window.stages.input.live
                live.unfold()
                settle(application, lambda page=page, live=live: page != "wall" or live.result is not None)
                path = folder / f"{name}_{language}.png"
                picture(window, path)
                Image.open(path).convert("RGB").quantize(128).save(path, optimize=True)
    end(window)
