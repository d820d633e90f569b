"""The tables of the records: as read, where they come from, what the rules of the codes say of them, sets chosen."""

from collections.abc import Iterable
from operator import attrgetter
from typing import NamedTuple

from core.codes.record_compatibility import CompatibilityRule
from core.file_names import shown
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import provenance
from core.report.tables import SHEET, WINDOW, DataColumn, DataTable, Speaker
from core.setting.record_selection import ChosenSet, Selection
from core.study.results import StudyResult
from core.text.catalogue import CATALOGUE
from core.text.sentence import format_number, word
from core.units import CM, G


class RecordRow(NamedTuple):
    """A record. kind : natural, artificial or simulated; factor : of the demand, 1.0 without one"""

    motion: GroundMotion
    kind: str
    factor: float = 1.0


def rows_of_records(result: StudyResult) -> list[RecordRow]:
    """The records of a study."""
    scaling = result.demand_required.scaling if result.demand else lambda motion: 1.0
    return [RecordRow(motion, kind, scaling(motion)) for motion, kind in zip(result.motions, result.kinds, strict=True)]


def records_as_read(speaker: Speaker) -> DataTable:
    """Intensity measures and format; rows : RecordRow."""
    say, window, apart = speaker.say, (WINDOW,), (SHEET,)
    return DataTable(
        (
            DataColumn(say("Record"), lambda row: row.motion.name, width=24),
            DataColumn("File", lambda row: shown(row.motion.file), width=34, only=apart),
            DataColumn("PGA [g]", lambda row: row.motion.pga / G, ".3f", 9),
            DataColumn("SI [cm]", lambda row: row.motion.housner_intensity / CM, ".1f", 9),
            DataColumn(say("Scale"), _scale, only=window),
            DataColumn(say("Kind"), lambda row: word(row.kind, speaker.language), only=window),
            DataColumn(say("Unit"), lambda row: row.motion.unit, width=8),
            DataColumn("Δt [s]", lambda row: row.motion.time_step, "g", 9),
            DataColumn("PGV [cm/s]", lambda row: row.motion.pgv / CM, ".1f", 9),
            DataColumn(say("D5-95 [s]"), lambda row: row.motion.duration_5_95, ".1f", 9),
            DataColumn(say("Format"), lambda row: row.motion.format, width=12),
            DataColumn("PGD [cm]", lambda row: row.motion.pgd / CM, ".2f", 9, only=apart),
            DataColumn("Arias [m/s]", lambda row: row.motion.arias, ".3f", 9, only=apart),
            DataColumn(say("Samples"), lambda row: row.motion.acceleration.size, ".0f", 9, only=apart),
            DataColumn("SHA-256", lambda row: row.motion.file_sha256[:16], width=17.5, only=apart),
        )
    )


def _scale(row: RecordRow) -> str:
    return format(row.motion.scale, "g")


def origin_of_records(speaker: Speaker) -> DataTable:
    """Event, station, filter and the factor each is used with; rows : RecordRow."""
    say = speaker.say

    def station(row: RecordRow) -> str:
        origin = provenance(row.motion)
        return ", ".join(filter(None, (origin.event, origin.station)))

    return DataTable(
        (
            DataColumn(say("Record"), lambda row: row.motion.name, width=22),
            DataColumn(say("Event and station"), station, width=24),
            DataColumn(say("Date"), lambda row: provenance(row.motion).date.partition(" ")[0], width=12),
            DataColumn("M", lambda row: provenance(row.motion).magnitude, width=6),
            DataColumn(say("Distance [km]"), lambda row: provenance(row.motion).distance_km, width=13),
            DataColumn(say("Soil"), lambda row: provenance(row.motion).site_class, only=(SHEET,)),
            DataColumn(
                say("Filter [Hz], processing"), lambda row: provenance(row.motion).filter_and_processing, width=19
            ),
            DataColumn(say("PGA used [g]"), lambda row: row.factor * row.motion.pga / G, ".3f", 10),
            DataColumn(say("Scale used"), lambda row: row.motion.scale * row.factor, ".3f", 10),
            DataColumn(say("Kind"), lambda row: word(row.kind, speaker.language), width=14),
        ),
        folds=True,
    )


def rules_of_codes(speaker: Speaker) -> DataTable:
    """What the code asks of the set; rows : CompatibilityRule."""
    say, language = speaker.say, speaker.language

    def form(row: CompatibilityRule) -> str:
        return {"%": ".1%", "g": ".3f", "s": ".1f", "": ".0f"}[row.unit]

    def clause(row: CompatibilityRule) -> str:
        """A clause, or a range of periods where a value is only shown."""
        return row.clause.replace(".", ",") if row.code == "shown" and CATALOGUE.comma(language) else row.clause

    def outcome(row: CompatibilityRule) -> str:
        return word("shown" if row.passed is None else "passed" if row.passed else "not_passed", language)

    def tone(row: CompatibilityRule) -> str:
        return "quiet" if row.passed is None else "good" if row.passed else "bad"

    return DataTable(
        (
            DataColumn(say("Rule"), lambda row: word(row.name, language), width=40),
            DataColumn(say("Clause"), clause, width=30, tone=lambda row: "quiet"),
            DataColumn(say("Value"), attrgetter("value"), form, 13),
            DataColumn(say("Limit"), attrgetter("limit"), form, 13),
            DataColumn(say("Unit"), attrgetter("unit"), width=8, tone=lambda row: "quiet"),
            DataColumn(say("Outcome"), outcome, width=15, tone=tone),
        )
    )


def sets_of_selection(speaker: Speaker) -> DataTable:
    """Sets that [select] found, the first is taken; rows : (number, ChosenSet)."""
    say, kept = speaker.say, (speaker.say("kept"), speaker.say("not kept"))

    def records(row: tuple[int, ChosenSet]) -> str:
        return "; ".join(
            f"{shown(record.file).rpartition('/')[2]} {record.channel}".strip()
            + f" × {format_number(record.scale, 'g', speaker.language)}"
            for record in row[1].records
        )

    return DataTable(
        (
            DataColumn(say("Set"), lambda row: row[0], ".0f"),
            DataColumn(say("Records and factors"), records, width=40),
            DataColumn(
                say("Rule"),
                lambda row: kept[0] if row[1].fits else kept[1],
                tone=lambda row: "good" if row[1].fits else "bad",
            ),
            DataColumn(say("deviation"), lambda row: row[1].deviation, ".1%"),
            DataColumn("min", lambda row: row[1].lowest[1], ".2f"),
            DataColumn("T [s]", lambda row: row[1].lowest[0], ".2f"),
            DataColumn("max", lambda row: row[1].highest[1], ".2f"),
            DataColumn("T [s]", lambda row: row[1].highest[0], ".2f"),
            DataColumn("PGA", lambda row: row[1].pga_ratio, ".2f"),
        )
    )


def numbered_sets(selection: Selection | None) -> Iterable[tuple[int, ChosenSet]]:
    """Rows of `sets_of_selection`."""
    return enumerate(selection.sets, start=1) if selection else ()
