"""Reading a million samples in each shape of file, and the longest pause of the window while 200 files are previewed.

python3 run.py bench --records
"""

import os
import shutil
import tempfile
import time
from pathlib import Path

import numpy as np

from core.ground import records
from core.ground.records.grammar import Options
from tests.conftest import shelf_folder

SAMPLES, FILES = 1_000_000, 200


def files() -> dict[str, tuple[bytes, Options]]:
    """name -> (content, what the user says of it)."""
    values = np.round(np.random.default_rng(1).standard_normal(SAMPLES) * 0.05, 6)
    fields = [f"{value:14.7E}" for value in values]
    peer = [f"PEER\nE,1,S,90\nACC UNITS OF G\nNPTS= {SAMPLES}, DT= .005 SEC"]
    peer += ["".join(fields[k : k + 5]) for k in range(0, SAMPLES, 5)]
    esm = [
        "SAMPLING_INTERVAL_S: 0.005",
        f"NDATA: {SAMPLES}",
        "UNITS: cm/s^2",
        "DATA_TYPE: ACCELERATION",
    ]
    one = [f"{value:.6f}" for value in values]
    two = [f"{0.005 * k:.3f} {value:.6f}" for k, value in enumerate(values)]
    return {
        "PEER, glued": ("\n".join([*peer, ""]).encode(), Options()),
        "ESM": ("\n".join([*esm, *one, ""]).encode(), Options()),
        "one column": ("\n".join([*one, ""]).encode(), Options("g", 0.005)),
        "two columns": ("\n".join([*two, ""]).encode(), Options("g")),
    }


def longest_pause() -> float:
    """Seconds between two turns of the event loop while the dialog previews 200 files of the shelf."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtWidgets import QApplication

    from app.forms.import_dialog import ImportDialog

    application = QApplication.instance() or QApplication([])
    there = [path for path in sorted(shelf_folder().rglob("*")) if path.is_file()]
    with tempfile.TemporaryDirectory() as folder:
        copies = [Path(folder) / f"{k} {there[k % len(there)].name}" for k in range(FILES)]
        for k, copy in enumerate(copies):
            shutil.copyfile(there[k % len(there)], copy)
        dialog = ImportDialog(copies)
        dialog.show()
        longest, last = 0.0, time.perf_counter()
        while dialog.unmarked:
            application.processEvents()
            now = time.perf_counter()
            longest, last = max(longest, now - last), now
        dialog.deleteLater()
    return longest


def main() -> None:
    print(f"{'file':14} {'MB':>6} {'s for 1e6 samples':>18}")
    for name, (content, options) in files().items():
        start = time.perf_counter()
        records._motion(content, Path("x.txt"), options, 1.0, "x")
        print(f"{name:14} {len(content) / 1e6:6.1f} {time.perf_counter() - start:18.2f}")
    if shelf_folder():
        print(f"longest pause while {FILES} files are previewed: {longest_pause():.2f} s")
