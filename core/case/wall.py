"""A wall of the case: its keys, and the wall in SI that they make."""

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import MISSING, dataclass, replace
from functools import cached_property

from core.case.document import WallEvidence
from core.case.hold import Hold, ShareOfHold, hold_kind
from core.case.keys import choice_key, flag_key, key, number_key, section_to_dict, text_key
from core.case.loads import Load, ReturnWalls
from core.case.set_aside import SetAside
from core.case.shape import Shaped
from core.case.solids import Corner, Drawing, InPlan, Leaf, Opening, Solid, Step, Wedges
from core.case.variant_names import AS_IS, DESIGNED
from core.codes.masonry_types import TYPES
from core.errors import InputError, place
from core.known import require_value
from core.text.sentence import Key, sentence
from core.wall.arch import Arch
from core.wall.bending import TOP_TOLERANCE, spread_over
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.kinematics import MECHANISMS, Kinematics, kinematics
from core.wall.masonry import SLIDING, Declared, Masonry, base_length, weight_per_metre
from core.wall.moment_rotation import LAWS, WITH_BRANCH, MomentLaw
from core.wall.restitution import MODELS, restitution
from core.wall.solids import sum_of

MIN_ELASTIC = 0.001
"""Smallest D1 of a trilinear law that is given by its ends. That of an element free to vibrate may be shorter: it is no
rigid law all the same. However short, the wall vibrates on it before it rocks, and a motion that would not lift the
rigid wall drives it off its end with what it has stored there."""


MAX_INERTIA = 2.0
"""Largest I0/m over R^2 of a block: 4/3 of a slender rectangle, 3/2 of a triangle on its base. A block rocks the more
slowly the larger it is."""

MAX_SETBACK = 0.4
"""Largest hinge setback over the thickness: at 0.5 nothing is left to turn about."""


FOUND = {True: "one_sided", False: "two_sided"}
"""Whether a wall leans on something -> the mechanism that is found."""


def leans_on_something(table: Mapping) -> bool:
    """Whether the keys of a wall have a hold that it leans on."""
    holds = table.get("hold")
    kinds = [hold.get("kind") for hold in holds if isinstance(hold, Mapping)] if isinstance(holds, list | tuple) else []
    return any(not hold_kind(str(kind)).pulls for kind in kinds)


