"""Pictures of every tab, light and dark, Italian and English, at 1280x800 and 1920x1080.

python3 run.py bench --screenshots [--output DIR]

`--guide` beside it makes the pictures of resources/docs/guide and resources/docs/guida instead.
"""

import os
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "resources" / "cases"
SIZES = ((1280, 800), (1920, 1080))


def settle(application, ready, seconds: float = 120.0) -> None:
    """Let events pass until `ready()`."""
    import time

    end = time.monotonic() + seconds
    while not ready() and time.monotonic() < end:
        application.processEvents()
        time.sleep(0.01)
    for _ in range(5):
        application.processEvents()


def begin():
    """(application, window) off screen."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtCore import QStandardPaths

    QStandardPaths.setTestModeEnabled(True)
    from app import start as program

    application, window = program.make([])
    window.show()
    return application, window


def run(application, window, case: Path) -> None:
    """Open a case and run it."""
    window.session.open(case)
    settle(application, lambda: window.records.motions and not window.records.pending)
    window.run()
    settle(application, lambda: window.session.result is not None and window.job is None)


def end(window) -> None:
    window.session.saved = window.session.case
    window.close()


def main(folder: Path, case: Path = CASES / "verdict.toml") -> None:
    folder.mkdir(parents=True, exist_ok=True)
    application, window = begin()
    run(application, window, case)
    window.state_accuracy()
    settle(application, lambda: window.job is None)
    for language in ("it", "en"):
        window.set_choice("language", language)
        for theme in ("light", "dark"):
            window.set_choice("theme", theme)
            settle(application, lambda: window.records.motions)
            for width, height in SIZES:
                window.resize(width, height)
                for k, name in enumerate(window.pages):
                    window.forms.setCurrentIndex(k % 3)
                    window.tabs.setCurrentIndex(k)
                    settle(application, lambda: True)
                    window.grab().save(str(folder / f"{name}_{language}_{theme}_{width}.png"))
    end(window)


GUIDE = (
    ("verdict.toml", 0, (("facade_wall", "form", 0), ("facade_demand", "form", 1), ("facade_overview", "walls", 0),
                         ("facade_check", "check", 0), ("facade_histories", "histories", 0),
                         ("facade_capacity", "capacity", 0))),
    ("building.toml", -1, (("parapet_wall", "form", 0), ("parapet_check", "check", 0),
                           ("parapet_spectra", "spectra", 0))),
)  # fmt: skip
"""(case, wall, pictures: (name, page or form, which form)) of the guides."""


def guide(folder: Path) -> None:
    """Pictures of the guides in both languages, light, in 32 colours."""
    from PIL import Image

    folder.mkdir(parents=True, exist_ok=True)
    application, window = begin()
    window.set_choice("theme", "light")
    for case, wall, pictures in GUIDE:
        run(application, window, CASES / case)
        for language in ("it", "en"):
            window.set_choice("language", language)
            window.resize(1280, 800)
            settle(application, lambda: window.records.motions and not window.records.pending)
            window.pick(wall % window.chosen.count())
            for name, page, form in pictures:
                window.forms.setCurrentIndex(form)
                window.tabs.setCurrentWidget(window.pages.get(page, window.pages["check"]))
                settle(application, lambda: True)
                part = window.forms if page == "form" else window.tabs
                path = folder / f"{name}_{language}.png"
                part.grab().save(str(path))
                Image.open(path).convert("RGB").quantize(32).save(path, optimize=True)
    end(window)
