"""Part of a note on its records: event, station, filter and scale of each, how motions were generated."""

from core.ground.ground_motion import GroundMotion
from core.ground.provenance import provenance
from core.report.note import spectra_figure
from core.report.note.parts import Figures, Heading, Paragraph, Part, Table
from core.report.note.words import Words
from core.report.selection_words import lines_of as lines_of_selection
from core.setting.demand_input import find_generation_settings
from core.study.results import StudyResult
from core.units import G


def record_parts(result: StudyResult, words: Words, brief: bool = False) -> list[Part]:
    """Event, station, filter, and the scale each record is used with. brief : without the table of motions that are all
    generated, and without the figure of the spectra"""
    if not result.motions:
        return []
    say = words.say
    heads = [
        say("Record"),
        say("Event and station"),
        say("Date"),
        "M",
        say("Distance [km]"),
        say("Filter [Hz], processing"),
        say("PGA used [g]"),
        say("Scale used"),
        say("Kind"),
    ]
    rows = [_row(result, motion, kind, words) for motion, kind in zip(result.motions, result.kinds, strict=True)]
    widths = (2.2, 2.4, 1.2, 0.6, 1.3, 1.9, 1.0, 1.0, 1.4)
    unsaid = [k for k in range(len(heads)) if all(row[k] == "–" for row in rows)]
    told = [k for k in range(len(heads)) if k not in unsaid]
    table = Table([heads[k] for k in told], [[row[k] for k in told] for row in rows], [widths[k] for k in told])
    all_made = brief and all(motion.format == "generated" for motion in result.motions)
    parts: list[Part] = [Heading(say("Records")), *([] if all_made else [table])]
    if unsaid and "natural" in result.kinds:
        parts.append(Paragraph(say("No file states: {columns}.", columns=", ".join(heads[k] for k in unsaid)), "quiet"))
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


def _row(result: StudyResult, motion: GroundMotion, kind: str, words: Words) -> list[str]:
    """Cells of a record; a dash for what its file does not state."""
    where = provenance(motion)
    at_demand = result.demand_required.scaling(motion) if result.demand else 1.0
    station = ", ".join(part for part in (where.event, where.station) if part)
    date = where.date.split()[0] if where.date else ""
    cells = station, date, where.magnitude, where.distance_km, where.filter_and_processing
    pga, scale = words.number(at_demand * motion.pga / G, ".3f"), words.number(motion.scale * at_demand, ".3f")
    return [motion.name, *(cell or "–" for cell in cells), pga, scale, words.word(kind)]


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
