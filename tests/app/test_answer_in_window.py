"""Every zeta that the window shows of a finished run is one of the answer: pages, tables, bars, tree."""

import re

import pytest
import tomlkit

from core.answer.answer import answers_worst_first
from core.study.run import run
from core.variation import measures
from tests.core.answer.test_faces import HALF, by_heads, shown_in, zetas_of
from tests.core.variation.random_walls import random_tables

TAGS = re.compile(r"<[^>]*>")


def words_of_window(window):
    """Every text of the widgets of the window, cells below a head of zeta with it."""
    from PySide6.QtWidgets import QAbstractButton, QLabel, QTableWidget, QWidget

    def shown(kind):
        return (widget for widget in window.findChildren(kind) if widget.isVisible())

    for label in shown(QLabel):
        yield TAGS.sub(" ", label.text())
    for button in shown(QAbstractButton):
        yield button.text()
    for widget in shown(QWidget):
        yield widget.accessibleName()
        yield TAGS.sub(" ", widget.toolTip())
    for table in shown(QTableWidget):
        heads = [table.horizontalHeaderItem(column) for column in range(table.columnCount())]
        cells = [[table.item(row, column) for column in range(table.columnCount())] for row in range(table.rowCount())]
        text = [[item.text() if item else "" for item in row] for row in [heads, *cells]]
        yield from by_heads(text[0], text[1:])
    for row in window.tree.rows:
        yield f"ζ {row.chip}" if row.kind in ("wall", "group", "hinge") else row.chip


@pytest.mark.shows("answer.faces")
@pytest.mark.parametrize("language", ["en", "it"])
def test_that_every_zeta_of_the_window_is_one_of_the_answer(application, opened, language, monkeypatch, tmp_path):
    monkeypatch.setattr(measures, "MOST", 0)
    opened.set_choice("language", language)
    read = 0
    for number, table in enumerate(random_tables(4, first=44_000)):
        file = tmp_path / f"case{number}.toml"
        file.write_text(tomlkit.dumps(table | {"analysis": table["analysis"] | {"histories": False}}), encoding="utf-8")
        assert opened.files.open(file)
        result = run(opened.session.case, base_dir=tmp_path)
        opened.navigator.take(result)
        assert not opened.session.stale
        known = sorted(zeta for answer in answers_worst_first(result) for zeta in zetas_of(answer))
        for page in ("walls", "check"):
            opened.navigator.show_page(page)
            for _ in range(3):
                application.processEvents()
            for text in words_of_window(opened):
                for zeta in shown_in(text):
                    read += 1
                    assert min(abs(zeta - value) for value in known) <= HALF, (page, zeta, text[:200])
    assert read > 40
