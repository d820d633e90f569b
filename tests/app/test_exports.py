"""Charts that leave the program: whole, light, and every mark where its axes say."""

import csv
import io

import numpy as np
import pytest

pytest.importorskip("PySide6")

import pyqtgraph as pg
from PySide6.QtCore import QByteArray, QPointF
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

from app.look import language, theme
from app.shell.pages import delete
from app.views import figure_file
from app.views.chart import Chart
from app.views.figure_file import AXES_ASPECT, FigureSize, figure, raster
from app.views.table import Table
from core.errors import OutputError

SIZE = FigureSize(720 / 96 * 25.4, 192, caption=False)
"""As wide as the chart, twice the pixels of the screen."""

MARKS = ((61.7, 16.3), (80.0, 5.0), (100.0, 20.0), (118.0, 9.0))


@pytest.fixture
def chart(application):
    theme.set_theme("dark")
    made = Chart("SI [cm]", "q_eff [-]", "q against SI")
    made.view.setFixedSize(720, round(AXES_ASPECT * 720))
    made.points("time histories", *np.transpose(MARKS), 0, 12)
    made.curve("Eq. 15", [60.0, 120.0], [6.0, 18.0], 1, 3.0)
    made.plot.setXRange(50.0, 130.0, padding=0)
    made.plot.setYRange(0.0, 25.0, padding=0)
    made.show()
    application.processEvents()
    yield made
    made.deleteLater()
    theme.set_theme("light")


def place(chart, x, y) -> QPointF:
    """Where a point of the axes is in the view [px]."""
    return chart.view.mapFromScene(chart.plot.vb.mapViewToScene(QPointF(x, y)))


def near(image: QImage, x: float, y: float, shade: str, reach: int) -> bool:
    """Whether a pixel of this colour is within reach."""
    wanted = QColor(shade)
    for dx in range(-reach, reach + 1):
        for dy in range(-reach, reach + 1):
            found = image.pixelColor(round(x) + dx, round(y) + dy)
            if (
                max(
                    abs(found.red() - wanted.red()),
                    abs(found.green() - wanted.green()),
                    abs(found.blue() - wanted.blue()),
                )
                < 40
            ):
                return True
    return False


def drawn(chart, end) -> QImage:
    """The exported file as pixels, twice the size on the screen."""
    content = figure(chart, end, SIZE)
    if end == ".png":
        return QImage.fromData(content, "PNG")
    image = QImage(2 * chart.view.size(), QImage.Format.Format_RGB32)
    image.fill(QColor("white"))
    painter = QPainter(image)
    QSvgRenderer(QByteArray(content)).render(painter)
    painter.end()
    return image


def painted(application, size: FigureSize, dash: bool = False) -> tuple[QImage, int]:
    """The figure of a busy curve, and in how many turns of the window it was painted."""
    chart = Chart("x", "y", "busy")
    chart.show()
    application.processEvents()
    x = np.linspace(60.0, 120.0, 2000)
    chart.curve("busy", x, 100.0 + 90.0 * np.sin(7.0 * x), dash=dash)
    chart.plot.setYRange(-0.015, 250.0, padding=0)  # wider numbers beside the axis, once it is painted
    for turns, image in enumerate(raster(chart, size)):  # noqa: B007
        application.processEvents()
    delete(chart)
    return image, turns


LARGE = FigureSize(), FigureSize(120.0, 600, caption=False)


@pytest.mark.parametrize(
    "size",
    [
        *(FigureSize(80.0), FigureSize(60.0, 450, caption=False)),
        *(pytest.param(size, marks=pytest.mark.long) for size in LARGE),
    ],
)
def test_that_a_figure_in_strips_is_the_figure_painted_at_once(application, monkeypatch, size):
    in_strips, turns = painted(application, size)
    assert turns > 5
    monkeypatch.setattr(figure_file, "STRIP_CURVE_LENGTH", 1e9)
    at_once, turns = painted(application, size)
    assert turns == 1 and in_strips == at_once


def test_that_a_dashed_curve_is_painted_at_once(application):
    """Its dashes would begin anew in each strip."""
    assert painted(application, FigureSize(80.0), dash=True)[1] == 1


def test_that_a_chart_may_change_or_go_between_two_strips(application):
    for change in (lambda chart: chart.resize(500, 400), delete):
        chart = Chart("x", "y", "to be changed")
        chart.resize(700, 500)
        chart.show()
        application.processEvents()
        strips = raster(chart, FigureSize())
        next(strips)
        change(chart)
        strips.close()
        if change is not delete:
            application.processEvents()
            assert chart.view.width() == chart.width() == 500
            delete(chart)


