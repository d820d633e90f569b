"""Part of a note on its records: event, station, filter and scale of each, how motions were generated."""

from core.report.note import spectra_figure
from core.report.note.parts import Figures, Heading, Paragraph, Part, table_of_rows
from core.report.record_tables import origin_of_records, rows_of_records
from core.report.selection_words import lines_of as lines_of_selection
from core.report.tables import NOTE
from core.report.words import Words
from core.setting.demand_input import find_generation_settings
from core.study.results import StudyResult


def record_parts(result: StudyResult, words: Words, brief: bool = False) -> list[Part]:
    """Event, station, filter, and the scale each record is used with. brief : without the table of motions that are all
    generated, and without the figure of the spectra"""
    if not result.motions:
        return []
    say, rows, columns = words.say, rows_of_records(result), origin_of_records(words)
    table = table_of_rows(columns, rows, words.number)
    unsaid = columns.folded(NOTE, rows)
    all_made = brief and all(motion.format == "generated" for motion in result.motions)
    parts: list[Part] = [Heading(say("Records")), *([] if all_made else [table])]
    if unsaid and "natural" in result.kinds:
        parts.append(Paragraph(say("No file states: {columns}.", columns=", ".join(unsaid)), "quiet"))
    if result.selection:
        parts += [Paragraph(line, "quiet") for line in lines_of_selection(result.selection, say, words.language)]
    parts += _generated(result, words)
    rules = result.compliance
    if rules is not None:
        line = (
            say("The set is compatible with the spectrum (workbook, sheet Spectral compatibility).")
            if rules.compatible
            else say("The set is not compatible with the spectrum (workbook, sheet Spectral compatibility).")
        )
        parts.append(Paragraph(line))
    figure = None if brief else spectra_figure.spectra(result, words)
    return parts if figure is None else [*parts, Figures([figure])]


def _generated(result: StudyResult, words: Words) -> list[Part]:
    """How motions were generated."""
    settings = find_generation_settings(result.motions)
    if settings is None:
        return []
    seeds = {"n": settings.count, "first": settings.seed, "last": settings.seed + settings.count - 1}
    sentence = words.say(
        "{n} motions generated, seeds {first} to {last}: noise whose spectrum is brought to that of the demand "
        "times exp({scatter} ε(T)), ε correlated over the periods (Baker and Jayaram 2008), the set with one "
        "factor so that its mean fits (NTC 2018 3.2.3.6).",
        scatter=words.number(settings.scatter, ".2f"),
        **seeds,
    )
    return [Paragraph(sentence)]
