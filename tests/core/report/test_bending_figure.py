"""A wall held at its top in the note: its figure, its lines; all sheets of the workbook are made."""

from dataclasses import replace
from pathlib import Path

import pytest

from core.report.note.content import full_note
from core.report.note.parts import Derivation, Figures, Item, Paragraph
from core.report.note.pdf import Note
from core.study.run import run
from tests.clauses_alone import parse_case
from tests.core.variation.test_held_top import BUILDING, DEMAND, TOP, WALL
from tests.holds import between


@pytest.fixture(scope="module")
def of_three():
    bare = {key: value for key, value in WALL.items() if key not in ("load", "hold")}
    walls = [WALL, WALL | {"name": "back", "hinge_setback_m": 0.02, "load": [TOP, TOP | {"d_m": 0.25}]}]
    walls.append(bare | {"name": "bare", "base_z_m": 0.0})
    table = {"wall": walls, "building": BUILDING, "demand": DEMAND}
    return run(parse_case(table), base_dir=Path())


@pytest.fixture(params=["en", "it"])
def result(request, of_three):
    report = replace(of_three.case.report, language=request.param)
    return replace(of_three, case=replace(of_three.case, report=report))


def test_that_the_note_has_hinge_figure_and_lines(result):
    language = result.case.report.language
    parts = full_note(result, language)
    cells = {step.cell for part in parts if isinstance(part, Derivation) for step in part.steps}
    assert {f"wall{n}_{name}" for n in (1, 2, 3) for name in ("h1", "alpha0", "d_c0", "d0", "alpha_d")} <= cells
    words = [part.text for part in parts if isinstance(part, (Paragraph, Item))]
    assert any("No time histories" in line or "storie temporali" in line for line in words)
    captions = [figure.caption for part in parts if isinstance(part, Figures) for figure in part.figures]
    held = "held at its top" if language == "en" else "vincolata in testa"
    assert sum(held in caption for caption in captions) == 3
    assert Note(parts, language).pdf().startswith(b"%PDF")


def test_that_the_note_has_its_histories(folder):
    records = [{"file": "r1.txt", "unit": "m/s2", "time_step_s": 0.01}]
    table = {"wall": [WALL], "building": BUILDING, "demand": DEMAND | {"ag_g": 0.5}, "record": records}
    result = run(parse_case(table | {"analysis": {"q_step": 0.1, "polarity": "as_recorded"}}), base_dir=folder)
    parts = full_note(result, "en")
    captions = [figure.caption for part in parts if isinstance(part, Figures) for figure in part.figures]
    assert any("at the demand over θc" in caption for caption in captions)
    assert not any("No time histories" in part.text for part in parts if isinstance(part, (Paragraph, Item)))


def test_that_a_wall_between_transverse_walls_is_drawn_in_plan_with_its_lines():
    hold = between(4.0, tie_kn_m=30.0, tie_bar_length_m=5.0, tie_elongation_m=0.06)
    bare = {key: value for key, value in WALL.items() if key not in ("load", "hold")}
    wall = bare | {"name": "spans", "mechanism": "horizontal_bending", "hold": hold, "compressive_strength_mpa": 2.0}
    result = run(parse_case({"wall": [wall], "building": BUILDING, "demand": DEMAND}), base_dir=Path())
    parts = full_note(result, "en")
    (drawn,) = (
        figure for part in parts if isinstance(part, Figures) for figure in part.figures if "in plan" in figure.caption
    )
    labels = " ".join(label.text for label in drawn.labels)
    assert "L 4.00 m" in labels and "H 30.0 kN/m" in labels
    cells = {step.cell for part in parts if isinstance(part, Derivation) for step in part.steps}
    assert {f"wall1_{name}" for name in ("thrust", "setback", "alpha0", "d0", "alpha_d")} <= cells
