"""Every control by the keyboard, with a focus that is seen and a name that is read; words whole in large letters."""

import os
import re

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetricsF, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QDialog,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QScrollArea,
    QScrollBar,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QTextEdit,
    QWidget,
)

from app.input.import_dialog import ImportDialog
from app.look.section import FoldingSection, SectionHeader
from app.shell import guide, menus, tree
from app.shell.study_window import StudyWindow
from app.views import figure_dialogs, ladder
from app.views.chart import Chart
from app.views.ladder import Rung
from core.case.solids import Opening, Solid, Step, Wedges
from tests.app.driving import run, settle
from tests.conftest import ROOT

KINDS = (
    QAbstractButton,
    QLineEdit,
    QComboBox,
    QAbstractSlider,
    QAbstractSpinBox,
    QAbstractItemView,
    QTabBar,
    QTextEdit,
    QPlainTextEdit,
)
LANGUAGES = ("it", pytest.param("en", marks=pytest.mark.long))
"""Whose words are looked at: the longer ones in the short run."""

INSIDE = (QComboBox, QAbstractSpinBox, QLineEdit, QTabBar, QAbstractItemView)
"""Controls whose parts are none of their own."""


def controls(top: QWidget) -> list[QWidget]:
    """What is to be reached in a window as it stands."""
    return [
        one
        for one in top.findChildren(QWidget)
        if isinstance(one, KINDS)
        and not isinstance(one, (QScrollBar, QHeaderView))
        and one.isVisible()
        and one.isEnabled()
        and one.window() is top
        and not isinstance(one.parentWidget(), INSIDE)
    ]


def walked(application, top: QWidget, key) -> list[QWidget]:
    """Where the focus goes with this key until it comes back; in words it goes from link to link."""
    seen, before = {}, None  # a key for each: to look for one in a list of all takes longer than the keys
    for _ in range(300):
        QTest.keyClick(application.focusWidget() or top, key)
        now = application.focusWidget()
        if now is None or (now in seen and now is not before):
            break
        seen[now] = None
        before = now
    return list(seen)


def named(one: QWidget) -> str:
    """What a reader of the screen says of it: a name, its words, those of the label beside it."""
    words = one.text() if isinstance(one, QAbstractButton) else ""
    if name := one.accessibleName() or (words if len(words) > 1 else ""):
        return name
    return "".join(label.text() for label in one.window().findChildren(QLabel) if label.buddy() is one)


def told(one: QWidget) -> str:
    return f"{type(one).__name__} {named(one)!r} of {type(one.parentWidget()).__name__}"


def must_be_reached(application, top: QWidget, known: set[QWidget] = frozenset()) -> set[QWidget]:
    """By Tab and by Shift+Tab, or by the arrows of a group; each has a name and shows the focus, those known apart,
    which are of an earlier look at this window. Returns all that were reached."""
    top.activateWindow()
    for key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
        seen = walked(application, top, key)
        reached = set(seen)
        groups = [one.group() for one in seen if isinstance(one, QAbstractButton) and one.group()]
        wanted = controls(top)
        for one in wanted:
            by_arrows = isinstance(one, QAbstractButton) and one.group() in groups and one.group().exclusive()
            typed = isinstance(one, QComboBox) and one.lineEdit() in reached
            assert one in reached or by_arrows or typed, f"not reached: {told(one)}"
    for one in wanted:
        assert named(one), f"no name: {told(one)}"
    for one in (one for one in seen if one not in known):
        one.setFocus(Qt.FocusReason.TabFocusReason)
        focused = one.grab().toImage()
        one.clearFocus()
        assert focused != one.grab().toImage(), f"the focus is not seen: {told(one)}"
    return {*seen, *known}


def stages(window, application):
    """Each form and each page in front, by its name, with all sections open."""
    for section in window.findChildren(FoldingSection):
        section.unfold()
    for kind in window.stages.input.areas:
        window.navigator.show_input(kind)
        for _ in range(5):  # each lays out what is within the one before
            settle(application, lambda: True)
        yield kind
    for name in window.pages:
        window.navigator.show_page(name)
        if name == "note":
            settle(application, lambda: not window.pages["note"].content.is_setting)
        application.processEvents()
        yield name


