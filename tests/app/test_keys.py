"""A key of a case is complete: its field in the window, its help, its line in the page of the case."""

from dataclasses import fields

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app import guide
from app.forms.fields import Field, TextField
from app.language import set_language
from core.case.keys import NESTED
from core.case.schema import Generate, Record, Wall, sections
from core.case.site import BuildingMode, Demand, HazardRow, Spectrum
from core.case.values import field_of

ELSEWHERE = {
    (Wall, "mechanism"): "three buttons with their drawings",
    (Wall, "law"): "a list and two ends (app/forms/impact_form.py)",
    (Spectrum, "code"): "a list of codes (app/forms/demand_form.py)",
    (Demand, "spectrum_file"): "the same list",
    (Demand, "limit_states"): "written in the case file; the outcome at each limit state is shown without it",
    (Demand, "hazard_file"): "the table takes the rows of such a file",
    **{(Generate, key): "the button Generate…, which makes seven" for key in ("count", "seed")},
    **{(Record, entry.name): "the panel of records and its dialog" for entry in fields(Record)},
    **{
        (section, entry.name): "a table of numbers pasted as text"
        for section in (HazardRow, BuildingMode)
        for entry in fields(section)
    },
}
"""(section, key) that a person gives in another way than by a field of its own, and which."""

SECTIONS = tuple(sections().values())


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


def test_that_what_is_given_in_another_way_is_still_a_key():
    for section, key in ELSEWHERE:
        assert field_of(section, key)