@pytest.mark.parametrize("end", [".png", ".svg"])
def test_that_every_mark_and_line_is_where_its_axes_say(chart, end):
    image, light = drawn(chart, end), theme.LIGHT
    assert (image.width(), image.height()) == (2 * chart.view.width(), 2 * chart.view.height())
    for x, y in MARKS:
        at = place(chart, x, y)
        assert near(image, 2 * at.x(), 2 * at.y(), light.curves[0], 2), (x, y)
    for x, y in ((60.5, 6.1), (90.0, 12.0), (119.5, 17.9)):
        at = place(chart, x, y)
        assert near(image, 2 * at.x(), 2 * at.y(), light.curves[1], 3), (x, y)


@pytest.mark.parametrize("end", [".png", ".svg"])
def test_that_a_picture_is_whole_and_light(chart, end):
    image = drawn(chart, end)
    width, height = image.width(), image.height()
    assert all(
        image.pixelColor(x, y).lightness() > 240
        for x, y in ((3, 3), (width - 4, 3), (3, height - 4), (width - 4, height - 4))
    )
    # ink in each quarter: axis labels left and below, marks and legend right and above
    for left, top in ((0, 0), (width // 2, 0), (0, height // 2), (width // 2, height // 2)):
        dark = sum(
            image.pixelColor(x, y).lightness() < 200
            for x in range(left, left + width // 2, 3)
            for y in range(top, top + height // 2, 3)
        )
        assert dark > 20
    assert chart.view.backgroundBrush().color().lightness() < 100  # the screen stays dark


@pytest.mark.shows("files.no_formula_of_a_user")
def test_that_the_data_of_a_chart_can_be_read_back_and_run_no_formula(chart):
    chart.curve("=HYPERLINK(1)", [1.0], [2.0])
    rows = list(csv.reader(io.StringIO(chart.content(".csv").decode())))
    assert rows[0] == ["curve", "SI [cm]", "q_eff [-]"]
    assert [(float(x), float(y)) for name, x, y in rows if name == "time histories"] == list(MARKS)
    assert rows[-1] == ["'=HYPERLINK(1)", "1.0", "2.0"]


@pytest.mark.shows("files.no_formula_of_a_user")
@pytest.mark.parametrize(
    ("text", "copied"),
    [
        ("=1+1", "'=1+1"),
        ("@x", "'@x"),
        ("-A1", "'-A1"),
        ("+cmd", "'+cmd"),
        ("-0,5", "-0,5"),
        ("−1.2", "−1.2"),
        ("wall", "wall"),
        ("–", "–"),
        ("a\tb\nc", "a b c"),
        ("-inf", "'-inf"),
        ("-1_0", "'-1_0"),
        ("1e-3", "1e-3"),
        ("-3.2", "-3.2"),
    ],
)
def test_that_a_copied_cell_is_never_a_formula(application, text, copied):
    table = Table("t", ["a", "b"])
    table.show_rows([[text, "x"]])
    assert table.text().split("\n")[1].split("\t") == [copied, "x"]


def test_that_a_chart_that_cannot_be_written_says_so_and_leaves_the_old_one(chart, tmp_path):
    path = tmp_path / "c.png"
    path.write_bytes(b"old")
    with pytest.raises(OutputError, match="cannot be written"):
        chart.write(tmp_path / "none" / "c.png")
    tmp_path.chmod(0o555)
    try:
        chart.write(path)  # as root a folder can always be written
        assert path.read_bytes().startswith(b"\x89PNG")
    except OutputError:
        assert path.read_bytes() == b"old"
    finally:
        tmp_path.chmod(0o755)
    assert [p.name for p in tmp_path.iterdir()] == ["c.png"]


def test_that_the_ending_decides_in_any_case(chart, tmp_path):
    chart.write(tmp_path / "x.CSV")
    chart.write(tmp_path / "x.SVG")
    assert (tmp_path / "x.CSV").read_text().startswith("curve")
    assert (tmp_path / "x.SVG").read_bytes().startswith(b"<?xml")


def test_that_an_export_leaves_the_numbers_of_small_axes_as_they_are(chart):
    """pyqtgraph would show 0.1 g as 100, in the file and on the screen from then on."""
    chart.clear()
    chart.curve("ground", [0.0, 0.5], [-0.12, 0.13])
    chart.plot.setXRange(0.0, 0.5)
    chart.plot.setYRange(-0.15, 0.15)
    for end in (".png", ".svg"):
        chart.content(end)
        for side in ("left", "bottom"):
            assert chart.plot.getAxis(side).autoSIPrefixScale == 1.0


def test_that_an_image_is_recoloured_in_the_light_file(chart):
    seen = []
    chart.add(pg.ImageItem(np.zeros((2, 2))), lambda chosen, scale: seen.append(chosen))
    chart.content(".png")
    assert seen == [theme.current, theme.LIGHT, theme.current]


def rows_of(chart) -> list[list[str]]:
    return list(csv.reader(io.StringIO(chart.content(".csv").decode("utf-8-sig")), delimiter=","))


def test_that_the_csv_of_bars_has_the_names_of_the_records_and_no_number_for_what_overturned(chart):
    chart.clear()
    chart.bars("stands", [0.0, 2.0], [0.31, 1.2], values=[0.31, 1.74])
    chart.bars("overturned", [1.0], [1.2], 1, values=[np.nan])
    chart.names_below(["a", "=b", "c"])
    assert rows_of(chart)[1:] == [["stands", "a", "0.31"], ["stands", "c", "1.74"], ["overturned", "'=b", ""]]
    chart.clear()
    chart.curve("x", [1.0], [2.0])
    assert rows_of(chart)[1:] == [["x", "1.0", "2.0"]]


def test_that_an_italian_csv_has_semicolons_and_commas(chart):
    language.set_language("it")
    try:
        lines = chart.content(".csv").decode("utf-8-sig").splitlines()
    finally:
        language.set_language("en")
    assert lines[0] == "curva;SI [cm];q_eff [-]" and lines[1] == "time histories;61,7;16,3"


def test_that_no_chart_of_a_result_writes_a_number_that_nobody_computed(opened, application):
    """Overturned runs have no largest rotation: none is drawn into the files."""
    from tests.app.driving import run

    opened.session.edit_section("demand", ag_g=1.5, demand_scaling="pga")
    run(application, opened)
    result = opened.session.result
    dynamic = result.walls[0].assessment.dynamic
    assert any(one.peak_ratio is None for one in dynamic.runs)
    opened.navigator.show_page("check")
    written = {row[2] for row in rows_of(opened.pages["check"].content.peaks)[1:]}
    assert written == {"" if r.peak_ratio is None else repr(r.peak_ratio) for r in dynamic.runs}
    opened.navigator.show_page("capacity")
    peaks = rows_of(opened.pages["capacity"].content.peaks)
    assert "1.25" not in {row[2] for row in peaks}
    opened.navigator.show_page("histories")
    tab = opened.pages["histories"].content
    tab.slider.setValue(tab.slider.maximum())
    assert "9.99" not in tab.words.text()
    largest = max(abs(float(row[2])) for row in rows_of(tab.rotation)[1:])
    assert largest == pytest.approx(
        np.abs(tab.history.rotation).max() / result.walls[0].model.collapse_rotation, rel=1e-12
    )


def test_that_the_capacity_chart_shows_the_points_of_the_search(opened, application):
    """The first multiplier that overturns is the one q was bisected from; what was not searched is not survival."""
    from tests.app.driving import run

    run(application, opened)
    opened.navigator.show_page("capacity")
    tab = opened.pages["capacity"].content
    ida = opened.session.result.walls[0].runs[0].ida
    _, q, _ = next(entry for entry in tab.peaks.data if entry[0] == "overturns")
    step = opened.session.result.search.q_step
    assert q[0] / (1.0 + step) < ida.q <= q[0] * (1.0 + 1e-12)
    _, places, outcomes = tab.strips.data[0]
    assert "".join(str(int(outcome)) for outcome in outcomes) == ida.outcomes
    assert places[0] == pytest.approx(ida.q_start * (1.0 + step) ** ida.first_index, rel=1e-9)


def test_that_the_ground_is_shown_at_the_multiplier_in_use(opened, application):
    from tests.app.driving import run

    run(application, opened)
    opened.navigator.show_page("histories")
    tab = opened.pages["histories"].content
    wall, motion = opened.session.result.walls[0], opened.session.result.motions[0]
    tab.slider.setValue(300)
    _, _, felt = tab.ground.data[0]
    assert np.abs(felt).max() == pytest.approx(tab.q * wall.model.threshold / 9.80665, rel=1e-9)
    assert felt.size == motion.acceleration.size


def test_that_an_svg_opens_whatever_a_name_holds(chart):
    from xml.etree import ElementTree

    from app.views.figure_file import FigureSize, figure

    chart.curve("a\ufffe\uffff", [60.0, 120.0], [5.0, 6.0], 2)
    chart.caption = "wall \uffff"
    for content in (chart.content(".svg"), figure(chart, ".svg", FigureSize())):
        assert "\\uffff" in "".join(ElementTree.fromstring(content).itertext())
