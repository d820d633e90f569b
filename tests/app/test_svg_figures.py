"""Figures as SVG in readers that are not Qt: bars, lines, marks, maps and histories as they are in the data."""

import os
import re
from xml.etree import ElementTree

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage

from app.look import theme
from app.shell.pages import delete
from app.views.axis import TICK_LETTERS, elide_name
from app.views.chart import Chart
from app.views.chart_output import ChartOutput
from app.views.figure_file import AXES_ASPECT, FigureSize, figure
from app.views.page_units import convert_to_page_units
from tests.app.driving import run
from tests.svg_readers import READERS, picture_by

WIDE = 605
HEIGHTS = (0.23, 0.4, 0.1, 0.9, 0.61)
SCALE = 3
"""Pixels of the pictures that are compared for one of the layout."""


@pytest.fixture
def chart(application):
    theme.set_theme("light")
    made = Chart("record", "ζ [-]", "Peaks")
    made.resize(700, 500)
    made.show()
    made.plot.showGrid(x=False, y=False)
    application.processEvents()
    yield made
    delete(made)


def shaded(pixels: np.ndarray, shade: str) -> np.ndarray:
    """Where a picture has this colour: near to it, and of its hue, which an edge on white keeps and a grey has not."""
    wanted = [int(shade[k : k + 2], 16) for k in (1, 3, 5)]
    first = int(np.argmin(wanted))  # the channel in which white is the farthest: few pixels are left for the others
    found = np.flatnonzero(np.abs(pixels[..., first] - pixels.dtype.type(wanted[first])) <= 60)
    values = pixels.reshape(-1, 3)[found].astype(float)
    near = (np.abs(values - wanted) <= 60).all(axis=-1)
    found, values = found[near], values[near]
    hue = np.array(wanted) - np.mean(wanted)
    values -= values.mean(axis=-1, keepdims=True)
    along = values @ hue / np.linalg.norm(hue)
    mask = np.zeros(pixels.shape[:2], bool)
    mask.flat[found[(along >= 0.5 * np.linalg.norm(hue)) & (along >= 0.95 * np.linalg.norm(values, axis=-1))]] = True
    return mask


def pixels_of(content: bytes) -> np.ndarray:
    image = QImage.fromData(content, "PNG").convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(np.int16)


