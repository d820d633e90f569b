"""What the model tells of tests on a shake table, in words and as a chapter of the solved cases."""

from collections.abc import Iterator, Sequence

from core.lab.research.shake_table import AGREE, Found, Score
from core.lab.solved.solved import worded
from core.report.note.parts import Heading, Paragraph, Part, Table
from core.text.sentence import Sentence, format_number

METHODS: dict[str, Sentence] = {
    "measured": worded("body as measured"),
    "slenderness": worded("slenderness fitted"),
    "setback": worded("setback of the hinges fitted"),
    "restitution": worded("restitution fitted"),
    "pgv": worded("threshold of PGV fitted"),
    "distinct_elements": worded("distinct elements, stiffness chosen"),
}
"""Method of a score -> its words."""

OF_FIRST_BODY = worded("setback of the first body")


def _scores(one: Found) -> Iterator[tuple[Sentence, Score]]:
    yield from ((METHODS[score.method], score) for score in one.scores)
    if one.tried:
        yield OF_FIRST_BODY, one.tried


def _title(one: Found) -> Sentence:
    return worded("body {name}: {n} tests", name=one.body.name, n=one.tests)


def _remarks(one: Found) -> list[Sentence]:
    share, low, high = (100.0 * value for value in one.setback)
    tests, overturned = one.below_rule
    values = {"share": share, "low": low, "high": high}
    return [
        worded("setback by all its tests: {share:.1f} % of the width ({low:.1f} to {high:.1f})", **values),
        worded(
            "computed peak 0.1 to 0.4 of the collapse rotation: {n} tests, {overturned} overturned",
            n=tests,
            overturned=overturned,
        ),
    ]


def _left_out(count: int) -> list[Sentence]:
    if not count:
        return []
    values = {"n": count, "share": 100.0 * AGREE}
    return [worded("left out: {n} tests whose measured PGA is not within {share:.0f} % of the stated one", **values)]


def _said(name: Sentence, one: Score) -> Sentence:
    values = {
        "fitted": tuple(map(str, one.fitted)),
        "name": name,
        "right": 100.0 * one.right,
        "low": 100.0 * one.interval[0],
        "high": 100.0 * one.interval[1],
        "missed": 100.0 * one.missed,
        "false": 100.0 * one.false,
    }
    if not one.fitted:
        return worded(
            "{name}: right {right:.1f} % ({low:.1f} to {high:.1f}), missed {missed:.0f} %, false {false:.0f} %",
            **values,
        )
    return worded(
        "{name}: right {right:.1f} % ({low:.1f} to {high:.1f}), missed {missed:.0f} %, false {false:.0f} %; "
        "fitted {fitted}",
        **values,
    )


def lines(results: Sequence[Found], left_out: int, language: str) -> list[str]:
    """What was found, in words. left_out : tests of no use"""
    text = []
    for result in results:
        text.append(_title(result).text(language))
        under = [*(_said(name, score) for name, score in _scores(result)), *_remarks(result)]
        text += [f"  {sentence.text(language)}" for sentence in under]
    return text + [sentence.text(language) for sentence in _left_out(left_out)]


def chapter(results: Sequence[Found], left_out: int, language: str) -> list[Part]:
    """Write what was found as tables of a document."""
    about = worded(
        "Whether each tested body overturns, computed with the model of every wall, beside what it did. What is "
        "fitted is fitted on one half of the events and scored on the other; each interval is of nine of ten draws "
        "of the events. Missed: of the tests that overturned, those computed standing, the unsafe side; false: of "
        "those that stood, computed overturned. What is found is the result: there is no value that it must reach."
    )
    parts: list[Part] = [
        Heading(worded("Tests on a shake table").text(language), new_page=True),
        Paragraph(about.text(language)),
    ]
    heads = [
        head.text(language)
        for head in (
            worded("Method"),
            worded("Fitted"),
            worded("Right [%]"),
            worded("Nine of ten [%]"),
            worded("Missed [%]"),
            worded("False [%]"),
        )
    ]
    for result in results:
        rows = [
            (
                name.text(language),
                ", ".join(map(str, score.fitted)) or "–",
                format_number(100.0 * score.right, ".1f", language),
                " – ".join(format_number(100.0 * end, ".1f", language) for end in score.interval),
                f"{100.0 * score.missed:.0f}",
                f"{100.0 * score.false:.0f}",
            )
            for name, score in _scores(result)
        ]
        parts += [Heading(_title(result).text(language), 3), Table(heads, rows, (4.0, 2.6, 1.3, 2.2, 1.4, 1.3))]
        parts += [Paragraph(remark.text(language)) for remark in _remarks(result)]
    return parts + [Paragraph(remark.text(language), "quiet") for remark in _left_out(left_out)]
