"""Where a reader who timed an engineer's tasks stumbled: each was so once."""

import os

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from tests.app.driving import type_into


def choose(field, name) -> None:
    """A name of a list, as a click has it."""
    field.editor.setCurrentIndex(field.editor.findData(name))
    field.editor.activated.emit(field.editor.currentIndex())


def test_that_a_level_of_knowledge_proposes_its_confidence_factor_and_none_below_it(opened):
    fields, session = opened.demand.fields, opened.session
    for level, factor in (("LC2", 1.2), ("LC3", 1.0), ("LC1", 1.35), ("LC3", 1.0)):
        choose(fields["knowledge_level"], level)
        assert session.case.demand.confidence_factor == factor
    type_into(fields["confidence_factor"], "1.1")
    choose(fields["knowledge_level"], "LC2")
    assert session.case.demand.confidence_factor == 1.2
    type_into(fields["confidence_factor"], "1.3")
    choose(fields["knowledge_level"], "LC3")
    assert session.case.demand.confidence_factor == 1.3
    session.undo()
    assert (session.case.demand.knowledge_level, session.case.demand.confidence_factor) == ("LC2", 1.3)