def dialogs(window, application, monkeypatch, visit) -> set[str]:
    """`visit(dialog)` for each dialog of the window; returns the titles of those that were there."""
    titles = set()

    def look(dialog) -> QDialog.DialogCode:
        dialog.show()
        application.processEvents()
        visit(dialog)
        titles.add(dialog.windowTitle())
        dialog.hide()
        return QDialog.DialogCode.Rejected

    monkeypatch.setattr(QDialog, "exec", look)
    window.navigator.show_page("check")
    chart = window.pages["check"].content.findChild(Chart)
    figure_dialogs.ask_size(window)
    chart._ask_limits()
    chart.show_table()
    menus.find(window)
    menus.open_client_view(window)
    look(ImportDialog([ROOT / "tests" / "motions" / "noise_1.txt"], window))
    guide.show_guide(window)
    look(window.findChild(guide.Guide))
    menus.open_study_window(window)
    look(window.findChild(StudyWindow))
    return titles


@pytest.mark.shows("window.access")
def test_that_every_control_of_a_stage_is_reached_by_the_keys_and_shows_it(opened, application):
    run(application, opened)
    opened.activateWindow()
    names, known = [], set()
    for name in stages(opened, application):
        known = must_be_reached(application, opened, known)
        names.append(name)
    assert len(names) == len(opened.stages.input.areas) + len(opened.pages)
    opened.show_first_run()
    must_be_reached(application, opened, known)


def test_that_the_arrows_go_from_stage_to_stage(opened, application):
    opened.activateWindow()
    opened.header.buttons["input"].setFocus(Qt.FocusReason.TabFocusReason)
    for name in ("answer", "why", "report"):
        QTest.keyClick(application.focusWidget(), Qt.Key.Key_Right)
        assert opened.stages.front == name and application.focusWidget() is opened.header.buttons[name]


@pytest.mark.shows("window.access")
def test_that_every_control_of_a_dialog_is_reached_by_the_keys_and_shows_it(opened, application, monkeypatch):
    run(application, opened)
    found = dialogs(opened, application, monkeypatch, lambda dialog: must_be_reached(application, dialog))
    assert len(found) == 8


def whole(words: str, *controls: QWidget) -> bool:
    """Whether a tool tip of one of these has words that begin as these do."""
    return any(words.rstrip("…") in control.toolTip() for control in controls)


def cut(one: QWidget, top: QWidget) -> str:
    """How much of its words a control shows less than all, nothing where all are there."""
    words, room = "", one.contentsRect().width()
    if isinstance(one, QLabel) and one.text() and not one.pixmap():
        words = one.text()
        plain = re.sub("<[^>]*>", "", words)
        rich = plain != words
        if words.endswith("…") and isinstance(one.parentWidget(), SectionHeader):
            return "" if whole(words, one.parentWidget()) else "no tool tip"
        if one.wordWrap():
            longest = max(one.fontMetrics().horizontalAdvance(word) for word in plain.split())
            if one.heightForWidth(one.width()) > one.height() + 1 or (longest > room + 1 and not rich):
                return f"{one.heightForWidth(one.width())} in a height of {one.height()}, a word of {longest} in {room}"
            return ""
        needed = one.sizeHint().width() if rich else one.fontMetrics().horizontalAdvance(plain.split("\n")[0])
    elif isinstance(one, QComboBox):
        words, option = one.currentText(), QStyleOptionComboBox()
        one.initStyleOption(option)
        part = QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField, one
        needed, room = one.fontMetrics().horizontalAdvance(words), one.style().subControlRect(*part).width()
    elif (
        isinstance(one, QAbstractButton)
        and not isinstance(one, SectionHeader)
        and not isinstance(one.parentWidget(), INSIDE)
    ):
        words, needed, room = one.text(), one.sizeHint().width(), one.width()
        high = one.heightForWidth(one.width()) if one.hasHeightForWidth() else one.sizeHint().height()
        if high > one.height() + 2:
            return f"a height of {high} in {one.height()}"
    elif isinstance(one, QTabBar) and one.count():
        words, needed, room = one.tabText(one.count() - 1), one.tabRect(one.count() - 1).right(), one.width()
    if not words:
        return ""
    if needed > room + 1 and not whole(words, one):
        return f"{needed} in {room}"
    left, above = one.mapTo(top, QPoint(0, 0)).x(), one.parentWidget()
    while above is not None and above is not top:
        edge = above.mapTo(top, QPoint(0, 0)).x()
        if left < edge - 1 or left + one.width() > edge + above.width() + 1:
            return f"beyond the edge of {type(above).__name__}"
        above = None if isinstance(above, QScrollArea) else above.parentWidget()
    return ""


