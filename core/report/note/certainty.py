"""Part of a note beside the verdict of a wall: another sample of records, moved inputs, the rates of limit states."""

from core.known import require_value
from core.report import uncertainty_text
from core.report.note.parts import Curve, Figure, Figures, Heading, Item, Part, Table, path
from core.report.words import Words
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.wall_verdict import sort_by_severity
from core.variation.swings import Sensitivity

MAX_TOLD = 24
"""Walls, the worst first, that are told of."""


def certainty_line(result: StudyResult, wall: WallResult, words: Words) -> list[str]:
    """The sentence on other samples of records, of a result that decides about its wall."""
    verdict = uncertainty_text.verdict_of(result, wall)
    line = uncertainty_text.interval_line(words.say, verdict, words.language) if verdict else ""
    return [line] if line else []


def certainty(result: StudyResult, words: Words) -> list[Part]:
    """The section of the walls whose inputs were moved, or whose site has a hazard; the worst first."""
    say, language = words.say, words.language
    parts: list[Part] = []
    for verdict in sort_by_severity(result.verdicts, result.walls)[:MAX_TOLD]:
        if not verdict.sensitivity and not verdict.rates:
            continue
        parts.append(Heading(verdict.title, 3))
        if verdict.sensitivity:
            parts += _moved(result, verdict, words)
        if verdict.rates:
            life = require_value(result.case.demand).nominal_life_years
            rows = [uncertainty_text.rate_row(say, rate, language) for rate in verdict.rates]
            parts.append(Table(uncertainty_text.rate_heads(say, life), rows, (1.1, 1.4, 0.7, 2.0, 1.0, 1.2, 1.1, 1.6)))
        parts += [Item(line, "quiet") for line in uncertainty_text.rate_lines(say, result, verdict.rates)]
    return [Heading(say("How sure"), new_page=True), *parts] if parts else []


def _moved(result: StudyResult, verdict: WallVerdict, words: Words) -> list[Part]:
    """The inputs that move zeta: figure and table; what zeta required asks of thickness, ties and a_g."""
    say, language = words.say, words.language
    parts: list[Part] = []
    sensitivity, target = require_value(verdict.sensitivity), result.demand_required.zeta_target
    rows = uncertainty_text.moved_rows(sensitivity, language)
    if rows:
        cells = []
        for row in rows:
            ends = [part for words_of, zeta, _ in row.ends for part in (words_of, words.number(zeta, ".2f"))]
            cells.append([row.name, *ends, *["–"] * (4 - len(ends))])
        tones = {
            (n, 2 + 2 * m): "bad" for n, row in enumerate(rows) for m, (_, _, sure) in enumerate(row.ends) if not sure
        }
        heads = [say("Input"), say("moved to"), "ζ_E", say("moved to"), "ζ_E"]
        parts += [
            Figures([_tornado(sensitivity, target, words)]),
            Table(heads, cells, (1.6, 3.0, 0.6, 3.0, 0.6), tones),
        ]
    parts += [Item(line, "quiet") for line in uncertainty_text.sensitivity_remarks(say, result, verdict, language)]
    if labels := uncertainty_text.reach_labels(sensitivity):
        heads = [say("For ζ {zeta}", zeta=words.number(target, ".2f")), say("now")]
        heads += uncertainty_text.check_names(result, labels, language)
        cells = [uncertainty_text.reach_row(say, one, labels, language) for one in sensitivity.reach]
        parts.append(Table(heads, cells, (1.6, 0.9, *[1.8] * len(labels))))
    return parts


def _tornado(sensitivity: Sensitivity, target: float, words: Words) -> Figure:
    """zeta from the lowest to the highest of each input, beside zeta as it is and zeta required."""
    curves, names = [], []
    base = sensitivity.base or 0.0
    for k, swing in enumerate(sensitivity.swings):
        zetas = [0.0 if end.zeta is None else end.zeta for end in swing.ends]
        curves.append(path([(k, min(base, *zetas)), (k, max(base, *zetas))], "accent", width=7.0))
        names.append(uncertainty_text.swing_name(swing, words.language))
    ends = (-0.6, len(names) - 0.4)
    curves.append(Curve(words.say("ζ_E as it is"), ends, (base, base), "ink", width=1.2))
    curves.append(Curve(words.say("ζ required"), ends, (target, target), "amber", "dash"))
    highest = max(max(curve.y) for curve in curves)
    caption = words.say("ζ_E with each input moved on its own")
    return Figure(caption, curves, " ", "ζ_E", ends, (0.0, 1.08 * highest), names=names, least_area=2.6)
