"""What makes the window considerate: overview, errors that lead, records edited, figures for a report, help."""

import re
from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("PySide6")

from PySide6.QtCore import QTimer
from PySide6.QtGui import QColor, QImage

from app.look import language, theme
from app.shell import figure_export
from app.views.axis import SPARE_PLOTS
from app.views.figure_file import FigureSize, figure, raster
from app.views.note_tab import NoteTab
from app.views.table import Table
from app.views.walls_tab import HANGS_ON, KEYS, RISK, ZETA, values_of
from core.codes.record_compatibility import common_factor
from core.errors import InputError, place
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.setting.demand_input import read_demand
from tests.app.conftest import window_in, with_verdict
from tests.app.driving import Held, run, settle, type_into
from tests.conftest import SEVEN

VERDICT = SEVEN


@pytest.fixture(scope="module")
def shared_walls(application, tmp_path_factory, of_seven):
    """One window for all tests that leave its case as it was."""
    with pytest.MonkeyPatch.context() as patch:
        made = window_in(application, tmp_path_factory.mktemp("walls"), patch, [])
        yield with_verdict(application, next(made), of_seven)
        next(made, None)


@pytest.fixture
def walls(shared_walls, application):
    """That window, with its own state in what all windows share."""
    settle(application, lambda: shared_walls.records.motions and not shared_walls.records.pending)
    theme.set_theme("light")
    language.set_language("en")
    shared_walls.refresh()
    shared_walls.navigator.pick(0)
    shared_walls.navigator.show_page("walls")
    yield shared_walls
    while shared_walls.session.dirty:  # what a test typed is taken back
        shared_walls.session.undo()


@pytest.fixture
def own_walls(opened, application, of_seven):
    """The same walls, in a window that a test may leave as it likes."""
    return with_verdict(application, opened, of_seven)


def test_that_the_overview_is_first_sorts_and_opens_a_wall(walls):
    tab = walls.pages["walls"].content
    walls.navigator.show_page("walls")
    assert walls.navigator.page == "walls"
    names = [tab.table.item(r, 0).text() for r in range(tab.table.rowCount())]
    assert names == ["Timpano", "Facciata"]  # the lowest zeta first
    assert tab.table.item(0, 2).foreground().color() == QColor(theme.current.bad)
    tab._sort(2)
    assert tab.table.item(0, 0).text() == "Facciata"
    tab._sort(0)
    assert tab.table.item(0, 0).text() == "Facciata"
    tab.table.cellClicked.emit(1, 0)
    assert walls.navigator.page == "check"
    assert walls.navigator.wall.name == "Timpano"


@pytest.mark.parametrize("falling", [False, True])
def test_that_the_overview_sorts_by_the_values_of_the_results_not_by_their_words(walls, falling):
    """A return period beyond what is known is shown as "> 2475"."""
    tab = walls.pages["walls"].content
    result, verdicts = tab.shown[0], {verdict.governing: verdict for verdict in tab.shown[0].verdicts}
    tab.by = len(KEYS)  # no column: the first one asked for rises
    for column, key in enumerate(KEYS):
        for _ in range(1 + falling):
            tab._sort(column)
        found = [values_of(result.walls[k], verdicts[k], result).get(key) for k in tab.order]
        there = [value for value in found if isinstance(value, float | int)]
        assert there == sorted(there, reverse=falling) and None not in found[: len(there)]
        assert {key for key in KEYS[:RISK] if key not in ("check", HANGS_ON)} <= set(
            values_of(result.walls[0], None, None)
        )
    tab._sort(ZETA)


def test_that_a_title_clicked_while_a_case_runs_does_not_bring_back_the_last_result(own_walls):
    """The overview has no veil then: a verdict of an earlier input would look like one of this."""
    own_walls.navigator.show_page("walls")
    tab, wall = own_walls.pages["walls"].content, own_walls.session.result.walls[0]
    tab.show_running([wall], {wall.part.origin: (None, False)})
    tab.table.horizontalHeader().sectionClicked.emit(0)
    assert tab.table.rowCount() == 1 and tab.table.item(0, 3).text() == "…" and tab.order == []