def page_of(content: bytes) -> tuple[int, int]:
    """Size of the page of an SVG [px of the layout]."""
    return tuple(map(int, re.search(rb'viewBox="0 0 (\d+) (\d+)"', content).groups()))


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("width", [160.0, 80.0])
def test_that_bars_are_as_high_as_the_data_in_every_reader(chart, reader, width):
    chart.bars("stands", np.arange(5.0), HEIGHTS)
    chart.bars("overturned", [5.0], [1.0], 1)
    chart.set_range((-0.6, 5.6), (0.0, 2.0))
    content = figure(chart, ".svg", FigureSize(width, 96, caption=False))
    across, high = page_of(content)
    picture = picture_by(reader, content, 2 * across, 2 * high)
    top = int(0.8 * high)  # below the legend
    blue, red = (shaded(picture, theme.LIGHT.curves[k])[top:] for k in (0, 1))
    columns = np.flatnonzero(blue.any(axis=0))
    parts = np.split(columns, np.flatnonzero(np.diff(columns) > 3) + 1)
    assert len(parts) == len(HEIGHTS)
    reach = np.array([blue[:, part[part.size // 4]].sum() for part in parts])  # beside the tick in its middle
    across = np.flatnonzero(red.any(axis=0))
    whole = red[:, across[across.size // 4]].sum()
    assert reach / whole == pytest.approx(np.array(HEIGHTS), abs=3.0 / whole)


@pytest.mark.parametrize("reader", READERS)
def test_that_lines_marks_and_levels_are_where_the_data_are_in_every_reader(chart, reader):
    x = np.linspace(0.0, 5.0, 6)
    chart.curve("curve", x, 0.2 + 0.1 * x, 1, 3.0, legend=False)
    chart.points("marks", x, 0.9 - 0.1 * x, 2, 12, legend=False)
    chart.plot.setLabel("left", "y")
    chart.set_range((-0.5, 5.5), (0.0, 1.0))
    places = {}

    def keep(chart):
        places.update(
            {
                (k, a): chart.view.mapFromScene(chart.plot.vb.mapViewToScene(QPointF(float(a), float(b))))
                for k, ys in ((1, 0.2 + 0.1 * x), (2, 0.9 - 0.1 * x))
                for a, b in zip(x, ys, strict=True)
            }
        )

    real = chart.paint_light
    chart.paint_light = lambda painter: (real(painter), keep(chart))
    content = figure(chart, ".svg", FigureSize(160.0, 96, caption=False))
    across, high = page_of(content)
    picture = picture_by(reader, content, 2 * across, 2 * high)
    for (k, _), at in places.items():
        row, column = 2 * at.y(), 2 * at.x()
        around = shaded(picture, theme.LIGHT.curves[k])[row - 3 : row + 4, column - 3 : column + 4]
        assert around.any(), (k, at)


@pytest.fixture(scope="module")
def shared(of_verdict):
    """A window on two walls that have run, the second above the ground, with an accuracy statement of the first."""
    return of_verdict


def charts_of(window, application):
    for name, page in window.pages.items():
        if name == "note":  # it has no chart, and takes a second to be set
            continue
        window.navigator.show_page(name)
        application.processEvents()
        yield from (one for one in page.content.findChildren(Chart) if one.data)


def share_and_middle(pixels: np.ndarray, k: int) -> tuple[float, np.ndarray]:
    """The share of a picture that the k-th colour of the curves has, and its middle as a part of height and width."""
    mask = shaded(pixels, theme.LIGHT.curves[k])
    rows, columns = np.divmod(np.flatnonzero(mask), mask.shape[1])
    return mask.mean(), np.array([rows.mean(), columns.mean()]) / mask.shape if rows.size else np.zeros(2)


@pytest.fixture(scope="module")
def drawn(shared, application):
    """Every figure of the first wall: (name, its SVG, what each colour of its picture by Qt is: `share_and_middle`)."""
    shared.navigator.pick(0)
    coloured = []
    for k, shade in enumerate(theme.LIGHT.curves):
        parts = [int(shade[n : n + 2], 16) for n in (1, 3, 5)]
        if max(parts) - min(parts) >= 60:  # no grey, as letters and axes are
            coloured.append(k)
    found = []
    for one in charts_of(shared, application):
        raster = pixels_of(figure(one, ".png", FigureSize(160.0, SCALE * 96, caption=False)))
        wanted = {k: share_and_middle(raster, k) for k in coloured}
        found.append((one.name, figure(one, ".svg", FigureSize(160.0, 96, caption=False)), wanted))
    return found


def test_that_no_figure_asks_for_a_stroke_that_does_not_scale(drawn):
    assert len(drawn) >= 9
    for name, content, _ in drawn:
        assert b"non-scaling" not in content, name
        ElementTree.fromstring(content)


@pytest.mark.long
def test_that_no_figure_of_any_wall_and_width_asks_for_a_stroke_that_does_not_scale(shared, application):
    names = set()
    for wall in range(len(shared.session.result.walls)):
        shared.navigator.pick(wall)
        for one in charts_of(shared, application):
            for width in (80.0, 160.0):
                content = figure(one, ".svg", FigureSize(width))
                assert b"non-scaling" not in content, one.name
                ElementTree.fromstring(content)
            names.add(one.name)
    assert len(names) >= 9


@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.long)])
@pytest.mark.parametrize("reader", READERS)
def test_that_every_figure_shows_the_same_in_every_reader(drawn, reader, every):
    """The share of the picture that each colour of the curves has, and its middle: edges of lines of two pixels, which
    a reader may draw otherwise, are a fifth of them. Bars in strokes of the units of the axes fill the picture. In the
    short form each figure in one of the readers."""
    assert len(drawn) >= 9
    for name, content, wanted in drawn if every else drawn[READERS.index(reader) :: len(READERS)]:
        across, high = page_of(content)
        picture = picture_by(reader, content, SCALE * across, SCALE * high)
        for k, (share, middle) in wanted.items():
            if share < 0.003:  # a label, an end of a line
                continue
            seen = share_and_middle(picture, k)
            assert seen[0] == pytest.approx(share, rel=0.2, abs=2e-4), (name, k)
            assert seen[1] == pytest.approx(middle, abs=0.05), (name, k)


@pytest.mark.parametrize(
    ("shape", "points"),
    [
        ('<rect vector-effect="non-scaling-stroke" x="1" y="2" width="3" height="4"/>', [(12, 36), (42, 36), (42, 24)]),
        ('<line vector-effect="non-scaling-stroke" x1="1" y1="2" x2="3" y2="4"/>', [(12, 36), (32, 30)]),
        ('<polyline fill="none" vector-effect="non-scaling-stroke" points="1,2 3,4 "/>', [(12, 36), (32, 30)]),
        ('<path vector-effect="non-scaling-stroke" d="M1,2 L3,4"/>', [(12, 36), (32, 30)]),
        ('<ellipse vector-effect="non-scaling-stroke" cx="1" cy="2" rx="3" ry="1"/>', [(42, 36), (12, 33), (-18, 36)]),
        ('<circle vector-effect="non-scaling-stroke" cx="1" cy="2" r="1"/>', [(22, 36), (12, 33), (2, 36)]),
    ],
)
def test_that_every_shape_moves_with_the_matrix_of_its_group(shape, points):
    words = '<text x="5" y="6" font-size="3">a</text>'
    group = f'<g stroke-width="1" transform="matrix(10,0,0,-3,2,42)" \nfont-size="12" \n>\n{shape}\n{words}\n</g>'
    moved = convert_to_page_units(f"<svg>{group}</svg>")
    ElementTree.fromstring(moved)
    assert "non-scaling" not in moved and moved.count("matrix(10,0,0,-3,2,42)") == 1
    assert f'<g transform="matrix(10,0,0,-3,2,42)">{words}</g>' in moved
    pairs = [tuple(map(float, pair)) for pair in re.findall(r"([-\d.e]+),([-\d.e]+)(?=[ \"])", moved)]
    assert all(any(pair == pytest.approx(point, abs=1e-6) for pair in pairs) for point in points), moved


# names


def words_of(content: bytes) -> list[str]:
    return [text.strip() for text in ElementTree.fromstring(content).itertext() if text.strip()]


@pytest.mark.parametrize(
    ("width", "count"),
    [
        *((80.0, 28), (120.0, 14), (160.0, 8)),
        *(
            pytest.param(width, count, marks=pytest.mark.long)
            for width, count in ((80.0, 8), (80.0, 14), (120.0, 8), (120.0, 28), (160.0, 14), (160.0, 28))
        ),
    ],
)
def test_that_all_records_are_named_at_every_width(application, chart, width, count):
    names = [f"IT.STATION{k}.HNE.{1900 + k}" for k in range(count)]
    chart.bars("stands", np.arange(float(count)), np.linspace(0.2, 0.9, count))
    chart.names_below(names)
    chart.set_range((-0.6, count - 0.4), (0.0, 1.0))
    before = chart.view.size(), chart.plot.getAxis("bottom").height()
    content = figure(chart, ".svg", FigureSize(width))
    shown = words_of(content)
    assert [name for name in names if elide_name(name, TICK_LETTERS) not in shown] == []
    application.processEvents()
    assert (chart.view.size(), chart.plot.getAxis("bottom").height()) == before, "the screen is as it was"
    assert pixels_of(figure(chart, ".png", FigureSize(width, 96))).shape[0] > 0


def test_that_a_figure_too_narrow_for_all_names_says_so(chart):
    names = [f"record {k:02d}" for k in range(90)]
    chart.bars("stands", np.arange(90.0), np.full(90, 0.5))
    chart.names_below(names)
    chart.set_range((-0.6, 89.6), (0.0, 1.0))
    shown = words_of(figure(chart, ".svg", FigureSize(80.0, caption=False)))
    said = [text for text in shown if "90 names" in text]
    step = int(re.search(r"one in (\d+)", said[0])[1])
    assert [name for name in names[::step] if name not in shown] == []


@pytest.mark.parametrize("width", [80.0, 160.0])
def test_that_every_strip_of_a_figure_is_named(chart, width):
    lines = [(float(k), f"IT.ST{k:02d}.HNE (+)") for k in range(40)]
    chart.bars("x", np.arange(40.0), np.arange(40.0))
    chart.names_beside(lines)
    chart.set_range((0.0, 40.0), (-0.5, 39.5))
    content = figure(chart, ".svg", FigureSize(width))
    assert [name for _, name in lines if elide_name(name, TICK_LETTERS + 4) not in words_of(content)] == []
    across, high = page_of(content)
    assert high > AXES_ASPECT * across


@pytest.mark.parametrize("reader", READERS)
def test_that_a_figure_of_80_mm_has_letters_that_keep_their_room(chart, reader):
    """Below 120 mm the layout has more pixels an inch: its letters shrink with it, in every reader."""
    chart.curve("curve", [0.0, 1.0], [0.0, 1.0], 0)
    sizes = {}
    for width in (160.0, 80.0):
        content = figure(chart, ".svg", FigureSize(width, caption=False))
        sizes[width] = set(re.findall(rb'font-size="([\d.]+)"', content))
        size = re.search(rb'width="([\d.]+)mm"', content)
        assert float(size[1]) == pytest.approx(width, abs=0.2)
        picture_by(reader, content, *page_of(content))
    assert sizes[160.0] == sizes[80.0]


# what captions and columns say


def test_that_captions_say_floor_where_it_is_the_floor(opened, application):
    from dataclasses import replace

    from core.case.site import Building, Spectrum

    captions, live = {}, set()
    for base in (0.0, 6.0):
        opened.session.edit_wall(0, base_z_m=base)
        building = Building(height_m=9.0, storeys=3, period_s=0.26)
        opened.session.edit(replace(opened.session.case, building=building))
        opened.session.edit_section("demand", soil_factor=None, spectrum=Spectrum("EN1998", "B", type=1))
        run(application, opened)
        opened.navigator.pick(0)
        charts = list(charts_of(opened, application))
        captions[base] = {one.name: one.caption for one in charts}
        live |= {one.name for one in charts if one.live}
    for name, words in captions[0.0].items():
        assert "floor" not in (name + words).lower(), name
    for name, words in captions[6.0].items():
        assert "motion of the floor at 6 m" in words or name in live or "validation" in name.lower(), (name, words)
    assert "Ground motion" in captions[0.0] and "Motion of the floor" in captions[6.0]
    assert "Ground motion" not in captions[6.0]
    ground = opened.pages["histories"].content.ground
    assert "Motion of the floor. " in " ".join(words_of(figure(ground, ".svg", FigureSize())))


@pytest.mark.parametrize(("language", "head"), [("en", "outcome"), ("it", "esito")])
def test_that_the_columns_of_the_map_say_what_they_hold(opened, application, language, head):
    from app.views.figure_dialogs import data_table
    from core.rocking.outcome import COLLAPSED, STABLE

    opened.set_choice("language", language)
    run(application, opened)
    opened.navigator.show_page("capacity")
    strips = opened.pages["capacity"].content.strips
    mark = ";" if language == "it" else ","
    first = strips.content(".csv").decode("utf-8-sig").splitlines()[0]
    assert first.split(mark)[1] == "q [-]" and head in first and f"{STABLE} " in first and f"{COLLAPSED} " in first
    dialog = data_table(strips)
    assert head in strips.columns[2] and strips.columns[0] and strips.labels[1] not in strips.columns
    dialog.deleteLater()
    assert ChartOutput.column == ""
