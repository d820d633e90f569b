"""The window, offscreen: forms and case, records, run, cancel, stale results, export, languages."""

import os
import time
from dataclasses import replace

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QLocale, QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget

from app.look.drawing import moving_blocks
from app.shell.navigator import row_of
from core.case.reader import read_case
from core.case.rules import parse_case
from core.study import run as study
from tests.app.driving import run, settle, type_into
from tests.conftest import ROOT


@pytest.mark.shows("window.marks")
@pytest.mark.parametrize("locale", ["it_IT", "de_DE", "en_US", "C"])
def test_that_comma_and_point_mean_the_same_in_every_locale(opened, locale):
    QLocale.setDefault(QLocale(locale))
    try:
        for text in ("31.2", "31,2"):
            type_into(opened.walls.fields["thickness_m"], text)
            assert opened.session.case.wall[0].thickness_m == pytest.approx(0.312, rel=1e-15)
    finally:
        QLocale.setDefault(QLocale("C"))


def test_that_a_wrong_number_is_said_at_the_field_and_leaves_the_case(opened):
    field = opened.walls.fields["thickness_m"]
    type_into(field, "abc")
    assert field.is_wrong and "not a number" in field.said
    type_into(field, "9999999")
    assert "from 0.5 to 2000 cm" in field.said
    assert opened.session.case.wall[0].thickness_m != 99999.99
    type_into(field, "62")
    assert not field.is_wrong and field.said == ""
    assert opened.session.case.wall[0].thickness_m == pytest.approx(0.62)


def test_that_form_and_case_say_the_same_after_undo(opened):
    type_into(opened.walls.fields["height_m"], "6,5")
    assert opened.session.case.wall[0].height_m == 6.5
    opened.tree.tree.setFocus()
    opened.session.undo()
    assert opened.walls.fields["height_m"].editor.text() == "5"
    assert "*" not in opened.windowTitle()


def test_that_the_geometry_can_be_written_in_four_ways_and_stays_the_same_wall(opened):
    block = opened.session.case.wall[0].block()
    for k in (1, 2, 3, 0):
        opened.walls.shape.setCurrentIndex(k)
        opened.walls._shape_chosen(k)
        found = opened.session.case.wall[0].block()
        assert found.slenderness == pytest.approx(block.slenderness, rel=1e-12)
        assert found.p2 == pytest.approx(block.p2, rel=1e-12)


def test_that_the_way_back_from_a_general_block_rounds_nothing(opened):
    opened.session.edit_wall(0, height_m=6.1, thickness_m=0.37, hinge_setback_m=0.013)
    wall = opened.session.case.wall[0]
    for shape in ("general", "thickness_m"):
        opened.walls._shape_chosen(opened.walls.shape.findData(shape))
    assert opened.session.case.wall[0] == wall
    opened.walls._shape_chosen(opened.walls.shape.findData("general"))
    opened.session.edit_wall(0, radius_m=2.5)  # another block: nothing to go back to
    opened.walls._shape_chosen(opened.walls.shape.findData("thickness_m"))
    found = opened.session.case.wall[0]
    assert found.height_m != pytest.approx(6.1, rel=1e-3) and found.hinge_setback_m == 0.0


def test_that_the_mechanism_of_a_new_wall_is_found_until_one_is_chosen(opened):
    opened.walls.add()
    assert opened.session.case.wall[-1].mechanism == ""
    type_into(opened.walls.fields["height_m"], "4")
    type_into(opened.walls.fields["thickness_m"], "40")
    assert not opened.run_button.isEnabled() and "mechanism" not in opened.missing.text()
    chosen = {name: button.isChecked() for name, button in opened.walls.mechanisms.items()}
    assert [name for name, checked in chosen.items() if checked] == ["two_sided"]  # nothing holds it
    QTest.mouseClick(opened.walls.mechanisms["one_sided"], Qt.MouseButton.LeftButton)
    assert opened.session.case.wall[-1].mechanism == "one_sided"
    # with a demand the height of the base is never guessed
    assert not opened.run_button.isEnabled() and opened.walls.fields["base_z_m"].message.text()
    type_into(opened.walls.fields["base_z_m"], "0")
    assert opened.session.case.wall[-1].base_z_m == 0.0 and opened.run_button.isEnabled()


