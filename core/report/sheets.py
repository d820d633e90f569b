"""Input, Records, Results and Method sheets."""

import math
import platform

from openpyxl.utils import get_column_letter

from core.capacity.accuracy import HELD_TRIED, NOISE, PROMISED, TIMES_NOISE, Accuracy
from core.report.cells import (
    ACCELERATION,
    BAD,
    INK,
    QUIET,
    RATIO,
    WHOLE,
    Book,
    fill,
    header,
    heighten,
    number,
    paragraph,
    rule,
    text,
    title,
)
from core.report.confirmed import unconfirmed_holds
from core.report.record_tables import origin_of_records, records_as_read, rows_of_records
from core.report.selection_rows import selection_rows
from core.report.sheet_table import column_widths, write_table
from core.report.stated.quantity import serialize
from core.report.stated.walls import RUN, RunSource
from core.study.results import StudyResult
from core.text.sentence import localized, word
from core.version import NAME, VERSION, commit
from core.wall.restitution import MODELS

METHOD = (
    "motion",
    "equations",
    "misprints",
    "q",
    "set",
    "outcomes",
    "range",
    "circolare",
    "loads",
    "held_top",
    "held_ends",
    "left_out",
)
"""Paragraphs of the sheet Method, in their order; held_top where a wall is."""


def rule_word(book: Book, rule_name: str | None) -> str:
    return {
        None: "–",
        "mean": book.say("mean"),
        "minimum": book.say("minimum"),
        "too_few": book.say("minimum, too few"),
        "incomplete": book.say("incomplete"),
    }[rule_name]


def status_word(book: Book, status: str) -> str:
    return {
        "collapse_found": book.say("collapse found"),
        "no_collapse_found": book.say("no collapse found"),
        "impact_limit": book.say("impact limit"),
    }[status]


def records(book: Book, result: StudyResult) -> None:
    """The ground motions as read, with their intensity measures and hashes; event and station, blank for the engineer
    where the files leave them open."""
    table, rows = records_as_read(book), rows_of_records(result)
    widths = column_widths(table)
    sheet = book.sheet("Records", widths, landscape=True)
    title(sheet, 1, book.say("Ground motions"))
    row = write_table(book, sheet, 3, table, rows, 32)
    row = paragraph(
        sheet,
        row + 2,
        book.say(
            "SI: integral of the 5 % pseudo-velocity from 0.1 to 2.5 s (Eq. 11), not divided by 2.4. "
            "PGV and PGD without baseline step: no meaning for uncorrected records. Nothing trimmed or "
            "resampled. SHA-256: first 16 digits of the file's hash; the whole one is in the JSON."
        ),
        len(widths),
        150,
        color=QUIET,
    )
    for motion in result.motions:
        for warning in motion.warnings:
            line = f"• {motion.name}: {warning.text(book.language)}"
            row = paragraph(sheet, row, line, len(widths), 150)
    row = write_table(book, sheet, row + 1, origin_of_records(book), rows, 46)
    if result.selection:
        selection_rows(book, sheet, result.selection, row + 2)
    sheet.freeze_panes = "A4"
    sheet.print_title_rows = "3:3"


