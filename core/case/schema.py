"""The case: what the user asks. Keys, ranges, defaults and names in one place, for form and file."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import MISSING, asdict, dataclass, field, fields

from core.case.back_restraint import EVIDENCE, RESTRAINTS, with_choice
from core.case.keys import channel_key, choice_key, flag_key, key, number_key, paragraphs_key, path_key, text_key
from core.case.loads import Load, ReturnWalls
from core.case.place import Site
from core.case.select import Select
from core.case.sensitivity import Ranges
from core.case.site import Building, Demand
from core.case.solids import Drawing, Opening, Solid, Step, Wedges
from core.codes.masonry_types import TYPES
from core.codes.vertical_bending import bending
from core.errors import InputError, place
from core.ground.scattered import SPREAD
from core.rocking.methods import AUTO, METHODS
from core.text.sentence import Key, sentence
from core.wall import ties, wall_body, wall_loads
from core.wall.bars import Bar
from core.wall.block import Block
from core.wall.loads import BARE, RestoringMoment
from core.wall.moment_rotation import LAWS, WITH_BRANCH, MomentLaw
from core.wall.restitution import MODELS, Restitution, restitution

MIN_ELASTIC = 0.001
"""Smallest D1 of a trilinear law that is given by its ends. That of an element free to vibrate may be shorter: it is no
rigid law all the same. However short, the wall vibrates on it before it rocks, and a motion that would not lift the
rigid wall drives it off its end with what it has stored there."""


@dataclass(frozen=True)
class Report:
    """[report]: what the title block of the workbook and the first page of the note say.

    date : also that of the PDF, as 2026-11-25 or 25/11/2026
    letterhead : lines of the office, with | between them; logo : a picture beside them, relative to the case
    font : of the note, of this machine; pdf_standard : a-1b for portals that take no other, without attached files
    judgement : of the engineer on the results (NTC 2018 10.2), at the end of the note, which else has room for it
    extent : of the note; short without derivations and histories of the walls
    """

    client: str = text_key()
    site: str = text_key()
    project: str = text_key()
    author: str = text_key()
    revision: str = text_key()
    date: str = text_key()
    language: str = choice_key("en", "it", default="en")
    letterhead: str = text_key()
    logo: str = text_key()
    font: str = text_key()
    pdf_standard: str = choice_key("a-3a", "a-1b", default="a-3a")
    judgement: str = paragraphs_key(form="note")
    extent: str = choice_key("full", "short", default="full", form="note")


AS_IS, DESIGNED = "stato di fatto", "progetto"
"""Variants of a wall: two walls of one name are compared if each is one of them."""


@dataclass(frozen=True)
class WallJustification:
    """[wall.justification]: why a value of the wall that raises zeta holds, in the engineer's words."""

    velocity_ratio: str = text_key()
    restitution: str = text_key()
    law: str = text_key()
    return_walls: str = text_key()
    return_wedges: str = text_key()
    contact: str = text_key()
    free_element: str = text_key()
    base_z_m: str = text_key()
    elongation_m: str = text_key()
    slack_mm: str = text_key()
    prestress: str = text_key()
    anchorage_kn: str = text_key()
    load: str = text_key()
    compressive_strength_mpa: str = text_key()
    unit_weight_kn_m3: str = text_key()
    mass: str = text_key()
    h_m: str = text_key()
    d_m: str = text_key()


MOST_INERTIA = 2.0
"""Largest I0/m over R^2 of a block: 4/3 of a slender rectangle, 3/2 of a triangle on its base. A block rocks the more
slowly the larger it is."""

BENDS = "vertical_bending"
"""Mechanism of a wall held at its top: kinematic checks, no time histories."""

MAX_SETBACK = 0.4
"""Largest hinge setback over the thickness: at 0.5 nothing is left to turn about."""