def test_that_tree_form_and_pages_show_one_wall(walls):
    walls.walls.select(1)
    assert walls.navigator.wall.name == "Timpano" == walls.walls.wall.name
    walls.navigator.pick(0)
    assert walls.walls.current == 0 and walls.tree.current.wall == 0
    row = next(row for row in walls.tree.rows if row.text == "Timpano")
    walls.navigator.choose_row(row)
    assert walls.navigator.wall.name == "Timpano" == walls.walls.wall.name


@pytest.mark.shows("window.missing")
def test_that_an_error_leads_to_its_field_on_another_stage(opened, application):
    opened.session.edit_wall(0, height_m=7.0, thickness_m=0.4, slenderness_deg=None)
    type_into(opened.walls.fields["height_m"], "70")
    opened.walls.sections["geometry"].head.setChecked(False)
    opened.navigator.show_page("walls")
    opened.refresh()
    assert "Height H" in opened.missing.text() and opened.header.notice.isVisible()
    opened.header.notice.click()
    assert opened.stages.front == "input" and opened.walls.fields["height_m"].isVisible()
    assert opened.walls.fields["height_m"].editor.hasFocus()
    opened.walls.fields["height_m"].revert()


def test_that_a_hidden_field_that_blocks_shows_itself(opened):
    opened.session.edit_wall(0, hinge_setback_m=0.03, unit_weight_kn_m3=18.0)
    opened.session.edit_wall(0, compressive_strength_mpa=2.0)  # as a file can say it
    assert opened.session.problem() is not None and not opened.walls.fields["hinge_setback_m"].isHidden()
    opened.walls.fields["hinge_setback_m"].offer(0.0)
    assert opened.session.problem() is None and opened.walls.fields["hinge_setback_m"].isHidden()


def test_that_an_error_of_another_wall_leads_to_that_wall(own_walls):
    own_walls.session.edit_wall(1, thickness_m=0.4, height_over_thickness=9.0)
    assert own_walls.walls.current == 0 and own_walls.missing.text()
    own_walls.missing.lines.linkActivated.emit("0")
    assert own_walls.walls.current == 1


def test_that_a_record_that_cannot_be_read_leads_to_its_row(opened, application):
    record = replace(opened.session.case.record[0], file="nowhere.AT2")
    opened.session.edit(replace(opened.session.case, record=(record,)))
    settle(application, lambda: not opened.records.pending)
    assert "nowhere.AT2" in opened.missing.text()
    opened.missing.lines.linkActivated.emit("0")
    assert opened.records.isVisible() and opened.records._selected() == {0}
    opened.session.edit(replace(opened.session.case, record=(replace(record, include=False),)))
    settle(application, lambda: not opened.records.pending)
    assert "nowhere.AT2" not in opened.missing.text()


@pytest.mark.shows("window.missing")
def test_that_what_a_run_refuses_leads_to_its_field(opened, application, monkeypatch):
    def refuse(*arguments, **options):
        raise InputError(
            "setback_too_large",
            key="hinge_setback_m",
            setback=0.3,
            most=0.2,
            share=40.0,
            place=(place("wall", name=opened.walls.wall.name),),
        )

    monkeypatch.setattr("core.study.run.run", refuse)
    said = []
    monkeypatch.setattr("app.shell.window.QMessageBox.warning", lambda *words: said.append(words[2]))
    settle(application, lambda: not opened.records.pending)
    opened.run()
    settle(application, lambda: opened.runner.job is None)
    assert said and opened.walls.fields["hinge_setback_m"].rule in said[0] and opened.run_button.isEnabled()
    opened.session.edit_wall(0, height_m=6.0)
    assert opened.walls.fields["hinge_setback_m"].rule == "" == opened.missing.text()


