"""A draft is written whatever it holds: a refused text, a shape that cannot be written another way or a value that no
file could hold take no later edit with them."""

import itertools
import os
import random
from dataclasses import dataclass, replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtWidgets import QMessageBox

from app.work.session import Session
from core.case.loads import Load
from core.case.wall import Wall
from tests.app.driving import type_into


def recovered(session, folder):
    """The case as the next start finds it."""
    session.autosave()
    other = Session(folder)
    other.recover(session.recovery_file)
    other.close()
    return other.case


def choose_shape(window, shape: str) -> None:
    box = window.walls.shape
    box.setCurrentIndex(box.findData(shape))
    box.activated.emit(box.currentIndex())


OTHER_SHAPES = "slenderness_deg", "height_over_thickness", "general"
SIZES = ("6", "0.5"), ("60", "0.5"), ("0.1", "2000"), ("6", "2000")


@pytest.mark.parametrize(
    ("height", "thickness", "shape"),
    [
        pytest.param(*size, shape, marks=() if (m - n) % 3 == 0 else pytest.mark.long)
        for m, shape in enumerate(OTHER_SHAPES)
        for n, size in enumerate(SIZES)
    ],
)
def test_that_a_shape_that_cannot_be_written_so_is_refused_and_later_edits_are_kept(
    opened, application, tmp_path, height, thickness, shape
):
    """0.5 cm over 6 m are 0.048 degrees: no file may hold that slenderness."""
    walls, said = opened.walls, []
    walls.told.connect(said.append)
    type_into(walls.fields["height_m"], height)
    type_into(walls.fields["thickness_m"], thickness)
    choose_shape(opened, shape)
    type_into(walls.fields["notes"], "a later edit")
    wall = recovered(opened.session, tmp_path / "recovery_folder").wall[0]
    assert wall.notes == "a later edit" and wall == opened.session.case.wall[0]
    assert opened.files.save() and not opened.session.dirty
    opened.session.open(opened.session.path)
    assert opened.session.case.wall[0] == wall
    if said:  # refused: the block is given as before
        assert "not accepted" in said[0] and walls.shape.currentData() == "thickness_m"
        assert wall.thickness_m == pytest.approx(float(thickness) / 100.0)


@pytest.mark.parametrize("language", ["en", "it"])
def test_that_a_refused_shape_says_which_size_is_out_of_range(opened, application, language):
    opened.set_choice("language", language)
    type_into(opened.walls.fields["height_m"], "6")
    type_into(opened.walls.fields["thickness_m"], "0.5")
    choose_shape(opened, "slenderness_deg")
    words = opened.word.text()
    assert ("0.0477" in words) or ("0,0477" in words), words
    assert opened.walls.fields["slenderness_deg"].caption.text().split()[0] in words, words


@pytest.mark.parametrize(
    "values",
    [
        {"slenderness_deg": 0.01, "thickness_m": None},
        {"load": (Load("vertical", 5.0, -1.0), Load("thrust", 1e9, 2.0))},
        {"velocity_ratio": 7.0, "hinge_setback_m": 3.0, "hinge_heights": (-2.0,)},
    ],
)
def test_that_a_value_no_file_may_hold_takes_nothing_else_with_it(opened, tmp_path, monkeypatch, values):
    """No form gives one; should one ever come, the draft and the file hold all the rest, and the window says so."""
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    opened.session.edit_wall(0, **values)
    opened.session.edit_wall(0, notes="a later edit", length_m=7.0)
    case = recovered(opened.session, tmp_path / "recovery_folder")
    assert (case.wall[0].notes, case.wall[0].length_m, case.wall[0].height_m) == ("a later edit", 7.0, 5.0)
    assert case.demand == opened.session.case.demand and len(case.wall[0].load) == len(opened.session.case.wall[0].load)
    assert opened.files.save() and len(said) == 1 and "not accepted" in said[0]
    assert opened.session.dirty, "what the file does not hold is unsaved"
    opened.session.saved = opened.session.case
    opened.session.open(opened.session.path)
    assert opened.session.case.wall[0] == case.wall[0]


# a walk of valid and invalid texts


@dataclass(frozen=True)
class Typed:
    """A number field of the walk. right : texts it takes, with what the case holds then; wrong : texts it refuses"""

    of: str
    key: str
    right: tuple[tuple[str, float], ...]
    wrong: tuple[str, ...] = ("abc", "-1", "1e9", "9..5", "nan")

    def field(self, window):
        forms = {"wall": window.walls, "demand": window.demand, "analysis": window.analysis}
        fields = forms[self.of].fields
        return next(
            field for field in (fields.values() if isinstance(fields, dict) else fields) if field.key == self.key
        )


WALKED = (
    Typed("wall", "height_m", (("6", 6.0), ("3,2", 3.2), ("30", 30.0))),
    Typed("wall", "thickness_m", (("0.5", 0.005), ("60", 0.6), ("1800", 18.0))),
    Typed("wall", "base_z_m", (("0", 0.0), ("4.5", 4.5))),
    Typed("wall", "length_m", (("7", 7.0), ("12.5", 12.5))),
    Typed("wall", "unit_weight_kn_m3", (("18", 18.0), ("20", 20.0))),
    Typed("demand", "ag_g", (("0.12", 0.12), ("0,3", 0.3))),
    Typed("demand", "confidence_factor", (("1.2", 1.2), ("1.35", 1.35))),
)
SHAPES = ("thickness_m", "slenderness_deg", "height_over_thickness")