@dataclass(frozen=True)
class Wall:
    """[[wall]]: geometry, mechanism, restitution, moment law."""

    name: str = text_key(MISSING)
    mechanism: str = choice_key("one_sided", "two_sided", "both", BENDS)
    height_m: float | None = number_key(0.1, 60.0, unit="m", form="shape", filled=True)
    thickness_m: float | None = number_key(0.005, 20.0, unit="m", form_unit="cm", form="shape", filled=True)
    slenderness_deg: float | None = number_key(0.05, 60.0, unit="deg", form="shape", filled=True)
    height_over_thickness: float | None = number_key(0.5, 1000.0, form="shape", filled=True)
    radius_m: float | None = number_key(0.05, 60.0, unit="m", form="shape", filled=True)
    inertia_over_mass_m2: float | None = number_key(0.0025, 20000.0, unit="m2", form="shape", filled=True)
    restitution: str | None = choice_key(*MODELS, default=None)
    velocity_ratio: float | None = number_key(0.0, 1.0, filled=True)
    law: str | dict = key("law", "auto")
    hinge_heights: str | tuple[float, ...] | None = key("hinges", form="held")
    hinge_setback_m: float = number_key(0.0, 2.0, 0.0, unit="m", form_unit="cm", form="shape")
    masonry: str | None = choice_key(*TYPES, default=None, form="checks")
    compressive_strength_mpa: float | None = number_key(0.1, 100.0, unit="MPa", form="checks")
    base_z_m: float | None = number_key(0.0, 300.0, unit="m", form="checks")
    length_m: float | None = number_key(0.05, 200.0, unit="m", form="checks")
    unit_weight_kn_m3: float | None = number_key(5.0, 40.0, unit="kN/m3", form="checks")
    free_element: bool | None = flag_key(None, form="checks")
    elastic_modulus_mpa: float | None = number_key(10.0, 100000.0, unit="MPa", form="checks")
    back_restraint: str | None = choice_key(*RESTRAINTS, default=None, form="checks")
    restraint_evidence: str | None = choice_key(*EVIDENCE, default=None, form="checks")
    restraint_note: str = text_key(form="checks")
    unloaded_confirmed: bool = flag_key(form="checks")
    floor: str = text_key(form="checks")
    notes: str = text_key(form="checks")
    load: tuple[Load, ...] = key("tables", (), of=Load, columns="load{n}_")
    return_walls: ReturnWalls | None = key("section", of=ReturnWalls, columns="across_")
    solid: tuple[Solid, ...] = key("tables", (), of=Solid, columns="solid{n}_")
    drawing: tuple[Drawing, ...] = key("tables", (), of=Drawing)
    gable_m: float | None = number_key(0.1, 60.0, unit="m", form="body")
    openings: tuple[Opening, ...] = key("tables", (), of=Opening, columns="opening{n}_")
    steps: tuple[Step, ...] = key("tables", (), of=Step, columns="step{n}_")
    return_wedges: Wedges | None = key("section", of=Wedges, columns="wedges_")
    tie_height_m: float | None = number_key(0.1, 60.0, unit="m", form="held")
    tie_bar_length_m: float | None = number_key(0.2, 100.0, unit="m", form="held")
    tie_elongation_m: float | None = number_key(0.0, 10.0, unit="m", form="held")
    tie_spacing_m: float | None = number_key(0.1, 20.0, unit="m", form="held")
    justification: WallJustification | None = key("section", of=WallJustification)
    variant: str | None = choice_key(AS_IS, DESIGNED, default=None, form="held")

    @staticmethod
    def of_older(table: dict) -> dict:
        """The keys of a wall as they are now: what stands behind it was a free text before 0.16. A type of masonry
        gives the unit weight that is left out, where the table has one for it."""
        masonry = TYPES.get(str(table.get("masonry")))
        if masonry and "unit_weight_kn_m3" not in table and masonry.weight[0] == masonry.weight[1]:
            table = table | {"unit_weight_kn_m3": masonry.weight[0]}
        return with_choice(table)

    @property
    def title(self) -> str:
        """Its name, with its variant where it has one."""
        return self.name if self.variant is None else f"{self.name} ({self.variant})"

    @property
    def thickness(self) -> float | None:
        """t [m] of a rectangular wall, None of a general block."""
        if self.thickness_m is not None or self.height_m is None:
            return self.thickness_m
        if self.slenderness_deg is not None:
            return self.height_m * math.tan(math.radians(self.slenderness_deg))
        return None if self.height_over_thickness is None else self.height_m / self.height_over_thickness

    @property
    def setback(self) -> float:
        """u [m], the hinge inside the edge: as given, or 2 N / (3 f L) with N = unit weight t H L and the vertical
        loads, the triangle of stress under the wall about to turn."""
        if self.compressive_strength_mpa is None or self.thickness is None:
            return self.hinge_setback_m
        weight = wall_loads.weight_per_metre(self)
        if self.load:
            weight += wall_loads.vertical_loads(self)
        if wall_body.has_shape(self):
            assert self.length_m is not None
            weight *= self.length_m / wall_body.base_length(self)
        return 2.0 * weight / (3.0 * 1e6 * self.compressive_strength_mpa)

    @property
    def weight(self) -> float | None:
        """W [N] of the wall, None without length and unit weight."""
        if self.length_m is None or None in (self.unit_weight_kn_m3, self.thickness):
            return None
        return wall_loads.weight_per_metre(self) * self.length_m

    def block(self) -> Block:
        """The wall and the masses that move with it. Raises InputError for a wall without exactly one geometry."""
        bare = self.bare_block()
        return wall_loads.moving_block(self, bare) if self.load and not self.bends else bare

    def inner_block(self) -> Block | None:
        """`block` about the inner hinge, of a wall that is not symmetric."""
        if self.bends:
            return None
        return wall_loads.inner_of(self, self.block()) if self.load or wall_body.has_shape(self) else None

    def restoring(self) -> tuple[RestoringMoment, RestoringMoment]:
        """What its loads add to its moment, for outward and for inward rotations; its ties add `bars`."""
        return wall_loads.restoring_of(self, self.block()) if self.load and not self.bends else (BARE, BARE)

    def bars(self) -> tuple[Bar, ...]:
        """Its ties as the kernels take them."""
        return ties.scaled(self, self.block())

    def uplift_multiplier(self, mechanism: str) -> float:
        """a_RM / g = a tan(alpha) + c [-] (Eq. 2), of a two-sided wall the smaller one of its sides; of one
        held at its top alpha_0."""
        if self.bends:
            return bending(self).alpha0
        outer = self.block()
        blocks = (outer, self.inner_block() or outer) if mechanism == "two_sided" else (outer,)
        about = zip(blocks, self.restoring(), strict=False)
        return min(side.sine * math.tan(block.slenderness) + side.cosine for block, side in about)

    def bare_block(self) -> Block:
        """The wall alone."""
        here = (place("wall", name=self.name),)
        shape = ("thickness_m", "slenderness_deg", "height_over_thickness")
        given = [key for key in shape if getattr(self, key) is not None]
        if self.radius_m is not None or self.inertia_over_mass_m2 is not None:
            if self.hinge_setback_m or self.compressive_strength_mpa is not None:
                raise InputError("general_no_setback", place=here)
            if self.slenderness_deg is None or len(given) > 1 or self.height_m is not None or wall_body.has_shape(self):
                raise InputError("general_keys", place=here)
            if self.radius_m is None or self.inertia_over_mass_m2 is None:
                raise InputError("general_needs", place=here)
            if self.inertia_over_mass_m2 > MOST_INERTIA * self.radius_m**2:
                raise InputError(
                    "inertia_too_large",
                    place=here,
                    key="inertia_over_mass_m2",
                    given=self.inertia_over_mass_m2,
                    most=MOST_INERTIA * self.radius_m**2,
                    ratio=MOST_INERTIA,
                )
            return Block(math.radians(self.slenderness_deg), self.radius_m, self.inertia_over_mass_m2)
        if self.height_m is None or len(given) != 1:
            stated = sentence("accepted", "given" if self.height_m else "missing")
            raise InputError(
                "one_geometry",
                place=here,
                shapes=tuple(map(Key, shape)),
                height=stated,
                found=tuple(map(Key, given)) or sentence("accepted", "none"),
            )
        if self.compressive_strength_mpa is not None and self.hinge_setback_m:
            raise InputError("strength_gives_setback", place=here)
        if self.compressive_strength_mpa is not None and self.unit_weight_kn_m3 is None:
            raise InputError("strength_needs_weight", place=here, key="unit_weight_kn_m3")
        thickness, setback = self.thickness, self.setback
        assert thickness is not None
        if not setback < MAX_SETBACK * thickness:
            key = "hinge_setback_m" if self.hinge_setback_m else "compressive_strength_mpa"
            raise InputError(
                "setback_too_large",
                key=key,
                setback=setback,
                most=MAX_SETBACK * thickness,
                share=100 * MAX_SETBACK,
                place=here,
            )
        if (body := wall_body.body_of(self)) is not None:
            return body.about(setback)
        if setback == 0.0 and self.slenderness_deg is not None:
            return Block.rectangle(self.height_m, math.radians(self.slenderness_deg))
        return Block.with_setback(self.height_m, thickness, setback)

    def is_free(self, mechanism: str) -> bool:
        """Whether the wall is free to vibrate before it moves, not restrained by continuity with transverse
        walls (Circolare 7/2019 C8.7.1.2.1.3, .5): as asked, else a two-sided one is, a one-sided one not."""
        return mechanism == "two_sided" if self.free_element is None else self.free_element

    @property
    def has_closed_forms(self) -> bool:
        """Whether Eq. 15 and 16 say anything of it: fitted to walls on the ground without loads; of a body by the
        rectangle of the same p and alpha."""
        bare = not self.load and not self.bends
        return not self.above_ground and bare and not (self.is_unlike and "two_sided" in self.mechanisms())

    @property
    def is_unlike(self) -> bool:
        """Whether it is another block about its inner hinge."""
        return self.inner_block() is not None

    @property
    def above_ground(self) -> bool:
        """Whether what moves it is above the ground; with a demand its height is always given."""
        return (self.felt_z_m or 0.0) > 0.0

    @property
    def felt_z_m(self) -> float | None:
        """Height above the ground [m] at which its demand is taken: of its hinge, of a wall held at its top of its
        middle; None where it is not given."""
        if self.base_z_m is None or not self.bends:
            return self.base_z_m
        return self.base_z_m + 0.5 * (self.height_m or 0.0)

    @property
    def bends(self) -> bool:
        """Whether it is held at its top and opens a hinge between."""
        return self.mechanism == BENDS

    def mechanisms(self) -> tuple[str, ...]:
        return ("two_sided", "one_sided") if self.mechanism == "both" else (self.mechanism,)

    def restitution_model(self, mechanism: str) -> str:
        """Model of restitution for one mechanism: as asked, else the default that follows the mechanism."""
        model = self.restitution or ("user" if self.velocity_ratio is not None else None)
        return model or ("one_sided_theoretical" if mechanism == "one_sided" else "housner")

    def restitution_of(self, mechanism: str) -> Restitution:
        """Restitution for one mechanism."""
        model = self.restitution_model(mechanism)
        if MODELS[model].one_sided and mechanism == "two_sided":
            raise InputError(
                "restitution_one_sided", model=model, asked=self.mechanism, place=(place("wall", name=self.name),)
            )
        if (model == "user") != (self.velocity_ratio is not None):
            raise InputError("velocity_ratio_user", place=(place("wall", name=self.name),))
        contact = wall_loads.contact_of(self)
        return restitution(self.block(), model, self.velocity_ratio, contact)

    def moment_law(self) -> MomentLaw:
        """As it is given; an elastic branch is of the check at the demand alone."""
        if isinstance(self.law, str):
            return LAWS["rigid" if self.law in WITH_BRANCH else self.law]
        return MomentLaw(self.law["elastic_limit"], self.law["plateau_end"])


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


