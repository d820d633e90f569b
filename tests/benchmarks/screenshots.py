"""Pictures of every tab, light and dark, Italian and English, at 1280x800 and 1920x1080.

python3 run.py bench --screenshots [--output DIR]
"""

import os
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
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


def main(folder: Path, case: Path = ROOT / "resources" / "cases" / "verdict.toml") -> None:
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtCore import QStandardPaths

    QStandardPaths.setTestModeEnabled(True)
    from app import start as program

    folder.mkdir(parents=True, exist_ok=True)
    application, window = program.make([])
    window.show()
    window.session.open(case)
    settle(application, lambda: window.records.motions)
    window.run()
    settle(application, lambda: window.session.result is not None and window.job is None)
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
    window.session.saved = window.session.case
    window.close()