def results(book: Book, result: StudyResult) -> None:
    """Write one row for each wall, record and sign."""
    say = book.say
    columns = [
        ("q", 8, "q", RATIO),
        (say("bracket low"), 8, "bracket", "0.0000"),
        (say("bracket high"), 8, "bracket", "0.0000"),
        ("q SLV", 8, "q_slv", RATIO),
        (say("q SLV robust"), 8, "q_slv_robust", RATIO),
        ("q SLC", 8, "q_slc", RATIO),
        (say("q robust"), 8, "q_robust", RATIO),
        (say("Scale C"), 8, "collapse_scale", ACCELERATION),
        ("q_eff", 8, "q_eff", RATIO),
        (say("last survival"), 9, "q_last_survival", RATIO),
        (say("survived share"), 9, "survived_fraction", RATIO),
        (say("windows"), 9, "survival_windows", WHOLE),
        (say("analyses"), 9, "analyses", WHOLE),
        (say("unknown points"), 9, "impact_limited", WHOLE),
        (say("Eq. 7 clamped"), 9, "clamped", WHOLE),
    ]
    widths = [20, 11, 24, 7, 16, *(width for _, width, _, _ in columns)]
    sheet = book.sheet("Results", widths, landscape=True)
    step = 100 * result.search.q_step
    title(
        sheet,
        1,
        say(
            "Incremental dynamic analysis: grid step {step:g} %, method {method_words}",
            step=step,
            method_words=result.method_words,
        ),
    )
    before = [say("Wall"), say("Mechanism"), say("Record"), say("Sign"), say("Status")]
    header(sheet, 3, [*before, *(heading for heading, _, _, _ in columns)], 1, 44)
    row = 3
    for wall in book.steps.each(result.walls):
        for run in wall.runs:
            row += 1
            values = serialize(RUN, RunSource(run, wall, result))
            text(sheet, row, 1, book.titled(wall.name), wrap=True)
            text(sheet, row, 2, word(wall.mechanism, book.language))
            text(sheet, row, 3, run.record, wrap=True)
            heighten(sheet, row, (book.titled(wall.name), 20), (run.record, 24))
            text(sheet, row, 4, "+" if run.polarity > 0 else "−", align="center")
            text(sheet, row, 5, status_word(book, values["status"]), color=INK if run.ida.q else BAD)
            low, high = values["bracket"] or (None, None)
            values |= {"survival_windows": len(values["survival_windows"])}
            for column, (heading, _, key, shape) in enumerate(columns, start=6):
                value = {7: low, 8: high}.get(column, values[key])
                number(sheet, row, column, value, shape, bold=heading == "q" and value is not None)
            rule(sheet, row, 1, len(widths))
    if row > 3:
        sheet.auto_filter.ref = f"A3:{get_column_letter(len(widths))}{row}"
    sheet.freeze_panes = "D4"
    sheet.print_title_rows = "3:3"
    paragraph(
        sheet,
        row + 2,
        say(
            "q, q SLV, q SLC: first collapse, first peak at 0.40 and 0.60 θc on the grid, bisected "
            "to 1e-4. q robust, q SLV robust: around them 16 % of the points collapse, or reach 0.40 θc. "
            "Survival, share and windows are of the map and depend on the grid step ({step:g} %).",
            step=step,
        ),
        len(widths),
        170,
        color=QUIET,
    )


def method(book: Book, result: StudyResult) -> None:
    """Equations, versions, hashes, range of use, misprints, what is left out."""
    say = book.say
    sheet = book.sheet("Method", [30, 75])
    title(sheet, 1, say("Method, range of use, provenance"))
    row = 3
    settings = result.search
    facts = [
        (say("Program"), f"{NAME} {VERSION} {commit()[:12]}"),
        ("Python", f"{platform.python_version()}, {platform.system()} {platform.machine()}"),
        (say("Case SHA-256"), result.case.sha256),
        (say("Method"), result.method_words),
        (
            say("Search"),
            ", ".join(
                f"{word(f'key_{key}', book.language)} {book.digits(getattr(settings, key), 'g')}"
                for key in ("q_step", "q_limit", "map_span", "robust_window")
            ),
        ),
        (
            say("Sign of the records"),
            {"both": word("both", book.language), "as_recorded": say("as recorded"), "reversed": say("reversed")}[
                result.case.analysis.polarity
            ],
        ),
    ]
    for wall in result.walls:
        if wall.wall.bends:
            continue
        ratio = MODELS[wall.restitution.model].source
        label = f"{book.titled(wall.name)}, {word(wall.mechanism, book.language)}"
        law = say("rigid")
        if not wall.law.is_rigid:
            ends = f"D1 {wall.law.elastic_limit:g}, D2 {wall.law.plateau_end:g}"
            law = f"{say('trilinear')} {ends}"
        facts.append((label, f"{ratio}, e = {book.digits(wall.restitution.ratio_at_rest, '.4f')}; {law}"))
    if len(facts) > 46:
        facts = facts[:46] + [("…", say("see Input and the JSON"))]
    for label, value in facts:
        text(sheet, row, 1, label, bold=True, wrap=True)
        text(sheet, row, 2, value, wrap=True)
        longest = max(len(label) / 30, len(value) / 78)
        sheet.row_dimensions[row].height = 14 * math.ceil(longest)
        rule(sheet, row, 1, 2)
        row += 1
    row = _uncertainty(book, sheet, result, row + 1)
    without = unconfirmed_holds(wall.wall for wall in result.walls)
    for code in (one for one in METHOD if one not in without):
        label = localized("method_label", code, book.language)
        body = localized("method_body", code, book.language)
        text(sheet, row, 1, label, bold=True, wrap=True)
        text(sheet, row, 2, body, wrap=True)
        lines = max(math.ceil(len(body) / 80), math.ceil(len(label) / 28))
        sheet.row_dimensions[row].height = 13.8 * lines + 4
        fill(sheet.cell(row, 1), "F2F5F8")
        rule(sheet, row, 1, 2)
        row += 1


