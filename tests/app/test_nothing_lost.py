"""What a user named, saved or started is not changed or lost without a word."""

import os
from dataclasses import replace
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox

from app.shell import files
from app.work import recovery
from core.errors import InputError
from tests.app.driving import run, settle


def own_record(opened, application, tmp_path) -> Path:
    """The one record of the case, copied where a test may change it."""
    (entry,) = opened.session.case.record
    mine = tmp_path / "mine.txt"
    mine.write_bytes(Path(entry.file).read_bytes())
    opened.session.edit(replace(opened.session.case, record=(replace(entry, file=mine.name),)))
    settle(application, lambda: not opened.records.pending)
    return mine


@pytest.mark.shows("window.not_overwritten")
@pytest.mark.parametrize("answer, written", [("Yes", True), ("No", False)])
def test_that_an_ending_added_to_a_name_overwrites_nothing_unasked(opened, tmp_path, monkeypatch, answer, written):
    (tmp_path / "v1.2.toml").write_text("another")
    (tmp_path / "v1.toml").write_text("a third")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "v1.2"), ""))
    monkeypatch.setattr(QMessageBox, "question", lambda *_: getattr(QMessageBox.StandardButton, answer))
    assert opened.files.save_as() is written
    assert ((tmp_path / "v1.2.toml").read_text() == "another") is not written
    assert (tmp_path / "v1.toml").read_text() == "a third"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: ("", ""))
    assert files.path_to_write(opened, "", "", "", (".toml",)) is None


def test_that_a_chart_not_written_says_so(opened, monkeypatch):
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    target = Path("/nowhere/at/all.csv")
    monkeypatch.setattr("app.views.chart_output.path_to_write", lambda *_: target)
    opened.pages["check"].content.peaks._save_data()
    assert said[0].startswith(f"{target}: cannot be written (No such file or directory)")


@pytest.mark.parametrize("line", ['height_m = "7,0"', "name = 3", "law = {a = 1}", "notes = 2", "height_m = 1e9"])
def test_that_a_case_with_a_value_of_another_kind_leaves_what_is_open(opened, tmp_path, monkeypatch, line):
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    bad = tmp_path / "bad.toml"
    bad.write_text(f"[[wall]]\n{line}\n")
    before, path = opened.session.case, opened.session.path
    assert not opened.files.open(bad)
    assert said and line.split(" = ")[0] in said[0]
    assert opened.session.case == before and opened.session.path == path


@pytest.mark.parametrize("text", ["record = 5", "wall = 3", "[report]\nrevision = 2", "title = 5"])
def test_that_a_case_of_another_shape_is_refused_in_words(opened, tmp_path, monkeypatch, text):
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    bad = tmp_path / "bad.toml"
    bad.write_text(text)
    assert not opened.files.open(bad) and said


@pytest.mark.shows("window.not_overwritten")
def test_that_a_case_changed_by_another_program_is_not_overwritten_unasked(opened, monkeypatch):
    path = opened.session.path
    path.write_text(path.read_text() + "# a note\n")
    opened.session.edit_section("analysis", q_step=0.03)
    asked = []
    monkeypatch.setattr(QMessageBox, "question", lambda *a: asked.append(a[2]) or QMessageBox.StandardButton.No)
    assert not opened.files.save() and "another program" in asked[0].lower()
    assert path.read_text().endswith("# a note\n")


def test_that_a_file_beside_the_workbook_is_not_overwritten_unasked(opened, application, tmp_path, monkeypatch):
    run(application, opened)
    own = tmp_path / "own.json"
    own.write_text("mine")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "own.xlsx"), ""))
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.No)
    opened.files.ask_export()
    assert opened.runner.job is None and own.read_text() == "mine"


