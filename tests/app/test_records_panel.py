"""Records in the window: each motion by itself, the dialog that takes files in."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from core.case.schema import Record
from core.case.site import Spectrum
from tests.app.driving import settle, type_into
from tests.conftest import ROOT


@pytest.fixture
def bundled(opened, application):
    """The window with the three bundled motions as one entry."""
    pattern = (ROOT / "tests" / "motions" / "noise_*.txt").as_posix()
    case = replace(opened.session.case, record=(Record(pattern, kind="artificial"),))
    opened.session.edit(case)
    settle(application, lambda: not opened.records.pending and len(opened.records.motions) > 2)
    return opened


def files(window) -> list[str]:
    return [entry.file.split("/")[-1] for entry in window.session.case.record]


def test_that_one_motion_of_many_is_left_out_alone(bundled, application):
    n = len(bundled.records.rows)
    bundled.records.table.item(1, 0).setCheckState(Qt.CheckState.Unchecked)
    entries = bundled.session.case.record
    assert [entry.include for entry in entries] == [k != 1 for k in range(n)]
    assert {entry.kind for entry in entries} == {"artificial"}
    settle(application, lambda: not bundled.records.pending)
    assert len(bundled.records.motions) == n - 1
    bundled.session.undo()
    assert files(bundled) == ["noise_*.txt"]


def test_that_one_motion_of_many_is_turned_or_removed_alone_and_all_of_them_as_one(bundled, application):
    bundled.records.table.selectAll()
    bundled.records.reverse()
    assert [entry.scale for entry in bundled.session.case.record] == [-1.0]
    settle(application, lambda: not bundled.records.pending)
    n = len(bundled.records.rows)
    bundled.records.table.clearSelection()
    bundled.records.table.selectRow(0)
    bundled.records.remove()
    assert files(bundled) == [f"noise_{k}.txt" for k in range(2, n + 1)]
    assert {entry.scale for entry in bundled.session.case.record} == {-1.0}


def test_that_a_record_that_is_there_twice_is_named_at_once(bundled, application, tmp_path):
    first = bundled.records.motions[0]
    copy = tmp_path / "copy.txt"
    copy.write_bytes((bundled.session.base_dir / first.file).read_bytes())
    bundled.session.add_records([Record(str(copy), kind="artificial")])
    settle(application, lambda: not bundled.records.pending)
    assert "twice" in bundled.records.words.text() and "copy" in bundled.records.words.text()
    last = bundled.records.table.rowCount() - 1
    assert "twice" in bundled.records.table.item(last, 1).toolTip()
    bundled.records.table.item(last, 0).setCheckState(Qt.CheckState.Unchecked)
    settle(application, lambda: not bundled.records.pending)
    assert "twice" not in bundled.records.words.text()


def test_that_generated_motions_are_ticked_and_stay_one_set(bundled, application):
    bundled.session.edit_section("demand", soil_factor=None)
    spectrum = Spectrum("EN1998", "B", type=1)
    bundled.session.edit_section("demand", spectrum=spectrum)
    bundled.records.ask_replace = lambda: False
    bundled.records.generate()
    settle(application, lambda: not bundled.records.pending)
    row = len(bundled.records.rows) - 1
    tick = bundled.records.table.item(row, 0)
    assert tick.checkState() == Qt.CheckState.Checked
    assert not tick.flags() & Qt.ItemFlag.ItemIsUserCheckable
    bundled.records.table.selectRow(row)
    bundled.records.reverse()
    assert bundled.records.words.text() == bundled.records.one_set
    bundled.records.remove()
    assert bundled.session.case.generate is None and files(bundled) == ["noise_*.txt"]


def test_that_the_dialog_takes_only_choices_the_case_accepts_and_shows_those_of_each_file(application, tmp_path):
    from PySide6.QtWidgets import QDialogButtonBox

    from app.input.import_dialog import ImportDialog

    samples = [f"{0.02 * k:.2f} {np.sin(0.1 * k):.6f}" for k in range(300)]
    for name in ("a.txt", "b.txt"):
        (tmp_path / name).write_text("\n".join(["head 1", *samples]))
    dialog = ImportDialog([tmp_path / "a.txt", tmp_path / "b.txt"])
    unit, step, column, skip, _, _ = dialog.fields
    ok = dialog.buttons.button(QDialogButtonBox.StandardButton.Ok)
    unit.offer("m/s2")
    for text in ("-0.01", "nan", "3"):
        type_into(step, text)
        application.processEvents()
        assert step.message.text() and not ok.isEnabled()
        assert dialog.entries[tmp_path / "a.txt"].time_step_s is None
    type_into(step, "0,02")
    type_into(column, "2")
    type_into(skip, "1")
    application.processEvents()
    assert ok.isEnabled()
    (entry,) = dialog.chosen()
    assert (entry.unit, entry.time_step_s, entry.column, entry.skip_lines) == ("m/s2", 0.02, 2, 1)
    dialog.list.setCurrentRow(1)
    assert step.editor.text() == "" and unit.editor.currentData() is None
    dialog.list.setCurrentRow(0)
    assert step.editor.text() == "0.02" and unit.editor.currentData() == "m/s2"
    dialog.deleteLater()


def test_that_files_beyond_what_the_dialog_shows_are_named(application, tmp_path):
    from app.input.import_dialog import MAX_FILES, ImportDialog

    paths = [tmp_path / f"{k}.txt" for k in range(MAX_FILES + 3)]
    dialog = ImportDialog(paths)
    assert len(dialog.paths) == MAX_FILES and "3" in dialog.hint.text()
    dialog.deleteLater()


def test_that_the_dialog_marks_what_cannot_be_read(application, tmp_path):
    from app.input.import_dialog import ImportDialog

    good, bad = tmp_path / "a_good.txt", tmp_path / "bad.txt"
    good.write_text("\n".join(f"{np.sin(0.1 * k):.6f}" for k in range(300)))
    bad.write_text("no numbers here")
    dialog = ImportDialog([good, bad])
    settle(application, lambda: not dialog.unmarked)
    assert "✕" in dialog.list.item(0).text() and "✕" in dialog.list.item(1).text()
    dialog.list.setCurrentRow(0)
    dialog.change(unit="g", time_step_s=0.01)
    settle(application, lambda: not dialog.unmarked)
    assert "✕" not in dialog.list.item(0).text() and "✕" in dialog.list.item(1).text()
    assert dialog.list.item(1).toolTip() and not dialog.list.item(0).toolTip()
    dialog.deleteLater()


def test_that_a_file_of_several_channels_is_a_row_for_each_and_none_is_taken_unticked(application, tmp_path):
    from PySide6.QtCore import Qt

    from app.input.import_dialog import ImportDialog
    from tests.core.ground import dialects

    path, other = tmp_path / "three.V2", tmp_path / "one.AT2"
    path.write_bytes(dialects.volume2())
    other.write_bytes(dialects.peer())
    dialog = ImportDialog([path, other])
    settle(application, lambda: not dialog.unmarked)
    shown = [dialog.list.item(k).text() for k in range(dialog.list.count())]
    assert [name.rstrip(" ✕") for name in shown] == [
        "three.V2: 1: 360 Deg",
        "three.V2: 2: Up (vertical)",
        "three.V2: 3: 90 Deg",
        "one.AT2",
    ]
    assert [entry.file for entry in dialog.chosen()] == [str(other)]
    for k in (0, 2):
        dialog.list.setCurrentRow(k)  # each has its preview
        assert "CSMIP" in dialog.words.text() and dialog.chart.data
        dialog.list.item(k).setCheckState(Qt.CheckState.Checked)
    taken = dialog.chosen()
    assert [entry.channel for entry in taken] == ["1: 360 Deg", "3: 90 Deg", ""]
    dialog.deleteLater()


def test_that_two_channels_of_one_file_are_two_records(opened, application, tmp_path):
    from tests.core.ground import dialects

    path = tmp_path / "three.V2"
    path.write_bytes(dialects.volume2())
    entries = tuple(Record(str(path), channel=name) for name in ("1", "3"))
    opened.session.edit(replace(opened.session.case, record=entries, generate=None))
    settle(application, lambda: not opened.records.pending)
    names = [motion.name for motion in opened.records.motions]
    assert names == ["three 1: 360 Deg", "three 3: 90 Deg"] and not opened.records._twins()
