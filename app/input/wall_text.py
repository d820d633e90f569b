"""What the form says of a wall from its case and from the last result."""

import contextlib
import math
from collections.abc import Callable
from typing import Any

from app.input.hinges_field import hinge_words
from app.input.impact_form import named_laws, named_models
from app.look.language import current_language, number, result_word, tr, variant_word
from app.work.session import Session
from core.capacity.scale_free_law import estimates
from core.case.floor_loads import add_corner_thrust, add_floor_loads
from core.case.hinges import hinges_of
from core.case.hold import Hold
from core.case.keys import unit_in_form
from core.case.loads import Load
from core.case.rules import TESTED_STRENGTH
from core.case.schema import Case
from core.case.values import field_of
from core.case.variant_names import AS_IS, DESIGNED
from core.case.wall import Wall
from core.codes.target_spectrum import velocity_integral
from core.errors import InputError
from core.report.verdict_words import tone_of
from core.setting.demand_input import read_demand
from core.study import wall_result
from core.study.variants import changed_keys
from core.study.wall_verdict import zeta_by_hinge
from core.text.sentence import capital, choice, notice
from core.wall.block import Block
from core.wall.kinematics import kinematics

OF_ONE = "law_of_a_set", "law_of_one_record"
"""What is said of q alone."""


def estimate_lines(session: Session, wall: Wall) -> list[str]:
    """A first answer without records: q of Ribalta's law at the demand, where its spectrum is given."""
    case = session.case
    try:
        demand = read_demand(case, session.base_dir) if case.demand else None
        if demand is None or demand.target is None or not wall.has_closed_forms or not wall.mechanism:
            return []
        answers = [
            estimates(
                wall.block(),
                wall.restitution_of(mechanism),
                wall.moment_law(),
                kinematics(mechanism).one_way,
                velocity_integral(demand.target),
                demand.pga,
            )
            for mechanism in wall.mechanisms()
        ]
    except (InputError, TypeError, KeyError):
        return []  # the form says elsewhere what is missing
    lines = []
    for mechanism, answer in zip(wall.mechanisms(), answers, strict=True):
        for one, slv in [answer] if answer else []:
            values = {"q": one.q, "q_slv": slv.q}
            line = tr(
                "Research, no records, {kind}: q {q:.1f}, q SLV {q_slv:.1f}", kind=result_word(mechanism), **values
            )
            ranges = [*one.ranges[:2], *(said for said in slv.ranges if said.code not in OF_ONE)]
            lines.append(", ".join([line, *(said.text(current_language()) for said in ranges)]))
    return lines


def hinge_zetas(session: Session, k: int) -> list[tuple[float, float | None]]:
    """Every hinge of the k-th wall above its base [m], with the zeta by which the run judges it, None without one."""
    case, result = session.case, None if session.stale else session.result
    found: dict[float, float | None] = {}
    if result is not None and (own := next((wall for wall in result.walls if wall.part.origin == k), None)) is not None:
        found = dict(zeta_by_hinge(result, own))
    try:
        heights = [0.0, *hinges_of(case.wall[k], case.building)]
        return [(hinge, found.get(hinge)) for hinge in heights] if len(heights) > 1 else []
    except (InputError, TypeError, ZeroDivisionError):  # work in progress
        return []


def deciding_hinge(session: Session, k: int) -> tuple[float, str] | None:
    """Height above the base of the k-th wall of the hinge that decides about it [m], and the tone of its outcome; None
    without a run, and where the wall bends."""
    result = None if session.stale else session.result
    for verdict in result.verdicts if result else ():
        wall = result.walls[verdict.governing] if result else None
        if result is not None and wall is not None and wall.part.origin == k:
            return (wall.part.hinge, tone_of(result, wall)) if wall.part.turns else None
    return None


SHAPE_KEYS = ("height_m", "thickness_m", "slenderness_deg", "height_over_thickness", "radius_m", "inertia_over_mass_m2")
"""Keys of which some give the shape of a wall."""


