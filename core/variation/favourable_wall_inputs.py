"""The inputs of a case that raise zeta."""

import contextlib
import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from core.case.document import document_of
from core.case.site import FULL_FACTOR
from core.case.wall import Wall
from core.codes.assumption import DEFAULT, GIVEN
from core.codes.elastic_branch import ELASTIC, can_have_branch
from core.codes.limits import MIN_STATIONS_FOR_MINIMUM
from core.codes.masonry_types import least_strength, moduli, weights
from core.codes.verdict_sentence import CODE_Q
from core.errors import InputError
from core.ground.scattered import SPREAD
from core.known import require_value
from core.setting import demand_input
from core.setting.check_input import CheckInput
from core.setting.demand_input import find_generation_settings
from core.text.sentence import Number, sentence
from core.variation.evaluate import Evaluation
from core.variation.favourable_input import (
    GIVEN_WORD,
    NONE_WORD,
    Alternative,
    FavourableInput,
    SceneChange,
    demand_change,
    single_alternative,
    wall_change,
)
from core.variation.favourable_loads import favourable_ties_and_forces, favourable_weights
from core.variation.favourable_site import favourable_building, favourable_demand
from core.wall.kinematics import kinematics
from core.wall.masonry import is_stable
from core.wall.restitution import MODELS
from core.wall.solids import clipped

CORNER_ANGLES = 20.0, 70.0
"""Directions, from its first wall in plan, in which a corner is looked at too [deg]."""

MAX_RESTRAINT_SHARE = 0.999
"""Height of the restraint, of the top of the body, below which what it lifts is shown."""


RECTANGLE_INERTIA = 4.0 / 3.0
"""I_0/m over R^2 of a rectangle."""

MIN_SETBACK = 0.01
"""Hinge setback [m] of any masonry: its edge is not sharp."""


MIN_SPREAD_SHARE = 0.5
"""Share of the spread of natural motions about a spectrum below which given records are said to be too much alike."""

RATIO_INCREMENT = 0.1
"""Added to a given velocity ratio: its zeta is shown as well."""


def favourable_inputs(evaluation: Evaluation) -> Iterator[FavourableInput]:
    """Inputs of the case that raise zeta."""
    scene, q_check = evaluation.scene, evaluation.made("linear_q_code")
    wall, demand, asked = scene.wall, scene.demand, scene.asked
    model, dynamic = wall.restitution_model(scene.mechanism), evaluation.dynamic is not None
    if dynamic and not MODELS[model].by_theory:
        given = wall.restitution_of(scene.mechanism).ratio_at_rest
        more = min(given + RATIO_INCREMENT, 1.0)
        key = "velocity_ratio" if model == "user" else "restitution"
        ratio = replace(wall, restitution=None, velocity_ratio=None).restitution_of(scene.mechanism).ratio_at_rest
        ends = (
            Alternative(wall_change(restitution=None, velocity_ratio=more), more),
            Alternative(wall_change(restitution=None, velocity_ratio=None), ratio),
        )
        yield FavourableInput(
            "lift_velocity_ratio",
            key,
            wall.evidence,
            given,
            ends,
            lambda zetas, _: sentence(
                "reason",
                "lift_velocity_ratio",
                e=given,
                more=more,
                zeta_more=Number(zetas[0]),
                theory=ratio,
                zeta_theory=Number(zetas[1]),
            ),
            each_written=True,
        )
    if dynamic:
        yield from _of_the_law(evaluation)
    if demand.confidence_factor < FULL_FACTOR:
        yield single_alternative(
            "confidence_factor",
            "lift_confidence_factor",
            asked.evidence,
            demand.confidence_factor,
            Alternative(demand_change(confidence_factor=FULL_FACTOR), FULL_FACTOR),
            fc=demand.confidence_factor,
            level=asked.knowledge_level or "",
        )
    if q_check is not None and q_check.q is not None and q_check.q > CODE_Q:
        end = Alternative(demand_change(q_code=CODE_Q), CODE_Q)
        reasons = asked.evidence
        yield single_alternative("q_code", "lift_q_code", reasons, demand.q_code, end, histories=False, q=demand.q_code)
    if wall.return_walls is not None and q_check is not None:
        end = Alternative(wall_change(return_walls=None), NONE_WORD)
        yield single_alternative("return_walls", "lift_return_walls", wall.evidence, GIVEN_WORD, end, histories=False)
    yield from favourable_demand(scene)
    yield from _of_the_set(evaluation)
    yield from favourable_ties_and_forces(scene, not dynamic)
    yield from favourable_weights(scene)
    yield from _of_the_shape(wall, scene.mechanism)
    yield from _of_the_body(scene)
    yield from _of_the_edge(scene)
    yield from _unlike_weights(wall)
    yield from _odd_weight(wall)
    if wall.above_ground and scene.building is not None:
        yield from favourable_building(scene, scene.building)


