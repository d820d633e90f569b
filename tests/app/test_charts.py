"""Charts: what Reset shows, what a copy and a figure hold, and windows built again."""

import gc
import os
import re
import weakref
from dataclasses import replace

import numpy as np
import pyqtgraph as pg
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QByteArray, QEvent, QObject, QRect, QRectF, Qt
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QWidget

from app.look import theme
from app.shell.window import MainWindow
from app.views.axis import elide_name
from app.views.chart import Chart
from app.views.figure_file import FigureSize, figure
from app.views.hatch import Hatch
from app.views.table import Table
from tests.app.conftest import own_windows
from tests.app.driving import run
from tests.conftest import ROOT


@pytest.fixture(scope="module")
def shared(of_verdict):
    """A window on two walls that have run, the second above the ground, with an accuracy statement of the first."""
    return of_verdict


def charts_of(window, application):
    """Every chart with data, its tab in front."""
    for name, page in window.pages.items():
        if name == "note":  # it has no chart, and takes a second to be set
            continue
        window.navigator.show_page(name)
        application.processEvents()
        yield from (chart for chart in page.content.findChildren(Chart) if chart.data)


def zoom(chart) -> None:
    (left, right), (low, high) = chart.plot.viewRange()
    chart.plot.setXRange(left + 0.4 * (right - left), left + 0.5 * (right - left), padding=0)
    chart.plot.setYRange(low + 0.4 * (high - low), low + 0.5 * (high - low), padding=0)


def shows_everything(chart) -> bool:
    """Whether all data are in view on each axis, or the ends the chart was given."""
    log = chart.plot.ctrl.logXCheck.isChecked()
    for k, (name, (low, high)) in enumerate(zip("xy", chart.plot.viewRange(), strict=True)):
        values = np.concatenate([entry[k + 1] for entry in chart.data])
        values = np.log10(values) if log else values
        first, last = chart.ranges.get(name, (np.nanmin(values), np.nanmax(values)))
        reach = last - first
        wide = high - low <= 4.0 * reach + 1e-9  # a band about a curve is no curve
        if not (low <= first + 1e-9 * reach and last - 1e-9 * reach <= high and wide):
            return False
    return True


@pytest.mark.parametrize("wall", [0, pytest.param(1, marks=pytest.mark.long)])
def test_that_reset_shows_everything_in_every_chart(shared, application, wall):
    shared.navigator.pick(wall)
    names = []
    for chart in charts_of(shared, application):
        if chart.name == "Survival map":
            continue  # its axis is a logarithm that its data are not
        before = chart.plot.viewRange()
        zoom(chart)
        application.processEvents()
        chart.reset()
        application.processEvents()
        assert shows_everything(chart), (chart.name, before, chart.plot.viewRange())
        names.append(chart.name)
    assert len(names) >= 9


def test_that_the_chart_of_methods_says_why_it_is_empty(shared, accuracy):
    shared.navigator.pick(0)
    shared.navigator.show_page("validation")
    tab = shared.pages["validation"].content
    tab.show_accuracy(replace(accuracy, points=(), q_reference=None))
    assert "No other method" in tab.chart.reason.text() and not tab.chart.reason.isHidden()
    tab.show_accuracy(accuracy)
    assert tab.chart.reason.isHidden()


def test_that_the_next_wall_is_shown_whole_after_a_zoom(shared, application):
    shared.navigator.pick(0)
    for chart in charts_of(shared, application):
        zoom(chart)
    application.processEvents()
    shared.navigator.pick(1)
    for chart in charts_of(shared, application):
        assert chart.name == "Survival map" or shows_everything(chart), chart.name


def test_that_the_survival_map_is_whole_after_reset(shared, application):
    shared.navigator.show_page("capacity")
    strips = shared.pages["capacity"].content.strips
    before = strips.plot.viewRange()
    zoom(strips)
    strips.reset()
    assert np.allclose(strips.plot.viewRange(), before)
    item = next(item for item, *_ in strips.items if isinstance(item, Hatch))
    (left, right), (low, high) = before
    assert left <= item.area.left() < item.area.right() <= right
    assert low <= item.area.top() < item.area.bottom() <= high


# pictures