def test_that_a_strength_takes_the_setback_with_it(opened):
    opened.session.edit_wall(0, hinge_setback_m=0.03, unit_weight_kn_m3=18.0)
    opened.walls.fields["compressive_strength_mpa"].offer(2.0)
    assert opened.session.case.wall[0].hinge_setback_m == 0.0 and opened.session.problem() is None


@pytest.mark.shows("window.no_site")
def test_that_a_new_demand_assumes_nothing_of_the_site(opened):
    opened.session.edit(replace(opened.session.case, demand=None, generate=None))
    opened.demand.last = None
    opened.demand.given.setChecked(True)
    assert opened.session.case.demand.ag_g == "" and opened.demand.fields["ag_g"].editor.text() == ""
    assert opened.session.problem() is not None and not opened.run_button.isEnabled()
    opened.demand._kind_chosen(opened.demand.kind.findData("NTC2018"))
    assert opened.demand.fields["soil"].editor.currentIndex() == -1
    assert opened.demand.fields["tc_star_s"].editor.text() == ""


@pytest.mark.shows("window.stages")
def test_that_finished_walls_appear_while_others_run(own_walls, application):
    seen = []
    tab = own_walls.pages["walls"].content
    tab.show_running = lambda found, _: seen.append(len(found))
    own_walls.session.edit_wall(0, height_m=6.9)
    run(application, own_walls)
    assert seen == [1, 2]


def test_that_the_common_factor_brings_the_mean_to_the_target(walls):
    case, motions = walls.session.case, walls.records.motions
    demand = read_demand(case, walls.session.base_dir)
    factor = common_factor(motions, demand)
    periods = np.geomspace(0.15, 2.0, 400)
    spectra = [pseudo_acceleration_spectrum(m.acceleration, m.time_step, periods) for m in motions]
    ratio = demand.target.acceleration(periods) / (factor * np.mean(spectra, axis=0))
    assert np.log(ratio).mean() == pytest.approx(0.0, abs=2e-3)