def must_be_whole(top: QWidget) -> None:
    for one in top.findChildren(QWidget):
        if one.isVisible() and one.window() is top:
            lost = cut(one, top)
            assert not lost, f"{told(one)} {getattr(one, 'text', str)()!r}: {lost}"


@pytest.fixture
def large(application):
    """Letters of 150 %."""
    usual = application.font()
    font = application.font()
    font.setPointSizeF(1.5 * font.pointSizeF())
    application.setFont(font)
    yield
    application.setFont(usual)


@pytest.mark.shows("window.access")
@pytest.mark.parametrize("language", LANGUAGES)
def test_that_no_word_is_cut_in_large_letters(large, fresh, application, monkeypatch, language):
    fresh.session.edit_section("report", author="N. N.")
    run(application, fresh)
    fresh.set_choice("language", language)
    fresh.resize(1280, 800)
    settle(application, lambda: fresh.records.motions and not fresh.records.pending)
    assert fresh.size().width() == 1280 and fresh.size().height() == 800
    assert fresh.font().pointSizeF() > 12.0
    for _ in stages(fresh, application):
        must_be_whole(fresh)
    dialogs(fresh, application, monkeypatch, must_be_whole)
    fresh.show_first_run()
    application.processEvents()
    must_be_whole(fresh)


@pytest.mark.shows("window.access")
@pytest.mark.parametrize("language", LANGUAGES)
def test_that_the_window_fits_a_screen_of_1280_by_800_at_150_percent(fresh, application, language):
    """Such a screen has 853 x 533 pixels of the window, of which frame and bar of the desktop take some."""
    fresh.set_choice("language", language)
    fresh.resize(853, 480)
    for _ in stages(fresh, application):
        assert fresh.size().width() == 853 and fresh.size().height() == 480


class Recorder:
    """A painter that keeps what it writes: (words, their place, the room they were given), and the bars it fills."""

    RenderHint = QPainter.RenderHint
    last: "Recorder"

    def __init__(self, painter):
        Recorder.last = self
        self.painter = painter if isinstance(painter, QPainter) else QPainter(painter)
        self.written, self.bars = [], []

    def __getattr__(self, name):
        return getattr(self.painter, name)

    def drawText(self, place, *rest):
        words, metrics = rest[-1], QFontMetricsF(self.painter.font())
        if isinstance(place, QPointF):
            wide = metrics.horizontalAdvance(words)
            found = room = QRectF(place.x(), place.y() - metrics.ascent(), wide, metrics.height())
        else:
            found, room = self.painter.boundingRect(place, *rest), place
        self.written.append((words, found, room))
        self.painter.drawText(place, *rest)

    def fillRect(self, area, shade):
        self.bars.append(area)
        self.painter.fillRect(area, shade)


ONE_CHECK = Rung("q = 2", "C8.7.1.2.1.7", 0.72, "0.146 / 0.200 g", "bad", True)


@pytest.mark.parametrize("language", LANGUAGES)
def test_that_no_painted_word_of_the_ladder_is_cut_or_covered(large, fresh, application, monkeypatch, language):
    run(application, fresh)
    fresh.set_choice("language", language)
    fresh.resize(1280, 800)
    fresh.navigator.show_page("check")
    application.processEvents()
    monkeypatch.setattr(ladder, "QPainter", Recorder)

    def paint(one, event):
        real(one, event)
        Recorder.last.painter = None  # it ends with the event

    real = ladder.Ladder.paintEvent
    monkeypatch.setattr(ladder.Ladder, "paintEvent", paint)
    shown = fresh.pages["check"].content.ladder
    all_checks = [*shown.rungs, ONE_CHECK._replace(name="lower q of the histories", zeta=9.0), ONE_CHECK]
    for rungs in (shown.rungs, [ONE_CHECK], all_checks):
        alone = ladder.Ladder()
        alone.show_rungs(rungs, 1.0)
        alone.resize(shown.width(), alone.minimumSizeHint().height())
        alone.grab()
        painter = Recorder.last
        assert len(painter.bars) == len(rungs) and len(painter.written) == 4 * len(rungs) + 1
        areas = [found for words, found, _ in painter.written if words]
        for k, (words, found, room) in enumerate(one for one in painter.written if one[0]):
            assert not words.endswith("…") and room.adjusted(-1, -1, 1, 1).contains(found), words
            assert QRectF(alone.rect()).contains(found), words
            others = [*areas[:k], *areas[k + 1 :], *painter.bars]
            assert not any(found.adjusted(1, 1, -1, -1).intersects(other) for other in others), words