def _of_the_set(evaluation: Evaluation) -> Iterator[FavourableInput]:
    """A generated set that scatters less than nature does."""
    scene = evaluation.scene
    if scene.by_default or not evaluation.satisfied:
        return
    asked = find_generation_settings(scene.ground)
    if asked is None or asked.count < len(scene.ground):
        yield from _of_records_alike(scene)
    if asked is None:
        return
    if asked.scatter < SPREAD:
        natural = replace(asked, scatter=SPREAD)
        end, reasons = Alternative(lambda scene: scene.regenerate_motions(natural), SPREAD), scene.asked.evidence
        yield single_alternative("scatter", "lift_scatter", reasons, asked.scatter, end, given=asked.scatter)


def _of_records_alike(scene: CheckInput) -> Iterator[FavourableInput]:
    """Given records that all but follow the spectrum, as matched ones do, whatever their files are called."""
    seen = scene.compliance
    if seen is None or len(seen.spectra) < MIN_STATIONS_FOR_MINIMUM:
        return
    spread = float(np.log(seen.spectra).std(axis=0, ddof=1).mean())
    if spread < MIN_SPREAD_SHARE * SPREAD:
        reasons = scene.asked.evidence
        end = Alternative(lambda scene: scene.regenerate_motions(demand_input.DEFAULT_SET), SPREAD)
        yield single_alternative("scatter", "lift_alike", reasons, spread, end, given=spread, usual=SPREAD)


def _of_the_law(evaluation: Evaluation) -> Iterator[FavourableInput]:
    """Inputs of the moment law that raise zeta: a trilinear law, and a rigid law in place of the branch of
    an element free to vibrate."""
    scene, wall = evaluation.scene, evaluation.scene.wall
    if not wall.moment_law().is_rigid:
        end = Alternative(wall_change(law="rigid"), "rigid")
        yield single_alternative("law", "lift_law", wall.evidence, _law_named(wall.law), end)
    given = wall.law == "rigid" and wall.in_si.is_free(scene.mechanism) and evaluation.satisfied
    if given and can_have_branch(wall.in_si, scene.mechanism):  # a wall that fails without it is not asked
        end = Alternative(wall_change(law=ELASTIC), sentence("word", "with_branch"))
        yield single_alternative("law", "lift_rigid", wall.evidence, sentence("word", "choice_rigid"), end)


def _of_the_edge(scene: CheckInput) -> Iterator[FavourableInput]:
    """A hinge nearer to the edge than the weakest masonry of its type lets it be, or than MIN_SETBACK: FC 1.35 lets
    one leave the strength out (C8.7.1.2.1.3), and alpha_0 then counts on more than there is."""
    wall = scene.wall
    if wall.kinematics.arches:
        yield from _of_the_hinges(scene)
        return
    weakest, least = least_strength(wall.masonry), setback_at(wall, wall.masonry)
    if wall.setback >= least * (1.0 - 1e-9):
        return
    there = turning_inside(wall, least)
    f, cm = wall.compressive_strength_mpa, 100.0 * least
    if f is None:
        source = GIVEN if wall.hinge_setback_m else DEFAULT
        given, end = wall.hinge_setback_m, Alternative(there, least)
        said = {"given": 100.0 * given, "cm": cm, "f": weakest}
        code = "lift_edge" if wall.thickness is not None else "lift_edge_of_body"
        # the clause permits a hinge nearer to the edge, and no masonry that its weight crushes through
        stands = wall.thickness is None or (least < 0.5 * wall.thickness and _stands_at(wall, least))
        yield single_alternative("hinge_setback_m", code, None, given, end, source, permitted=stands, **said)
    elif f > weakest:
        tested = scene.demand.confidence_factor < FULL_FACTOR  # then the strength is that of tests, as it must be
        shown = document_of(wall.evidence, "compressive_strength_mpa")
        shown = shown or (document_of(scene.asked.evidence, "confidence_factor") if tested else None)
        end = Alternative(there, weakest)
        yield single_alternative("compressive_strength_mpa", "lift_strength", shown, f, end, given=f, f=weakest, cm=cm)