def pixels(image: QImage) -> np.ndarray:
    """Red, green, blue of a picture, shape (height, width, 3)."""
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.bits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def is_shade(image: QImage, shade: str, tolerance: int = 40) -> np.ndarray:
    """Where a picture has this colour."""
    wanted = [int(shade[k : k + 2], 16) for k in (1, 3, 5)]
    return (np.abs(pixels(image) - wanted) <= tolerance).all(axis=2)


def drawn_svg(content: bytes, width: int) -> QImage:
    """A picture of an SVG, so many pixels wide."""
    renderer = QSvgRenderer(QByteArray(content))
    size = renderer.defaultSize()
    image = QImage(width, round(width * size.height() / size.width()), QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    renderer.render(painter)
    painter.end()
    return image


@pytest.mark.shows("window.stale")
def test_that_a_copied_picture_of_stale_results_says_so(application, monkeypatch):
    chart = Chart("x", "y", "c")
    chart.resize(400, 300)
    chart.curve("k", [0.0, 1.0], [0.0, 1.0])
    chart.show()
    application.processEvents()
    chart.copy()
    fresh = QGuiApplication.clipboard().image()
    assert fresh.size() == 2 * chart.view.size()
    assert not is_shade(fresh, theme.LIGHT.bad).any()
    monkeypatch.setattr(Table, "stale", True)
    chart.copy()
    marked = QGuiApplication.clipboard().image()
    assert marked.height() > fresh.height()
    assert is_shade(marked, theme.LIGHT.bad)[fresh.height() :].sum() > 50
    chart.live = True
    chart.copy()
    assert QGuiApplication.clipboard().image().size() == fresh.size()
    chart.deleteLater()


@pytest.mark.parametrize("end", [".png", ".svg"])
@pytest.mark.parametrize(("width", "dpi"), [(160.0, 300), (160.0, 600), (80.0, 300)])
def test_that_a_curve_is_as_wide_in_a_figure_as_on_the_screen(application, end, width, dpi):
    """Two pixels of 1/96 inch are 0.53 mm; below 120 mm all shrinks with the figure."""
    chart = Chart("x", "y", "c")
    chart.resize(500, 400)
    chart.curve("k", [0.0, 1.0], [0.5, 0.5], 1, 2.0, legend=False)
    chart.plot.showGrid(x=False, y=False)
    chart.set_range((0.0, 1.0), (0.0, 1.0))
    content = figure(chart, end, FigureSize(width, dpi))
    across = round(width / 25.4 * dpi)
    image = QImage.fromData(content, "PNG") if end == ".png" else drawn_svg(content, across)
    shade = int(theme.LIGHT.curves[1][5:], 16)  # its blue, of which it has none
    left, top = image.width() // 3, int(0.3 * image.height())
    part = image.copy(left, top, image.width() // 2 - left, int(0.6 * image.height()) - top)
    covered = (255.0 - pixels(part)[..., 2]) / (255.0 - shade)
    thick = np.median(covered.sum(axis=0)) / dpi * 25.4
    assert thick == pytest.approx(2.0 / 96.0 * 25.4 * min(1.0, width / 120.0), abs=25.4 / dpi)
    chart.deleteLater()


def test_that_a_curve_of_an_svg_ends_at_the_axes(application):
    """Of a chart that shows a part of its data; Qt's own reader of SVG does not cut, other programs do."""
    chart = Chart("x", "y", "c")
    chart.resize(500, 400)
    x = np.linspace(0.0, 1.0, 200)
    chart.curve("k", x, np.sin(30.0 * x), 1, 2.0, legend=False)
    chart.set_range((0.3, 0.5), (-0.5, 0.5))
    text = figure(chart, ".svg", FigureSize(160.0, 96)).decode()
    shade = theme.LIGHT.curves[1]
    (clip,) = set(re.findall(rf'<g clip-path="url\(#(\w+)\)"><g [^>]*stroke="{shade}"', text))
    outline = re.search(rf'<clipPath id="{clip}">\s*<path [^>]*d="M([^"]*)"', text)[1]
    places = np.array([[float(v) for v in pair.split(",")] for pair in re.split(" L| ", outline)])
    (left, top), (right, bottom) = places.min(axis=0), places.max(axis=0)
    assert 30 < left < 100 and right <= 605.0 and 0.0 <= top < bottom < 0.95 * 375.0
    chart.deleteLater()


@pytest.mark.parametrize("end", [".png", ".svg"])
def test_that_a_hatched_area_is_hatched_in_every_file(application, end):
    chart = Chart("x", "y", "c")
    chart.resize(500, 400)
    area = Hatch(QRectF(0.0, 0.0, 1.0, 1.0))

    def recolor(chosen, scale):
        area.set_pen(pg.mkPen(chosen.quiet, width=scale))

    chart.add(area, recolor)
    chart.plot.showGrid(x=False, y=False)
    chart.set_range((0.0, 2.0), (0.0, 1.0))
    content = figure(chart, end, FigureSize(160.0, 300))
    image = QImage.fromData(content, "PNG") if end == ".png" else drawn_svg(content, 1890)
    top, high = int(0.3 * image.height()), int(0.3 * image.height())
    for (left, right), hatched in (((0.25, 0.45), True), ((0.65, 0.95), False)):
        part = image.copy(int(left * image.width()), top, int((right - left) * image.width()), high)
        share = is_shade(part, theme.LIGHT.quiet, 60).mean()
        assert (0.02 < share < 0.5) == hatched, (left, right, share)
    chart.deleteLater()


@pytest.mark.parametrize("language", ["it", pytest.param("en", marks=pytest.mark.long)])  # the longer words
def test_that_no_word_of_a_legend_is_cut_at_1280(shared, application, language):
    shared.set_choice("language", language)
    shared.resize(1280, 800)
    shared.navigator.pick(0)
    for chart in charts_of(shared, application):
        shown = [label.text for _, label in chart.legend.items]
        if not chart.beside:
            assert shown == chart.entries, chart.name
    mean = shared.navigator.wall.assessment.dynamic.mean_peak_ratio
    if mean is not None:
        legend = shared.pages["check"].content.peaks.legend.items
        value = f"{mean:.2f}" if language == "en" else f"{mean:.2f}".replace(".", ",")
        assert any(value in label.text for _, label in legend)
    shared.set_choice("language", "en")


def test_that_a_name_longer_than_its_chart_keeps_its_beginning_and_end(application):
    name = "a very long name of a file of a station " * 3 + "(+)"
    chart = Chart("x", "y", "c")
    chart.resize(400, 300)
    chart.show()
    chart.curve(name, [0.0, 1.0], [0.0, 1.0])
    application.processEvents()
    chart.fit()
    ((_, label),) = chart.legend.items
    assert "…" in label.text and label.text.endswith("(+)") and label.itemRect().width() < 400
    assert label.text == elide_name(name, len(label.text))
    chart.deleteLater()


# the window


def test_that_nothing_of_an_earlier_theme_or_language_is_kept(opened, application):
    """Charts, actions and widgets are as many after the fourth change as after the second."""
    made = weakref.WeakSet()
    real = Chart.__init__

    def init(chart, *arguments, **options):
        real(chart, *arguments, **options)
        made.add(chart)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Chart, "__init__", init)
        counts = []
        for choice in (("theme", "dark"), ("language", "it"), ("theme", "light"), ("language", "en")):
            opened.set_choice(*choice)
            for name in opened.pages:
                opened.navigator.show_page(name)
            application.processEvents()
            gc.collect()
            charts = len(made)
            application.sendPostedEvents(None, QEvent.Type.DeferredDelete)  # as the loop does
            counts.append((charts, len(opened.findChildren(QObject))))
    charts, objects = zip(*counts, strict=True)
    assert set(charts) == {len(opened.findChildren(Chart))}
    assert max(objects) <= min(objects) + 20, counts


def test_that_a_refresh_makes_no_action_that_stays(opened, application):
    opened.files.remember(ROOT / "resources" / "cases" / "example.toml")
    application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    before = len(opened.findChildren(QObject))
    for _ in range(5):
        opened.refresh()
    application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert len(opened.findChildren(QObject)) == before


class Screen:
    """A screen with so much room."""

    def __init__(self, free: QRect):
        self.free = free

    def availableGeometry(self) -> QRect:
        return self.free


def test_that_the_end_of_the_tests_leaves_qt_the_widget_its_layouts_measure_with(application):
    """Where both deleted it a process of the tests ended by a fault of memory, at one end in four."""
    plot = pg.PlotWidget()
    plot.show()
    application.processEvents()
    found = own_windows(application)
    assert plot in found
    assert any(type(one) is QWidget and one not in found for one in application.topLevelWidgets())
    plot.close()
    plot.deleteLater()


@pytest.mark.parametrize("free", [QRect(0, 0, 1024, 700), QRect(60, 30, 1220, 770)])
def test_that_the_window_is_no_larger_than_its_screen(opened, application, monkeypatch, free):
    monkeypatch.setattr(MainWindow, "screen", lambda _: Screen(free))
    opened.resize(1900, 1000)
    opened.reset_layout()
    application.processEvents()
    assert free.contains(opened.frameGeometry()), opened.frameGeometry()


def test_that_the_height_of_the_base_says_what_it_takes(opened):
    words = opened.walls.fields["base_z_m"].toolTip()
    assert "building" in words.lower() and "no check" not in words


def test_that_panels_of_a_history_share_their_times_and_end_with_the_fall(shared, application):
    shared.navigator.show_page("histories")
    tab = shared.pages["histories"].content
    panels = (tab.ground, tab.rotation, tab.energy)

    def shown():
        application.processEvents()
        return [chart.plot.viewRange()[0] for chart in panels]

    def first_pixel(chart):
        """Of time 0, in the panel."""
        return chart.plot.vb.mapViewToScene(pg.Point(0.0, 0.0)).x()

    tab._set_q(0.5)  # it rests
    whole = shown()
    assert all(abs(ends[1] / tab.times[-1] - 1.0) < 0.05 for ends in whole)
    assert max(map(first_pixel, panels)) - min(map(first_pixel, panels)) < 2.5
    tab._set_q(20.0)
    end = tab.history.rotation.size * tab.motion.time_step
    assert end < 0.8 * tab.times[-1]
    assert all(end < ends[1] < 1.1 * end for ends in shown())
    assert tab.ground.plot.vb.height() >= 120
    for factor in np.linspace(20.0, 3.0, 40):  # never before the fall
        tab._set_q(factor)
        assert tab.until >= min(tab.history.rotation.size * tab.motion.time_step, tab.times[-1]) - 1e-9
    tab._set_q(0.5)
    assert shown() == whole


def test_that_a_limit_outside_of_a_chart_is_named_at_its_edge(application):
    rng = np.random.default_rng(5)
    for case in range(30):
        log = bool(case % 3 == 0)
        chart = Chart("x", "y", "limits")
        chart.set_log(log)
        ends = np.sort(rng.uniform(0.1, 10.0, (2, 2)), axis=1)
        chart.set_range(*(tuple(np.log10(pair) if log else pair) for pair in ends))
        values = rng.uniform(0.1, 10.0, 6)
        lines = [
            chart.level(float(np.log10(value) if log else value), f"limit {k}", vertical=k % 2 == 1)
            for k, value in enumerate(values)
        ]
        for _ in range(2):  # as set, and after a zoom
            shown, marks = chart.plot.viewRange(), chart.edges.items.items()
            named = " ".join(item.toPlainText() for _, item in marks if item.isVisible())
            for k, line in enumerate(lines):
                low, high = shown[0] if k % 2 else shown[1]
                assert (f"limit {k}" in named) == (not low <= line.value() <= high)
            zoom(chart)
        chart.clear()
        assert not chart.edges.items and not chart.edges.lines
        chart.deleteLater()


def test_that_the_axis_of_rotations_follows_the_peak_and_names_the_collapse_beyond(shared, application):
    shared.navigator.show_page("histories")
    tab = shared.pages["histories"].content
    for factor in (*np.geomspace(0.3, 6.0, 25), *np.geomspace(6.0, 0.3, 25)):
        tab._set_q(float(factor))
        peak, (_, top) = float(np.abs(tab.rotation.data[0][2]).max()), tab.rotation.ranges["y"]
        assert min(peak, 1.4) <= top <= min(1.4, max(0.01, 1.16 * peak) / 0.4)
        marks = [item.toPlainText() for item in tab.rotation.edges.items.values() if item.isVisible()]
        assert any("θc" in mark for mark in marks) == (top < 1.0)


def test_that_the_chart_of_the_law_names_each_of_its_lines(opened, application):
    """Both ends for one record have a name in its CSV, and one entry in its legend."""
    run(application, opened)
    opened.navigator.show_page("intensity")
    page = opened.pages["intensity"].content
    names = [name for name, _, _ in page.scale_free.data]
    assert all(names) and names.count("nine natural records of ten") == 2
    lines = page.scale_free.content(".csv").decode("utf-8-sig")
    assert lines.count("nine natural records of ten") == 120
    assert sum("nine natural" in label.text for _, label in page.scale_free.plot.legend.items) == 1
