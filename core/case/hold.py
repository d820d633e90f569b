"""What holds a wall: each hold with its place, what it stands, and the document that shows it."""

from collections.abc import Iterable
from dataclasses import MISSING, dataclass, replace

from core.case.document import Document
from core.case.keys import flag_key, key, number_key, text_key
from core.known import require_value
from core.wall import arch, bars, masonry, ties

TIE = "tie"
"""Kind of hold that yields, and is gone beyond the elongation it stands."""


@dataclass(frozen=True)
class HoldKind:
    """A kind of hold, asked for what it is and recognised by no name.

    name : as a case file has it
    has_height : it is at a height; where not, it holds the wall over a stretch
    of_building : what has no end of its own holds a wall up to the highest of these; may_rise : one of them above the
        height of the building too
    pulls : it pulls the wall back alone, and stops it from nothing inward
    is_local : it holds a wall only where it stands along it
    is_bar : it yields, is slack when the wall comes back, and is gone beyond the elongation it stands
    """

    name: str
    has_height: bool = False
    of_building: bool = False
    may_rise: bool = False
    pulls: bool = False
    is_local: bool = False
    is_bar: bool = False


HOLD_KINDS = {
    kind.name: kind
    for kind in (
        HoldKind("floor", has_height=True, of_building=True),
        HoldKind("roof", has_height=True, of_building=True, may_rise=True),
        HoldKind("ring_beam", has_height=True),
        HoldKind("anchor", has_height=True, pulls=True),
        HoldKind(TIE, has_height=True, pulls=True, is_bar=True),
        HoldKind("cross_walls", is_local=True),
        HoldKind("buttress", is_local=True),
        HoldKind("contact"),
    )
}
"""Name -> kind, in the order in which a person is offered them."""

NO_KIND = HoldKind("")
"""The kind of a draft that has none yet."""


def hold_kind(name: str) -> HoldKind:
    """The kind of this name; of a name that is none the one that is nothing."""
    return HOLD_KINDS.get(name, NO_KIND)


LEAST_BELOW_SOUGHT = 0.1
"""Least height of the part of a wall below a tie that is sought [m]."""


@dataclass(frozen=True)
class Bars:
    """[wall.hold.bar]: the steel bars of a tie, over the length of the wall.

    thread_mm : diameter of the thread at their ends, that of the bar if none is given
    fy_mpa, fu_mpa : 235 and 360 if none is given
    existing : of an existing building: f_y and f_u are given mean values, which FC divides
    anchorage_kn : least resistance of the anchorage of a bar (plate, bearing and punching of the masonry), found by the
        engineer; without it the elongation of the bars is not counted on
    """

    number: int = number_key(1, 500, MISSING, whole=True)
    diameter_mm: float = number_key(4.0, 100.0, MISSING, unit="mm")
    fy_mpa: float | None = number_key(100.0, 1500.0, unit="MPa")
    fu_mpa: float | None = number_key(100.0, 2000.0, unit="MPa")
    thread_mm: float | None = number_key(4.0, 100.0, unit="mm")
    existing: bool = flag_key()
    anchorage_kn: float | None = number_key(0.0, 10000.0, unit="kN", exclusive=True)

    @property
    def strength(self) -> float:
        """f_y [MPa]."""
        return self.fy_mpa or 1e-6 * ties.DEFAULT_STRENGTH

    @property
    def tensile(self) -> float:
        """f_u [MPa]."""
        return self.fu_mpa or 1e-6 * ties.DEFAULT_TENSILE

    def in_si(self) -> ties.Steel:
        """The bars in SI."""
        return ties.Steel(
            self.number,
            1e-3 * self.diameter_mm,
            1e6 * self.strength,
            1e6 * self.tensile,
            None if self.thread_mm is None else 1e-3 * self.thread_mm,
            self.existing,
            None if self.anchorage_kn is None else 1e3 * self.anchorage_kn,
        )


