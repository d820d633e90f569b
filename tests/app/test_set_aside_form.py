"""A mechanism is set aside in the window, with its document, and looked at again."""

import os

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from core.case.document import Document
from core.case.set_aside import SetAside
from tests.app.driving import type_into


def field(fields, key):
    return next(field for field in fields if field.key == key)


def test_that_a_mechanism_set_aside_by_hand_is_in_the_case_with_its_document(opened):
    form = opened.walls.set_aside
    form.add("overturning")
    assert opened.session.problem() is not None  # its document is to be given
    field(form.shown_by.fields, "kind").offer("calculation")
    type_into(field(form.shown_by.fields, "reference"), "sheet 4")
    type_into(field(form.fields, "from_m"), "3")
    entry = SetAside("overturning", 3.0, evidence=Document("calculation", "sheet 4"))
    assert opened.session.case.wall[0].set_aside == (entry,)
    assert opened.session.problem() is None
    assert form.list.item(0).text() == "Overturning, ≥ 3 m"
    form.delete()
    assert opened.session.case.wall[0].set_aside == ()


def test_that_what_is_left_out_leads_to_where_it_is_set_aside(opened):
    opened.navigator.ask("set_aside")
    assert opened.walls.set_aside.isVisibleTo(opened)
