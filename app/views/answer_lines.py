"""Lines of the answer that say what is to be done and what limits the verdict, each with where it leads."""

import html

from app.look import theme
from app.look.language import tr
from core.case.asked import ASKED, HOLD
from core.known import require_value
from core.report.verdict_words import lines_of, names_in, tone_of
from core.study.results import StudyResult, WallResult
from core.text.sentence import Sentence, sentence, word


def verdict_color(result: StudyResult, wall: WallResult) -> str:
    """Green only where nothing is left to read."""
    return getattr(theme.current, tone_of(result, wall))


PLACE_OF_CODE = {
    **dict.fromkeys(("measure_tie", "measure_ties", "measure_hold", "measure_thrust"), "variant"),
    **dict.fromkeys(("measure_height", "measure_thickness", "no_measure"), "variant"),
    "to_no_check": "demand",
    "to_no_restraint": "holds",
    "to_no_top_restraint": "holds",
    "to_end": "holds",
    "to_no_spectrum": "demand",
    "to_no_soil_factor": "key:soil_factor",
    "to_not_compatible": "records",
    "to_few_records": "records",
    "to_bundled": "records",
    "to_one_sign": "key:polarity",
    "to_building": "building",
    "lift_edge": "key:hinge_setback_m",
    "to_evidence": "holds",
    "to_evidence_strength": "holds",
    "other_building": "building",
    "heights_left_out": "key:hinge_heights",
    "hinges_as_asked": "key:hinge_heights",
    "to_set_aside": "key:hinge_heights",
    "to_set_aside_stretch": "set_aside",
}
"""Code of what is to be done, or of what limits the verdict -> where that leads, see `CheckTab.asked`."""


def link(target: str, words: str) -> str:
    """A link of the answer, in HTML."""
    return f"<a href='{target}' style='color:{theme.current.curves[0]}; text-decoration:none'>{words} →</a>"


def _target(one: Sentence) -> str | None:
    """Where a sentence leads."""
    if one.code == "give_reason":
        return f"reason:{dict(one.values)['key']}"
    if one.code in PLACE_OF_CODE or one.code not in ASKED:
        return PLACE_OF_CODE.get(one.code)
    row = ASKED[one.code]
    return "holds" if row.section == HOLD else f"reason:{row.keys[0]}"


def say_in_window(action: Sentence) -> Sentence:
    """What is to be done as the window says it: a document is given in the form it leads to, not in a file."""
    values = dict(action.values)
    if "evidence" in values and _target(action):
        return sentence(action.group, action.code, **values | {"evidence": sentence("added", "in_form")})
    return action


def _linked(words: list[str], sentences: tuple[Sentence, ...]) -> list[str]:
    """Sentences as HTML; more words than sentences lead nowhere."""
    lines = [html.escape(line, quote=False) for line in words]
    for k, action in enumerate(sentences):
        if target := _target(action):
            lines[k] = link(target, lines[k])
    return lines


def _words(result: StudyResult, wall: WallResult, language: str, kind: str) -> list[str]:
    before = len(f"{word(kind, language)}: ")
    return [line[before:] for line in lines_of(result, wall, language, (kind,))]


def _head_first(lines: list[str], kind: str, language: str) -> list[str]:
    """Lines, the first after the word of their kind."""
    return [f"<b>{word(kind, language)}:</b> {lines[0]}", *lines[1:]] if lines else []


def required_actions(result: StudyResult, wall: WallResult, language: str, alone: bool = False) -> list[str]:
    """What is to be done, alone without the word of that."""
    to_do = require_value(wall.assessment).verdict.to_do
    lines = _linked([say_in_window(action).text(language, names_in(language)) for action in to_do], to_do)
    return lines if alone else _head_first(lines, "to_do", language)


def blocking_lines(wall: WallResult, lines: list[str]) -> list[str]:
    """Select those of the lines of `verdict_limitations` that make a verdict indicative and lead where nothing that is
    to be done does."""
    verdict = require_value(wall.assessment).verdict
    led = {_target(action) for action in verdict.to_do}
    blocking = zip(verdict.limits[: verdict.blocking], lines, strict=False)
    return [line for action, line in blocking if (_target(action) or not led) and _target(action) not in led]


def verdict_limitations(
    result: StudyResult, wall: WallResult, language: str, warnings: list[str], alone: bool = False
) -> list[str]:
    """What limits the result, what makes it indicative first; nothing twice. warnings : of demand and wall; alone :
    without the word of that"""
    words = _words(result, wall, language, "limits")
    for warning in warnings:
        if not any(warning.rstrip(".") in line for line in words):
            words.append(warning)
    extra = next((verdict.extra for verdict in result.verdicts if result.walls[verdict.governing] is wall), ())
    lines = _linked(words, (*require_value(wall.assessment).verdict.limits, *extra))
    return lines if alone else _head_first(lines, "limits", language)


def no_dynamic_check(result: StudyResult, wall: WallResult) -> tuple[str, str]:
    """(why a wall with a demand has no dynamic check, what leads to one)."""
    if wall.wall.above_ground and result.case.building is None:
        return tr("No dynamic check: the motion of the floor follows from the building."), "building"
    if wall.wall.in_si.arch is not None:
        return tr("No dynamic check: none is made of a wall between transverse walls."), ""
    if not result.motions:
        return tr("No dynamic check: it needs records and a demand at SLV or SLC."), "generate"
    return tr("No dynamic check: at SLD none is made, but at SLV or SLC."), "demand"