def held(case) -> dict[str, float]:
    """What the walk follows, the thickness however it is given."""
    wall = case.wall[0]
    values = {one.key: getattr(wall if one.of == "wall" else case.demand, one.key) for one in WALKED}
    return {key: value for key, value in values.items() if value is not None} | {"thickness_m": wall.thickness}


@pytest.mark.shows("window.drafts")
@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.long) for seed in (1, 2))])
def test_that_the_draft_holds_the_last_valid_value_of_every_field_on_a_walk_with_refused_texts(
    opened, application, tmp_path, seed
):
    chance, expected = random.Random(seed), held(opened.session.case)
    opened.session.edit(replace(opened.session.case, title="a walk"))
    opened.activateWindow()
    done = []
    for _ in range(60):
        act = chance.random()
        if act < 0.25:
            shape = chance.choice(SHAPES)
            choose_shape(opened, shape)
            done.append(shape)
        elif act < 0.3:
            language = chance.choice(("en", "it"))
            opened.set_choice("language", language)
            done.append(language)
        else:
            one = chance.choice(WALKED[: 2 if act < 0.5 else None])
            field = one.field(opened)
            if one.key == "thickness_m" and field.isHidden():
                continue
            text, value = chance.choice(one.right) if act < 0.7 else (chance.choice(one.wrong), None)
            opened.setFocus()  # a new editing begins: it is taken back to what stood there then
            type_into(field, text)
            done.append(f"{one.key} {text}")
            if value is not None:
                assert not field.wrong, (seed, done, field.error)
                expected[one.key] = value
            else:
                assert field.wrong, (seed, done)
            if one.key == "height_m" and value is not None:  # H/t or alpha are kept, t follows
                expected["thickness_m"] = opened.session.case.wall[0].thickness
        case = recovered(opened.session, tmp_path / "recovery_folder")
        assert held(case) == pytest.approx(expected, rel=1e-9), (seed, done)


# red text through a change of language or theme


RED = (("height_m", "9..5"), ("thickness_m", "abc"), ("base_z_m", "-4"))


@pytest.mark.shows("window.language")
@pytest.mark.parametrize("choice", [("language", "it"), ("theme", "dark")])
def test_that_red_text_survives_a_change_of_language_or_theme(opened, application, choice):
    for key, text in RED:
        type_into(opened.walls.fields[key], text)
    type_into(opened.demand.fields["ag_g"], "a lot")
    before = opened.session.case
    said = {key: opened.walls.fields[key].error for key, _ in RED}
    opened.set_choice(*choice)
    application.processEvents()
    for key, text in RED:
        field = opened.walls.fields[key]
        assert field.wrong and field.editor.text() == text and text in {*field.error.split(":"), text}
        assert (field.error == said[key]) == (choice[0] == "theme"), "its words are of the new language"
    assert opened.demand.fields["ag_g"].editor.text() == "a lot" and opened.session.case == before
    assert not opened.run_action.isEnabled()


def test_that_red_text_of_a_load_and_of_a_solid_that_are_chosen_survives(opened, application):
    loads = opened.walls.loads
    for kind in ("vertical", "thrust"):
        loads.add(kind)
    loads.list.setCurrentRow(1)
    type_into(next(field for field in loads.fields if field.key == "kn_m"), "5,5,5")
    solids = opened.walls.body.solids
    for button in itertools.islice(solids.findChildren(type(solids.delete_button)), 1):
        button.click()
    corners = next(field for field in solids.fields if field.key == "polygon_m")
    corners.show()
    corners.editor.setPlainText("0 0\n4 x")
    assert corners.wrong
    before = opened.session.case
    opened.set_choice("language", "it")
    loads, solids = opened.walls.loads, opened.walls.body.solids
    size = next(field for field in loads.fields if field.key == "kn_m")
    assert loads.list.currentRow() == 1 and size.wrong and size.editor.text() == "5,5,5"
    corners = next(field for field in solids.fields if field.key == "polygon_m")
    assert corners.wrong and corners.editor.toPlainText() == "0 0\n4 x" and opened.session.case == before


def test_that_a_wall_of_a_table_is_no_draft_without_its_shape():
    """A wall without any size is written and read again: all of it is to be given."""
    from core.case.rules import parse_draft
    from core.case.schema import Case
    from core.case.writer import table_of

    case = Case(wall=(Wall("w", ""),))
    assert parse_draft(table_of(case)) == case


def test_that_a_load_whose_kind_is_still_to_be_given_is_shown(opened, application, faults, tmp_path):
    path = tmp_path / "draft.toml"
    sizes = 'mechanism = "one_sided"\nheight_m = 5.0\nthickness_m = 0.5\n'
    path.write_text(f'[[wall]]\nname = "w"\n{sizes}[[wall.load]]\nkn_m = 10.0\n')
    opened.session.saved = opened.session.case
    assert opened.files.open(path)
    opened.navigator.show_input("wall", 0)
    application.processEvents()
    assert faults == [] and opened.walls.loads.list.item(0).text().startswith("–, 10 kN/m")