def _of_the_hinges(scene: CheckInput) -> Iterator[FavourableInput]:
    """A strength above the lowest of its masonry, by which the hinges of an arch lie nearer to the faces and its ends
    are crushed by a larger thrust."""
    wall = scene.wall
    f, weakest = require_value(wall.compressive_strength_mpa), least_strength(wall.masonry)
    if f <= weakest:
        return
    there = require_value(replace(wall, compressive_strength_mpa=weakest).in_si.arch)
    end = Alternative(wall_change(compressive_strength_mpa=weakest), weakest)
    said = {"given": f, "f": weakest, "cm": 100.0 * there.setback}
    yield single_alternative("compressive_strength_mpa", "lift_strength", wall.evidence, f, end, **said)


def setback_at(wall: Wall, masonry: str | None) -> float:
    """Hinge setback [m] by the lowest f of a masonry and, where it is not given, its greatest unit weight, of the table
    where none is named; MIN_SETBACK at least."""
    weight = wall.unit_weight_kn_m3 or weights(masonry)[1]
    if wall.thickness is None:
        block = wall.block()
        area = 2.0 * block.radius**2 * math.sin(2.0 * block.slenderness)  # t H
        return max(MIN_SETBACK, 2e3 * weight * area / (3e6 * least_strength(masonry)))
    weighed = replace(wall, unit_weight_kn_m3=weight, hinge_setback_m=0.0)
    with contextlib.suppress(InputError):  # nothing stands just above the base of oblique solids
        return max(MIN_SETBACK, replace(weighed, compressive_strength_mpa=least_strength(masonry)).setback)
    return MIN_SETBACK


def turning_inside(given: Wall, setback: float, **values: Any) -> SceneChange:
    """The hinge at least so far inside the edge [m], whatever else has moved it. given : the wall as it is"""

    def change(scene: CheckInput) -> CheckInput:
        wall = scene.wall
        there = _hinge_at(given, setback)
        slender = there.get("slenderness_deg")
        nearer = wall.setback < setback if slender is None else slender < (wall.slenderness_deg or 0.0)
        return scene.replace_parts(wall=replace(wall, **values, **(there if nearer else {})))

    return change


def _stands_at(wall: Wall, setback: float) -> bool:
    """Whether a wall stands at rest about a hinge so far inside the edge [m]: a lean may bring its weight beyond it."""
    try:
        moved = replace(wall, **_hinge_at(wall, setback)).in_si
        return is_stable(moved.block, moved.restoring[0])
    except InputError:
        return False


def _hinge_at(wall: Wall, setback: float) -> dict[str, Any]:
    """The keys of a wall with its hinge so far [m] inside the edge; a body given by its radius turns about another
    point, of the same centroid."""
    if wall.thickness is not None:
        return {"compressive_strength_mpa": None, "hinge_setback_m": setback}
    block = wall.block()
    assert wall.radius_m is not None and wall.inertia_over_mass_m2 is not None
    x, z = block.radius * math.sin(block.slenderness) - setback, block.radius * math.cos(block.slenderness)
    radius = math.hypot(x, z)
    inertia = wall.inertia_over_mass_m2 - wall.radius_m**2 + radius**2
    return {"radius_m": radius, "slenderness_deg": math.degrees(math.atan2(x, z)), "inertia_over_mass_m2": inertia}


def _unlike_weights(wall: Wall) -> Iterator[FavourableInput]:
    """Solids of unlike weight: lighter outside, heavier inside, the weights alone move the centroid."""
    given = wall.unit_weight_kn_m3
    own = [solid.unit_weight_kn_m3 for solid in wall.solid if solid.unit_weight_kn_m3 is not None]
    if any(weight != given for weight in own):
        even = own[0] if given is None else given
        solids = tuple(replace(solid, unit_weight_kn_m3=None) for solid in wall.solid)
        end = Alternative(wall_change(solid=solids, unit_weight_kn_m3=even), even)
        value = sentence("word", "of_solids")
        yield single_alternative("unit_weight_kn_m3", "lift_solid_weight", wall.evidence, value, end, even=even)