@dataclass(frozen=True)
class Hold:
    """[[wall.hold]]: what holds a wall.

    name : by default its kind and its height
    h_m : above the base of the wall; of cross walls, a buttress or contact from_m to to_m in its place, where to_m is
        by default the lowest of the highest floor or roof, the eaves and the top of the building
    out_kn_m : what it stands outward, per metre of wall; of cross walls and buttresses per metre of height, across each
        end of the wall between them beside the friction of its thrust; of a tie its force at yield, in place of `bar`;
        without it a hold is contact
    in_kn_m : what it stands inward, pressed by a wall that bends inward, beside out_kn_m; not compared without it
    spacing_m : clear distance L between two cross walls or buttresses, between which the wall spans; of a tie to be
        designed that of its bars along the wall
    tie_kn_m : yield force of the ties along the wall that its ends push against, per metre of its height
    tie_bar_length_m, tie_elongation_m : length of a bar of these, and the elongation it stands
    shoulder_length_m, shoulder_thickness_m : of the masonry beyond the last cross wall, along the wall and across it
    corner_wall : wall of the case with a [wall.corner] that stands there, and takes the thrust; corner_side : which of
        its two walls this one goes on from, 1 or 2
    bar_length_m and what follows : of a tie only, but for elongation_m
    fy_mpa : with out_kn_m, gives the elongation at yield; 235 if none is given
    elongation_m : what it stands before it is gone, of a hold that yields at out_kn_m; without it, it is brittle
    stiffness_kn_m2 : of a floor, a roof, a ring beam or an anchor, with out_kn_m: force per metre of wall and per metre
        it gives way; with it, or with elongation_m, the impulses of a wall that comes back from inward are looked at
    slack_mm : before it pulls; prestress : share of the force at yield
    design : it is not there yet: what it has to hold is sought
    """

    kind: str = key("choice", MISSING, names=HOLD_KINDS)
    name: str = text_key()
    h_m: float | None = number_key(0.0, 60.0, unit="m", exclusive=True)
    from_m: float | None = number_key(0.0, 60.0, unit="m")
    to_m: float | None = number_key(0.0, 60.0, unit="m", exclusive=True)
    out_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m", exclusive=True)
    in_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m", exclusive=True)
    spacing_m: float | None = number_key(0.3, 50.0, unit="m")
    tie_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m", exclusive=True)
    tie_bar_length_m: float | None = number_key(0.2, 300.0, unit="m")
    tie_elongation_m: float | None = number_key(0.0, 10.0, unit="m")
    shoulder_length_m: float | None = number_key(0.05, 50.0, unit="m")
    shoulder_thickness_m: float | None = number_key(0.05, 20.0, unit="m", form_unit="cm")
    corner_wall: str = text_key()
    corner_side: int | None = number_key(1, 2, whole=True)
    bar_length_m: float | None = number_key(0.2, 100.0, unit="m")
    fy_mpa: float | None = number_key(100.0, 1500.0, unit="MPa")
    elongation_m: float | None = number_key(0.0, 10.0, unit="m")
    stiffness_kn_m2: float | None = number_key(1.0, 1e9, unit="kN/m2")
    slack_mm: float | None = number_key(0.0, 500.0, unit="mm")
    prestress: float | None = number_key(0.0, 0.9)
    bar: Bars | None = key("section", of=Bars, columns="hold{n}_bar_")
    design: bool = flag_key()
    evidence: Document | None = key("section", of=Document, columns="hold{n}_evidence_")

    @property
    def has_height(self) -> bool:
        """Whether it is at a height, not over a stretch."""
        return hold_kind(self.kind).has_height

    @property
    def is_local(self) -> bool:
        """Whether it holds a wall only where it stands along it."""
        return hold_kind(self.kind).is_local

    @property
    def is_bar(self) -> bool:
        """Whether it is a tie, one that is sought too."""
        return hold_kind(self.kind).is_bar

    @property
    def is_contact(self) -> bool:
        """Whether a wall leans on it."""
        return not hold_kind(self.kind).pulls

    @property
    def is_tie(self) -> bool:
        """Whether it is a tie that is there, not one that is sought."""
        return self.is_bar and not self.design

    @property
    def spans(self) -> bool:
        """Whether a wall spans between two of these."""
        return self.is_local and self.spacing_m is not None

    @property
    def only_there(self) -> bool:
        """Whether it holds a wall only where it stands, and how far apart is not said."""
        return self.is_local and not self.spans

    @property
    def shows_strength(self) -> bool:
        """Whether its document shows what it stands, not only that it is there."""
        return self.evidence is not None and self.evidence.shows_strength

    @property
    def with_tie(self) -> bool:
        """Whether ties along the wall are said to hold its ends."""
        return self.tie_kn_m is not None

    @property
    def with_shoulder(self) -> bool:
        """Whether masonry beyond its ends is."""
        return self.shoulder_length_m is not None

    @property
    def at_yield(self) -> float:
        """Elongation of a bar of the ties along the wall at yield [m]."""
        return ties.elongation_at_yield(require_value(self.tie_bar_length_m))

    @property
    def alone(self) -> "Hold":
        """Hold the wall by contact alone: it neither spans to it nor is held outward."""
        return Hold(self.kind, self.name, self.h_m, self.from_m, self.to_m, evidence=self.evidence)

    def tie(self, wall_length: float | None) -> ties.Tie:
        """The tie of a hold that is one, for a metre of a wall of this length [m]."""
        length, stands = require_value(self.bar_length_m), self.elongation_m or 0.0
        height, slack, prestress = require_value(self.h_m), 1e-3 * (self.slack_mm or 0.0), self.prestress or 0.0
        if self.bar is not None:
            wall = require_value(wall_length)
            return ties.tie_of_bars(height, self.bar.in_si(), length, wall, stands, slack, prestress)
        strength = ties.DEFAULT_STRENGTH if self.fy_mpa is None else 1e6 * self.fy_mpa
        at_yield = ties.elongation_at_yield(length, strength)
        return ties.tie_of_force(height, 1e3 * require_value(self.out_kn_m), at_yield, stands, slack, prestress)

    def tie_in_si(self, wall_length: float | None) -> masonry.Load:
        """What a tie does to a metre of a wall of this length [m]. Raises TypeError where it has no size yet."""
        tie = self.tie(wall_length)
        return masonry.Load(TIE, tie.bar.strength, 0.0, tie.bar.height, False, tie)

    def above(self, height: float) -> "Hold | None":
        """The hold as the part of a wall above a height of it has it [m]; None of what is lower."""
        if self.has_height:
            left = require_value(self.h_m) - height
            return replace(self, h_m=left) if left > (LEAST_BELOW_SOUGHT - 1e-9 if self.design else 1e-9) else None
        if self.to_m is not None and self.to_m <= height:
            return None
        low = None if self.from_m is None else max(0.0, self.from_m - height)
        return replace(self, from_m=low, to_m=None if self.to_m is None else self.to_m - height)

    def top(self, least: Iterable[float]) -> float | None:
        """Height up to which it holds [m]. least : those of which the lowest is that of cross walls, a buttress or
        contact without one of its own; None where there is none"""
        return self.h_m if self.has_height else self.to_m or min(least, default=None)

    def arch_in_si(
        self, height: float, thickness: float, unit_weight: float, strength: float, presses: float
    ) -> arch.Arch:
        """The arch of a wall between two of these. height, thickness : [m]; unit_weight : w [N/m3]; strength : f [Pa];
        presses : what presses the wall outward between them [N/m]"""
        tie = shoulder = None
        beyond = 0.0
        spacing = require_value(self.spacing_m)
        if self.tie_kn_m is not None and self.tie_bar_length_m is not None and self.tie_elongation_m is not None:
            bays = max(1.0, self.tie_bar_length_m / spacing)
            tie = arch.Along(1e3 * self.tie_kn_m, self.at_yield, self.tie_elongation_m, bays)
        if self.shoulder_length_m is not None and self.shoulder_thickness_m is not None:
            sizes = self.shoulder_length_m, self.shoulder_thickness_m
            parted = arch.parted_flat(spacing, thickness)
            shoulder = arch.thrust_of_shoulder(*sizes, height, unit_weight, parted)
            beyond = unit_weight * sizes[0] * sizes[1]
        between = arch.arch_of(spacing, thickness, strength, tie, shoulder, presses, beyond)
        return between._replace(across=1e3 * (self.out_kn_m or 0.0))


@dataclass(frozen=True)
class ShareOfHold(Hold):
    """What a hold has for the stretch below it, or for the one above (h_m 0).

    beside_kn_m : weight whose inertia goes to it beside what the stretch hands to it, by the lever rule
    backed : something is behind the stretch, all along or within it, so that it cannot bend inward as a whole
    rocking : what rocks above it, of the highest one; stub : what may fall there, too low to rock
    yielded : bar of a tie between the ends of a stretch, at h_m, which has yielded
    """

    beside_kn_m: float = 0.0
    backed: bool = False
    rocking: masonry.PartAbove | None = None
    stub: masonry.StubAbove | None = None
    yielded: bars.TieBar | None = None

    @property
    def is_tie(self) -> bool:
        """It holds the stretch with its strength alone: no bar of it is followed."""
        return False
