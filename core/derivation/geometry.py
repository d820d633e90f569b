"""The block of a wall as lines of a calculation: sizes, solids, loads, uplift, velocity ratio."""

import math

from core.derivation import arch, bending, body
from core.derivation.line import FULL, INPUT, LIVE, RUN, SYMBOLS, VALUE, Columns, Line, Section, Word
from core.derivation.quantity import Given
from core.known import require_value
from core.study.results import WallResult
from core.units import G
from core.wall.block import Block
from core.wall.masonry import load_to_force
from core.wall.restitution import MODELS, housner_ratio, one_sided_ratio
from core.wall.rocking_model import seen_from
from core.wall.solids import Part


def governing_side(wall: WallResult) -> float:
    """The hinge the formulas are written about: 1.0 the outer one, -1.0 the inner one where that is the weaker."""
    outer, inner = (
        seen.restoring.sine * math.tan(seen.slenderness) + seen.restoring.cosine
        for seen in (wall.model, seen_from(wall.model, -1.0))
    )
    return -1.0 if not wall.model.one_sided and inner < outer else 1.0


def shown_block(wall: WallResult) -> Block:
    """The block about the hinge the formulas are written about."""
    return wall.block if governing_side(wall) > 0.0 else wall.wall.in_si.inner_block or wall.block


def geometry(wall: WallResult) -> Section:
    """Section of the block: sizes, slenderness, radius, frequency parameter, uplift, velocity ratio."""
    asked, block = wall.wall, shown_block(wall)
    if asked.kinematics.arches:
        return arch.geometry(wall)
    if asked.bends:
        return bending.geometry(wall)
    by_sizes = asked.height_m is not None and (asked.slenderness_deg is None or asked.setback > 0.0)
    lines: list[Line | Columns] = []
    if asked.is_loaded:
        lines = _loaded(wall)
    elif asked.parts:
        lines = _body(wall)
        lines += [
            Line(body.slenderness_of_body, math.degrees(block.slenderness), note=SYMBOLS),
            Line(body.radius_of_body, block.radius, note=SYMBOLS),
            Line(body.inertia_of_body, block.inertia_over_mass),
            Line(body.equivalent_height, block.height),
            Line(body.p, block.frequency_parameter, note=SYMBOLS),
            _uplift(body.a_rm, block.threshold_acceleration / G),
        ]
    else:
        lines = _sizes(wall) if block.is_rectangle or (asked.height_m and asked.setback) else []
        alpha, degrees = body.SLENDERNESS, math.degrees(block.slenderness)
        if asked.height_m and asked.setback:
            alpha = body.slenderness_with_setback
        elif block.is_rectangle and by_sizes:
            alpha = body.slenderness_of_sizes
        given = alpha is body.SLENDERNESS
        lines.append(
            Line(alpha, degrees, INPUT if given else LIVE, VALUE if given else FULL, "as given" if given else "")
        )
        if block.is_rectangle:
            lines.append(Line(body.radius_of_rectangle, block.radius, note=FULL))
        elif asked.height_m and asked.setback:
            lines.append(Line(body.radius_with_setback, block.radius, note=FULL))
            lines.append(Line(body.inertia_with_setback, block.inertia_over_mass))
        else:
            lines.append(Line(body.RADIUS, block.radius, INPUT, VALUE))
            lines.append(Line(body.INERTIA, block.inertia_over_mass, INPUT))
        if not block.is_rectangle:
            lines.append(Line(body.equivalent_height, block.height))
        p = body.p_of_rectangle if block.is_rectangle else body.p
        lines.append(Line(p, block.frequency_parameter, note=FULL if block.is_rectangle else SYMBOLS))
        lines.append(_uplift(body.a_rm, block.threshold_acceleration / G))
    return Section("The block", [*lines, *_impacts(wall)])


def _uplift(of: Given, value: float) -> Line:
    return Line(of, value, LIVE, SYMBOLS, "acceleration that lifts the wall", run_name="a_rm_run")


def _sizes(wall: WallResult) -> list[Line | Columns]:
    """Lines of the sizes the case gives."""
    asked = wall.wall
    lines: list[Line | Columns] = [Line(body.HEIGHT, wall.height, INPUT)]
    if asked.slenderness_deg is None or asked.setback or asked.is_loaded or asked.has_shape:
        lines.append(Line(body.THICKNESS, wall.thickness, INPUT))
    if asked.setback or asked.is_loaded or asked.has_shape:
        lines.append(Line(body.SETBACK, asked.setback, RUN if asked.compressive_strength_mpa else INPUT))
    return lines


def _body(wall: WallResult) -> list[Line | Columns]:
    """The solids of a body, and its centroid from the hinge the formulas are about."""
    asked, sums = wall.wall, require_value(wall.wall.in_si.body)
    (x, z), rows, cells = sums.centroid, [], []
    parts = asked.parts
    for k, part in enumerate(parts, start=1):
        own = part.body
        rows.append((solid_name(part, k), (own.mass, *own.centroid, own.inertia)))
        cells.append([f"solid{k}_{key}" for key in "mxzi"])
    inward = governing_side(wall) < 0.0
    at_hinge = require_value(asked.thickness) - asked.setback - x if inward else x - asked.setback
    solids = Columns(
        "Solids, from the outer face of the base", body.SOLIDS, ("kg", "m", "m", "kg m²"), rows, RUN, {}, cells
    )
    return [
        *_sizes(wall),
        solids,
        Line(body.body_mass, sums.mass, note=SYMBOLS),
        Line(body.x_g, x, note=SYMBOLS),
        Line(body.z_g, z, note=SYMBOLS),
        Line(body.i_o, sums.inertia, note=SYMBOLS),
        Line(body.i_g, sums.inertia / sums.mass - x**2 - z**2),
        Line(body.x_of_body_inward if inward else body.x_of_body, at_hinge, note=FULL),
        Line(body.y_of_body, z),
    ]


