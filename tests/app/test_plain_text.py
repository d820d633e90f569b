"""Names are text: no label of the window takes one as markup, no line of a terminal is made by one."""

import os
from dataclasses import replace
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6 import QtGui
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel

from core.case.rules import parse_wall
from core.errors import InputError, place
from tests.app.driving import settle
from tests.test_boundaries import ROOT
from tests.trees import nodes_of

EVIL = "<h1>VERIFIED</h1><img src='x'>"


def test_that_labels_are_made_plain_or_rich_by_one_helper():
    import ast

    for path in sorted((ROOT / "app").rglob("*.py")):
        if path.name == "labels.py":
            continue
        for node in nodes_of(path):
            made = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "QLabel"
            assert not made, path


@pytest.mark.shows("doors.markup")
def test_that_no_label_of_the_window_takes_a_name_as_markup(opened, application):
    wall = replace(opened.session.case.wall[0], name=EVIL, floor=EVIL, notes=EVIL)
    opened.session.edit(replace(opened.session.case, wall=(wall,), title=EVIL))
    settle(application, lambda: True)
    labels = [label for label in opened.findChildren(QLabel) if type(label).__module__.startswith("app.")]
    assert len(labels) > 40
    for label in labels:
        assert label.textFormat() in (Qt.TextFormat.PlainText, Qt.TextFormat.RichText)
        if label.textFormat() == Qt.TextFormat.RichText:
            assert "<h1>" not in label.text() and "<img" not in label.text(), label.text()


@pytest.mark.parametrize("name", ["a\x1b[31mb", "a\x07", "a\u202eb", "a\nerror: verified", "a\r\nb", "a\u2028b"])
def test_that_no_name_makes_a_line_or_a_colour_of_a_sentence(name):
    with pytest.raises(InputError) as refused:
        parse_wall({"name": name, "mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.4})
    for error in (refused.value, InputError("no_case_file", place=(Path(name), place("wall", name=name)))):
        for language in ("en", "it"):
            text = error.text(language)
            assert text.isprintable() and len(text.splitlines()) == 1


BOXES = ("warning", "critical", "question", "information")


@pytest.mark.shows("doors.markup")
def test_that_message_boxes_and_tips_take_no_name_as_markup():
    """What they say is a text of the program without values, or goes through `escape_html`."""
    import ast

    bare, seen = [], 0
    for path in sorted((ROOT / "app").rglob("*.py")):
        for node in nodes_of(path):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
                continue
            of_box = node.func.attr in BOXES and ast.unparse(node.func.value) == "QMessageBox" and len(node.args) > 2
            if not of_box and node.func.attr != "setToolTip":
                continue
            said, seen = node.args[2] if of_box else node.args[-1], seen + 1
            made = ast.unparse(said.func) if isinstance(said, ast.Call) else ""
            if not (isinstance(said, ast.Constant) or made == "escape_html" or (made == "tr" and not said.keywords)):
                bare.append(f"{path.name}: {ast.unparse(node)}")
    assert seen > 40 and bare == []


@pytest.mark.parametrize("text", [EVIL, "/tmp/<b>verified</b>.toml: not read", "a < b\nc > d", "plain words"])
def test_that_plain_shows_every_letter_of_a_text(application, text):
    from PySide6.QtGui import QTextDocument

    from app.look.labels import escape_html

    shown, document = escape_html(text), QTextDocument()
    if QtGui.Qt.mightBeRichText(shown):
        document.setHtml(shown)
        assert document.toPlainText() == text
    else:
        assert shown == text
