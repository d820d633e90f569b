"""Pages of one language: no word of the other, no decimal mark of the other in the name of a stretch."""

import re
from pathlib import Path

import pytest

from core.case.rules import parse_case
from core.report.note.archive import note_of
from core.study.run import run
from core.text.sentence import title_in
from tests.core.report import whole_workbook

WORDS = {
    "en": {"the", "of", "and", "wall", "walls", "with", "not", "which", "hinge", "height", "verified", "demand", "by"},
    "it": {"il", "della", "delle", "parete", "pareti", "che", "non", "cerniera", "altezza", "verificata", "domanda"},
}
"""Words that stand in any page of a language, and are none of the other."""

POINT_IN_NAME = re.compile(r"[\[(]\+?\d+\.\d+[–\d.]* m")
SHOWN = {"kind": "calculation", "reference": "C1"}


def result_in(language):
    """A wall between floors, one that turns about its hinges, one that stands free; names that are of no language."""
    held = [{"kind": "floor", "h_m": h, "out_kn_m": 45.0, "evidence": SHOWN} for h in (3.35, 6.7)]
    loads = [{"kind": "vertical", "kn_m": 12.0, "d_m": 0.3, "h_m": h, "mass": "none"} for h in (3.35, 6.7)]
    plain = {"height_m": 6.8, "thickness_m": 0.5, "length_m": 8.0, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
    leans = [{"kind": "contact", "to_m": 6.8, "evidence": SHOWN}]
    walls = [plain | {"name": "A1", "hold": held, "load": loads}, plain | {"name": "B2", "hold": leans, "load": loads}]
    walls.append({"name": "C3", "height_m": 1.25, "thickness_m": 0.3, "base_z_m": 6.8, "unloaded_confirmed": True})
    spectrum = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
    table = {"wall": walls, "demand": {"ag_g": 0.15, "spectrum": spectrum}, "report": {"language": language}}
    table["building"] = {"height_m": 8.1, "storeys": 2, "period_s": 0.25}
    return run(parse_case(table | {"analysis": {"histories": False}}), base_dir=Path())


def cells_of(result):
    """Words of every cell of a workbook."""
    for sheet in whole_workbook.build(result, []).workbook.worksheets:
        for row in sheet.iter_rows():
            for cell in row:
                if isinstance(cell.value, str) and not cell.value.startswith("="):
                    yield sheet.title, cell.value


def foreign(text, language):
    """Words of the other language in a text: two at least, for some are words of both."""
    other = WORDS["it" if language == "en" else "en"]
    return [word for word in re.findall(r"[a-zà-ù]+", text.lower()) if word in other]


@pytest.mark.shows("window.language")
@pytest.mark.parametrize("language", ["en", "it"])
def test_that_no_page_of_note_or_workbook_has_a_word_of_the_other_language(language):
    result = result_in(language)
    lines = [("note", text) for _, _, text in note_of(result, Path(), within=False).lines()]
    found = [(where, text) for where, text in (*lines, *cells_of(result)) if len(foreign(text, language)) > 1]
    assert found == []
    if language == "it":
        assert [(where, text) for where, text in (*lines, *cells_of(result)) if POINT_IN_NAME.search(text)] == []


def test_that_heights_in_a_name_have_the_comma_of_a_language():
    assert title_in("A1 [3.4–6.8, −3.4 m]", "it") == "A1 [3,4–6,8; −3,4 m]"
    assert title_in("v1.2 (+3.2 m): x", "it") == "v1.2 (+3,2 m): x"
    assert title_in("A1 [3.4–6.8 m]", "en") == "A1 [3.4–6.8 m]" and title_in("nord 3.4", "it") == "nord 3.4"
