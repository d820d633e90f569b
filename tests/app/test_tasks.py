"""What a person at work in the window met: each was wrong once."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtWidgets import QFileDialog, QMessageBox, QPushButton, QToolButton

from app.shell import client_view, files, finder
from app.shell.pointing import point_at
from core.answer.answer import ordered_runs
from core.case.hold import Bars, Hold
from core.case.loads import Load
from core.case.site import Building, Demand, Spectrum
from core.case.variant_names import AS_IS, DESIGNED
from tests.app.driving import run, settle
from tests.conftest import ROOT
from tests.core.report.test_picture import png

CASES = ROOT / "resources" / "cases"


def button(window, label: str) -> QToolButton:
    return next(one for one in window.tree.buttons.findChildren(QToolButton) if one.text() == label)


def marked(window):
    return window.tree.current


def consistent(window) -> None:
    """The row marked in the tree is the wall the form edits and the pages show."""
    row = marked(window)
    if not window.session.case.wall:
        assert window.walls.wall is None
        return
    assert row is not None
    if row.wall >= 0:
        assert row.wall == window.walls.current
        assert window.stages.front != "input" or window.stages.input.kind == "wall"
    elif window.stages.front == "input" and row.kind in window.stages.input.areas:
        assert window.stages.input.kind == row.kind
    if window.session.result is not None:
        known = window.navigator.results_of().get(window.walls.current, [])
        assert window.navigator.shown in known or (window.navigator.shown == -1 and not known)
        if row.kind == "hinge":
            assert row.result == window.navigator.shown
    if window.navigator.page in ("histories", "capacity") and window.navigator.wall is not None:
        content = window.pages[window.navigator.page].content
        said = content.words if window.navigator.page == "histories" else content.title
        assert said.text().startswith(window.navigator.wall.name)


def test_that_a_change_after_finding_leaves_the_menus_whole(opened, faults):
    finder.Finder(opened)
    opened.session.edit_wall(0, height_m=4.5)
    opened.refresh()
    assert faults == []
    found = finder.Finder(opened)
    for words in ("italiano", "dark", "animation", "sweep", "three-storey", "restitution"):
        found.line.setText(words)
        assert found.fitting, words


def test_that_what_was_switched_off_in_one_case_does_not_come_back_in_another(opened):
    demand = replace(opened.session.case.demand, ag_g=0.31, soil_factor=None, spectrum=Spectrum("EN1998", "B", type=2))
    opened.session.edit(replace(opened.session.case, demand=demand, building=Building(9.0, 3)))
    opened.demand._kind_chosen(0)
    opened.demand.given.setChecked(False)
    opened.demand.building.given.setChecked(False)
    opened.files.new()
    opened.demand.given.setChecked(True)
    opened.demand.building.given.setChecked(True)
    assert opened.session.case.demand == Demand("") and opened.session.case.building == Building("", "")
    opened.demand._kind_chosen(opened.demand.kind.findData("EN1998"))
    assert opened.session.case.demand.spectrum == Spectrum("EN1998", "")


def test_that_bars_switched_off_at_one_wall_do_not_come_back_at_another(opened):
    opened.walls.add()
    for k in (0, 1):
        opened.session.edit_wall(k, hold=(Hold("tie", h_m=3.0, bar=Bars(2, 20.0) if k == 0 else None),))
    opened.navigator.show_input("wall", 0)
    opened.walls.holds.bars.setChecked(False)
    opened.navigator.show_input("wall", 1)
    opened.walls.holds.bars.setChecked(True)
    assert opened.session.case.wall[1].hold[0].bar == Bars("", "")


def test_that_another_case_begins_at_its_first_wall(opened):
    opened.walls.add()
    opened.navigator.show_stage("why")
    opened.files.open(CASES / "building.toml")
    consistent(opened)
    assert marked(opened).key == ("wall", 0, "") and opened.stages.front == "input"
    opened.navigator.show_input("records")
    opened.walls.select(2)
    consistent(opened)
    opened.navigator.show_stage("report")
    opened.navigator.choose_row(next(row for row in opened.tree.rows if row.kind == "report"))
    assert opened.stages.front == "input" and opened.stages.input.kind == "report"
    opened.navigator.show_stage("report")
    opened.navigator.show_stage("input")
    assert opened.stages.input.kind == "report"


@pytest.mark.parametrize("count", [30, pytest.param(150, marks=pytest.mark.long)])
def test_that_tree_form_and_pages_show_one_wall_whatever_is_done(opened, application, tmp_path, count):
    """A walk: open, select, add, delete, undo, change stage, with and without a result."""
    text = opened.session.path.read_text()
    wall = text[: text.index("[[record]]")]
    (tmp_path / "two.toml").write_text(
        wall.replace('"w"', '"v"')
        + wall.replace("base_z_m = 0", "base_z_m = 0\nhinge_heights = [1.0, 2.0]")
        + text[len(wall) :]
    )
    opened.files.open(tmp_path / "two.toml")
    run(application, opened)
    assert len(opened.session.result.walls) == 4
    draw = np.random.default_rng(11)

    def chosen():
        rows = opened.tree.rows
        opened.navigator.choose_row(rows[int(draw.integers(0, len(rows)))])

    steps = (
        chosen,
        chosen,
        chosen,
        lambda: opened.navigator.show_stage(str(draw.choice(["input", "answer", "why", "report"]))),
        lambda: opened.navigator.show_page(str(draw.choice(["histories", "capacity"]))),
        opened.walls.add,
        opened.walls.add_variant,
        opened.walls.duplicate,
        opened.walls.delete,
        opened.session.undo,
        opened.session.undo,
        opened.session.redo,
        lambda: opened.navigator.pick(int(draw.integers(0, len(opened.session.result.walls)))),
    )
    for k in range(count):
        steps[int(draw.integers(0, len(steps)))]()
        try:
            consistent(opened)
        except AssertionError as error:
            raise AssertionError(f"step {k}") from error
    application.processEvents()


def test_that_a_missing_sentence_leads_to_the_variant_it_is_about(opened):
    opened.walls.add_variant()
    opened.session.edit_wall(1, base_z_m=None)
    opened.navigator.show_input("wall", 0)
    (problem,) = opened.missing.problems
    assert "w (as designed)" in problem.words
    assert [row.chip for row in opened.tree.rows if row.kind == "wall"] == ["", "!"]
    assert not opened.walls.fields["base_z_m"].rule
    problem.lead()
    assert opened.walls.current == 1 and opened.walls.fields["base_z_m"].rule


def test_that_a_missing_sentence_of_a_load_leads_to_its_field(opened):
    load, holds = Load("vertical", 5.0, 3.0, 0.25, "none"), (Hold("contact"), Hold("tie", h_m=4.0, out_kn_m=4.0))
    opened.session.edit_wall(0, load=(load,), hold=holds, unit_weight_kn_m3=18.0)
    opened.navigator.show_stage("answer")
    (problem,) = opened.missing.problems
    problem.lead()
    field = next(field for field in opened.walls.holds.fields if field.key == "bar_length_m")
    assert opened.walls.holds.list.currentRow() == 1 and field.isVisibleTo(opened) and field.rule
    opened.session.edit_wall(0, load=(), hold=())
    opened.session.edit(replace(opened.session.case, building=Building(9.0, "")))
    opened.navigator.show_input("wall", 0)
    (problem,) = opened.missing.problems
    problem.lead()
    field = next(field for field in opened.demand.building.fields if field.key == "storeys")
    assert opened.stages.input.kind == "building" and field.rule


def test_that_finding_a_field_of_a_load_there_is_none_of_leads_to_adding_one(opened, application):
    found = finder.Finder(opened)
    field = next(field for field in opened.walls.holds.fields if field.key == "bar_length_m")
    opened.activateWindow()
    found.line.setText(field.caption.text())
    found._go()
    application.processEvents()
    assert not field.isVisibleTo(opened) and opened.focusWidget() is opened.walls.holds.add_button
    before = opened.session.case
    for one in opened.stages.fields:
        point_at(opened.navigator, one)
        shown = one.isVisibleTo(opened) and one.isEnabled()
        assert shown == one.isAncestorOf(opened.focusWidget()), one.key
    assert opened.session.case == before


def test_that_a_form_of_nothing_shows_no_value(opened):
    """Whatever stood there: a place, say, of the case before."""
    from PySide6.QtWidgets import QLineEdit

    opened.session.edit(replace(opened.session.case, building=Building(9.0, 3)))
    forms = opened.walls, opened.demand, opened.demand.building
    lines = [line for form in forms for line in form.findChildren(QLineEdit)]
    for line in lines:
        line.setText("7")
    opened.files.new()
    assert len(lines) > 60 and not [line.accessibleName() for line in lines if line.text()]
    assert not any(button.isChecked() for button in opened.walls.mechanisms.values())


def test_that_a_variant_has_its_pair_and_its_undo_stays_at_the_wall(opened):
    opened.walls.add()
    opened.navigator.show_input("wall", 0)
    opened.navigator.show_stage("why")
    button(opened, "+ variant").click()
    assert [wall.title for wall in opened.session.case.wall] == [f"w ({AS_IS})", f"w ({DESIGNED})", "wall"]
    assert opened.stages.front == "input" and opened.walls.current == 1
    for k in (0, 1):
        opened.navigator.show_input("wall", k)
        button(opened, "+ variant").click()
        assert len(opened.session.case.wall) == 3 and opened.walls.current == 1
    opened.session.undo()
    assert opened.walls.wall.name == "w" and len(opened.session.case.wall) == 2
    consistent(opened)
    opened.session.edit_wall(0, variant=DESIGNED)
    opened.walls.add_variant()
    assert [wall.variant for wall in opened.session.case.wall] == [AS_IS, DESIGNED, None]


def test_that_walls_pasted_are_shown_and_counted(opened):
    from PySide6.QtWidgets import QApplication

    rows = "\n".join(f"{name}\t0\t4,5\t45\tun lato" for name in ("nord", "sud"))
    QApplication.clipboard().setText(f"Parete\tz\tH\tt\tMeccanismo\n\tm\tm\tcm\t\n{rows}\n")
    opened.navigator.show_stage("answer")
    button(opened, "paste").click()
    assert [wall.name for wall in opened.session.case.wall] == ["w", "nord", "sud"]
    assert opened.stages.front == "input" and opened.walls.wall.name == "nord" and "2" in opened.word.text()


@pytest.mark.shows("window.not_overwritten")
@pytest.mark.parametrize("names", [("example",), pytest.param(("building", "verdict"), marks=pytest.mark.long)])
def test_that_nothing_is_written_over_or_beside_an_example(opened, monkeypatch, tmp_path, names):
    asked = []
    monkeypatch.setattr(files, "path_to_write", lambda *given: asked.append(Path(given[2])))
    for name in names:
        path = CASES / f"{name}.toml"
        before = path.read_bytes()
        opened.files.open(path)
        opened.session.edit(replace(opened.session.case, title="mine"))
        assert not opened.files.save() and path.read_bytes() == before
        assert asked[-1].name == path.name and asked[-1].parent != CASES
        assert opened.files.proposed(".pdf").parent != CASES
        opened.session.saved = opened.session.case
    opened.session.save(tmp_path / "mine.toml")
    assert opened.files.proposed(".pdf") == tmp_path / "mine.pdf"


def test_that_no_sentence_however_long_widens_the_window(opened, application):
    opened.navigator.show_stage("report")
    application.processEvents()
    before = opened.minimumSizeHint().width()
    long = "The note cannot be set, for a reason that takes very many words to be said. " * 12
    opened.pages["note"].content.word.setText(long)
    opened.show_word(long)
    opened.header.say(long)
    places = [one.x() for one in opened.header.buttons.values()]
    for words in ("1 missing", "The input has changed: press F5.", ""):
        opened.header.show_notice(words, long)
        application.processEvents()
        assert opened.minimumSizeHint().width() == before
        assert [one.x() for one in opened.header.buttons.values()] == places
    opened.show_running(True)
    application.processEvents()
    assert [one.x() for one in opened.header.buttons.values()] == places
    opened.show_running(False)


def test_that_a_wall_has_no_zeta_before_all_its_hinges_are_there(opened, application):
    from app.shell import tree
    from core.setting.plan import count_results_by_wall

    opened.session.edit(replace(opened.session.case, building=Building(9.0, 3)))
    spectrum = Spectrum("EN1998", "B", type=1)
    opened.session.edit_section("demand", soil_factor=None, spectrum=spectrum)
    opened.session.edit_wall(0, hinge_heights=(1.0, 2.0), unit_weight_kn_m3=18.0, elastic_modulus_mpa=600.0)
    assert list(count_results_by_wall(opened.session.case)) == [3]
    run(application, opened)
    found = sorted(opened.session.result.walls, key=lambda wall: -wall.assessment.verdict.zeta_e)
    opened.runner.finished_walls = found[:1]
    zetas = opened.runner.zetas_so_far()
    first = found[0].assessment.verdict.zeta_e
    assert zetas == {0: (first, False)}
    state = tree.State(opened.session.case, None, False, (), 1, False, {}, zetas)
    (row,) = (row for row in tree.rows_of(state) if row.kind == "wall")
    assert row.chip == f"≤ {first:.2f}"
    tab = opened.pages["walls"].content
    tab.show_running(opened.runner.finished_walls, zetas)
    assert [tab.table.item(0, column).text() for column in (2, 3)] == [f"≤ {first:.2f}", "…"]
    opened.runner.finished_walls = found
    assert opened.runner.zetas_so_far() == {0: (found[-1].assessment.verdict.zeta_e, True)}
    opened.runner.finished_walls = []


def test_that_the_client_sees_both_walls_at_one_scale(opened, application):
    opened.walls.add_variant()
    opened.session.edit_wall(1, height_m=3.0)
    run(application, opened)
    opened.navigator.pick(0)
    view = client_view.ClientView(opened, "title", client_view.sides_of(opened.session.result, opened.navigator.wall))
    view.resize(900, 600)
    view.grab()
    one, other = view.drawings
    assert one.size_of[0] != other.size_of[0] and one.scale == pytest.approx(other.scale)
    view.deleteLater()


def test_that_the_first_wall_asks_for_its_demand_at_once(opened):
    from app.shell import first_run

    opened.show_first_run()
    first_run.open_first_choice(opened, "wall")
    words = " ".join(problem.words for problem in opened.missing.problems)
    assert "a_g" in words and opened.walls.fields["base_z_m"].caption.text() in words


def test_that_the_answer_leads_to_what_it_asks_for(opened, application):
    opened.session.edit_section("demand", ag_g=0.03)
    opened.session.edit(replace(opened.session.case, record=(replace(opened.session.case.record[0], scale=0.1),)))
    settle(application, lambda: not opened.records.pending)
    run(application, opened)
    content = opened.pages["check"].content
    verdict = opened.navigator.wall.assessment.verdict
    assert {one.code for one in verdict.to_do} & {"to_no_spectrum"}
    behind = next("".join(fact.lines) for fact in content.drawer.facts if fact.label == "Limits")
    assert behind.count("the dynamic check is not at the demand") == 1
    content.to_do.words.linkActivated.emit("demand")
    assert opened.stages.front == "input" and opened.stages.input.kind == "demand"
    opened.navigator.ask("variant")
    assert len(opened.session.case.wall) == 2 and opened.stages.front == "input"


def test_that_an_answer_without_bars_leads_to_a_demand_and_to_motions(opened, application):
    spectrum = Spectrum("EN1998", "B", type=1)
    opened.session.edit_section("demand", soil_factor=None, spectrum=spectrum)
    analysis = replace(opened.session.case.analysis, histories="none")
    opened.session.edit(replace(opened.session.case, record=(), analysis=analysis))
    settle(application, lambda: not opened.records.pending)
    run(application, opened)
    content = opened.pages["check"].content
    assert content.peaks.isHidden() and "generate" in content.no_peaks.text()
    content.no_peaks.linkActivated.emit("generate")
    assert opened.session.case.generate.count == 14 and opened.stages.input.kind == "records"
    opened.session.edit(replace(opened.session.case, demand=None, generate=None))
    settle(application, lambda: not opened.records.pending)
    run(application, opened)
    opened.navigator.show_page("check")
    content = opened.pages["check"].content
    assert content.peaks.isHidden() and "'demand'" in content.no_peaks.text()


def test_that_a_bar_leads_to_its_history_and_pages_open_at_the_governing_record(opened, application):
    motions = sorted((ROOT / "tests" / "motions").glob("noise_[23].txt"))
    opened.records.take(motions, ask=False)
    settle(application, lambda: len(opened.records.motions) == 3)
    opened.session.edit_wall(0, mechanism="one_sided")
    opened.session.edit_section("analysis", polarity="both")
    run(application, opened)
    opened.navigator.show_page("check")
    checked = ordered_runs(opened.navigator.wall.assessment.dynamic)
    content = opened.pages["check"].content
    assert len(checked) == 6
    ticks = content.peaks.plot.getAxis("bottom")._tickLevels[0]
    assert ticks and all(name[-1] in "+−" for _, name in ticks)
    for name in ("histories", "capacity"):
        opened.navigator.show_page(name)
    histories, capacity = (opened.pages[name].content for name in ("histories", "capacity"))
    assert histories.record.currentIndex() == capacity.record.currentIndex()
    assert (histories.run.motion, histories.run.polarity) == (checked[0].motion, checked[0].polarity)
    for k, one in enumerate(checked):
        opened.navigator.show_page("check")
        content.peaks.clicked.emit(k + 0.2, 0.1)
        assert opened.navigator.page == "histories"
        assert (histories.run.motion, histories.run.polarity) == (one.motion, one.polarity)
        if one.peak_ratio is not None:
            peak = histories.history.peak / opened.navigator.wall.model.collapse_rotation
            assert peak == pytest.approx(one.peak_ratio, rel=1e-7)  # of a search and of one history
    assert histories.words.toolTip().startswith("C ")


def test_that_no_first_page_covers_a_case_that_is_open(opened, monkeypatch):
    from app.shell import start

    opened.show_first_run()
    opened.files.open(CASES / "building.toml")
    assert opened.stages.first is None
    opened.show_first_run()
    opened.navigator.choose_row(next(row for row in opened.tree.rows if row.kind == "wall"))
    assert opened.stages.first is None and opened.stages.front == "input"
    opened.show_first_run()
    swap = opened.session.recovery_folder / "x-aa.swap"
    swap.parent.mkdir(exist_ok=True)
    swap.write_text('{"path": null, "base_dir": ".", "case": "title = \\"again\\""}')
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Yes)
    start.offer_recovery(opened)
    assert opened.session.case.title == "again" and opened.stages.first is None


def test_that_a_logo_is_chosen_and_one_that_is_not_there_is_said(opened, monkeypatch, tmp_path):
    picture = tmp_path / "logos" / "l.png"
    picture.parent.mkdir()
    picture.write_bytes(png(30, 20))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(picture), ""))
    logo = next(field for field in opened.stages.note_form.fields if field.key == "logo")
    logo.findChild(QPushButton).click()
    assert logo.editor.text() == "logos/l.png"
    assert opened.session.case.report.logo == "logos/l.png" and not opened.missing.problems
    (tmp_path / "deeper").mkdir()
    opened.session.save(tmp_path / "deeper" / "c.toml")
    assert opened.session.case.report.logo == "../logos/l.png"
    opened.session.edit_section("report", logo="absent.png")
    (problem,) = opened.missing.problems
    assert "absent.png" in problem.words and opened.run_button.isEnabled()
    problem.lead()
    assert opened.stages.input.kind == "report"


def test_that_records_are_taken_wherever_they_are_dropped(opened, application, monkeypatch):
    from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
    from PySide6.QtGui import QDragEnterEvent, QDropEvent

    taken = []
    monkeypatch.setattr(opened.records, "take", taken.append)
    folder = ROOT / "tests" / "motions"
    payload = QMimeData()
    payload.setUrls([QUrl.fromLocalFile(str(folder))])
    keys = (Qt.DropAction.CopyAction, payload, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    enter = QDragEnterEvent(QPointF(20, 300).toPoint(), *keys)
    opened.navigator.show_stage("why")
    application.sendEvent(opened, enter)
    assert enter.isAccepted()
    application.sendEvent(opened, QDropEvent(QPointF(20, 300), *keys))
    assert taken == [[folder]] and opened.stages.input.kind == "records" and opened.stages.front == "input"
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(folder))
    opened.records.add_folder()
    assert taken == [[folder], [folder]]


def test_that_a_figure_is_saved_at_the_last_size_without_a_question(opened, application, monkeypatch, tmp_path):
    from app.views import chart_output, figure_dialogs

    run(application, opened)
    opened.navigator.show_page("check")
    chart = opened.pages["check"].content.peaks
    monkeypatch.setattr(figure_dialogs, "ask_size", lambda *_: pytest.fail("asked"))
    monkeypatch.setattr(chart_output, "path_to_write", lambda *_: tmp_path / "f.png")
    slots = dict(chart.menu_of())
    slots["Save as a figure for a report: PNG, SVG or PDF"]()
    assert (tmp_path / "f.png").stat().st_size > 1000 and "Size of the figures…" in slots


@pytest.mark.parametrize("tongue", ["en", "it"])
def test_that_sentences_of_the_window_are_in_its_words(opened, tongue):
    from core.text.catalogue import CATALOGUE

    opened.set_choice("language", tongue)
    opened.files.new()
    opened.session.edit(replace(opened.session.case, demand=Demand(0.2, spectrum=Spectrum("NTC2018", "B"))))
    said = [problem.words for problem in opened.missing.problems]
    opened.walls.add()
    opened.session.edit_wall(0, hold=(Hold("tie", h_m=3.0, bar=Bars(2, "")),), unit_weight_kn_m3=18.0)
    said += [problem.words for problem in opened.missing.problems]
    opened.session.edit_wall(0, mechanism="one_sided", base_z_m=0.0)
    said += [problem.words for problem in opened.missing.problems]
    assert len(said) > 5
    for words in said:
        assert not any(part in words for part in ("[", "_sided", "NTC2018", "f0")), words
    texts = [words for group in ("window", "key", "reason") for words in CATALOGUE[group].values()]
    old = ("sheet Demand", "tab Check", "tab Spectra", "press Add", "(left,", "scheda Domanda", "scheda Verifica")
    assert not [pair for pair in texts for words in pair if words and any(part in words for part in old)]


def test_that_a_long_sentence_of_what_is_missing_is_whole(opened, application):
    opened.session.edit_wall(0, name="facade of the court " * 5, base_z_m=None)
    (problem,) = opened.missing.problems
    assert len(problem.words) > 220
    application.processEvents()
    lines = opened.missing.lines
    assert "…" not in lines.text() and lines.height() >= lines.heightForWidth(lines.width())


def test_that_a_wall_that_is_deleted_leaves_the_pages(opened, application):
    opened.walls.duplicate()
    run(application, opened)
    opened.navigator.choose_row(next(row for row in opened.tree.rows if row.wall == 0))
    opened.navigator.show_page("histories")
    opened.walls.delete()
    assert opened.navigator.wall is opened.session.result.walls[1]
    consistent(opened)


def test_that_a_note_in_another_language_than_the_window_says_so(opened, application):
    run(application, opened)
    opened.navigator.show_page("note")
    note = opened.pages["note"].content
    settle(application, lambda: not note.is_setting)
    assert "English" not in note.word.text()
    opened.set_choice("language", "it")
    opened.navigator.show_page("note")
    note = opened.pages["note"].content
    settle(application, lambda: not note.is_setting)
    assert note.word.text().endswith("(English)")