ASKED_AT = {
    "thin": "thickness_m",
    "slender": "height_m",
    "odd_weight": "unit_weight_kn_m3",
    "odd_modulus": "elastic_modulus_mpa",
    "odd_strength": "compressive_strength_mpa",
    "heavy_load": "kn_m",
    "unlike_masonry": "masonry",
}
"""Question on an unusual value of a wall -> key at whose field it stands."""


def input_questions(wall: Wall) -> dict[str, str]:
    """Key -> what is asked of its value, few engineers mean one like it; as with the result, and while it is typed."""
    asked = []
    with contextlib.suppress(InputError, TypeError, ZeroDivisionError):  # work in progress
        asked += wall_result.unusual_input(wall)
    (low, high), strength = TESTED_STRENGTH, wall.compressive_strength_mpa
    if strength is not None and not low <= strength <= high:
        asked.append(notice("odd_strength", f=strength, low=low, high=high))
    return {ASKED_AT[one.code]: one.text(current_language()) for one in asked}


def shape_of(wall: Wall) -> str:
    """How the shape is given: "general" by R and I0/m, else the key beside the height."""
    if wall.radius_m is not None or wall.inertia_over_mass_m2 is not None:
        return "general"
    keys = ("slenderness_deg", "height_over_thickness")
    return next((key for key in keys if getattr(wall, key) is not None), "thickness_m")


def convert_shape_keys(shape: str, wall: Wall, block: Block) -> dict[str, float | None]:
    """Values of the keys that give the block of a wall in another way. shape : as of `shape_of`"""
    values: dict[str, float | None] = dict.fromkeys(SHAPE_KEYS)
    if shape == "general":
        return values | {
            "radius_m": block.radius,
            "inertia_over_mass_m2": block.inertia_over_mass,
            "slenderness_deg": math.degrees(block.slenderness),
            "hinge_setback_m": 0.0,
        }
    height, thickness = wall.height_m or block.height, wall.thickness or block.thickness
    given = {
        "thickness_m": thickness,
        "slenderness_deg": math.degrees(math.atan2(thickness, height)),
        "height_over_thickness": height / thickness,
    }
    own = {"height_m": height, "hinge_setback_m": wall.hinge_setback_m, shape: getattr(wall, shape) or given[shape]}
    return values | own


def unused_history_sections(wall: Wall) -> dict[str, bool]:
    """Sections of the form that a wall held at its top has no use for -> whether something stands there."""
    return {
        "held": wall.return_walls is not None,
        "hinges": wall.hinge_heights is not None,
        "impact": wall.restitution is not None or wall.velocity_ratio is not None or wall.law != "auto",
    }


def load_kind_text(load: Load) -> str:
    """Kind of a load in words; of a draft it may still be to be given."""
    return choice(load.kind, current_language()) if load.kind else "–"


def _load_words(load: Load) -> str:
    size = f" {number(load.kn_m, 'g')} kN/m" if load.kn_m else ""
    return load_kind_text(load) + size


def _hold_words(hold: Hold) -> str:
    """A hold in a few words."""
    size = f" {number(hold.out_kn_m, 'g')} kN/m" if isinstance(hold.out_kn_m, float) else ""
    return (choice(hold.kind, current_language()) if hold.kind else "–") + size


ENTRY_WORDS: dict[str, Callable[[Any], str]] = {"load": _load_words, "hold": _hold_words}
"""Key of the loads or of the holds of a wall -> one of them in a few words."""


def differences(case: Case, wall: Wall) -> list[str]:
    """What is another in a variant than in the wall as it is, a line for each key; empty of any other wall."""
    before = next((one for one in case.wall if one.name == wall.name and one.variant == AS_IS), None)
    if wall.variant != DESIGNED or before is None:
        return []
    lines = []
    for key in changed_keys(before, wall):
        entry, old, new = field_of(Wall, key), getattr(before, key), getattr(wall, key)
        words = result_word(f"key_{key}")
        if entry.metadata["kind"] == "float":
            unit, factor = unit_in_form(entry)
            ends = (number(one if one is None else factor * one, ".4g") for one in (old, new))
            words += f" {' → '.join(ends)} {unit}".rstrip()
        elif key in ENTRY_WORDS:
            signed = [("+", one) for one in new if one not in old] + [("−", one) for one in old if one not in new]
            words += " " + ", ".join(f"{sign} {ENTRY_WORDS[key](one)}" for sign, one in signed)
        elif entry.metadata["kind"] == "choice":
            words += f" {' → '.join(choice(one, current_language()) if one else '–' for one in (old, new))}"
        lines.append(words)
    return lines


