"""The answer as one types: clauses at once, the verdict when the hand rests, assumptions as switches."""

from dataclasses import replace

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from shiboken6 import isValid

from core.case.select import Select
from core.case.site import Spectrum
from core.known import require_value
from core.study.run import run
from core.text.sentence import word
from tests.app.driving import settle, type_into


@pytest.fixture
def live(opened, application):
    """The live answer of the window, unfolded; the pause is short."""
    found, session = opened.stages.input.live, opened.session
    spectrum = Spectrum(code="NTC2018", f0=2.4, tc_star_s=0.33, soil="B", topography="T1")
    session.edit(replace(session.case, demand=replace(session.case.demand, soil_factor=None, spectrum=spectrum)))
    found.rested.setInterval(30)
    opened.navigator.show_input("wall", 0)
    found.unfold()
    yield found
    if isValid(found):
        found.rested.setInterval(400)
        found.head.setChecked(False)


def zetas(live) -> list:
    return [rung.zeta for rung in live.ladder.rungs]


def shows_nothing(live) -> bool:
    """No word of an answer."""
    return live.ladder.isHidden() and live.head.words == "" and not live.lines.text() and live.board.isHidden()


def verdict_of(result):
    return require_value(result.walls[result.verdicts[0].governing].assessment).verdict


def test_that_the_spectra_stand_beside_the_records(opened, application):
    given = opened.stages.input
    opened.navigator.show_input("records")
    application.processEvents()
    assert given.views.currentWidget() is given.spectra
    chart = given.spectra.made.chart
    names = [name for name, *_ in chart.data]
    assert all(motion.name in names for motion in opened.records.motions)


@pytest.mark.shows("window.live")
def test_that_the_clauses_follow_a_key_and_the_verdict_the_hand_that_rests(live, opened, application):
    settle(application, lambda: live.result is not None)
    before = verdict_of(live.result)
    field = opened.walls.fields["thickness_m"]
    type_into(field, "80")
    assert opened.session.case.wall[0].thickness_m == 0.8 and live.result is None
    settle(application, lambda: not live.at_once.isActive())
    expected = run(require_value(opened.session.checked()), base_dir=opened.session.base_dir)
    clauses = {check.zeta for check in expected.walls[0].assessment.checks if check.name != "dynamic"}
    at_once = [rung.zeta for rung in live.ladder.rungs if rung.zeta is not None]
    assert at_once and set(at_once) <= clauses
    settle(application, lambda: live.result is not None)
    assert verdict_of(live.result) == verdict_of(expected) != before
    assert zetas(live) == [check.zeta for check in expected.walls[0].assessment.checks]
    assert live.head.words.startswith(f"w: {word(verdict_of(expected).code, 'en')}")


def test_that_a_switch_shows_the_wall_at_the_other_end_and_back(live, opened, application):
    """A wall that passes by what is required of it alone."""
    opened.session.edit_section("demand", ag_g=0.2, zeta_target=0.5)
    settle(application, lambda: live.result is not None and bool(live.switches))
    as_it_is, said = zetas(live), live.head.words
    rows = {row.key: row for row in verdict_of(live.result).assumptions}
    key = next(key for key, box in live.switches.items() if box.isEnabled())
    live.switches[key].setChecked(True)
    settle(application, lambda: zetas(live) != as_it_is)
    assert rows[key].zeta in zetas(live) and live.head.words != said
    live.switches[key].setChecked(False)
    assert zetas(live) == as_it_is and live.head.words == said


def test_that_it_rests_while_folded_or_out_of_sight_or_the_case_runs(live, opened, application):
    settle(application, lambda: live.result is not None)
    live.head.setChecked(False)
    assert live.at is None and live.result is None and live.job is None and shows_nothing(live)
    live.unfold()
    assert live.at is not None
    opened.navigator.show_stage("answer")
    assert live.at is None and live.job is None
    opened.navigator.show_stage("input")
    assert live.at is not None
    opened.navigator.show_input("records")
    assert live.isHidden() and live.at is None
    opened.navigator.show_input("wall", 0)
    settle(application, lambda: live.result is not None)
    opened.run()
    assert opened.runner.job is not None and live.at is None and shows_nothing(live)
    opened.navigator.show_input("wall", 0)
    opened.session.edit_wall(0, thickness_m=0.2)
    application.processEvents()
    assert shows_nothing(live) and not live.switches
    settle(application, lambda: opened.runner.job is None)


def test_that_histories_decide_also_where_their_records_are_still_to_be_chosen(live, opened, application, tmp_path):
    settle(application, lambda: live.result is not None)
    case = opened.session.case
    opened.session.edit(replace(case, record=(), select=Select(folder=str(tmp_path))))
    settle(application, lambda: "F5" in live.head.words)
    first = live.ladder.rungs[0]
    assert first.decides and first.zeta is None and first.tone == "amber"


def test_that_a_spectrum_another_program_wrote_is_another_input(live, opened, application, tmp_path):
    path = tmp_path / "s.csv"
    path.write_text("\n".join(f"{0.05 * k:.2f},{0.3 if k < 10 else 3.0 / (k + 1):.4f}" for k in range(81)))
    demand = replace(opened.session.case.demand, spectrum=None, spectrum_file=str(path), soil_factor=1.2)
    opened.session.edit(replace(opened.session.case, demand=demand))
    settle(application, lambda: live.at is not None)
    before = live.at
    path.write_text(path.read_text().replace("0.3000", "0.6000"))
    opened.refresh()
    assert live.at != before


def test_that_what_is_missing_is_asked_for_first_and_what_is_refused_said(live, opened, application):
    field = opened.walls.fields["height_m"]
    settle(application, lambda: live.result is not None)
    type_into(field, "high")
    settle(application, lambda: live.at is None or live.at[0] is None)
    settle(application, lambda: opened.missing.problems)  # when the hand rests
    assert live.ladder.isHidden() and "missing" in live.head.words
    assert not live.at_once.isActive() and not live.rested.isActive()


def test_that_a_window_built_again_has_it_as_it_was(live, opened, application):
    opened.set_choice("theme", "dark")
    again = opened.stages.input.live
    assert again is not live and again.head.isChecked() and live.at is None
    settle(application, lambda: again.result is not None)
    assert opened.settings.value("live", None, bool) is True
    again.head.setChecked(False)
