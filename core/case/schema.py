"""The case: what the user asks. Keys, ranges, defaults and names in one place, for form and file."""

import hashlib
import json
from collections.abc import Iterator, Sequence
from dataclasses import MISSING, dataclass, field, fields, replace

from core.case.keys import (
    channel_key,
    choice_key,
    flag_key,
    number_key,
    paragraphs_key,
    path_key,
    section_to_dict,
    text_key,
)
from core.case.place import Site
from core.case.select import Select
from core.case.sensitivity import Ranges
from core.case.site import Building, Demand
from core.case.wall import Wall
from core.ground.scattered import SPREAD
from core.rocking.methods import AUTO, METHODS
from core.text.sentence import LANGUAGES


@dataclass(frozen=True)
class Report:
    """[report]: what the title block of the workbook and the first page of the note say.

    date : also that of the PDF, as 2026-11-25 or 25/11/2026
    letterhead : lines of the office, with | between them; logo : a picture beside them, relative to the case
    font : of the note, of this machine; pdf_standard : a-1b for portals that take no other, without attached files
    judgement : of the engineer on the results (NTC 2018 10.2), at the end of the note, which else has room for it
    extent : of the note; brief has what decides about each wall, full each of its hinges and all checks
    """

    client: str = text_key()
    site: str = text_key()
    project: str = text_key()
    author: str = text_key()
    revision: str = text_key()
    date: str = text_key()
    language: str = choice_key(*LANGUAGES, default="en")
    letterhead: str = text_key()
    logo: str = text_key()
    font: str = text_key()
    pdf_standard: str = choice_key("a-3a", "a-1b", default="a-3a")
    judgement: str = paragraphs_key(form="note")
    extent: str = choice_key("brief", "full", default="brief", form="note")


@dataclass(frozen=True)
class Record:
    """[[record]]: a file or a glob, and only what the file does not say."""

    file: str = path_key(MISSING)
    unit: str | None = choice_key("g", "m/s2", "cm/s2", "mm/s2", default=None, form="file")
    time_step_s: float | None = number_key(1e-5, 0.5, unit="s", form="file")
    column: int | None = number_key(1, 100, whole=True, form="file")
    skip_lines: int | None = number_key(0, 1000, whole=True, form="file")
    channel: str = channel_key()
    scale: float = number_key(-1000.0, 1000.0, 1.0)
    kind: str = choice_key("natural", "artificial", "simulated", default="natural", form="file")
    include: bool = flag_key(True)


@dataclass(frozen=True)
class Generate:
    """[generate]: a set of artificial motions whose mean is compatible with the spectrum of the demand.

    scatter : standard deviation of ln S_a about it, that of natural records by default; 0 matches each to the spectrum
    """

    count: int = number_key(1, 50, 14, whole=True)
    seed: int = number_key(0, 1_000_000, 1, whole=True)
    scatter: float = number_key(0.0, 1.0, SPREAD)


DECIDE, BESIDE, NO_HISTORIES = "decide", "beside", "none"
"""What time histories do to an outcome."""


@dataclass(frozen=True)
class Analysis:
    """[analysis]: method and search.

    histories : decide, as the clause has them; beside a check of the clauses, which decides then; none (also true and
        false, of the first and the last)
    """

    method: str = choice_key(AUTO.name, *METHODS, default=AUTO.name)
    q_step: float = number_key(1e-4, 0.1, 0.005, form_unit="%")
    q_limit: float = number_key(1.5, 1000.0, 100.0)
    map_span: float = number_key(1.0, 10.0, 2.0)
    robust_window: float = number_key(0.01, 0.5, 0.10, form_unit="%")
    polarity: str = choice_key("both", "as_recorded", "reversed", default="both")
    histories: str = choice_key(DECIDE, BESIDE, NO_HISTORIES, default=DECIDE)
    accuracy: bool = flag_key()

    @staticmethod
    def upgrade_keys(table: dict) -> dict:
        """The keys with the word for histories that are switched on or off."""
        given = table.get("histories")
        return table | {"histories": DECIDE if given else NO_HISTORIES} if isinstance(given, bool) else table


