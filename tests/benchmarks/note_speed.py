"""Seconds the calculation note takes after a run: what it says, its layout, the PDF with its case within, the pages of
the preview; of one wall and of twelve.

    python3 run.py bench --note

The least of five.
"""

import time
from dataclasses import replace
from pathlib import Path

from core.case.rules import parse_case
from core.report.note.archive import note_attachments, note_of
from core.report.note.content import full_note
from core.study.results import StudyResult
from core.study.run import run
from tests.benchmarks.inputs import Command
from tests.conftest import ROOT

WALL = {
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "hold": [{"kind": "cross_walls"}],
    "load": [{"kind": "vertical", "kn_m": 10.0, "d_m": 0.3, "h_m": 4.0, "mass": "none"}],
}
DEMAND = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}


def result_of(count: int) -> StudyResult:
    """So many walls under seven motions, all checks."""
    walls = [WALL | {"name": f"wall {k}", "height_m": 5.0 + 0.2 * k, "thickness_m": 0.5} for k in range(count)]
    table = {
        "wall": walls,
        "demand": DEMAND,
        "generate": {"scatter": 0.0, "count": 7, "seed": 1},
        "analysis": {"q_step": 0.05},
    }
    return run(parse_case(table), base_dir=ROOT)


def main(options: Command) -> None:
    for count in options.few((1, 12)):
        result, rows = result_of(count), []
        for _ in range(options.number(5, 1)):
            again = replace(result, started_utc="")
            start = time.perf_counter()
            full_note(again, "en")
            said = time.perf_counter()
            made = note_of(again, Path(), within=False)
            laid = time.perf_counter()
            pages = made.pages(96.0)
            shown = time.perf_counter()
            note_attachments(again)
            signed = note_of(again, Path())
            kept = time.perf_counter()
            content = signed.pdf()
            rows.append((said - start, laid - said, shown - laid, kept - shown, time.perf_counter() - kept))
        assert len(pages) >= 2 * count and content.startswith(b"%PDF")
        print(f"{count} walls, {len(pages)} pages, {len(content) / 1e3:.0f} kB")
        names = ("content", "layout", "pages at 96 dpi", "files within", "PDF")
        for name, *seconds in zip(names, *rows, strict=True):
            print(f"  {name:<16} {min(seconds):.2f} s")