def add_building_loads(case: Case, wall: Wall | None) -> Wall | None:
    """A wall with what its building brings to it, where that is complete."""
    try:
        return None if wall is None else add_corner_thrust(add_floor_loads(wall, case.building))
    except TypeError:  # still to be given
        return wall


def shape_words(wall: Wall) -> list[str]:
    """What makes a wall another shape than a rectangle."""
    forms = [] if wall.gable_m is None else [tr("gable {z} m", z=number(wall.gable_m, "g"))]
    if wall.out_of_plumb_m:
        forms.append(tr("out of plumb {f} cm", f=number(100.0 * wall.out_of_plumb_m, "g")))
    for key, one, many in (
        ("openings", tr("1 opening"), tr("{n} openings", n=len(wall.openings))),
        ("steps", tr("1 step"), tr("{n} steps", n=len(wall.steps))),
        ("solid", tr("1 solid"), tr("{n} solids", n=len(wall.solid))),
    ):
        if count := len(getattr(wall, key)):
            forms.append(one if count == 1 else many)
    if wall.corner is not None:
        forms.append(tr("corner"))
    if wall.return_wedges is not None:
        forms.append(tr("wedges"))
    if wall.leaf is not None and wall.leaf.thickness_m:
        forms.append(tr("leaf {t} cm", t=number(100.0 * wall.leaf.thickness_m, "g")))
    return forms


def contents_of(wall: Wall) -> dict[str, str]:
    """What each section of the form of a wall holds, in a few words."""
    height = "" if not wall.height_m else f"H {number(wall.height_m, 'g')} m"
    try:
        thickness = f"t {number(100.0 * wall.thickness, '.3g')} cm" if wall.thickness else ""
    except TypeError:  # still to be given
        thickness = ""
    base = "" if wall.base_z_m is None else tr("base {z} m", z=number(wall.base_z_m, "g"))
    kinds = [load_kind_text(load) for load in wall.load]
    carries = [f"{kinds.count(kind)} × {kind}" for kind in dict.fromkeys(kinds)]
    kinds_held = dict.fromkeys(hold.kind for hold in wall.hold if hold.kind)
    law = named_laws().get(wall.law if isinstance(wall.law, str) else "own", "")
    ratio = tr("default of the mechanism") if wall.restitution is None and wall.velocity_ratio is None else ""
    if wall.velocity_ratio is not None:
        ratio = f"e {number(wall.velocity_ratio, 'g')}"
    weight = wall.unit_weight_kn_m3
    notes = ["" if weight is None else f"{number(weight, 'g')} kN/m³", variant_word(wall.variant), wall.notes]
    hinges = wall.hinge_heights
    return {
        "geometry": ", ".join(filter(None, (height, thickness))),
        "body": ", ".join(shape_words(wall)) or tr("rectangle"),
        "mechanism": ", ".join(filter(None, (result_word(wall.mechanism) if wall.mechanism else "", base))),
        "holds": ", ".join(capital(choice(kind, current_language())) for kind in kinds_held) or tr("nothing"),
        "loads": ", ".join(carries) or (tr("nothing, confirmed") if wall.unloaded_confirmed else tr("nothing")),
        "held": tr("friction of return walls") if wall.return_walls is not None else tr("none"),
        "hinges": tr("usual")
        if hinges is None
        else hinge_words()[hinges]
        if isinstance(hinges, str)
        else "; ".join(number(hinge, "g") for hinge in hinges),
        "impact": f"{ratio or named_models().get(wall.restitution)}, {law}",
        "notes": ", ".join(filter(None, notes)),
    }
