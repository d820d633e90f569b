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
from tests.benchmarks.inputs import Command
from tests.conftest import ROOT, shelf_folder

SAMPLES, FILES = 1_000_000, 200


def files(samples: int) -> dict[str, tuple[bytes, Options]]:
    """name -> (content, what the user says of it), of records of so many samples."""
    values = np.round(np.random.default_rng(1).standard_normal(samples) * 0.05, 6)
    fields = [f"{value:14.7E}" for value in values]
    peer = [f"PEER\nE,1,S,90\nACC UNITS OF G\nNPTS= {samples}, DT= .005 SEC"]
    peer += ["".join(fields[k : k + 5]) for k in range(0, samples, 5)]
    esm = ["SAMPLING_INTERVAL_S: 0.005", f"NDATA: {samples}", "UNITS: cm/s^2", "DATA_TYPE: ACCELERATION"]
    one = [f"{value:.6f}" for value in values]
    two = [f"{0.005 * k:.3f} {value:.6f}" for k, value in enumerate(values)]
    return {
        "PEER, glued": ("\n".join([*peer, ""]).encode(), Options()),
        "ESM": ("\n".join([*esm, *one, ""]).encode(), Options()),
        "one column": ("\n".join([*one, ""]).encode(), Options("g", 0.005)),
        "two columns": ("\n".join([*two, ""]).encode(), Options("g")),
    }


def longest_pause(folder_of_records: Path, count: int) -> float:
    """Seconds between two turns of the event loop while the dialog previews so many files of this folder."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtWidgets import QApplication

    from app.input.import_dialog import ImportDialog

    application = QApplication.instance() or QApplication([])
    there = [path for path in sorted(folder_of_records.rglob("*")) if path.is_file()]
    with tempfile.TemporaryDirectory() as folder:
        copies = [Path(folder) / f"{k} {there[k % len(there)].name}" for k in range(count)]
        for k, copy in enumerate(copies):
            shutil.copyfile(there[k % len(there)], copy)
        dialog = ImportDialog(copies)
        dialog.show()
        assert len(dialog.unmarked) == count
        longest, last = 0.0, time.perf_counter()
        while dialog.unmarked:
            application.processEvents()
            now = time.perf_counter()
            longest, last = max(longest, now - last), now
        dialog.deleteLater()
    return longest


def main(options: Command) -> None:
    """Print the table and the pause."""
    samples, count = options.number(SAMPLES, 10_000), options.number(FILES, 14)
    print(f"{'file':14} {'MB':>6} {'s':>8}   ({samples} samples)")
    for name, (content, said) in files(samples).items():
        start = time.perf_counter()
        motion = records._motion(content, Path("x.txt"), said, 1.0, "x")
        seconds = time.perf_counter() - start
        assert motion.acceleration.size == samples
        print(f"{name:14} {len(content) / 1e6:6.1f} {seconds:8.2f}")
    folder = shelf_folder() or ROOT / "tests" / "motions"
    print(f"longest pause while {count} files are previewed: {longest_pause(folder, count):.2f} s")
