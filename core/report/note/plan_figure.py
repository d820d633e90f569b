"""Figure of a building: its key plan, each wall in the colour of its outcome."""

from core.report.key_plan import Placed, centre_of, key_plan, size_of
from core.report.note.parts import Figure, Figures, Heading, Label, Part, Table, path
from core.report.words import Words
from core.study.results import StudyResult

AWAY, MARGIN = 0.05, 0.14
"""Distance of the words from their wall, and the room around the plan, of its size."""


def plan_numbers(result: StudyResult) -> dict[int, int]:
    """Number of a result that decides about its wall -> its number in the key plan; empty without one."""
    placed = key_plan(result)
    return {place.result: n for n, place in enumerate(placed, start=1)} if len(placed) > 1 else {}


def plan(result: StudyResult, words: Words, ranked: bool = True) -> list[Part]:
    """The key plan under its heading; nothing where fewer than two walls have a place. ranked : with the table of the
    walls by their numbers"""
    placed = key_plan(result)
    if len(placed) < 2:
        return []
    centre, size = centre_of(placed), size_of(placed)
    curves = [path(one.ends, one.tone or "ink", width=3.0) for one in placed]
    labels = [Label(f"{n}", *one.beside(centre, AWAY * size)) for n, one in enumerate(placed, start=1)]
    points = [point for one in placed for point in one.ends]
    (left, right), (low, high) = ((min(p[k] for p in points), max(p[k] for p in points)) for k in (0, 1))
    margin = MARGIN * size
    caption = words.say("Key plan: each wall in the colour of its outcome, numbered from the worst")
    x_range, y_range = (left - margin, right + margin), (low - margin, high + margin)
    figure = Figure(caption, curves, x_range=x_range, y_range=y_range, labels=labels)
    table = [_ranked(placed, words)] if ranked else []
    return [Heading(words.say("Key plan"), 3), Figures((figure,)), *table]


def _ranked(placed: list[Placed], words: Words) -> Table:
    """The walls by their numbers, with the mechanism that decides about each."""
    heads = ["", words.say("Wall"), words.say("Mechanism"), "ζ_E", words.say("Verdict")]
    rows = [
        [
            str(n),
            one.wall.name,
            words.word(one.wall.mechanism),
            words.number(one.zeta, ".2f"),
            words.word(one.wall.required_assessment.verdict.code),
        ]
        for n, one in enumerate(placed, start=1)
    ]
    tones = {(n, column): one.tone for n, one in enumerate(placed) for column in (3, 4)}
    return Table(heads, rows, (1, 6, 3, 2, 5), tones, [one.result for one in placed])