def solid_name(part: Part, k: int) -> str:
    """Name of the k-th solid of a wall, from 1: a number where a word would be a private one."""
    return f"{k} –" if part.weight < 0.0 else f"{k}"


def _loaded(wall: WallResult) -> list[Line | Columns]:
    """Lines of a wall with loads up to a_RM, about the governing hinge."""
    asked, block, model, side = wall.wall, shown_block(wall), wall.model, governing_side(wall)
    bare, restoring = asked.in_si.bare, model.restoring if side > 0.0 else model.mirrored
    of_body = asked.parts
    where = "Loads, about the outer hinge" if side > 0.0 else "Loads, about the inner hinge"
    rows = []
    tied, at_limit = bool(asked.ties), forces_at_limit(wall)
    counted = (
        wall.required_assessment.kinematic.wall
        if wall.assessment and wall.required_assessment.kinematic
        else asked.in_si
    )
    for load in asked.in_si.loads:
        force = load_to_force(load, asked.in_si, side)
        pushed = 1e-3 * load.force if load.pushes else 0.0
        distance = force.distance + asked.setback  # entered from the face of this hinge: the formulas take off u
        held = 1e-3 * force.horizontal if load.tie and load in counted.loads else 0.0
        constant = 0.0 if load.tie else 1e-3 * force.horizontal
        values = (1e-3 * force.vertical, constant, distance, force.height, pushed)
        of_tie = (held, at_limit.pop(0) if load.tie else 0.0) if tied else ()
        rows.append((Word(f"choice_{load.kind}"), (*values, *of_tie)))
    units = ("kN/m", "kN/m", "m", "m", "kN/m", *(("kN/m", "kN/m") if tied else ()))
    symbols = body.LOADS | body.TIES if tied else body.LOADS
    weight = 1e-3 * asked.in_si.weight
    alone: list[Line | Columns] = [
        *_sizes(wall),
        Line(body.UNIT_WEIGHT, asked.unit_weight_kn_m3, INPUT),
        Line(body.w, weight, note=FULL),
        Line(body.x, bare.centroid[0]),
        Line(body.y, bare.centroid[1]),
    ]
    if of_body:
        alone = [*_body(wall), Line(body.LENGTH, asked.length_m, INPUT), Line(body.w_of_body, weight, note=FULL)]
    return [
        *alone,
        Columns(where, symbols, units, rows, INPUT, {"load.d": "setback"}),
        Line(
            body.slenderness_with_loads,
            math.degrees(block.slenderness),
            LIVE,
            SYMBOLS,
            "of the wall with the masses that move with it",
        ),
        Line(body.radius_with_loads, block.radius, note=SYMBOLS),
        Line(body.inertia_of_body_with_loads if of_body else body.inertia_with_loads, block.inertia_over_mass),
        Line(body.p, block.frequency_parameter, note=SYMBOLS),
        Line(body.a, restoring.sine),
        Line(body.c, restoring.cosine),
        Line(body.theta_c_degrees, math.degrees(block.slenderness + restoring.lean)),
        Line(body.theta_c, block.slenderness + restoring.lean),
        _uplift(body.a_rm_with_loads, model.threshold / G),
    ]


def forces_at_limit(wall: WallResult) -> list[float]:
    """Force the displacement check counts of each tie at its limit [kN/m]."""
    kinematic = wall.required_assessment.kinematic if wall.assessment else None
    given = wall.wall.ties
    if not (kinematic and kinematic.d_limit is not None and kinematic.chain.ties):
        return [0.0 for _ in given]
    theta = kinematic.chain.rotation(kinematic.d_limit)
    forces = [tie.bar.force_at(theta) for tie in wall.wall.in_si.ties]
    return [0.0 if tie.slack_mm else 1e-3 * force for tie, force in zip(given, forces, strict=True)]


def _impacts(wall: WallResult) -> list[Line]:
    """The velocity ratio, by its formula where the model has one."""
    model, block = wall.restitution.model, shown_block(wall)
    e, words = wall.restitution.ratio_at_rest, {"model": MODELS[model].source}
    if governing_side(wall) < 0.0 and wall.restitution.ratio_inward is not None:
        e = wall.restitution.ratio_inward
    label = "velocity ratio of an impact: {model}"
    if model not in body.RATIOS:
        of = body.VELOCITY_RATIO
        label = "velocity ratio of an impact: given" if model == "user" else label
        return [Line(of, e, INPUT if model == "user" else RUN, VALUE, label, words=words)]
    contact = wall.wall.in_si.contact
    if contact:
        base, top = body.e_base_with_loads, body.e_top_with_loads
        label = "velocity ratio of an impact: {model}, derived of the body and what moves with it"
    elif block.is_rectangle:
        base, top = body.e_base_of_rectangle, body.e_top_of_rectangle
    else:
        base, top = body.e_base_of_block, body.e_top_of_block
    at_base = housner_ratio(block, contact)
    lines = [Line(base, at_base)]
    if MODELS[model].one_sided:
        lines.append(Line(top, one_sided_ratio(block, contact) / at_base**2))
    return [*lines, Line(body.RATIOS[model], e, LIVE, VALUE, label, body.VELOCITY_RATIO.label, words)]