@pytest.mark.shows("window.paste")
def test_that_rows_copied_from_excel_become_walls(opened):
    QApplication.clipboard().setText("Parete\tz\tH\tt\tMeccanismo\n\tm\tm\tcm\t\nnord\t0\t4,5\t45\tun lato\n")
    opened.walls.paste()
    wall = opened.session.case.wall[-1]
    assert (wall.name, wall.height_m, wall.mechanism) == ("nord", 4.5, "one_sided")
    assert wall.thickness_m == pytest.approx(0.45)


@pytest.mark.shows("window.job")
def test_the_whole_job(opened, application, tmp_path):
    """Run, look at every tab, edit, see it stale, run again, cancel, export, save, open again."""
    run(application, opened)
    result = opened.session.result
    assert result.walls[0].q_set is not None
    for name in opened.pages:
        opened.navigator.show_page(name)
        application.processEvents()
    assert not opened.stages.veil.isVisibleTo(opened)
    type_into(opened.walls.fields["height_m"], "4.8")
    assert opened.session.stale and opened.stages.veil.isVisibleTo(opened)
    assert opened.files.export_refused()
    run(application, opened)
    assert not opened.session.stale
    opened.session.edit_section("analysis", q_step=0.0005)
    opened.run()
    settle(application, lambda: opened.stages.bar.maximum() > 0)
    opened.runner.cancel()
    start = time.monotonic()
    settle(application, lambda: opened.runner.job is None)
    assert time.monotonic() - start < 5.0  # measured in the benchmark; here only that it ends
    opened.session.undo()
    assert not opened.session.stale  # the finished result is kept
    opened.files.save()
    opened.files.export(tmp_path / "out" / "small.xlsx") if (tmp_path / "out").mkdir() is None else None
    settle(application, lambda: opened.runner.job is None)
    assert (tmp_path / "out" / "small.xlsx").exists()
    assert read_case(opened.session.path) == opened.session.case


@pytest.mark.shows("window.same_files")
def test_that_the_exported_workbook_is_the_batchs_cell_for_cell(opened, application, tmp_path):
    from app.terminal import batch
    from core.report.differences import compare_workbooks

    run(application, opened)
    (tmp_path / "a").mkdir()
    opened.files.export(tmp_path / "a" / "small.xlsx")
    settle(application, lambda: opened.runner.job is None)
    assert batch.run(opened.session.path, tmp_path / "b", 1, True, False) == 0
    assert compare_workbooks(*((tmp_path / name / "small.xlsx").read_bytes() for name in "ab")) == ([], [])


def test_that_dropped_files_become_records(opened, application):
    motions = sorted((ROOT / "tests" / "motions").glob("noise_[23].txt"))
    opened.records.take(motions, ask=False)
    settle(application, lambda: len(opened.records.motions) == 3)
    assert opened.records.table.rowCount() == 3
    opened.records.table.selectRow(1)
    opened.records.reverse()
    assert opened.session.case.record[1].scale == -1.0
    opened.records.remove()  # the rows are of before: nothing is removed by mistake
    assert len(opened.session.case.record) == 3
    settle(application, lambda: not opened.records.pending)
    opened.records.table.item(2, 0).setCheckState(Qt.CheckState.Unchecked)
    assert opened.session.case.record[2].include is False


