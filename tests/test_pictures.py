"""The pictures of the documents: each is shown, and made by the version it should be of."""

import re
import struct

import pytest

from core.version import NAME, VERSION
from tests.benchmarks.made_by import KEY
from tests.benchmarks.pictures import FOLDER, SHOWN, first_page_of
from tests.conftest import ROOT

DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "resources" / "docs").rglob("*.md"))]
CHARTS = ("q_step", "q_error", "work_precision", "cost_per_wall")
"""Of benchmarks that take long: they are of the version their page names."""

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def words_of(content: bytes) -> dict[str, str]:
    """Keyword -> text of the chunks tEXt of a PNG."""
    assert content.startswith(SIGNATURE)
    words, place = {}, len(SIGNATURE)
    while place < len(content):
        length, kind = struct.unpack(">I4s", content[place : place + 8])
        if kind == b"tEXt":
            key, _, text = content[place + 8 : place + 8 + length].partition(b"\0")
            words[key.decode("latin-1")] = text.decode("latin-1")
        place += 12 + length
    return words


def version_of(name: str) -> str:
    """Major and minor number of the version by which a picture was made."""
    made_by = words_of((FOLDER / f"{name}.png").read_bytes()).get(KEY, "")
    found = re.fullmatch(rf"{NAME} (\d+\.\d+)\.\d+", made_by)
    assert found, f"{name}.png is made by {made_by or 'what it does not say'}"
    return found[1]


def shown() -> dict[str, set[str]]:
    """Picture of the documents, a path below FOLDER -> texts of the pages that show it."""
    found: dict[str, set[str]] = {}
    for page in DOCUMENTS:
        text = page.read_text(encoding="utf-8")
        for name in re.findall(r"!\[[^\]]*\]\([^)]*pictures/([\w/]+\.\w+)\)", text):
            found.setdefault(name, set()).add(text)
    return found


def test_that_every_picture_is_shown_and_every_one_shown_is_there():
    assert set(shown()) == {path.relative_to(FOLDER).as_posix() for path in FOLDER.rglob("*.*")}


OF_THE_WINDOW = [f"guide/{name}_{language}" for one in SHOWN for name, _ in one.views for language in ("en", "it")]


@pytest.mark.parametrize("name", ["note", *OF_THE_WINDOW])
def test_that_a_picture_of_the_program_is_of_this_version(name):
    assert version_of(name) == VERSION.rpartition(".")[0], "make them anew: python3 run.py bench --pictures"


def test_that_the_command_of_pictures_makes_every_picture_but_the_charts():
    made = {"note", *OF_THE_WINDOW, *CHARTS, "architecture"}
    assert {name.rpartition(".")[0] for name in shown() if not name.startswith("study_")} == made


@pytest.mark.parametrize("name", CHARTS)
def test_that_a_chart_is_of_the_version_its_page_names(name):
    """In the words after the picture, with the command that makes it."""
    of_pages = [text.partition(f"pictures/{name}.png)")[2] for text in shown()[f"{name}.png"]]
    said = [re.match(r"\n+Made by (\d+\.\d+)\.\d+ with\s`python3 run.py bench --", text) for text in of_pages]
    assert [found[1] for found in said if found] == [version_of(name)]


def test_that_the_page_of_a_wall_is_that_of_its_heading():
    """A brief note has no contents."""
    first = [(1, 80.0, "gable, 2.40 × 0.30"), (1, 90.0, "parapet, 1.20 × 0.25")]
    headings = [(page, 50.0, f"{name} – not verified, ζ 0.16") for page, name in ((2, "gable"), (4, "parapet"))]
    assert [first_page_of(name, first + headings) for name in ("gable", "parapet")] == [2, 4]
