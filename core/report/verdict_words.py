"""Order and tone of the verdicts, for workbook, note and window."""

import functools

from core.case.document import PRESENCE, STATED, STRENGTH, AnyEvidence
from core.codes.outcomes import FAILS, OUTCOMES
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.wall_verdict import hinge_location, sort_by_severity
from core.text.catalogue import CATALOGUE
from core.text.sentence import FormNames, Number, Sentence, sentence, word


@functools.cache
def names_in(language: str) -> FormNames:
    """Names by which the report calls the keys of a case."""
    captions = {code: CATALOGUE.of(words, language) for code, words in CATALOGUE["key"].items()}
    for code in CATALOGUE["word"]:
        kind, _, name = code.partition("_")
        if kind == "section":
            captions[f"[{name}]"] = word(code, language).lower()
    return FormNames(captions)


def sort_results(result: StudyResult) -> list[tuple[WallResult, bool]]:
    """(result, whether it is the one that decides about its wall): the worst wall first, of each its worst hinge first;
    without a demand all as they are."""
    ordered = sort_by_severity(result.verdicts, result.walls)
    if not ordered:
        return [(wall, True) for wall in result.walls]
    return [(result.walls[k], k == one.governing) for one in ordered for k in one.results]


def sentence_of(wall: WallResult, language: str) -> str:
    """The verdict of a result in words: of its wall where it decides about it, else of its hinge."""
    return wall.required_assessment.verdict.text(
        language, wall.part.asked.title, hinge_location(wall), names_in(language)
    )


def write_headline(wall: WallResult, language: str) -> str:
    """What decides about a wall in one line, beside its outcome; of one that passes with what that rests on."""
    verdict = wall.required_assessment.verdict
    values = dict(verdict.values)
    if not values.get("by"):
        return sentence_of(wall, language)
    fails = OUTCOMES[verdict.code].judgement == FAILS
    target = Number(verdict.zeta_target, ".2f")
    line = {"by": values["by"], "where": hinge_location(wall), "target": target}
    line["tail"] = sentence("added", "nothing") if fails else values.get("tail", "")
    words = sentence("added", "headline", **line).text(language, names_in(language))
    return words[:1].upper() + words[1:]


def say_in_note(action: Sentence) -> Sentence:
    """What is to be done as a note says it: the kinds of the document by their names, not by those of a file."""
    values = dict(action.values)
    evidence = values.get("evidence")
    asked_in = dict(evidence.values) if isinstance(evidence, Sentence) else {}
    names = [kind for kind in str(asked_in.get("kinds", "")).split(" | ") if kind in (*PRESENCE, *STRENGTH, *STATED)]
    if not names:
        return action
    kinds = sentence("added", "by_kinds", kinds=tuple(sentence("word", f"evidence_{kind}") for kind in names))
    return sentence(action.group, action.code, **values | {"evidence": kinds})


def outcome_of(result: StudyResult, verdict: WallVerdict) -> tuple[str, str | None]:
    """(code of the outcome of a wall, label of the check that decides)."""
    assessment = result.walls[verdict.governing].assessment
    if assessment is None:
        return "undetermined", None
    decides = next((check.label for check in assessment.checks if check.name == assessment.verdict.governing), None)
    return assessment.verdict.code, decides


LINE_KINDS = ("to_do", "limits", "note")


def lines_of(
    result: StudyResult, wall: WallResult, language: str, kinds: tuple[str, ...] = (*LINE_KINDS, "reason")
) -> list[str]:
    """Lines that follow the sentence, each kind with its word: what to do, what limits the result, notes, reasons
    given."""
    verdict = wall.required_assessment.verdict
    extra = [one.extra for one in result.verdicts if result.walls[one.governing] is wall]
    said = (verdict.to_do, (*verdict.limits, *(extra[0] if extra else ())), verdict.notes)
    lines = [
        f"{word(kind, language)}: {sentence.text(language, names_in(language))}"
        for kind, sentences in zip(LINE_KINDS, said, strict=True)
        for sentence in sentences
        if kind in kinds
    ]
    if "reason" not in kinds:
        return lines
    demand = result.case.demand
    given: tuple[AnyEvidence, ...] = (*wall.wall.evidence, *(demand.evidence if demand else ()))
    for entry in given:
        key, shown = word(f"key_{entry.of}", language), entry.words.text(language)
        lines.append(f"{word('reason_given', language)}, {key}: {shown}")
    return lines


def tone_of(result: StudyResult, wall: WallResult) -> str:
    """good, amber or bad; good only where nothing is left to read; "" without a verdict."""
    if wall.assessment is None:
        return ""
    tone = OUTCOMES[wall.required_assessment.verdict.code].tone
    return "amber" if tone == "good" and result.has_remarks(wall) else tone