def test_that_files_and_folders_dropped_with_the_mouse_are_taken(opened, application, monkeypatch):
    from app.input.import_dialog import ImportDialog

    seen = []
    monkeypatch.setattr(ImportDialog, "exec", lambda dialog: seen.append(dialog) or dialog.DialogCode.Accepted)
    folder = ROOT / "tests" / "motions"
    payload = QMimeData()
    payload.setUrls([QUrl.fromLocalFile(str(folder)), QUrl("https://example.org/a.txt")])
    place = QPointF(opened.records.rect().center())
    keys = (Qt.DropAction.CopyAction, payload, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    enter = QDragEnterEvent(place.toPoint(), *keys)
    application.sendEvent(opened.records, enter)
    assert enter.isAccepted()
    application.sendEvent(opened.records, QDropEvent(place, *keys))
    names = {path.name for path in folder.glob("*.txt")}
    settle(application, lambda: len(opened.records.motions) == len(names) + 1)
    assert len(seen) == 1
    assert {entry.file.split("/")[-1] for entry in opened.session.case.record} == names


def test_that_a_file_that_is_no_record_is_said_in_the_dialog(opened, tmp_path):
    from app.input.import_dialog import ImportDialog

    wrong = tmp_path / "wrong.txt"
    wrong.write_text("hello")
    bare = tmp_path / "bare.txt"
    bare.write_text("\n".join(f"{np.sin(0.1 * k):.6f}" for k in range(300)))
    dialog = ImportDialog([wrong, bare])
    assert "wrong.txt" in dialog.words.text()
    dialog.list.setCurrentRow(1)
    assert dialog.chosen() == []
    dialog.change(unit="m/s2", time_step_s=0.01)
    (entry,) = dialog.chosen()
    assert (entry.unit, entry.time_step_s) == ("m/s2", 0.01)
    dialog.deleteLater()


@pytest.mark.shows("window.slider")
def test_that_the_slider_integrates_what_the_core_says(opened, application):
    from core.capacity.ida import threshold_of
    from core.rocking.history import integrate_history

    run(application, opened)
    opened.navigator.show_page("histories")
    tab = opened.pages["histories"].content
    tab.slider.setValue(700)
    motion = opened.session.result.motions[0]
    wall = opened.session.result.walls[0]
    factor = tab.q * threshold_of(wall.model) / motion.pga
    truth = integrate_history(motion.acceleration, motion.time_step, factor, wall.governing_model)
    assert np.array_equal(tab.history.rotation, truth.rotation)


def test_that_charts_export_light_pictures_and_their_data(opened, application, tmp_path):
    run(application, opened)
    opened.set_choice("theme", "dark")
    opened.navigator.show_page("intensity")
    application.processEvents()
    chart = opened.pages["intensity"].content.chart
    for end in ("png", "svg", "csv"):
        chart.write(tmp_path / f"c.{end}")
        assert (tmp_path / f"c.{end}").stat().st_size > 500
    corner = chart.image().pixelColor(3, 3)
    assert corner.lightness() > 240
    chart.copy()
    assert QApplication.clipboard().mimeData().hasImage()
    assert "SI [cm]" in (tmp_path / "c.csv").read_text(encoding="utf-8")


def test_that_tables_copy_with_tabs(opened, application):
    run(application, opened)
    opened.navigator.show_page("check")
    lines = opened.pages["check"].content.table.text().splitlines()
    assert len(lines) > 3 and all(line.count("\t") == 7 for line in lines)


@pytest.mark.shows("window.language")
def test_that_the_window_speaks_italian(opened, application):
    opened.set_choice("language", "it")
    assert opened.page_labels["walls"] == "Quadro generale" and opened.header.buttons["why"].text() == "3 Perché"
    assert opened.walls.fields["height_m"].caption.text() == "Altezza H"
    opened.set_choice("language", "en")
    assert opened.page_labels["walls"] == "Overview"


def test_that_every_editor_has_a_name_for_a_screen_reader(opened):
    from PySide6.QtWidgets import QComboBox, QLineEdit

    nameless = [
        widget
        for kind in (QLineEdit, QComboBox)
        for widget in opened.findChildren(kind)
        if not widget.accessibleName()
        and not widget.objectName().startswith("qt_")
        and not isinstance(widget.parent(), QComboBox)
    ]
    assert [type(widget.parent()).__name__ for widget in nameless] == []


def test_that_a_field_that_holds_nothing_accepted_stops_a_run(opened, application):
    for text in ("", "45x", "9999999"):
        type_into(opened.walls.fields["thickness_m"], "60")
        field = opened.walls.fields["thickness_m"].editor
        field.selectAll()
        QTest.keyClick(field, Qt.Key.Key_Delete)
        QTest.keyClicks(field, text)
        application.processEvents()
        assert not opened.run_button.isEnabled(), text
        opened.run()
        assert opened.runner.job is None
    type_into(opened.walls.fields["thickness_m"], "60")
    application.processEvents()
    assert opened.run_button.isEnabled()


def test_that_a_result_of_another_case_never_arrives(opened, application):
    opened.run()
    path = opened.session.path
    opened.files.open(path)  # the same words, but the run was of the case before
    settle(application, lambda: opened.runner.job is None)
    assert opened.session.result is None
    assert opened.navigator.wall is None and "F5" in opened.pages["walls"].content.words.text()


def test_that_only_one_job_runs_at_a_time(opened, application):
    opened.run()
    first = opened.runner.job
    opened.run()
    opened.runner.state_accuracy(opened.navigator.shown)
    assert opened.runner.job is first and opened.files.export_refused()
    settle(application, lambda: opened.runner.job is None)


def test_that_an_export_never_takes_the_place_of_a_record(opened, application, monkeypatch):

    said = []
    run(application, opened)
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    record = opened.session.base_dir / "small.json"
    (entry,) = opened.session.case.record
    opened.session.edit(replace(opened.session.case, record=(replace(entry, file=str(record)),)))
    opened.files.export(opened.session.base_dir / "small.xlsx")
    assert said and "overwrite" in said[-1] and opened.runner.job is None


def test_that_a_failing_worker_is_a_dialog_with_a_log(opened, application, monkeypatch):
    shown = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: shown.append(a[-1]))

    def broken(job):
        raise RuntimeError("broken on purpose")

    opened.runner.start(broken, lambda _: None)
    settle(application, lambda: opened.runner.job is None and shown)
    assert "broken on purpose" in shown[0] and ".log" in shown[0]


