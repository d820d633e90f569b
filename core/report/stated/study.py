"""Quantities of a study: what the results JSON holds, in its order."""

from typing import Any, NamedTuple

from core.case.case_files import as_dict
from core.report.case_text import text_of
from core.report.stated.quantity import Quantity, list_quantity, object_quantity, text, untyped_quantity
from core.report.stated.records import DEMAND, RECORD, SELECTION
from core.report.stated.verdicts import PAIR, VERDICT, VariantSummary, VerdictSource
from core.report.stated.walls import WALL, WallResultSource
from core.study.results import StudyResult
from core.study.variants import compare_results, compare_walls
from core.version import NAME, VERSION, commit

OF_STUDY = (
    object_quantity(
        "program",
        "what made the results",
        (
            text("name", "name", lambda _: NAME),
            text("version", "version", lambda _: VERSION),
            text("commit", "commit of its sources", lambda _: commit()),
        ),
        lambda result: result,
    ),
    text("started_utc", "beginning of the run"),
    untyped_quantity(
        "case", "the case with its defaults, by the keys of the page of the case", lambda result: result.case.as_dict()
    ),
    text("case_toml", "the text of its file, to be run again", text_of),
    text("case_sha256", "SHA-256 of the file of the case", "case.sha256"),
    list_quantity(
        "files",
        "the files it names beside its records",
        (
            text("role", "the key that names it"),
            text("file", "as the case names it"),
            text("sha256", "SHA-256 of its bytes"),
            Quantity("notices", "frees", "what was said when it was read", lambda file: as_dict(file)["notices"]),
            Quantity(
                "rows", "rows", "the cells of a table of walls; null of a file that is not held", lambda file: file.rows
            ),
        ),
        lambda result: result.case.files,
    ),
    Quantity(
        "drawings",
        "frees",
        "drawings that solids come from",
        lambda result: [dict(note.values) for note in result.case.drawings] or None,
    ).optional(),
    object_quantity("demand", "what is asked of the walls", DEMAND, lambda result: result if result.demand else None),
    list_quantity("records", "the records", RECORD, lambda result: zip(result.motions, result.kinds, strict=True)),
    object_quantity(
        "selection", "how they were chosen from a folder", SELECTION, lambda result: result.selection or None
    ).optional(),
)
"""Quantities read from StudyResult: what stands before the verdicts."""

VERDICTS = (
    list_quantity(
        "verdicts",
        "one a wall of the case, none without a demand",
        VERDICT,
        lambda result: [VerdictSource(verdict, result) for verdict in result.verdicts],
    ),
)
WALLS = (
    list_quantity(
        "walls",
        "one a wall, hinge and mechanism",
        WALL,
        lambda result: [WallResultSource(wall, result) for wall in result.walls],
    ),
)


class Pair(NamedTuple):
    """A wall as it is and as it is designed."""

    name: str
    changed: tuple[str, ...]
    before: VariantSummary
    after: VariantSummary


def _pairs(result: StudyResult) -> list[Pair] | None:
    """By the hinge that decides, without a demand by q of each hinge and mechanism; None where there are none."""
    pairs: list[Any]
    if result.verdicts:
        pairs = list(compare_walls(result.verdicts))
        sides = [
            [VariantSummary.of(VerdictSource(side, result)) for side in (pair.before, pair.after)] for pair in pairs
        ]
    else:
        pairs = list(compare_results(result.walls))
        sides = [[VariantSummary(q_set=side.q_set) for side in (pair.before, pair.after)] for pair in pairs]
    return [Pair(one.name, one.changed, *both) for one, both in zip(pairs, sides, strict=True)] or None


PAIRS = (list_quantity("variants", "walls as they are beside as they are designed", PAIR, _pairs).optional(),)

RESULTS = (*OF_STUDY, *VERDICTS, *WALLS, *PAIRS)
"""Quantities read from StudyResult: the whole file."""
