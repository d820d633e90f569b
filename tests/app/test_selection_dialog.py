"""Records chosen from a folder in the window: the list of sets, the one that is taken."""

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtWidgets import QDialog

from app.input.selection_dialog import SelectionDialog, choose_for
from core.case.select import Select
from core.setting.plan import select_case_records
from tests.app.driving import settle
from tests.core.study.folder_of_records import case, write_folder


@pytest.fixture(scope="module")
def base(tmp_path_factory):
    place = tmp_path_factory.mktemp("select")
    write_folder(place)
    return place


def test_that_the_sets_are_listed_and_one_is_taken(base, application):
    dialog = SelectionDialog(case(), base)
    assert dialog.count.value() == 3 and dialog.folder.text() == "recs" and not dialog.ok.isEnabled()
    dialog.search()
    assert dialog.stop_button.isEnabled() and not dialog.search_button.isEnabled()
    settle(application, lambda: dialog.job is None)
    found = select_case_records(case(), base)[1]
    assert dialog.table.rowCount() == len(found.sets) == 10
    assert dialog.taken == found.chosen.records and dialog.ok.isEnabled()
    assert "20 horizontal records of 23 files" in dialog.words.text()
    dialog.table.selectRow(4)
    assert dialog.taken == found.sets[4].records
    dialog.deleteLater()


def test_that_a_search_is_stopped_and_what_cannot_be_chosen_is_said(base, application):
    dialog = SelectionDialog(case(), base)
    dialog.search()
    dialog.stop()
    settle(application, lambda: dialog.job is None)
    assert dialog.taken == () and not dialog.ok.isEnabled() and dialog.words.text() == "Stopped."
    dialog.folder.setText("nothing")
    dialog.search()
    settle(application, lambda: dialog.job is None)
    assert "there is no such folder" in dialog.words.text() and dialog.table.rowCount() == 0
    dialog.deleteLater()


def test_that_the_records_of_the_set_take_the_place_of_those_there(base, opened, application, monkeypatch):
    found = select_case_records(case(), base)[1]
    taken = tuple(replace(record, file=str((base / record.file).resolve())) for record in found.chosen.records)

    def accepted(dialog) -> int:
        dialog.show_found(replace(found, sets=(replace(found.chosen, records=taken),)))
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(SelectionDialog, "exec", accepted)
    opened.session.edit(replace(opened.session.case, demand=None, generate=None))
    opened.records.choose()
    assert "spectrum of the demand" in opened.records.words.text()
    opened.session.edit(replace(opened.session.case, demand=case().demand))
    assert choose_for(opened.session, opened) == ""
    assert opened.session.case.record == taken and opened.session.case.generate is None
    settle(application, lambda: not opened.records.pending and len(opened.records.motions) == 3)
    assert [motion.scale for motion in opened.records.motions] == [one.scale for one in taken]
    opened.session.undo()
    assert opened.session.case.record != taken


def test_that_a_case_with_a_choice_shows_what_is_chosen_and_keeps_its_folder(base, opened, application):
    asked = case()
    select = replace(asked.select, folder=str(base / "recs"))
    opened.session.edit(replace(opened.session.case, record=(), generate=None, demand=asked.demand, select=select))
    settle(application, lambda: not opened.records.pending and len(opened.records.motions) == 3)
    assert [opened.records.table.item(k, 5).text() for k in range(3)] == ["natural"] * 3
    moved = opened.session._moved(replace(opened.session.case, select=Select("recs")), Path("/a"), Path("/a/b"))
    assert moved.select.folder == "../recs"
    opened.records.table.selectAll()
    opened.records.remove()
    assert opened.session.case.select is None