@dataclass(frozen=True)
class Wall(Shaped):
    """[[wall]]: geometry, mechanism, restitution, moment law."""

    name: str = text_key(MISSING)
    mechanism: str = key("choice", MISSING, names=MECHANISMS)
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
    base_friction: float | None = number_key(0.05, 0.4, form="checks")
    elastic_modulus_mpa: float | None = number_key(10.0, 100000.0, unit="MPa", form="checks")
    unloaded_confirmed: bool = flag_key(form="checks")
    floor: str = text_key(form="checks")
    notes: str = text_key(form="checks")
    hold: tuple[Hold, ...] = key("tables", (), of=Hold, columns="hold{n}_")
    load: tuple[Load, ...] = key("tables", (), of=Load, columns="load{n}_")
    set_aside: tuple[SetAside, ...] = key("tables", (), of=SetAside, columns="set_aside{n}_")
    return_walls: ReturnWalls | None = key("section", of=ReturnWalls, columns="across_")
    solid: tuple[Solid, ...] = key("tables", (), of=Solid, columns="solid{n}_")
    drawing: tuple[Drawing, ...] = key("tables", (), of=Drawing)
    gable_m: float | None = number_key(0.1, 60.0, unit="m", form="body")
    openings: tuple[Opening, ...] = key("tables", (), of=Opening, columns="opening{n}_")
    steps: tuple[Step, ...] = key("tables", (), of=Step, columns="step{n}_")
    out_of_plumb_m: float | None = number_key(0.0, 2.0, unit="m", form_unit="cm", form="body")
    return_wedges: Wedges | None = key("section", of=Wedges, columns="wedges_")
    corner: Corner | None = key("section", of=Corner, columns="corner_")
    leaf: Leaf | None = key("section", of=Leaf, columns="leaf_")
    plan: InPlan | None = key("section", of=InPlan, columns="plan_")
    evidence: tuple[WallEvidence, ...] = key("tables", (), of=WallEvidence, columns="evidence{n}_")
    variant: str | None = choice_key(AS_IS, DESIGNED, default=None, form="held")

    @staticmethod
    def upgrade_keys(table: dict) -> dict:
        """The keys of a wall with the unit weight that is left out, where the table of masonry types has one."""
        masonry = TYPES.get(str(table.get("masonry")))
        if masonry and "unit_weight_kn_m3" not in table and masonry.weight[0] == masonry.weight[1]:
            table = table | {"unit_weight_kn_m3": masonry.weight[0]}
        return table

    @staticmethod
    def with_mechanism(table):
        """The keys of a wall with the mechanism that is left out: one-sided where it leans on something, else
        two-sided; what it may do beside that is found (`core.case.register`)."""
        if not isinstance(table, Mapping) or "mechanism" in table:
            return table
        return {**table, "mechanism": FOUND[leans_on_something(table)]}

    @property
    def title(self) -> str:
        """Name of the wall, with its variant where it has one."""
        return self.name if self.variant is None else f"{self.name} ({self.variant})"

    @property
    def setback(self) -> float:
        """u [m], the hinge inside the edge: as given, or 2 N / (3 f L) with N = unit weight t H L and the vertical
        loads, the triangle of stress under the wall about to turn."""
        if (arch := self._arch()) is not None:
            return arch.setback
        if self.compressive_strength_mpa is None or self.thickness is None:
            return self.hinge_setback_m
        parts, weight = self.parts, require_value(self.unit_weight_kn_m3)
        vertical_force = weight_per_metre(parts, self.length_m, 1e3 * weight, self.thickness, self.height_m)
        if self.load:
            vertical_force += self._vertical_loads()
        if parts:
            whole = base_length(parts, require_value(self.length_m), self.thickness)
            if not whole:
                raise InputError("nothing_at_base", place=(place("wall", name=self.title),), key="solid")
            vertical_force *= require_value(self.length_m) / whole
        return 2.0 * vertical_force / (3.0 * 1e6 * self.compressive_strength_mpa)

    def _vertical_loads(self) -> float:
        """Sum of the vertical loads [N/m]. Raises InputError where one has no size yet."""
        for n, load in enumerate(self.load, start=1):
            if load.is_weight and load.kn_m in (None, ""):
                here = (place("wall", name=self.title), place("load", n=n))
                raise InputError("load_size_missing", place=here, key="kn_m")
        return sum(1e3 * require_value(load.kn_m) for load in self.load if load.is_weight)

    @property
    def weight(self) -> float | None:
        """W [N] of the wall, None without length and unit weight."""
        if self.length_m is None or self.unit_weight_kn_m3 is None or self.thickness is None:
            return None
        weight = 1e3 * self.unit_weight_kn_m3
        return weight_per_metre(self.parts, self.length_m, weight, self.thickness, self.height_m) * self.length_m

    @cached_property
    def in_si(self) -> Masonry:
        """The wall in SI. Raises InputError for a wall without exactly one geometry, TypeError where a load or a part
        of its shape is still to be given."""
        across = self.return_walls
        return Masonry(
            name=self.name,
            mechanism=self.mechanism,
            bare=self.bare_block(),
            height=self.height_m,
            thickness=self.thickness,
            setback=self.setback,
            length=self.length_m,
            unit_weight=None if self.unit_weight_kn_m3 is None else 1e3 * self.unit_weight_kn_m3,
            modulus=None if self.elastic_modulus_mpa is None else 1e6 * self.elastic_modulus_mpa,
            strength=None if self.compressive_strength_mpa is None else 1e6 * self.compressive_strength_mpa,
            kind=self.masonry,
            law=self.moment_law(),
            branch=self.law if isinstance(self.law, str) and self.law in WITH_BRANCH else "",
            bound=any(self._is_bound_by(hold) for hold in self.hold),
            friction=SLIDING if self.base_friction is None else self.base_friction,
            felt=self.demand_height_m,
            parts=self.parts,
            loads=(*(load.in_si for load in self.load), *(tie.tie_in_si(self.length_m) for tie in self.ties)),
            across=None if across is None else across.in_si(),
            arch=self._arch(),
            declared=self._declared(),
            yielded=tuple(hold.yielded for hold in self.hold if isinstance(hold, ShareOfHold) and hold.yielded),
        )

    @property
    def arch(self) -> Hold | None:
        """The cross walls or buttresses between which it spans; None where how far apart they are is not said."""
        return next((hold for hold in self.hold if hold.spans), None)

    @property
    def ties(self) -> tuple[Hold, ...]:
        """The ties that are there, as bars; what holds the top of a stretch between ties is none."""
        return tuple(hold for hold in self.hold if hold.is_tie)

    @property
    def is_loaded(self) -> bool:
        """Whether loads or ties act on it."""
        return bool(self.load) or bool(self.ties)

    @property
    def sought(self) -> Hold | None:
        """The tie that is to be designed."""
        return next((hold for hold in self.hold if hold.design), None)

    @property
    def restraints(self) -> tuple[Hold, ...]:
        """What holds it but ties."""
        return tuple(hold for hold in self.hold if not hold.is_bar)

    @property
    def is_shared_stretch(self) -> bool:
        """Whether it is a stretch of a wall between holds that have a strength for it, or bends inward over them."""
        shares = (hold for hold in self.hold if isinstance(hold, ShareOfHold))
        return any(not hold.is_bar or hold.out_kn_m not in (None, math.inf) for hold in shares)

    @property
    def held_by(self) -> Hold | None:
        """What stands behind it, holds its top or its ends: contact along the wall before what is only in places, and
        of several the first that nothing shows."""
        if self.kinematics.arches:
            return self.arch
        if self.kinematics.bends_up:
            return next((hold for hold in self.hold if self._holds_top(hold)), None)
        behind = [hold for hold in self.hold if hold.is_contact]
        along = [hold for hold in behind if not hold.only_there] or behind
        return next((hold for hold in along if hold.evidence is None), next(iter(along), None))

    def _is_bound_by(self, hold: Hold) -> bool:
        """Whether a hold is shown to tie a wall, over all its height, to what is beside or behind it."""
        ties = hold.is_local or (hold.has_height and hold.is_contact)
        top = hold.h_m if hold.has_height else hold.to_m
        reaches = top is None or self.height_m is None or self.height_m - top <= (self.thickness or 0.0)
        return ties and hold.evidence is not None and reaches and not hold.from_m

    def _holds_top(self, hold: Hold) -> bool:
        height, top = require_value(self.height_m), hold.h_m if hold.has_height else None
        return top is not None and abs(top - height) <= TOP_TOLERANCE * height

    def _declared(self) -> Declared:
        if (hold := self.held_by) is None:
            return Declared(unloaded=self.unloaded_confirmed)
        foot = next((foot for foot in self.hold if foot.h_m == 0.0 and foot.out_kn_m is not None), None)
        named = foot is not None and math.isfinite(require_value(foot.out_kn_m))
        return Declared(
            *_named(hold),
            self.unloaded_confirmed,
            None if hold.out_kn_m is None else 1e3 * hold.out_kn_m,
            1e3 * hold.beside_kn_m if isinstance(hold, ShareOfHold) else 0.0,
            None if foot is None else 1e3 * require_value(foot.out_kn_m),
            None if hold.in_kn_m is None else 1e3 * hold.in_kn_m,
            hold.elongation_m,
            hold.rocking if isinstance(hold, ShareOfHold) else None,
            hold.stub if isinstance(hold, ShareOfHold) else None,
            None if hold.stiffness_kn_m2 is None else 1e3 * hold.stiffness_kn_m2,
            Declared(*_named(foot)) if named and foot is not None else None,
        )

    def _arch(self) -> Arch | None:
        """The arch of a wall that spans between transverse walls; None of another one. Raises InputError where it lacks
        something."""
        if not self.kinematics.arches:
            return None
        here = (place("wall", name=self.name),)
        if self.arch is None:
            raise InputError("arch_missing", place=here, key="spacing_m", arch=Key("[[wall.hold]]"))
        height, thickness = self.height_m, self.thickness
        weight, strength = self.unit_weight_kn_m3, self.compressive_strength_mpa
        if height is None or thickness is None or weight is None or strength is None:
            given = {"height_m": height, "thickness_m": thickness, "unit_weight_kn_m3": weight}
            key = next((key for key, value in given.items() if value is None), "compressive_strength_mpa")
            raise InputError("arch_needs", place=here, key=key, arch=Key("spacing_m"))
        thrust = sum(1e3 * abs(require_value(load.kn_m)) for load in self.load if load.is_thrust)
        presses = thrust * require_value(self.arch.spacing_m) / spread_over(height)
        return self.arch.arch_in_si(height, thickness, 1e3 * weight, 1e6 * strength, presses)

    @cached_property
    def as_json(self) -> str:
        """Keys and values, for the digest of its case."""
        return json.dumps(section_to_dict(self), sort_keys=True)

    def without_ties(self) -> "Wall":
        """The wall with its other holds alone."""
        return replace(self, hold=tuple(hold for hold in self.hold if not hold.is_tie))

    def without_sought(self) -> "Wall":
        """The wall without the tie that is to be designed."""
        return replace(self, hold=tuple(hold for hold in self.hold if not hold.design))

    def block(self) -> Block:
        """The wall and the masses that move with it. Raises InputError as `in_si`."""
        return self.in_si.block

    def bare_block(self) -> Block:
        """The wall alone. Raises InputError for a wall without exactly one geometry."""
        here = (place("wall", name=self.name),)
        shape = ("thickness_m", "slenderness_deg", "height_over_thickness")
        given = [key for key in shape if getattr(self, key) is not None]
        if self.radius_m is not None or self.inertia_over_mass_m2 is not None:
            if self.hinge_setback_m or self.compressive_strength_mpa is not None:
                raise InputError("general_no_setback", place=here)
            if self.slenderness_deg is None or len(given) > 1 or self.height_m is not None or self.has_shape:
                raise InputError("general_keys", place=here)
            if self.radius_m is None or self.inertia_over_mass_m2 is None:
                raise InputError("general_needs", place=here)
            if self.inertia_over_mass_m2 > MAX_INERTIA * self.radius_m**2:
                raise InputError(
                    "inertia_too_large",
                    place=here,
                    key="inertia_over_mass_m2",
                    given=self.inertia_over_mass_m2,
                    most=MAX_INERTIA * self.radius_m**2,
                    ratio=MAX_INERTIA,
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
        if self.parts:
            body = sum_of(self.parts)
            if not body.mass > 0.0:
                raise InputError("body_without_mass", place=here)
            return body.about(setback)
        if setback == 0.0 and self.slenderness_deg is not None:
            return Block.rectangle(self.height_m, math.radians(self.slenderness_deg))
        return Block.with_setback(self.height_m, thickness, setback)

    @property
    def has_closed_forms(self) -> bool:
        """Whether Eq. 15 and 16 say anything of it: fitted to walls on the ground without loads; of a body by the
        rectangle of the same p and alpha."""
        bare = not self.is_loaded and not self.bends
        return not self.above_ground and bare and not (self.is_asymmetric and self.kinematics.rocks_both_ways)

    @property
    def is_asymmetric(self) -> bool:
        """Whether it is another block about its inner hinge."""
        return self.in_si.inner_block is not None

    @property
    def above_ground(self) -> bool:
        """Whether what moves it is above the ground; with a demand its height is always given."""
        return (self.demand_height_m or 0.0) > 0.0

    @property
    def demand_height_m(self) -> float | None:
        """Height above the ground [m] at which its demand is taken: of its hinge, of a wall held at its top of its
        middle, of one that spans between transverse walls of its top; None where it is not given."""
        if self.base_z_m is None or not self.bends:
            return self.base_z_m
        return self.base_z_m + self.kinematics.demand_at * (self.height_m or 0.0)

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

    @property
    def bends(self) -> bool:
        """Whether it is held at its top, or at both ends, and opens a hinge between."""
        return self.kinematics.bends

    @property
    def leans(self) -> bool:
        """Whether it may overturn to one side alone: something stands behind it."""
        return self.kinematics.turns_one_way

    def mechanisms(self) -> tuple[str, ...]:
        return self.kinematics.stands_for or (self.mechanism,)

    def restitution_model(self, mechanism: str) -> str:
        """Model of restitution for one mechanism: as asked, else the default that follows the mechanism."""
        model = self.restitution or ("user" if self.velocity_ratio is not None else None)
        return model or kinematics(mechanism).restitution

    def restitution_of(self, mechanism: str) -> Restitution:
        """Restitution for one mechanism."""
        model = self.restitution_model(mechanism)
        if MODELS[model].one_sided and kinematics(mechanism).both_ways:
            raise InputError(
                "restitution_one_sided", model=model, asked=self.mechanism, place=(place("wall", name=self.name),)
            )
        if (model == "user") != (self.velocity_ratio is not None):
            raise InputError("velocity_ratio_user", place=(place("wall", name=self.name),))
        return restitution(self.in_si.block, model, self.velocity_ratio, self.in_si.contact)

    def moment_law(self) -> MomentLaw:
        """Moment law as it is given; an elastic branch belongs to the check at the demand alone."""
        if isinstance(self.law, str):
            return LAWS["rigid" if self.law in WITH_BRANCH else self.law]
        return MomentLaw(self.law["elastic_limit"], self.law["plateau_end"])


def find_mechanism(wall: Wall, walls: Iterable[Wall]) -> str:
    """The mechanism of a wall of a case that has none chosen: what it or its variant leans on says it. walls : of the
    case"""
    variants = (variant for variant in walls if variant.name == wall.name)
    return FOUND[any(hold.is_contact for variant in variants for hold in variant.hold)]


def _named(hold: Hold) -> tuple[str, str | None, str]:
    """Kind of a hold, kind of the document that shows it, and what the engineer says of both."""
    shown = hold.evidence
    names = (hold.name, *((shown.reference, shown.note) if shown else ()))
    return hold.kind, shown.kind if shown else None, ", ".join(filter(None, names))
