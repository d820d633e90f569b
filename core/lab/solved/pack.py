"""The solved cases as one PDF and as JSON (NTC 2018, 10.2)."""

import json
import math
from collections import Counter
from collections.abc import Sequence

from core.case.rules import parse_case
from core.case.writer import dumps
from core.lab.solved.cases import Subject, cases_of
from core.lab.solved.shipped import SHIPPED
from core.lab.solved.solved import Answer, Kind, Sketch, Solved, worded
from core.report.note.parts import (
    Beside,
    Contents,
    Curve,
    Figure,
    Heading,
    Item,
    Mathematics,
    Paragraph,
    Part,
    Table,
    path,
)
from core.report.note.pdf import Attachment, Note
from core.report.words import Words
from core.text.sentence import Sentence, format_number
from core.version import NAME, VERSION, commit, line

NAME_OF_PDF, NAME_OF_JSON = "solved.pdf", "solved.json"

MAX_ROWS_TOGETHER = 20
"""Answers of a table that is not parted between pages, fewer than these."""

KIND_TITLES: dict[Kind, Sentence] = {
    Kind.CLOSED_FORM: worded("closed form"),
    Kind.REFERENCE: worded("reference solution"),
    Kind.HAND: worded("calculation by hand"),
    Kind.PRINTED: worded("printed table or example"),
    Kind.EXPERIMENT: worded("experiment"),
}


def input_of(case: Solved) -> str:
    """Text of the case file by which a case is run again, "" where there is none."""
    if case.shipped:
        return (SHIPPED / f"{case.shipped}.toml").read_text(encoding="utf-8")
    return dumps(parse_case(dict(case.table))) if case.table else ""


def file_of(case: Solved) -> str:
    """Name of that file."""
    return f"{case.shipped or case.key}.toml"


def called(answer: Answer, language: str) -> str:
    """What an answer is."""
    return answer.words if isinstance(answer.words, str) else answer.words.text(language)


def written(answer: Answer, language: str) -> tuple[str, str, str]:
    """Expected value, found value and their difference."""
    places = answer.decimals
    first, second = (".7g", ".8g") if places is None else (f".{places}f", f".{places + 2 * (places > 0)}f")
    difference = answer.difference
    return (
        format_number(answer.expected, first, language),
        format_number(answer.found, second, language),
        format_number(difference, ".0e", language) if difference else "0",
    )


def summary(cases: Sequence[Solved]) -> Sentence:
    """How many cases agree."""
    differing = tuple(case.key for case in cases if not case.agrees)
    count = {"n": len(cases), "answers": sum(len(case.answers) for case in cases)}
    if not differing:
        return worded("All {n} cases, {answers} answers, agree with their sources.", **count)
    return worded(
        "{m} of {n} cases do not agree with their sources: {keys}.", m=len(differing), keys=differing, **count
    )


def as_json(cases: Sequence[Solved]) -> bytes:
    """The content of solved.json; null of what is no number."""
    content = {
        "program": NAME,
        "version": VERSION,
        "commit": commit(),
        "cases": [
            {
                "key": case.key,
                "kind": case.kind.value,
                "title_en": case.title.text("en"),
                "title_it": case.title.text("it"),
                "source": case.source,
                "agrees": case.agrees,
                "case_toml": input_of(case) or None,
                "answers": [
                    {
                        "name_en": called(answer, "en"),
                        "name_it": called(answer, "it"),
                        "unit": answer.unit,
                        "expected": answer.expected,
                        "found": answer.found if math.isfinite(answer.found) else None,
                        "difference": answer.difference if math.isfinite(answer.difference) else None,
                        "tolerance": answer.tolerance,
                        "agrees": answer.agrees,
                    }
                    for answer in case.answers
                ],
            }
            for case in cases
        ],
    }
    return (json.dumps(content, indent=1, allow_nan=False, ensure_ascii=False) + "\n").encode()


def pdf(chosen: Sequence[Subject], language: str, more: Sequence[Part] = ()) -> bytes:
    """The pack, with the input files of its cases within. more : chapters after the cases. Raises OutputError without
    the packages of a note."""
    cases = cases_of(chosen)
    files = {file_of(case): text for case in cases if (text := input_of(case))}
    say = _Say(language)
    data = Attachment(
        NAME_OF_JSON, as_json(cases).decode(), "application/json", "data", say(worded("answers of the program"))
    )
    inputs = [
        Attachment(name, text, "application/toml", "source", say(worded("input file of a case")))
        for name, text in files.items()
    ]
    return Note([*_parts(chosen, say), *more], language, line(), attachments=[data, *inputs]).pdf()


class _Say:
    """The words of a pack in a language."""

    def __init__(self, language: str):
        self.language = language
        self.of_note = Words(language).say

    def __call__(self, text: Sentence) -> str:
        return text.text(self.language)

    @property
    def yes(self) -> str:
        return self(worded("yes"))

    @property
    def no(self) -> str:
        return self(worded("NO"))


