"""A key of a case is complete: its field in the window, its help, its line in the page of the case."""

from dataclasses import dataclass, fields

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtWidgets import QLabel

from app.input.fields import Field, TextField
from app.input.made_fields import make_fields
from app.look.language import describe_message, set_language
from app.shell import guide
from core.case import wall_columns, wall_table
from core.case.keys import NESTED, number_key
from core.case.place import Site
from core.case.schema import Generate, Record, sections
from core.case.select import Select
from core.case.sensitivity import Ranges
from core.case.site import BuildingMode, Demand, HazardRow, Spectrum
from core.case.solids import Drawing
from core.case.values import field_of, parse_section
from core.case.wall import Wall
from core.errors import InputError, place
from core.text.catalogue import CATALOGUE

ELSEWHERE = {
    (Wall, "mechanism"): "three buttons with their drawings",
    (Wall, "law"): "a list and two ends (app/input/impact_form.py)",
    (Spectrum, "code"): "a list of codes (app/input/demand_form.py)",
    (Demand, "spectrum_file"): "the same list",
    (Demand, "limit_states"): "written in the case file; the outcome at each limit state is shown without it",
    (Demand, "hazard_file"): "the table takes the rows of such a file",
    **{
        (Site, key): "search, coordinates and map of the place (app/input/place_form.py)"
        for key in ("province", "longitude")
    },
    **{(Drawing, entry.name): "the dialog of the button From a drawing…" for entry in fields(Drawing)},
    **{(Generate, key): "the button Generate…, which takes the usual" for key in ("count", "seed", "scatter")},
    **{
        (Ranges, entry.name): "written in the case file; the button Move each input takes the usual"
        for entry in fields(Ranges)
    },
    **{
        (Select, entry.name): "the dialog of the button Choose…, the rest written in the case file"
        for entry in fields(Select)
    },
    **{(Record, entry.name): "the panel of records and its dialog" for entry in fields(Record)},
    **{
        (section, entry.name): "a table of numbers pasted as text"
        for section in (HazardRow, BuildingMode)
        for entry in fields(section)
    },
}
"""(section, key) that a person gives in another way than by a field of its own, and which."""

SECTIONS = tuple(sections().values())


@pytest.mark.shows("window.help")
@pytest.mark.parametrize("section", SECTIONS, ids=lambda section: section.__name__)
def test_that_every_key_has_a_field_in_the_window(opened, section):
    made = {(field.section, field.key) for field in opened.findChildren(Field)}
    for entry in fields(section):
        by_hand = (section, entry.name) in ELSEWHERE
        if entry.metadata["kind"] not in NESTED or by_hand:
            assert ((section, entry.name) in made) != by_hand, entry.name


@pytest.mark.parametrize("language", ["en", "it"])
def test_that_every_field_but_a_text_has_help(opened, language):
    opened.set_choice("language", language)
    without = {
        (field.section.__name__, field.key)
        for field in opened.findChildren(Field)
        if field.section in SECTIONS and not isinstance(field, TextField) and not guide.help_of(field)
    }
    opened.set_choice("language", "en")
    set_language("en")
    assert without == set()


def test_that_its_line_and_its_words_are_all_that_a_key_needs(opened, monkeypatch):
    """Field with unit, caption, tip and F1, what it accepts said by its caption, column of a table of walls."""
    texts = {
        "plaster_kn_m2": ("weight of the plaster", "peso dell'intonaco"),
        "plaster_kn_m2.tip": ("On both faces", "Sulle due facce"),
        "plaster_kn_m2.help": ("The plaster rocks with the wall.", "L'intonaco ruota con la parete."),
        "joint_m": ("joint", "giunto"),
        "joint_m.caption": ("Joint j", "Giunto j"),
        "joint_m.column": ("j", "j"),
    }
    monkeypatch.setitem(CATALOGUE.known, "key", CATALOGUE["key"] | texts)

    @dataclass(frozen=True)
    class Plastered(Wall):
        plaster_kn_m2: float | None = number_key(0.0, 2.0, unit="kN/m2", form="mine")
        joint_m: float = number_key(0.0, 0.5, 0.01, unit="m", form_unit="cm", form="mine")

    plaster, joint = make_fields(Plastered, "mine")
    assert (plaster.caption.text(), plaster.editor.toolTip()) == ("Weight of the plaster", "On both faces")
    assert guide.help_of(plaster) == "The plaster rocks with the wall."
    assert "kN/m²" in [label.text() for label in plaster.findChildren(QLabel)]
    assert plaster.optional and not joint.optional
    joint.show_value(0.02)
    assert (joint.caption.text(), joint.editor.text()) == ("Joint j", "2")
    joint.offer(0.6)
    assert joint.message.text() == "from 0 to 50 cm"
    with pytest.raises(InputError) as caught:
        parse_section(
            Plastered, {"name": "w", "mechanism": "both", "plaster_kn_m2": 3}, "wall", place("wall", name="w")
        )
    assert describe_message(caught.value) == 'wall "w": Weight of the plaster = 3 is not accepted: from 0 to 2 kN/m2'

    monkeypatch.setattr(wall_columns, "Wall", Plastered)
    monkeypatch.setattr(wall_columns, "parse_wall", lambda table: table)
    monkeypatch.setattr(wall_columns, "columns", wall_columns.columns.__wrapped__)
    for titles in ("Parete;Peso dell'intonaco [kN/m²];j [cm]", "name;weight of the plaster [kN/m2];joint_m [cm]"):
        (row,) = wall_table.parse_wall_rows(wall_table.text_rows(f"{titles}\nw;0,4;2"))
        assert row == {"name": "w", "plaster_kn_m2": 0.4, "joint_m": 0.02}


def test_that_what_is_given_in_another_way_is_still_a_key():
    for section, key in ELSEWHERE:
        assert field_of(section, key)