def test_that_closing_while_running_is_safe(opened, application):
    opened.session.edit_section("analysis", q_step=0.001)
    opened.run()
    opened.session.saved = opened.session.case
    opened.close()
    assert opened.runner.job is None or opened.runner.job.isFinished()


def test_that_many_redraws_and_random_events_do_no_harm(opened, application):
    """Short here; the long run is for a quiet evening: RIBALTA_REDRAWS=20000."""
    run(application, opened)
    opened.navigator.show_page("histories")
    tab = opened.pages["histories"].content
    random = np.random.default_rng(1)
    for k in range(int(os.environ.get("RIBALTA_REDRAWS", "30"))):
        tab.slider.setValue(int(random.integers(0, 2000)))
        if k % 10 == 0:
            opened.navigator.show_page(list(opened.pages)[int(random.integers(0, len(opened.pages)))])
            opened.resize(int(random.integers(900, 1500)), int(random.integers(600, 1000)))
        if k % 25 == 0:
            opened.session.edit_wall(0, height_m=float(random.uniform(3.0, 7.0)))
            opened.session.undo()
        application.processEvents()
    assert isinstance(opened.centralWidget(), QWidget)


def test_that_a_copied_picture_lets_the_program_end(tmp_path):
    """A QMimeData of Python's in the clipboard crashed Qt at exit: the end of the process is the test."""
    import subprocess
    import sys

    script = (
        "from PySide6.QtWidgets import QApplication; a = QApplication([]);"
        "from app.views.chart import Chart; c = Chart('x', 'y', 'n'); c.curve('k', [0, 1], [0, 1]); c.copy()"
    )
    found = subprocess.run(
        [sys.executable, "-P", "-c", script], env={**os.environ, "PYTHONPATH": str(ROOT)}, timeout=60
    )
    assert found.returncode == 0