def _parts(chosen: Sequence[Subject], say: _Say) -> list[Part]:
    cases = cases_of(chosen)
    good = all(case.agrees for case in cases)
    counts = Counter(case.kind for case in cases)
    program = [
        (say.of_note("Title"), NAME),
        (say.of_note("Author"), say.of_note("the Ribalta authors")),
        (say.of_note("Version"), f"{VERSION} {commit()[:12]}".strip()),
        (say.of_note("Licence"), "BSD-3-Clause"),
    ]
    parts: list[Part] = [
        Heading(say(worded("{name} {version}: solved cases", name=NAME, version=VERSION)), 1),
        Paragraph(
            say(
                worded(
                    "Test cases wholly solved and commented, as NTC 2018, 10.2 asks of the documentation of a "
                    "program, with the input files by which they are run again. Each answer was known from "
                    "elsewhere before the program was asked: a closed form, a solution to forty digits, a "
                    "calculation by hand, a printed table. The program found every number of this document anew "
                    "when the document was made."
                )
            )
        ),
        Table((), program, (1, 4)),
        Paragraph(say(summary(cases)), "good" if good else "bad"),
        Table((), [(say(KIND_TITLES[kind]), str(counts[kind])) for kind in Kind if counts[kind]], (2, 3)),
        Paragraph(
            say(
                worded(
                    "Difference: found over expected, less one, or the difference itself where zero is expected. "
                    "Tolerance: what the digits of the source, or the samples of the ground, leave open."
                )
            ),
            "quiet",
        ),
        Contents(),
        Heading(say(worded("Summary")), new_page=True),
        _summary(cases, say),
    ]
    numbers = {case.key: k for k, case in enumerate(cases, start=1)}
    for subject in chosen:
        parts.append(Heading(say(subject.title), new_page=True))
        for case in subject.cases:
            parts += _case(case, numbers[case.key], say)
    return parts


def _summary(cases: Sequence[Solved], say: _Say) -> Table:
    heads = [
        say(text)
        for text in (
            worded("No."),
            worded("Case"),
            worded("Source of the answer"),
            worded("Answers"),
            worded("Difference"),
            worded("Tolerance"),
            worded("Agrees"),
        )
    ]
    rows, tones = [], {}
    for k, case in enumerate(cases):
        least = case.furthest
        rows.append(
            (
                str(k + 1),
                say(case.title),
                say(KIND_TITLES[case.kind]),
                str(len(case.answers)),
                written(least, say.language)[2],
                format_number(least.tolerance, ".0e", say.language),
                say.yes if case.agrees else say.no,
            )
        )
        tones[k, 6] = "good" if case.agrees else "bad"
    return Table(heads, rows, (0.6, 5.0, 3.0, 1.2, 1.5, 1.5, 1.3), tones)


def _case(case: Solved, number: int, say: _Say) -> list[Part]:
    about: list[Part] = [Paragraph(f"{say(KIND_TITLES[case.kind])}: {case.source}", "quiet")]
    if case.formula:
        about.append(Mathematics(case.formula))
    if case.comment:
        about.append(Paragraph(say(case.comment)))
    if case.table or case.shipped:
        about.append(Item(say(worded("Input file, within this PDF: {file}", file=file_of(case))), "quiet", "→"))
    heads = [
        say(text)
        for text in (
            worded("Answer"),
            worded("Unit"),
            worded("Expected"),
            worded("Found"),
            worded("Difference"),
            worded("Tolerance"),
            worded("Agrees"),
        )
    ]
    rows, tones = [], {}
    for k, one in enumerate(case.answers):
        expected, computed, difference = written(one, say.language)
        room = format_number(one.tolerance, ".0e", say.language) if one.tolerance else "0"
        cells = (called(one, say.language), one.unit or "–", expected, computed, difference, room)
        rows.append((*cells, say.yes if one.agrees else say.no))
        tones[k, 6] = "good" if one.agrees else "bad"
    return [
        Heading(f"{number}. {say(case.title)}", 3),
        Beside(about, _figure(case.drawing, say(case.title))),
        Table(heads, rows, (4.2, 1.0, 1.9, 2.1, 1.5, 1.5, 1.2), tones, together=len(rows) < MAX_ROWS_TOGETHER),
    ]


def _figure(sketch: Sketch, title: str) -> Figure | None:
    """The section with its hinge, its loads and the ground beneath, to scale; None of a case without a sketch."""
    corners = [point for outline in (sketch.outline, *sketch.others) for point in outline] or [(0.0, 0.0), (4.0, 0.0)]
    left, right = min(x for x, _ in corners), max(x for x, _ in corners)
    size = max(max(z for _, z in corners), 0.5 * (right - left))
    curves: list[Curve] = []
    if sketch.outline:
        curves += [path([*outline, outline[0]], "accent", width=1.0) for outline in sketch.others]
        curves.append(path([*sketch.outline, sketch.outline[0]], "accent", width=1.6))
        curves.append(path([(left - 0.3 * size, 0.0), (right + 0.3 * size, 0.0)], "quiet", width=1.0))
        if right - left < 0.6 * size:  # seen along the wall
            curves.append(Curve("", (0.0,), (0.0,), "bad", "points"))
    for x, z, across, up in sketch.loads:
        tail, head = (x - 0.2 * size * across, z - 0.2 * size * up), 0.04 * size
        back = (x - head * across, z - head * up)
        barbs = [(back[0] + side * head * up, back[1] + side * head * across) for side in (-0.7, 0.7)]
        curves.append(path([tail, (x, z), barbs[0], (x, z), barbs[1]], "amber"))
    if sketch.motion:
        strongest = max(map(abs, sketch.motion))
        wide = 1.2 * size if sketch.outline else right - left
        start, level = 0.5 * (left + right - wide), -0.22 * size
        step = wide / (len(sketch.motion) - 1)
        samples = enumerate(sketch.motion)
        curves.append(
            path([(start + k * step, level + 0.15 * size * a / strongest) for k, a in samples], "ink", width=0.7)
        )
    if not curves:
        return None
    xs, zs = ([value for curve in curves for value in getattr(curve, axis)] for axis in ("x", "y"))
    margin = 0.05 * size
    return Figure(
        title, curves, x_range=(min(xs) - margin, max(xs) + margin), y_range=(min(zs) - margin, max(zs) + margin)
    )