def test_that_a_run_reads_records_that_changed_on_disk(opened, application, tmp_path):
    mine = own_record(opened, application, tmp_path)
    key = opened.records.key
    opened.run()
    opened.runner.cancel()
    assert opened.records.key == key and not opened.records.pending  # nothing changed
    size = opened.records.motions[0].acceleration.size
    lines = mine.read_text().splitlines()
    mine.write_text("\n".join(lines[: len(lines) // 2]))
    opened.run()
    opened.runner.cancel()
    settle(application, lambda: not opened.records.pending)
    assert opened.records.motions[0].acceleration.size < size


def test_that_the_newest_of_two_autosaves_comes_first_and_says_of_which_file(opened, tmp_path):
    import json

    folder = opened.session.recovery_folder
    folder.mkdir(exist_ok=True)
    for number, age in ((999998, 50), (999999, 500)):
        swap = folder / f"x-{number}.swap"
        swap.write_text(json.dumps({"path": "/a/b.toml", "base_dir": "/a", "case": ""}))
        os.utime(swap, (1.7e9 - age, 1.7e9 - age))
    found = opened.session.recoverable()
    assert [path.name for path in found] == ["x-999998.swap", "x-999999.swap"]
    assert recovery.describe(found[0]).startswith("/a/b.toml 20")


@pytest.mark.shows("window.stale")
def test_that_a_record_changed_on_disk_makes_the_results_stale(opened, application, tmp_path):
    mine = own_record(opened, application, tmp_path)
    run(application, opened)
    assert not opened.session.stale and not opened.files.export_refused()
    mine.write_text("\n".join(mine.read_text().splitlines()[:-200]) + "\n")
    assert opened.files.export_refused()  # seen at the export, before the window has read it again
    settle(application, lambda: not opened.records.pending)
    assert opened.session.stale and opened.stages.veil.isVisibleTo(opened)


NAMES = (
    "no\u00a0break.txt",
    "zero\u200bwidth.txt",
    "soft\u00adhyphen.txt",
    "new\U0001fae8emoji.txt",
    "bell\x07.txt",
    "no\uffffcharacter_x0041_.txt",
    "quote'\"percent%41.txt",
    "accent è.txt",
    "[1].txt",
)


@pytest.mark.parametrize(
    "name",
    [
        *(pytest.param(name, marks=pytest.mark.long) for name in NAMES[:6]),
        *NAMES[6:],
        b"latin-\xe8.txt".decode("utf-8", "surrogateescape"),
    ],
)
def test_that_every_name_the_system_gives_can_be_saved_read_run_and_reported(opened, application, tmp_path, name):
    """Dropped, saved, opened again, autosaved and recovered, run by the batch, read by a spreadsheet."""
    import openpyxl

    from app.terminal import batch
    from app.work.session import Session

    (entry,) = opened.session.case.record
    mine = tmp_path / name
    mine.write_bytes(Path(entry.file).read_bytes())
    record = replace(entry, file=opened.session.relative(mine))
    opened.session.edit(replace(opened.session.case, record=(record,)))
    settle(application, lambda: not opened.records.pending)
    assert len(opened.records.motions) == 1
    opened.session.autosave()
    other = Session(tmp_path / "recovery_folder")
    other.recover(opened.session.recovery_file)
    assert other.case.record == opened.session.case.record
    path = tmp_path / "saved.toml"
    opened.session.save(path)
    opened.session.open(path)
    assert opened.session.problem() is None
    assert batch.run(path, tmp_path / "out", 1, True, False) == 0
    book = openpyxl.load_workbook(tmp_path / "out" / "saved.xlsx")
    assert book.sheetnames and (tmp_path / "out" / "saved.json").read_text(encoding="utf-8")


def test_that_only_the_word_discard_deletes_an_autosave(opened, monkeypatch, tmp_path):
    from app.shell import start

    folder = opened.session.recovery_folder
    folder.mkdir(exist_ok=True)
    good, bad = folder / "x-aa.swap", folder / "y-bb.swap"
    good.write_text('{"path": null, "base_dir": ".", "case": ""}')
    bad.write_text("{")
    button = QMessageBox.StandardButton
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    for answer, left in ((button.Cancel, 2), (button.Discard, 0)):
        monkeypatch.setattr(QMessageBox, "question", lambda *_, answer=answer: answer)
        start.offer_recovery(opened)
        assert len(list(folder.glob("[xy]-*.swap"))) == left
    bad.write_text("{")
    monkeypatch.setattr(QMessageBox, "question", lambda *_: button.Yes)
    start.offer_recovery(opened)
    assert bad.exists() and "cannot be read" in said[0]


@pytest.mark.shows("doors.swap")
@pytest.mark.parametrize(
    "content",
    [
        "[]",
        "5",
        "null",
        '{"case": 5, "base_dir": ".", "path": null}',
        '{"case": "", "base_dir": 5, "path": null}',
        '{"case": "", "base_dir": ".", "path": "a\\u0000b"}',
        '{"case": "wall = 3", "base_dir": ".", "path": null}',
        '{"case": "", "base_dir": ".", "path": ["x"]}',
        "[" * 100000,
        '{"case": "x = [[[[", "base_dir": ".", "path": null}',
    ],
)
def test_that_no_content_of_a_swap_file_ends_the_program(opened, content):
    swap = opened.session.recovery_folder / "z-cc.swap"
    swap.parent.mkdir(exist_ok=True)
    swap.write_text(content)
    assert swap in opened.session.recoverable() and recovery.describe(swap)
    with pytest.raises(InputError):
        opened.session.recover(swap)
    assert swap.exists()


@pytest.mark.shows("doors.swap")
@pytest.mark.parametrize("value", ["nonsense", ["a", "b"], 5, b"\xff", ""])
def test_that_no_value_of_the_settings_keeps_the_window_from_starting(application, tmp_path, value):
    from PySide6.QtCore import QSettings

    from app.look import theme
    from app.shell import menus, window

    settings = QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)
    for key in ("theme", "language", "recent", "geometry", "state"):
        settings.setValue(key, value)
    assert menus.chosen(settings, "theme", theme.THEMES) is None
    made = window.MainWindow(settings, tmp_path / "recovery_folder")
    made.session.saved = made.session.case
    made.close()
    made.deleteLater()


def test_that_dropped_files_are_copied_never_moved(opened, tmp_path):
    from PySide6.QtCore import QMimeData, QPointF, QUrl
    from PySide6.QtGui import QDropEvent

    data = QMimeData()
    data.setUrls([QUrl("http://not.a/file")])
    both = Qt.DropAction.MoveAction | Qt.DropAction.CopyAction
    event = QDropEvent(QPointF(5, 5), both, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier)
    event.setDropAction(Qt.DropAction.MoveAction)
    opened.records.dropEvent(event)
    assert event.dropAction() == Qt.DropAction.CopyAction


def test_that_a_spectrum_file_changed_on_disk_makes_the_results_stale(opened, application, tmp_path):
    rows = [(0.05 * k, 0.24 * min(1.0 + k, 2.5, 25.0 / max(k, 1))) for k in range(100)]
    place = tmp_path / "s.txt"
    place.write_text("\n".join(f"{t:.2f} {s:.5f}" for t, s in rows) + "\n")
    opened.session.edit_section("demand", spectrum_file=place.name, housner_intensity_cm=None)
    settle(application, lambda: not opened.records.pending)
    run(application, opened)
    assert not opened.session.stale
    place.write_text("\n".join(f"{t:.2f} {s * (1.2 if t > 1 else 1):.5f}" for t, s in rows) + "\n")
    assert opened.session.stale
