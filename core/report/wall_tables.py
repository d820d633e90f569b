"""Tables of walls: their checks, as they are beside as they are designed, the values of the site and of the floors."""

from collections.abc import Callable, Iterator
from operator import itemgetter
from typing import NamedTuple

from core.codes.eq9 import LABEL
from core.report.tables import DataColumn, DataTable, Speaker
from core.report.verdict_words import outcome_of
from core.setting.floors import Floor
from core.study.results import Q_SOURCES, StudyResult, WallResult, WallVerdict
from core.study.variants import WallComparison
from core.text.sentence import title_in, word
from core.units import G

LAW_WORDS = {"q": "law_q", "q_slv": "law_q_slv"}
"""Quantity of the law -> its words."""


class CheckRow(NamedTuple):
    """A check, or for comparison what Eq. 9 and a law of q come to. values : q, capacity, demand, unit, zeta

    passed : None where it has no number; counts : whether it decides; outcome : its word in place of passed
    """

    label: str
    clause: str
    values: tuple[float | None, float | None, float | None, str, float | None]
    passed: bool | None
    counts: bool = False
    outcome: str = ""

    @property
    def tone(self) -> str:
        """Return the tone of zeta and outcome: quiet of what does not count."""
        return "quiet" if self.passed is None or not self.counts else "good" if self.passed else "bad"


def checks_of_wall(speaker: Speaker) -> DataTable:
    """The checks of a wall; rows : CheckRow."""
    say = speaker.say

    def quiet(row: CheckRow) -> str:
        return "" if row.counts else "quiet"

    def outcome(row: CheckRow) -> str:
        plain = "no_number" if row.passed is None else "passed" if row.passed else "not_passed"
        return row.outcome or word(plain, speaker.language)

    return DataTable(
        (
            DataColumn(say("Method"), lambda row: row.label, width=24, tone=quiet),
            DataColumn(say("Clause"), lambda row: row.clause, tone=quiet),
            DataColumn("q", lambda row: row.values[0], ".2f", tone=quiet),
            DataColumn(say("Capacity"), lambda row: row.values[1], ".3f", tone=quiet),
            DataColumn(say("Demand"), lambda row: row.values[2], ".3f", tone=quiet),
            DataColumn(say("Unit"), lambda row: row.values[3], tone=quiet),
            DataColumn("ζ", lambda row: row.values[4], ".2f", tone=lambda row: row.tone),
            DataColumn(say("Outcome"), outcome, tone=lambda row: row.tone),
        )
    )


def rows_of_checks(wall: WallResult, language: str) -> Iterator[CheckRow]:
    """The checks of a wall, those that decide marked."""
    for check, counts in wall.required_assessment.shown:
        shown = word("shown", language) if check.name == "floor_sld" else ""
        values = (check.q, check.capacity, check.demand, check.unit, check.zeta)
        yield CheckRow(word(check.label, language), check.clause, values, check.passed, counts, shown)


def rows_of_comparison(wall: WallResult, language: str) -> Iterator[CheckRow]:
    """Eq. 9 of the paper with each q, for comparison only."""
    compared = word("comparison", language)
    for source, check in zip(Q_SOURCES, wall.code_check, strict=False):
        if check:
            outcome = f"{word('passed' if check.passed else 'not_passed', language)} ({compared})"
            values = (check.q, check.capacity / G, check.demand / G, "g", check.ratio)
            yield CheckRow(word(source, language), LABEL, values, check.passed, outcome=outcome)


def rows_of_estimates(result: StudyResult, wall: WallResult, language: str) -> Iterator[CheckRow]:
    """Eq. 9 with the q that Ribalta's law estimates, a research output."""
    capacity = wall.model.threshold / G
    for estimate in wall.estimates:
        demand, ranges = result.demand_required.pga / G / estimate.q, estimate.ranges
        values, outcome = (
            (estimate.q, capacity, demand, "g", capacity / demand),
            ", ".join(each.text(language) for each in ranges),
        )
        yield CheckRow(word(LAW_WORDS[estimate.quantity], language), LABEL, values, None, outcome=outcome)


def variants_of_walls(speaker: Speaker, result: StudyResult) -> DataTable:
    """Walls as they are beside as they are designed; rows : WallComparison."""
    say, language = speaker.say, speaker.language

    def side(chosen: Callable[[WallComparison], WallVerdict], head: str) -> tuple[DataColumn, ...]:
        def outcome(row: WallComparison) -> str:
            return word(outcome_of(result, chosen(row))[0], language)

        def method(row: WallComparison) -> str:
            label = outcome_of(result, chosen(row))[1]
            return word(label, language) if label else ""

        return (
            DataColumn(head, outcome, width=17),
            DataColumn("ζ", lambda row: chosen(row).zeta_least, ".2f", 7),
            DataColumn(say("by"), method, width=16),
        )

    def changed(row: WallComparison) -> str:
        return ", ".join(word(f"key_{key}", language) for key in row.changed) or say("nothing")

    return DataTable(
        (
            DataColumn(say("Wall"), lambda row: title_in(row.name, language), width=18),
            *side(lambda row: row.before, say("before")),
            *side(lambda row: row.after, say("after")),
            DataColumn(say("changed"), changed, width=22),
        )
    )


def limit_states_of_site(speaker: Speaker) -> DataTable:
    """Values of the hazard; rows : of `states_of`."""
    years = f"T_R [{speaker.say('years')}]"
    return DataTable(
        (
            DataColumn(speaker.say("Limit state"), lambda row: row[0]),
            DataColumn(years, lambda row: row[1], ".0f"),
            *(DataColumn(head, itemgetter(k), ".3f") for k, head in _OF_HAZARD),
        )
    )


_OF_HAZARD = (2, "a_g [g]"), (3, "F0"), (4, "T_C* [s]")


def modes_of_floor(speaker: Speaker) -> DataTable:
    """Modes of the building at the heights of its walls; rows : (floor, number from 1, mode)."""

    def acceleration(row) -> float | None:
        floor, _, mode = row
        if floor.spectrum is None:
            return None
        return float(floor.spectrum.ground.acceleration([mode.period], mode.damping)[0]) / G

    def number(row) -> str:
        return f"{row[1]} ({speaker.say('estimate')})" if row[0].estimated else str(row[1])

    return DataTable(
        (
            DataColumn("z [m]", lambda row: row[0].z, ".2f"),
            DataColumn(speaker.say("Mode"), number),
            DataColumn("T [s]", lambda row: row[2].period, ".3f"),
            DataColumn("ξ [-]", lambda row: row[2].damping, ".3f"),
            DataColumn("γψ [-]", lambda row: row[2].participation, ".3f"),
            DataColumn("S_e(T, ξ) [g]", acceleration, ".3f"),
        )
    )


def numbered_modes(floor: Floor) -> list[tuple]:
    """Rows of `modes_of_floor`."""
    return [(floor, number, mode) for number, mode in enumerate(floor.modes, start=1)]


def motions_of_floor(speaker: Speaker) -> DataTable:
    """Peak of the floor over that of the ground; rows : motions of a floor."""

    def ground(motion) -> float:
        return motion.ground_pga or motion.pga

    return DataTable(
        (
            DataColumn(speaker.say("Record"), lambda motion: motion.name, width=22),
            DataColumn("PGA [g]", lambda motion: ground(motion) / G, ".3f"),
            DataColumn("PFA [g]", lambda motion: motion.pga / G, ".3f"),
            DataColumn("PFA/PGA", lambda motion: motion.pga / ground(motion), ".2f"),
        )
    )