@dataclass(frozen=True)
class Analysis:
    """[analysis]: method and search."""

    method: str = choice_key(AUTO.name, *METHODS, default=AUTO.name)
    q_step: float = number_key(1e-4, 0.1, 0.005, form_unit="%")
    q_limit: float = number_key(1.5, 1000.0, 100.0)
    map_span: float = number_key(1.0, 10.0, 2.0)
    robust_window: float = number_key(0.01, 0.5, 0.10, form_unit="%")
    polarity: str = choice_key("both", "as_recorded", "reversed", default="both")
    histories: bool = flag_key(True)
    accuracy: bool = flag_key()


def sections() -> dict[str, type]:
    """Every section of a case file as it is written there -> its class, one inside another after it."""

    def inside(name: str, section: type, repeated: bool) -> Iterator[tuple[str, type]]:
        yield f"[[{name}]]" if repeated else f"[{name}]", section
        for entry in fields(section):
            of = entry.metadata.get("of")
            if isinstance(of, type):
                yield from inside(f"{name}.{entry.name}", of, entry.metadata["kind"] == "tables")

    outer = (Report, Wall, Record, Generate, Select, Analysis, Site, Demand, Building)
    found = [one for of in outer for one in inside(of.__name__.lower(), of, of in (Wall, Record))]
    return dict([*found, *inside("sensitivity", Ranges, False)])


OWN_FIELDS = ("sha256", "given", "table", "table_notes", "drawings", "drawn_from", "source")
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

    @property
    def default_histories(self) -> bool:
        """Whether no records are given or asked for, so that a set is generated for its spectrum."""
        demand = self.demand
        asked = bool(self.record or self.generate or self.select) or not self.analysis.histories
        return not asked and demand is not None and bool(demand.spectrum or demand.spectrum_file)

    def as_dict(self) -> dict:
        """Keys and values as in the file, defaults filled, None where nothing is given."""
        content = asdict(self)
        for name in OWN_FIELDS:
            del content[name]
        return content

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