def sections() -> dict[str, type]:
    """Every section of a case file as it is written there -> its class, one inside another after it."""

    def inside(name: str, section: type, repeated: bool) -> Iterator[tuple[str, type]]:
        yield f"[[{name}]]" if repeated else f"[{name}]", section
        for entry in fields(section):
            of = entry.metadata.get("of")
            if isinstance(of, type):
                yield from inside(f"{name}.{entry.name}", of, entry.metadata["kind"] == "tables")

    outer = (Report, Wall, Record, Generate, Select, Analysis, Site, Demand, Building)
    named = [one for of in outer for one in inside(of.__name__.lower(), of, of in (Wall, Record))]
    return dict([*named, *inside("sensitivity", Ranges, False)])


OWN_FIELDS = ("sha256", "given", "table", "table_notes", "drawings", "drawn_from", "source", "files")
"""Fields of a Case that are no keys of a file."""


@dataclass(frozen=True)
class Case:
    """One study.

    sha256 : of the file it was read from, else of its content
    given : places (section, index, key) the user wrote
    table : of walls they came from, "" if none
    table_notes : Notices on it
    drawings : Notices of the drawings its solids come from; drawn_from : their files
    source : text of the file it was read from, whose comments the note keeps
    files : that it names beside its records, as they were read (CaseFile)
    """

    title: str = text_key("Ribalta")
    report: Report = field(default_factory=Report)
    wall: tuple[Wall, ...] = ()
    record: tuple[Record, ...] = ()
    walls: str | None = path_key(None)
    generate: Generate | None = None
    select: Select | None = None
    analysis: Analysis = field(default_factory=Analysis)
    demand: Demand | None = None
    building: Building | None = None
    site: Site | None = None
    sensitivity: Ranges | None = None
    sha256: str = field(default="", compare=False)
    given: frozenset = field(default=frozenset(), compare=False)
    table: str = field(default="", compare=False)
    table_notes: tuple = field(default=(), compare=False)
    drawings: tuple = field(default=(), compare=False)
    drawn_from: tuple[str, ...] = field(default=(), compare=False)
    source: str = field(default="", compare=False, repr=False)
    files: tuple = field(default=(), compare=False, repr=False)

    @property
    def default_histories(self) -> bool:
        """Whether no records are given or asked for, so that a set is generated for its spectrum."""
        demand = self.demand
        asked = bool(self.record or self.generate or self.select) or self.analysis.histories == NO_HISTORIES
        return not asked and demand is not None and bool(demand.spectrum or demand.spectrum_file)

    def as_dict(self) -> dict:
        """Keys and values as in the file, defaults filled, None where nothing is given."""
        return {key: section_to_dict(getattr(self, key)) for key in self.__dataclass_fields__ if key not in OWN_FIELDS}

    def digest(self) -> str:
        """SHA-256 of `as_dict` as JSON; the text of a wall is made once."""
        text = json.dumps(replace(self, wall=()).as_dict(), sort_keys=True)
        walls = ", ".join(wall.as_json for wall in self.wall)
        # within a text each quotation mark has its backslash: what is replaced is the key
        return hashlib.sha256(text.replace('"wall": []', f'"wall": [{walls}]').encode()).hexdigest()

    def differing(self) -> set[tuple]:
        """Places (section, index, key) whose value differs from the default."""
        places = set()
        sections: tuple[tuple[str, Sequence], ...] = (
            ("wall", self.wall),
            ("record", self.record),
            ("report", [self.report]),
            ("analysis", [self.analysis]),
            ("site", [self.site] if self.site else []),
            ("demand", [self.demand] if self.demand else []),
            ("generate", [self.generate] if self.generate else []),
            ("select", [self.select] if self.select else []),
            ("building", [self.building] if self.building else []),
            ("sensitivity", [self.sensitivity] if self.sensitivity else []),
        )
        for section, items in sections:
            for index, item in enumerate(items):
                for entry in fields(item):
                    if entry.default is MISSING or getattr(item, entry.name) != entry.default:
                        places.add((section, index, entry.name))
        return places
