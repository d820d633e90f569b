"""Help and looks: contrast, help of every number, the guide in two languages."""

import pytest

pytest.importorskip("PySide6")

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication, QLineEdit, QSlider, QWidget

from app.input.fields import Field
from app.look import theme
from app.shell import guide, menus
from core.study import self_test
from core.text.catalogue import CATALOGUE
from tests.app.driving import settle
from tests.core.lab.research.test_shake_table import invented


def contrast(one: QColor, other: QColor) -> float:
    """W3C contrast of two colours."""

    def light(color: QColor) -> float:
        parts = (color.redF(), color.greenF(), color.blueF())
        r, g, b = (c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
        return 0.2126 * r + 0.7152 * g + 0.0722 * b

    high, low = sorted((light(one), light(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.shows("window.themes")
@pytest.mark.parametrize("name", ["light", "dark"])
def test_that_edges_and_marks_stand_out(application, name):
    theme.set_theme(name)
    chosen = theme.THEMES[name]
    base = QColor(chosen.back)
    edge = QApplication.palette("QLineEdit").color(QPalette.ColorRole.Window).darker(140)
    assert contrast(edge, base) >= 3.0
    field = QLineEdit("x")
    field.resize(80, 30)
    picture = field.grab().toImage()
    drawn = max(contrast(picture.pixelColor(40, y), base) for y in (0, 1, 2))
    assert drawn >= 2.9
    form = QWidget()
    slider = QSlider(Qt.Orientation.Horizontal, form)
    slider.setValue(50)
    slider.resize(220, 30)
    form.resize(220, 30)
    picture, behind = form.grab().toImage(), QColor(chosen.window)
    for across in ([60], range(100, 120), [180]):  # the way behind its handle, the handle's edge, the way before it
        assert max(contrast(picture.pixelColor(x, y), behind) for x in across for y in range(30)) >= 3.0
    for mark in (chosen.good, chosen.amber, chosen.bad, chosen.quiet, chosen.ink):
        assert contrast(QColor(mark), base) >= 4.5
    theme.set_theme("light")


@pytest.mark.shows("window.help")
def test_that_every_number_field_has_help_in_both_languages(opened):
    for field in opened.findChildren(Field):
        if type(field).__name__ in ("NumberField", "RangeField"):
            assert guide.help_of(field), field.key
    for code, (english, italian) in CATALOGUE["key"].items():
        assert english != italian or not code.endswith(".help"), code


@pytest.mark.shows("window.help")
@pytest.mark.parametrize("tongue", ["en", "it"])
def test_that_the_guide_opens_in_its_language(opened, tongue):
    opened.set_choice("language", tongue)
    shown = guide.Guide(opened)
    assert shown.chosen.count() == 8
    for k in range(8):
        shown.chosen.setCurrentIndex(k)
        assert len(shown.text.toPlainText()) > 600
    assert ("Glossario" if tongue == "it" else "Glossary") in shown.text.toPlainText()
    shown.deleteLater()


def test_that_the_pages_of_both_guides_are_the_same():
    english, italian = (guide.pages_of(tongue) for tongue in ("en", "it"))
    assert [path.name[0] for path in english] == [path.name[0] for path in italian] == list("12345678")


def test_that_the_help_tells_what_the_model_says_of_tests_on_a_shake_table(application, opened, tmp_path, monkeypatch):
    invented(tmp_path)
    said = []
    monkeypatch.setattr(guide.QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    monkeypatch.setattr(guide.QMessageBox, "information", lambda _window, title, text: said.append((title, text)))
    guide.show_validation(opened)
    settle(application, lambda: said and opened.runner.job is None)
    ((title, text),) = said
    assert title == "Tests on a shake table" and "body 1: 71 tests" in text and "setback" in text


def test_that_the_help_saves_the_solved_cases_and_opens_them(application, opened, tmp_path, monkeypatch):
    from core.lab.solved import cases

    few = cases.SUBJECTS[0]._replace(cases=cases.SUBJECTS[0].cases[:2])
    monkeypatch.setattr(cases, "SUBJECTS", (few,))
    path, shown = tmp_path / "solved.pdf", []
    monkeypatch.setattr(guide, "path_to_write", lambda *_: path)
    monkeypatch.setattr(guide.QDesktopServices, "openUrl", lambda url: shown.append(url.toLocalFile()))
    guide.save_solved_cases(opened)
    settle(application, lambda: shown and opened.runner.job is None)
    assert shown == [str(path)] and path.read_bytes().startswith(b"%PDF")


def test_that_the_help_runs_the_case_within_a_report_again(application, opened, tmp_path, monkeypatch):
    from app.terminal import batch

    said = []
    assert batch.run(opened.session.path, tmp_path, 1, True, False) == 0
    report = opened.session.base_dir / "small.json"
    report.write_bytes((tmp_path / "small.json").read_bytes())
    monkeypatch.setattr(guide.QFileDialog, "getOpenFileName", lambda *_: (str(report), ""))
    monkeypatch.setattr(guide.QMessageBox, "information", lambda _window, title, text: said.append((title, text)))
    guide.show_verification(opened)
    settle(application, lambda: said and opened.runner.job is None)
    ((title, text),) = said
    assert title == "Verify a report" and "equal, run again by version" in text


@pytest.mark.shows("window.self_test")
def test_that_the_self_test_runs_in_the_background_of_a_start_and_about_and_help_tell_it(
    application, opened, monkeypatch
):
    said = []
    for name in ("about", "information", "warning"):
        monkeypatch.setattr(guide.QMessageBox, name, lambda *given, name=name: said.append((name, given[2])))
    menus.show_about(opened)
    assert "Self-test: not run yet" in said.pop()[1]
    opened.preparation.begin()
    settle(application, lambda: opened.preparation.job is None)
    menus.show_about(opened)
    assert said.pop()[1].endswith("Self-test: passed, to the last digit.") and not said
    guide.show_self_test(opened)
    settle(application, lambda: opened.runner.job is None)
    assert said.pop() == ("information", "Self-test: passed, to the last digit.") and not said


@pytest.mark.shows("window.self_test")
def test_that_a_wrong_answer_of_the_self_test_is_said_in_the_window_and_stays(application, opened, monkeypatch):
    said, stored = [], self_test.compute_answers("taylor")
    wrong = {**stored, "one_sided_q": stored["two_sided_q"], "kinematic": stored["kinematic"][::-1]}
    monkeypatch.setattr(self_test, "compute_answers", lambda method: wrong)
    monkeypatch.setattr(guide.QMessageBox, "warning", lambda *given: said.append(given[2]))
    opened.preparation.begin()
    settle(application, lambda: opened.preparation.job is None)
    (words,) = said
    assert "FAILED" in words and "the checks by the clauses, q of a one-sided wall come out wrong" in words
    assert "do not use any result" in words and opened.word.text() == words
    opened.preparation.tested(self_test.Outcome((), True))
    assert guide.self_test_words(opened) == words