def _compared(book: Book, accuracy: Accuracy) -> str:
    """How far another solver is from the one used, in a sentence."""
    if not accuracy.points:
        return book.say("No other solver follows this wall.")
    return book.say(
        "q by dormand_prince: {_digits} against {q:.4f}, difference {_percent}; history against "
        "DOP853 of scipy at the last survived scale: {_power} of θc.",
        _digits=_digits(book, accuracy.q_reference),
        q=accuracy.q,
        _percent=_percent(book, accuracy.solver_q_difference),
        _power=_power(book, accuracy.history_difference),
    )


def _bound(book: Book, accuracy: Accuracy) -> str:
    """Sentence on the bound of the error of the governing history; "" for a method that has none."""
    if accuracy.history_bound is not None:
        bound = {"_bound": _power(book, accuracy.history_bound), "least": PROMISED, "times": TIMES_NOISE}
        said = book.say(
            "Its error is within {_bound} of θc, the larger of {least:g} and {times:g} times what noise of {noise:g} "
            "on the samples does to it",
            noise=NOISE,
            **bound,
        )
        if accuracy.held:
            tried = book.say(": so in {n:g} random histories; landings that are tangent were not tried.", n=HELD_TRIED)
        else:
            tried = book.say(
                ": so in 30 000 random histories. Where a landing is tangent to the last digit one in a thousand "
                "exceeds it."
            )
        return f" {said}{tried}"
    if math.isfinite(accuracy.noise_effect):
        return ""
    return " " + book.say("Noise of {noise:g} on the samples decides whether the wall stands.", noise=NOISE)


def _uncertainty(book: Book, sheet, result: StudyResult, row: int) -> int:
    """How sure each q is, where the case asks for it: solver and definition as two statements."""
    say = book.say
    for wall in result.walls:
        accuracy = wall.accuracy
        if accuracy is None:
            continue
        title(
            sheet,
            row,
            f"{say('How sure')}: {book.titled(wall.name)}, {word(wall.mechanism, book.language)}, {accuracy.record}",
            11,
        )
        rows = [
            (say("Solver"), _compared(book, accuracy) + _bound(book, accuracy)),
            (
                say("Spread by definition"),
                say("q (q robust, q SLV robust) by step of the search: ")
                + "; ".join(
                    f"{book.digits(100 * s, 'g')} %: {_digits(book, q)} ({_digits(book, r)}, {_digits(book, slv)})"
                    for s, q, r, slv in accuracy.steps
                )
                + ". "
                + say("Samples rounded to five figures: q spreads ")
                + f"{_percent(book, accuracy.spread(0, accuracy.rounded))}, q robust "
                f"{_percent(book, accuracy.spread(1, accuracy.rounded))}, q SLV robust "
                f"{_percent(book, accuracy.spread(2, accuracy.rounded))}."
                + (
                    say(" Sign: ") + " / ".join(_digits(book, q) for q in accuracy.polarities)
                    if accuracy.polarities
                    else ""
                ),
            ),
        ]
        if accuracy.points:
            methods = "; ".join(f"{point.name}: {_power(book, point.error)}" for point in accuracy.points)
            rows.append((say("Methods on this history"), methods))
        for label, body in rows:
            row += 1
            text(sheet, row, 1, label, bold=True, wrap=True)
            text(sheet, row, 2, body, wrap=True)
            sheet.row_dimensions[row].height = 13.8 * math.ceil(len(body) / 80) + 4
            rule(sheet, row, 1, 2)
        row += 2
    return row


def _digits(book: Book, value: float | None) -> str:
    return book.digits(value, ".2f")


def _percent(book: Book, value: float | None) -> str:
    return "–" if value is None else book.digits(100 * value, ".2g") + " %"


def _power(book: Book, value: float | None) -> str:
    return word("overturned", book.language) if value is None else f"{value:.0e}"