def _odd_weight(wall: Wall) -> Iterator[FavourableInput]:
    """A unit weight that no masonry of its type has, beside loads that it holds or that hold it."""
    given, (low, high) = wall.unit_weight_kn_m3, weights(wall.masonry)
    if given is None or low <= given <= high or not (wall.is_loaded or wall.kinematics.arches):
        return
    solids = tuple(replace(solid, unit_weight_kn_m3=None) for solid in wall.solid)
    ends = tuple(
        Alternative(wall_change(unit_weight_kn_m3=value, solid=solids), value) for value in dict.fromkeys((low, high))
    )
    yield FavourableInput("lift_unit_weight", "unit_weight_kn_m3", wall.evidence, given, ends)


def _of_the_shape(wall: Wall, mechanism: str) -> Iterator[FavourableInput]:
    """Inputs of the shape that raise zeta: what a body drags along behind its base, and a restraint that it meets below
    its top."""
    if not wall.has_shape:
        return
    assert wall.thickness is not None and wall.height_m is not None
    parts = wall.parts
    if (corner := wall.corner) is not None:
        steep = replace(corner, length_1_m=0.5 * corner.length_1_m, length_2_m=0.5 * corner.length_2_m)
        turned = [(replace(corner, angle_deg=angle), Number(angle, ".0f")) for angle in CORNER_ANGLES]
        ends = (
            Alternative(wall_change(corner=steep), sentence("word", "half_as_long")),
            *(
                Alternative(wall_change(corner=one), sentence("word", "turning_at", angle=angle))
                for one, angle in turned
            ),
        )
        yield FavourableInput("lift_corner", "corner", wall.evidence, GIVEN_WORD, ends)
        return
    kept = [clipped(part, wall.thickness) for part in parts]
    if any(kept) and any(one is not part for one, part in zip(kept, parts, strict=True)):
        left = zip(wall.solid, kept, strict=False)  # the wedges come last
        solids = tuple(
            replace(solid, polygon_m=one.polygon, from_m=one.ends[0], to_m=one.ends[1]) for solid, one in left if one
        )
        end = Alternative(wall_change(return_wedges=None, solid=solids), NONE_WORD)
        yield single_alternative("return_wedges", "lift_return_wedges", wall.evidence, GIVEN_WORD, end)
    top = require_value(wall.top)
    if (
        kinematics(mechanism).one_way
        and MODELS[wall.restitution_model(mechanism)].one_sided
        and wall.height_m < MAX_RESTRAINT_SHARE * top
    ):
        end = Alternative(wall_change(height_m=top), top)
        yield single_alternative("contact", "lift_contact", wall.evidence, wall.height_m, end, h=wall.height_m, top=top)


def _of_the_body(scene: CheckInput) -> Iterator[FavourableInput]:
    """Inputs of the body that raise zeta: a moment of inertia above that of a slender rectangle, and a modulus above
    the lowest of the masonry."""
    wall = scene.wall
    given, radius = wall.inertia_over_mass_m2, wall.radius_m
    if given is not None and radius is not None and given > RECTANGLE_INERTIA * radius**2 * (1.0 + 1e-9):
        end = Alternative(
            wall_change(inertia_over_mass_m2=RECTANGLE_INERTIA * radius**2), RECTANGLE_INERTIA * radius**2
        )
        yield single_alternative(
            "inertia_over_mass_m2", "lift_inertia", wall.evidence, given, end, given=given, least=end.value
        )
    modulus, (least, most) = wall.elastic_modulus_mpa, moduli(wall.masonry)
    if modulus is not None and wall.in_si.is_free(scene.mechanism) and modulus > most:
        end = Alternative(wall_change(elastic_modulus_mpa=least), least)
        said = {"given": modulus, "least": least, "most": most}
        yield single_alternative("elastic_modulus_mpa", "lift_modulus", wall.evidence, modulus, end, **said)


def _law_named(law: str | dict) -> str:
    """A trilinear law as the table of assumptions shows it."""
    return law if isinstance(law, str) else f"D1 {law['elastic_limit']:g}, D2 {law['plateau_end']:g}"
