"""The pictures of README and guides: the window on their cases, and pages of a calculation note.

python3 run.py bench --pictures [--output DIR]    # into resources/pictures without DIR

Charts are made by their own benchmarks. Each picture says by which version it was made (made_by.py).
"""

import io
import time
from pathlib import Path
from typing import NamedTuple

from tests.benchmarks.inputs import Command
from tests.benchmarks.made_by import save_picture
from tests.benchmarks.screenshots import CASES, begin, end, image_of, run, settle
from tests.conftest import ROOT

FOLDER = ROOT / "resources" / "pictures"


class Shown(NamedTuple):
    """What the guides show of a case. wall : number of the one picked; views : (name, page or form)"""

    case: str
    wall: int
    views: tuple[tuple[str, str], ...]


SHOWN = (
    Shown(
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
    Shown("facade.toml", 1, (("body_wall", "wall"),)),
    Shown("building.toml", -1, (("parapet_wall", "wall"), ("parapet_check", "check"), ("parapet_spectra", "spectra"))),
)
"""The note is that of the last one."""

DPI, MARGIN, GROUND = 60, 12, "#c8ccd2"


def main(options: Command) -> None:
    """Write the pictures."""
    folder = options.folder(FOLDER)
    (folder / "guide").mkdir(exist_ok=True)
    application, window = begin()
    window.set_choice("theme", "light")
    for shown in options.few(SHOWN):
        start = time.perf_counter()
        run(application, window, CASES / shown.case)
        for language in options.few(("en", "it")):
            window.set_choice("language", language)
            window.resize(1280, 800)
            settle(application, lambda: window.records.motions and not window.records.pending)
            window.navigator.pick(shown.wall % len(window.session.result.walls))
            for name, page in shown.views:
                show(application, window, name, page)
                save_picture(image_of(window), folder / "guide" / f"{name}_{language}.png")
        print(f"{shown.case}: {time.perf_counter() - start:.0f} s", flush=True)
    result = window.session.result
    save_picture(image_of_note(result, result.walls[shown.wall].wall.name), folder / "note.png")
    end(window)


def show(application, window, name: str, page: str) -> None:
    """Bring a page or form to the front, of a body its shape, of another wall its geometry and mechanism."""
    window.navigator.show_page(page) if page in window.pages else window.navigator.show_input(page)
    for key, section in window.walls.sections.items():
        section.head.setChecked(key == "body" if name == "body_wall" else key in ("geometry", "mechanism"))
    live = window.stages.input.live
    live.unfold()
    window.show_word("")  # of the seconds of the run, which no two have alike
    window.setFocus()
    settle(application, lambda: page != "wall" or live.result is not None)


def first_page_of(name: str, lines: list[tuple[int, float, str]]) -> int:
    """Page, from 1, whose heading is the wall of this name.

    lines : (page, y [pt], text) of a brief note, in order
    """
    return next(page for page, _, text in lines if text.startswith(f"{name} – "))


def image_of_note(result, name: str):
    """Of the note of a result side by side: its first page, and the first two of the wall of this name."""
    from PIL import Image

    from core.report.note.archive import note_of

    note = note_of(result, Path(), within=False)
    first, made = first_page_of(name, note.lines()), note.pages(DPI)
    pages = [Image.open(io.BytesIO(made[page])).convert("RGB") for page in (0, first - 1, first)]
    width, height = pages[0].size
    image = Image.new("RGB", (len(pages) * (width + MARGIN) + MARGIN, height + 2 * MARGIN), GROUND)
    for k, page in enumerate(pages):
        image.paste(page, (MARGIN + k * (width + MARGIN), MARGIN))
    return image