def test_that_a_long_name_is_short_in_a_chart_and_whole_in_its_data(application):
    from app.views.axis import LEGEND_LETTERS, elide_name
    from app.views.chart import Chart

    name = "a_file_with_a_long_name_2016 3: 0 DEG (+)"
    assert len(elide_name(name)) <= LEGEND_LETTERS and elide_name(name).endswith("3: 0 DEG (+)")
    chart = Chart("x", "y", "c", legend="beside")
    chart.bars(name, [0], [0.5])
    chart.names_below([name])
    chart.fit()
    assert chart.legend.items[0][1].text == elide_name(name)
    assert name in chart.content(".csv").decode()
    chart.deleteLater()


def test_that_a_wall_of_a_result_is_found_by_what_it_is_and_not_by_its_name(tmp_path):
    """Walls whose names begin alike, their parts above hinges, and a list changed since the run."""
    wall = {"height_m": 4.0, "thickness_m": 0.4, "mechanism": "two_sided"}
    asked = [{**wall, "name": "w", "hinge_heights": [1.0]}, {**wall, "name": "w (+2 m) beside"}]
    result = study.run(parse_case({"wall": asked}), base_dir=tmp_path)
    walls = result.case.wall

    def rows(now):
        return [row_of(result, wall, now) for wall in result.walls]

    assert rows(walls) == [0, 0, 1]
    assert rows(walls[::-1]) == [1, 1, 0]
    assert rows(walls[1:]) == [None, None, 0]
    assert rows((replace(walls[0], name="v", height_m=5.0), walls[1])) == [0, 0, 1]


def test_that_the_answer_pressed_from_a_form_marks_the_wall_it_is_of(opened, application):
    run(application, opened)
    opened.navigator.show_input("report")
    assert opened.tree.current.kind == "report"
    opened.navigator.show_page("check")
    assert opened.tree.current.kind == "wall" and opened.tree.current.wall == opened.walls.current


def test_that_a_wall_that_bends_moves_as_two_blocks(opened, application):
    opened.session.edit_wall(
        0, mechanism="vertical_bending", height_m=3.0, thickness_m=0.3, slenderness_deg=None, unit_weight_kn_m3=18.0
    )
    opened.session.edit_wall(0, restitution=None, velocity_ratio=None)
    assert opened.session.problem() is None, str(opened.session.problem())
    run(application, opened)
    opened.navigator.show_page("histories")
    page = opened.pages["histories"].content
    assert page.run.ida.q > 1.0 and page.history.peak > 0.0 and "q" in page.words.text()
    energies = page.energy.data[0][2]
    assert energies.max() > 0.0 and (np.abs(page.history.rotation) <= page.history.peak + 1e-12).all()
    held = page.walls.drawings[0].held
    for sign in (1.0, -1.0):
        turned = moving_blocks(held, sign * 0.05)
        assert len(turned) == 2
        xs = [point.x() for point in turned[1]]
        top = max(turned[1], key=lambda point: point.y()).x()
        assert min(xs) < top <= max(xs) and max(point.y() for point in turned[1]) > 3.0  # it rises
        corner = sign * 0.15  # the edge that is held stays on its vertical
        assert min(abs(point.x() - corner) for point in turned[1]) < 1e-9
    before = page.walls.drawings[0].grab().toImage()
    page.set_time(float(page.times[int(np.abs(page.history.rotation).argmax())]))
    assert page.walls.drawings[0].rotation != 0.0 and page.walls.drawings[0].grab().toImage() != before


def test_that_an_empty_chart_has_no_numbers_at_its_axes(opened):
    from app.views.chart import Chart

    opened.navigator.show_page("spectra")
    chart = opened.pages["spectra"].content.findChildren(Chart)[0]
    axes = [chart.plot.getAxis(side) for side in ("bottom", "left")]
    chart.say_why("nothing yet")
    assert not any(axis.style["showValues"] for axis in axes)
    chart.clear()
    assert all(axis.style["showValues"] for axis in axes)
