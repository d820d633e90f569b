"""Dialogs that were asked once are gone, and leave nothing among the forms."""

import ast

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QDialog, QListWidget

from app.look.dialogs import delete_after_use
from app.shell.refused_texts import RefusedTexts
from tests.conftest import ROOT

NO_DIALOG = {"application", "menu"}
"""What else is executed: an application; a menu that is given its place."""


def test_that_a_dialog_is_gone_after_it_was_asked_also_where_that_fails(opened, faults):
    with pytest.raises(ZeroDivisionError), delete_after_use(QDialog(opened.walls)) as dialog:
        dialog.setObjectName("asked")
        raise ZeroDivisionError
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert opened.walls.findChild(QDialog, "asked") is None


def test_that_every_dialog_of_the_program_is_asked_once():
    found = []
    for path in sorted((ROOT / "app").rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        held = {
            id(node)
            for one in ast.walk(tree)
            if isinstance(one, ast.With) and any("delete_after_use(" in ast.unparse(item) for item in one.items)
            for node in ast.walk(one)
        }
        for node in ast.walk(tree):
            asked = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "exec"
            if asked and ast.unparse(node.func.value) not in NO_DIALOG and id(node) not in held:
                found.append(f"{path.name}: {ast.unparse(node)}")
    assert found == []


@pytest.mark.shows("window.language")
def test_that_a_change_of_language_finds_the_lists_of_the_forms_and_of_no_dialog(opened, application):
    """A dialog of a form that still stands, or is about to go, has a list too."""
    opened.walls.loads.add("vertical")
    left = QDialog(opened.walls.loads)
    QListWidget(left).addItems(["one", "two"])
    before = RefusedTexts(opened).rows
    opened.set_choice("language", "it")
    application.processEvents()
    assert RefusedTexts(opened).rows == before