def painted_rows(opened, application, monkeypatch, language: str) -> list[tuple]:
    """(row, its tool tip, what was written, the last of it its words) of the tree of a case with two variants."""
    found = {}

    def paint(delegate, painter, option, index):
        recorder = Recorder(painter)
        real(delegate, recorder, option, index)
        recorder.painter = None  # it is gone when the row is painted
        row = index.data(Qt.ItemDataRole.UserRole)
        found[row.key] = row, index.data(Qt.ItemDataRole.ToolTipRole), recorder.written

    real = tree.Chips.paint
    monkeypatch.setattr(tree.Chips, "paint", paint)
    opened.walls.add_variant()
    opened.set_choice("language", language)
    if language == "en":
        opened.build()  # with rows that this paints, which another language has as well
    opened.resize(1280, 800)
    run(application, opened)
    settle(application, lambda: opened.records.motions and not opened.records.pending)
    found.clear()
    opened.tree.grab()
    return list(found.values())


@pytest.mark.parametrize("language", LANGUAGES)
def test_that_no_painted_word_of_the_tree_is_cut_in_large_letters(large, fresh, application, monkeypatch, language):
    rows = painted_rows(fresh, application, monkeypatch, language)
    assert len([row for row, *_ in rows if row.chip]) >= 4 and any(row.depth == 2 for row, *_ in rows)
    for row, tip, (*chip, (words, found, room)) in rows:
        assert bool(chip) == bool(row.chip) and tip == row.text
        assert QRectF(fresh.tree.tree.viewport().rect()).contains(found)
        assert room.adjusted(-1, -1, 1, 1).contains(found)
        for _, place, bubble in chip:
            assert bubble.contains(place) and not bubble.intersects(room), row
        # a name of the user may be longer than the tree; what the program says is whole, or only in the tool tip
        whole = words in (row.text, row.text.split(tree.ROW_SEPARATOR)[0])
        assert whole or (row.depth and words.endswith("…")), row
    wide = fresh.tree.width()
    fresh.session.edit_section("report", author="N. N.")
    assert fresh.tree.width() == wide  # nothing moves under the hand that types


@pytest.mark.parametrize("language", LANGUAGES)
def test_that_the_first_level_of_the_tree_is_whole(opened, application, monkeypatch, language):
    for row, _, written in painted_rows(opened, application, monkeypatch, language):
        assert row.depth or written[-1][0] == row.text


SHAPES = {
    "short": {
        "openings": (Opening(0.5, 1.0, 1.0, 1.0), Opening(2.0, 2.5, diameter_m=0.8)),
        "steps": (Step(4.0, 0.3, "inner"),),
        "return_wedges": Wedges(2, 0.4, 1.0),
    },
    "solids": {
        "solid": (
            Solid("oblique", ((0.0, 0.0), (3.0, 5.0), (0.0, 5.0)), 0.5, angle_deg=45.0),
            Solid("oblique", ((0.5, 5 / 6), (3.0, 5.0), (0.5, 5.0)), 0.0, -0.5, angle_deg=-45.0),
        )
    },
}


def shaped(window, shape: str) -> None:
    """The form of a wall with short forms or with solids, all of its fields shown."""
    sizes = {"height_m": 5.0, "thickness_m": 0.5, "length_m": 4.0, "unit_weight_kn_m3": 18.0}
    window.session.edit_wall(0, mechanism="one_sided", **sizes, **SHAPES[shape])
    for section in window.findChildren(FoldingSection):
        section.unfold()
    window.navigator.show_input("wall")
    window.walls.body.solids.list.setCurrentRow(1)


@pytest.mark.parametrize("shape", SHAPES)
def test_that_every_control_of_a_shape_is_reached_by_the_keys_and_shows_it(opened, application, shape):
    shaped(opened, shape)
    assert opened.session.problem() is None
    settle(application, lambda: True)
    must_be_reached(application, opened)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("language", LANGUAGES)
def test_that_no_word_of_a_shape_is_cut_in_large_letters(large, fresh, application, language, shape):
    fresh.set_choice("language", language)
    fresh.resize(1280, 800)
    shaped(fresh, shape)
    settle(application, lambda: fresh.records.motions and not fresh.records.pending)
    must_be_whole(fresh)
