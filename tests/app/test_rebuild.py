"""A change of theme or language builds the window again: of the one before nothing stays alive."""

import gc
import os
from collections import Counter

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication, QGraphicsItem
from shiboken6 import isValid

from app.views.chart import Chart
from tests.app.driving import run, settle


def alive(application) -> Counter:
    """How many objects of Qt there are, by their type: widgets, and what Python knows of the others."""
    for _ in range(3):
        application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        application.processEvents()
        gc.collect()
    found = Counter(type(one).__name__ for one in QApplication.allWidgets() if isValid(one))
    known = (one for one in gc.get_objects() if isinstance(one, (QObject, QGraphicsItem)))
    return found + Counter(f"in Python: {type(one).__name__}" for one in known)


@pytest.mark.long
def test_that_four_changes_of_theme_and_language_leave_no_more_alive_than_one(opened, application):
    run(application, opened)

    def change(k: int) -> None:
        opened.set_choice("theme", ("dark", "light")[k % 2])
        opened.set_choice("language", ("it", "en")[k % 2])
        for kind in opened.stages.input.areas:
            opened.navigator.show_input(kind)
        for name in opened.pages:
            opened.navigator.show_page(name)
        settle(application, lambda: not opened.pages["note"].content.is_setting)

    change(0)
    change(1)  # the window was in English and light before: as it was
    once = alive(application)
    charts = sum(once[kind.__name__] for kind in (Chart, *Chart.__subclasses__()))
    assert charts == len(opened.findChildren(Chart)) >= 13
    for k in range(4):
        change(k)
    assert alive(application) == once