@pytest.mark.shows("window.figures")
@pytest.mark.parametrize(
    ("width", "dpi"), [(80.0, 300), *(pytest.param(160.0, dpi, marks=pytest.mark.long) for dpi in (300, 600))]
)
def test_that_a_figure_is_as_wide_as_asked_light_and_has_its_caption(walls, width, dpi):
    walls.set_choice("theme", "dark")
    walls.navigator.show_page("capacity")
    chart = walls.pages["capacity"].content.peaks
    size, ranges = chart.view.size(), chart.plot.viewRange()
    image = QImage.fromData(figure(chart, ".png", FigureSize(width, dpi)), "PNG")
    assert image.width() == pytest.approx(width / 25.4 * dpi, abs=3)
    assert image.dotsPerMeterX() == round(dpi / 25.4 * 1000)
    assert image.pixelColor(2, 2).lightness() > 240
    colors = {image.pixelColor(x, y).name() for x in range(0, image.width(), 3) for y in range(0, image.height(), 3)}
    assert theme.LIGHT.curves[0] in colors  # the curve itself
    below = range(int(0.92 * image.height()), image.height())
    assert any(image.pixelColor(x, y).lightness() < 140 for y in below for x in range(0, image.width() // 2, 2))
    assert (chart.view.size(), chart.plot.viewRange()) == (size, ranges)
    for end in (".svg", ".pdf"):
        content = figure(chart, end, FigureSize(width, dpi))
        assert len(content) > 4000 and content[:5] in (b"<?xml", b"%PDF-")
    walls.set_choice("theme", "light")


@pytest.mark.shows("window.stale")
def test_that_stale_results_say_so_where_they_leave_and_live_ones_do_not(walls):
    chart, table = walls.pages["check"].content.peaks, walls.pages["check"].content.table
    live = walls.pages["spectra"].content.chart
    walls.navigator.show_page("check")
    assert b"input has changed" not in figure(chart, ".svg", FigureSize())
    walls.session.edit_wall(0, height_m=6.5)
    assert Table.stale and chart.is_stale and not live.is_stale
    assert "input has changed" in chart.content(".csv").decode()
    assert "input has changed" in table.text() and "input has changed" not in live.content(".csv").decode()
    assert b"input has changed" in figure(chart, ".svg", FigureSize())
    walls.navigator.show_page("spectra")
    assert walls.stages.veil.isHidden()
    walls.navigator.show_page("check")
    assert not walls.stages.veil.isHidden()
    walls.session.undo()
    assert not Table.stale


@pytest.mark.shows("window.figures")
def test_that_all_figures_are_written_together_while_the_window_lives(walls, application, tmp_path, begun):
    folder = tmp_path / "figures"
    folder.mkdir()
    walls.navigator.show_page("check")
    walls.files.export_figures(folder, FigureSize(80.0))
    assert walls.runner.job is not None and not walls.cancel_button.isHidden()
    settle(application, lambda: walls.stages.bar.maximum() > 0)
    walls.runner.cancel()
    settle(application, lambda: walls.stages.stack.isEnabled())
    assert not list(folder.iterdir()) and walls.navigator.page == "check" and walls.tree.isEnabled()
    begun.clear()
    walls.files.export_figures(folder, FigureSize(80.0, 96))
    settle(application, lambda: walls.runner.job is None)
    assert walls.navigator.page == "check" and str(folder) in walls.word.text()
    names = sorted(path.name for path in folder.iterdir())
    assert len(names) == len(begun) >= 9 and not SPARE_PLOTS and all(name.endswith(".png") for name in names)
    for path in folder.iterdir():
        assert not QImage(str(path)).isNull()


@pytest.fixture
def begun(monkeypatch):
    """Names of the figures an export has begun to paint."""
    names = []

    def strips(chart, size):
        names.append(chart.name)
        yield from raster(chart, size)

    monkeypatch.setattr(figure_export, "raster", strips)
    return names


def test_that_a_window_built_anew_ends_the_export_in_the_midst_of_a_figure(walls, application, tmp_path, begun):
    walls.navigator.show_page("histories")
    walls.files.export_figures(tmp_path, FigureSize())
    settle(application, lambda: begun)
    walls.set_choice("language", "it")
    settle(application, lambda: walls.runner.job is None)
    for _ in range(5):
        application.processEvents()
    assert not list(tmp_path.glob("*.png")) and not SPARE_PLOTS
    assert walls.stages.stack.isEnabled() and walls.tree.isEnabled()


def test_that_no_figure_is_painted_while_the_file_of_another_is_made(walls, application, tmp_path, begun, monkeypatch):
    held = Held(monkeypatch, figure_export, "png")
    walls.files.export_figures(tmp_path, FigureSize(80.0))
    settle(application, held.reached.is_set)
    turns = []
    watch = QTimer()
    watch.timeout.connect(lambda: turns.append(len(begun)))
    watch.start(2)
    settle(application, lambda: len(turns) > 20)
    watch.stop()
    walls.runner.cancel()
    held.let_go()
    settle(application, lambda: walls.stages.stack.isEnabled())
    assert set(turns) == {1} and len(begun) == 1 and not SPARE_PLOTS


def test_that_nothing_plays_while_figures_are_painted(walls, application, tmp_path, begun):
    walls.navigator.show_page("histories")
    walls.pages["histories"].content.walls.play.setChecked(True)
    walls.files.export_figures(tmp_path, FigureSize(80.0))
    settle(application, lambda: len(begun) > 1)
    assert walls.runner.job is not None and not walls.pages["histories"].content.walls.play.isChecked()
    walls.runner.cancel()
    settle(application, lambda: walls.runner.job is None)


def test_that_the_cursor_reads_a_data_point(walls, application):
    chart = walls.pages["check"].content.peaks
    walls.navigator.show_page("check")
    entries = [label.text for _, label in chart.legend.items]
    assert "within θc" in entries and any("which decides" in entry or "overturns" in entry for entry in entries)
    at = next((x, y) for _, xs, ys in chart.data for x, y in zip(xs, ys, strict=True) if np.isfinite(y))
    name, x, _ = chart._nearest(at[0] + 0.01, at[1] + 0.01, False)
    assert x == at[0] and name
    assert chart._nearest(at[0], at[1] + 5.0, False) is None


def test_that_reset_restores_the_ranges_a_chart_was_given(walls):
    walls.navigator.show_page("capacity")
    chart = walls.pages["capacity"].content.peaks
    chart.plot.setYRange(0.2, 0.3, padding=0)
    chart.plot.setXRange(2.0, 2.1, padding=0)
    chart.reset()
    (left, right), (low, high) = chart.plot.viewRange()
    assert (low, high) == (0.0, 1.45) and left < 2.0 < 4.0 < right


def test_that_a_preset_sets_the_multiplier(walls):
    walls.navigator.pick(1)
    walls.navigator.show_page("histories")
    tab = walls.pages["histories"].content
    _, wall = tab.shown
    tab._set_to(1)
    assert tab.q * wall.model.threshold == pytest.approx(tab.motion.pga)
    plain, ground = tab.history.peak, tab.ground.data[0][2]
    assert "without FC" in tab.words.text() and "without FC" in tab.rotation.caption
    assert "1.00 times the demand" in tab.words.text()
    tab._set_to(2)  # FC on the strength: another wall under the same ground, and said to be
    assert tab.q * wall.model.threshold == pytest.approx(tab.motion.pga)
    assert np.array_equal(tab.ground.data[0][2], ground) and tab.history.peak != plain
    for said in (tab.words.text(), tab.rotation.caption, tab.ground.caption):
        assert "FC on the strength: 1.35" in said
    checked = next(
        r for r in wall.assessment.dynamic.runs if (r.record, r.polarity) == (tab.run.record, tab.run.polarity)
    )
    peak = tab.history.peak / wall.model.collapse_rotation
    if checked.peak_ratio is None:
        assert tab.history.outcome == 1
    else:
        assert peak == pytest.approx(checked.peak_ratio, rel=1e-9)
    tab._set_to(4)
    assert tab.history.outcome == 1 and tab.q == tab.run.ida.bracket[1]
    tab._set_to(3)
    assert tab.history.outcome != 1
    tab._set_to(5)
    assert tab.q == 2.0 and all("without FC" in said for said in (tab.words.text(), tab.rotation.caption))
    tab._set_to(2)
    tab.slider.setValue(tab.slider.value() + 1)
    assert "without FC" in tab.words.text() and "without FC" in tab.rotation.caption
    assert "1.00 times the demand" in tab.words.text()
    for choice in (1, 4):  # the ground is shown whole at every multiplier
        tab._set_to(choice)
        _, (low, high) = tab.ground.plot.viewRange()
        assert low < tab.ground.data[0][2].min() and tab.ground.data[0][2].max() < high


def test_that_empty_charts_say_why(walls):
    walls.navigator.show_page("validation")
    assert "press the button" in walls.pages["validation"].content.chart.reason.text()


@pytest.mark.shows("window.marks")
def test_that_numbers_have_a_comma_in_the_italian_window(walls):
    walls.set_choice("language", "it")
    assert walls.walls.fields["thickness_m"].editor.text() == "83"
    walls.walls.fields["thickness_m"].offer(0.835)
    walls.walls.fields["thickness_m"].show_value(0.8355)
    assert walls.walls.fields["thickness_m"].editor.text() == "83,55"
    assert re.search(r"\d,\d\d°", walls.walls.summary.text())
    axis = walls.pages["check"].content.peaks.plot.getAxis("left")
    assert axis.tickStrings([0.5], 1.0, 0.5) == ["0,5"]
    walls.set_choice("language", "en")


@pytest.mark.parametrize("tongue", ["it", pytest.param("en", marks=pytest.mark.long)])  # the longer words
def test_that_the_window_fits_a_small_screen(walls, application, monkeypatch, tongue):
    monkeypatch.setattr(NoteTab, "_set", lambda _: None)  # its pages scroll: nothing waits for them here
    walls.set_choice("language", tongue)
    for size in ((1024, 768), (960, 540)):
        walls.resize(*size)
        for page in walls.pages:
            walls.navigator.show_page(page)
            application.processEvents()
            assert (walls.width(), walls.height()) == size, page
            assert walls.minimumSizeHint().width() <= size[0]
            assert walls.minimumSizeHint().height() <= size[1]
            assert walls.stages.width() >= size[0] - 216
    for size, share in (((1280, 800), 0.83), ((1920, 1080), 0.85)):
        walls.resize(*size)
        application.processEvents()
        assert walls.stages.width() >= share * walls.width()
    walls.resize(1280, 800)
    application.processEvents()
    walls.set_choice("language", "en")


@pytest.mark.parametrize("tongue", ["it", pytest.param("en", marks=pytest.mark.long)])  # the longer words
def test_that_tables_fit_their_tab_at_1280(own_walls, application, tongue):
    own_walls.resize(1280, 800)
    own_walls.set_choice("language", tongue)
    for name in ("walls", "check"):
        own_walls.navigator.show_page(name)
        application.processEvents()
        for table in own_walls.pages[name].content.findChildren(Table):
            if table.isVisible() and table.rowCount():
                columns = sum(map(table.columnWidth, range(table.columnCount())))
                assert columns <= table.width(), name


def test_that_no_job_collects_widgets_in_its_thread(opened):
    """Cycles are collected in the thread of the window alone."""
    import gc
    import threading

    from app.work.worker import Job

    assert not gc.isenabled()
    seen = []

    class Cycle:
        def __del__(self):
            seen.append(threading.current_thread() is threading.main_thread())

    def work(job):
        for _ in range(3000):
            one = Cycle()
            one.itself = one
        return len(seen)

    done = []
    job = Job(work)
    job.done.connect(done.append)
    job.start()
    job.wait()
    opened.collector.look()
    gc.collect()
    assert len(seen) == 3000 and all(seen)


@pytest.mark.parametrize("size", [(1920, 1080), pytest.param((1280, 800), marks=pytest.mark.long)])
def test_that_figures_of_tabs_never_looked_at_fill_their_page(walls, application, tmp_path, size):
    walls.resize(*size)
    walls.build()  # every tab is made anew
    walls.navigator.take(walls.session.result)
    walls.navigator.show_page("walls")
    walls.files.export_figures(tmp_path, FigureSize(160, 96))
    settle(application, lambda: walls.runner.job is None)
    shown = {page for name, page in walls.pages.items() if name not in ("spectra", "note")}
    assert walls.navigator.fresh == shown | ({walls.navigator.beside} if size[0] > 1280 else set())
    assert walls.navigator.beside.made is None or walls.navigator.beside.content.run is not None
    figures = list(tmp_path.glob("* - *.png"))
    assert len(figures) == 12 and walls.navigator.page == "walls"
    for path in figures:
        picture = QImage(str(path))
        picture = picture.convertToFormat(QImage.Format.Format_Grayscale8)
        grey = np.frombuffer(picture.bits(), np.uint8).reshape(picture.height(), -1)
        grey = grey[:, : picture.width()]
        rows, columns = (np.flatnonzero((grey < 250).any(axis=k)) for k in (1, 0))
        assert columns[-1] - columns[0] > 0.9 * picture.width(), path.name
        assert rows[-1] - rows[0] > 0.9 * picture.height(), path.name
