"""Result of a wall from its runs: governing sign, set, power law, checks, warnings."""

import numpy as np

from core.capacity import closed_forms
from core.capacity.fragility import fragility
from core.capacity.ida import TRILINEAR_FLOOR, Ida, multiplier_of, threshold_of
from core.capacity.scale_free_law import estimates, scaled_intensity
from core.case.hinges import WallPart
from core.case.wall import Wall
from core.codes.eq9 import inequality
from core.codes.limits import MIN_STATIONS_FOR_MEAN, MIN_STATIONS_FOR_MINIMUM, set_capacity, set_rule
from core.codes.masonry_types import TYPES
from core.codes.target_spectrum import velocity_integral
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import stations
from core.study.governing import run_with_lowest_q
from core.study.results import Q_SOURCES, RecordResult, Run, WallResult
from core.text.sentence import Key, Sentence, notice, sentence
from core.units import CM
from core.wall.block import Block
from core.wall.impact import MOMENTUM, Restitution
from core.wall.kinematics import kinematics
from core.wall.restitution import MODELS, housner_ratio, one_sided_ratio
from core.wall.rocking_model import RockingModel
from core.wall.solids import MIN_BASE, section_area

LARGE_COLLAPSE_SCALE = 10.0

MIN_THICKNESS, MAX_SLENDERNESS = 0.10, 30.0
"""t [m] below which, and H/t above which, a wall is questioned."""

USUAL_WEIGHTS, USUAL_MODULI = (10.0, 28.0), (200.0, 10000.0)
"""Unit weights [kN/m3] and elastic moduli [MPa] of masonry; others are questioned."""

HEAVY = 1.5
"""Mean stress at the base [MPa] above which loads are questioned."""

NARROW_SI = 1.5
"""Below this ratio of the largest to the smallest SI a power law is warned of."""

RANGE_MARGIN = 0.1
"""Share by which a value may lie outside the range of its type of masonry before it is questioned: the range is one of
means."""

NEARLY_ELASTIC = 0.99
"""Above this velocity ratio a wall rocks for a very long time: warned."""


def run_result(model: RockingModel, motion: GroundMotion, k: int, polarity: int, ida: Ida) -> Run:
    """Run of one search, with its multiplier and q_eff. k : index of the motion in the study"""
    scale = q_eff = None
    if ida.q is not None:
        scale = multiplier_of(ida.q, motion.pga, threshold_of(model))
        q_eff = closed_forms.effective_q(ida.q, motion.pga)
    return Run(motion.name, k, polarity, ida, scale, q_eff)


def _lower(values: list[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return min(known) if known else None


def _per_record(
    motion: GroundMotion,
    k: int,
    runs: list[Run],
    block: Block,
    one_sided: bool,
    felt: GroundMotion | None,
    closed: bool,
) -> RecordResult:
    """Governing values of one record from its runs. felt : motion of the floor of a wall above the ground; closed : Eq.
    15 and 16 hold."""
    lowest = run_with_lowest_q(runs)
    si = motion.housner_intensity
    shape = (block.slenderness, block.height, si)
    mechanism = "one_sided" if one_sided else "two_sided"
    return RecordResult(
        record=motion.name,
        motion=k,
        polarity=lowest.polarity if lowest else None,
        q=lowest.ida.q if lowest else None,
        q_robust=_lower([run.ida.q_robust for run in runs]),
        q_slv=_lower([run.ida.q_slv for run in runs]),
        q_slv_low=_lower([run.ida.q_slv_low for run in runs]),
        q_slv_robust=_lower([run.ida.q_slv_robust for run in runs]),
        q_slv_safe=_lower([q for run in runs for q in (run.ida.q_slv_low, run.ida.q_slv_robust)]),
        q_eff=lowest.q_eff if lowest else None,
        intensity=si,
        pga=(felt or motion).pga,
        scaled=scaled_intensity(block.p2, motion.velocity_integral, motion.pga, mechanism) if closed else None,
        closed_form_q_eff=closed_forms.closed_form_q_eff(*shape, one_sided) if closed else None,
        closed_form_q=closed_forms.closed_form_q(*shape, motion.pga, one_sided) if closed else None,
    )


def _power_law(with_q: list[RecordResult]) -> closed_forms.PowerLaw | None:
    """The law of the records with a q."""
    points = [(entry.intensity, q_eff) for entry in with_q if (q_eff := entry.q_eff) is not None]
    return closed_forms.fit_power_law([si for si, _ in points], [q_eff for _, q_eff in points])


def wall_result(part: WallPart, mechanism, model, runs, motions, search, demand, floor=None) -> WallResult:
    """Result of one wall and mechanism from its runs; an incomplete set has no values.

    motions : of the ground; floor : Floor of a wall above it
    """
    wall = part.wall
    block, law = wall.block(), wall.moment_law()
    one_sided = kinematics(mechanism).one_way
    per_record = [
        _per_record(
            motion,
            k,
            [r for r in runs if r.motion == k],
            block,
            one_sided,
            floor.motions[k] if floor else None,
            wall.has_closed_forms,
        )
        for k, motion in enumerate(motions)
    ]
    with_q = [entry for entry in per_record if entry.q is not None]
    counted = stations([motions[entry.motion] for entry in with_q])
    incomplete = [run for run in runs if run.ida.status == "impact_limit"]
    rule = "incomplete" if incomplete else set_rule(counted) if runs else None
    sets = {
        name: set_capacity([getattr(entry, name) for entry in per_record], rule)
        for name in ("q", "q_robust", "q_slv", "q_slv_low", "q_slv_robust", "q_slv_safe")
    }
    closed_q_eff = closed_q = None
    if demand and demand.intensity and wall.has_closed_forms:
        shape = (block.slenderness, block.height, demand.intensity)
        closed_q_eff = closed_forms.closed_form_q_eff(*shape, one_sided)
        closed_q = closed_forms.closed_form_q(*shape, demand.pga, one_sided)
    checks = ()
    if demand and not wall.above_ground:  # above the ground the motion of the floor is not known
        sources = (demand.q_code, closed_q, sets["q"], sets["q_slv"], sets["q_robust"])
        checks = tuple(
            inequality(source, q, model.threshold, demand.pga) if q else None
            for source, q in zip(Q_SOURCES, sources, strict=True)
        )
    restitution = Restitution(MOMENTUM, model.ratio_at_rest) if wall.bends else wall.restitution_of(mechanism)
    estimated = ()
    if checks and demand.target and wall.has_closed_forms:
        estimated = estimates(block, restitution, law, one_sided, velocity_integral(demand.target), demand.pga)
    law_of_si = None if wall.above_ground else _power_law(with_q)
    fragile = fragility([run.ida for run in runs], search)
    return WallResult(
        part=part,
        block=block,
        mechanism=mechanism,
        restitution=restitution,
        law=law,
        model=model,
        runs=tuple(runs),
        per_record=tuple(per_record),
        set_rule=rule,
        q_set=sets["q"],
        q_min=None if incomplete else _lower([entry.q for entry in with_q]),
        q_robust_set=sets["q_robust"],
        q_slv_set=sets["q_slv"],
        q_slv_low_set=sets["q_slv_low"],
        q_slv_robust_set=sets["q_slv_robust"],
        q_slv_safe_set=sets["q_slv_safe"],
        power_law=law_of_si,
        fragility=fragile,
        closed_form_q_eff=closed_q_eff,
        closed_form_q=closed_q,
        code_check=checks,
        estimates=estimated,
        floor=floor,
        warnings=tuple(
            unusual_input(wall)
            + _no_loss(wall, mechanism)
            + ([] if wall.bends else _model_notices(wall, block, mechanism, model, restitution, law))
            + _set_notices(runs, len(with_q), len(counted), incomplete, fragile, search)
            + _power_law_notices(wall, with_q, law_of_si)
            + _form_notices(wall, block, mechanism, restitution, law, per_record, demand, checks)
        ),
    )


def unusual_input(wall: Wall) -> list[Sentence]:
    """Input few engineers mean: accepted, and questioned with the likely slip of unit."""
    notices, t = [], wall.thickness
    if t is not None and t < MIN_THICKNESS:
        notices.append(notice("thin", cm=100.0 * t))
    if t is not None and wall.height_m is not None and wall.height_m / t > MAX_SLENDERNESS:
        notices.append(notice("slender", ratio=wall.height_m / t, h=wall.height_m, t=t))
    weights = [wall.unit_weight_kn_m3, *(solid.unit_weight_kn_m3 for solid in wall.solid)]
    modulus = wall.elastic_modulus_mpa
    for weight in {
        weight for weight in weights if weight is not None and not USUAL_WEIGHTS[0] <= weight <= USUAL_WEIGHTS[1]
    }:
        notices.append(notice("odd_weight", w=weight, low=USUAL_WEIGHTS[0], high=USUAL_WEIGHTS[1]))
    if modulus is not None and not USUAL_MODULI[0] <= modulus <= USUAL_MODULI[1]:
        notices.append(notice("odd_modulus", e=modulus, low=USUAL_MODULI[0], high=USUAL_MODULI[1]))
    if wall.masonry:
        notices += _unlike_its_masonry(wall)
    if wall.is_loaded and t is not None:
        weight = wall.in_si.weight + wall.in_si.vertical_loads
        stress = 1e-6 * weight / (t - 2.0 * wall.setback)
        if parts := wall.parts:
            assert wall.length_m is not None
            area = section_area(parts, 0.0, 0.0, t)  # none under a corner of oblique solids
            stress = stress * wall.length_m * t / area if area > MIN_BASE else 0.0
        if stress > HEAVY:
            notices.append(notice("heavy_load", stress=stress))
    return notices


def _no_loss(wall: Wall, mechanism: str) -> list[Sentence]:
    """Notice for a body for which Eq. 6 gives more than 1."""
    if wall.bends or wall.restitution_model(mechanism) != "one_sided_theoretical":
        return []
    ratio = one_sided_ratio(wall.block(), wall.in_si.contact)
    return [notice("eq6_above_one", ratio=ratio)] if ratio > 1.0 else []


def _unlike_its_masonry(wall: Wall) -> list[Sentence]:
    """Values outside those of the type of masonry (Tables C8.5.I and C8.5.II)."""
    assert wall.masonry is not None
    row = TYPES[wall.masonry]
    strongest = row.strength[1] * row.most_factor
    ranges = (
        ("compressive_strength_mpa", wall.compressive_strength_mpa, row.strength[0], strongest, "MPa"),
        ("elastic_modulus_mpa", wall.elastic_modulus_mpa, *row.modulus, "MPa"),
        ("unit_weight_kn_m3", wall.unit_weight_kn_m3, *row.weight, "kN/m3"),
    )
    masonry = sentence("word", f"choice_{wall.masonry}")
    return [
        notice("unlike_masonry", key=Key(key), value=value, low=low, high=high, unit=unit, masonry=masonry)
        for key, value, low, high, unit in ranges
        if value is not None and not low * (1.0 - RANGE_MARGIN) <= value <= high * (1.0 + RANGE_MARGIN)
    ]


def _model_notices(wall, block, mechanism, model, restitution, law) -> list[Sentence]:
    notices = []
    if restitution.model == "costa_upper" and restitution.ratio_at_rest > housner_ratio(block, wall.in_si.contact):
        notices.append(notice("costa_above_housner", alpha=float(np.degrees(block.slenderness))))
    if kinematics(mechanism).one_way and not (MODELS[restitution.model].one_sided or restitution.model == "user"):
        notices.append(notice("hogan", model=restitution.model))
    if restitution.ratio_at_rest > NEARLY_ELASTIC and restitution.model == "user":
        notices.append(notice("nearly_elastic", ratio=restitution.ratio_at_rest))
    if wall.height_m is not None and wall.setback > 0.0 and not wall.is_loaded:
        notices.append(notice("setback_height", height=block.height))
    elif not block.is_rectangle and not wall.is_loaded:
        notices.append(notice("general_height", height=block.height))
        if MODELS[restitution.model].one_sided and wall.height_m is None:
            notices.append(notice("general_contact"))
    if not law.is_rigid:
        top = model.collapse_rotation
        share = np.sin((1.0 - law.plateau_end) * top) / np.sin(top)
        notices.append(notice("trilinear_threshold", plateau=float(share)))
    return notices


def _set_notices(runs, files: int, counted: int, incomplete, fragile, search) -> list[Sentence]:
    """files : with a number; counted : stations of these"""
    notices = []
    if incomplete:
        notices.append(notice("incomplete", n=len(incomplete)))
    elif runs and counted < MIN_STATIONS_FOR_MINIMUM:
        notices.append(notice("too_few" if counted else "no_numbers", n=counted))
    if runs and counted < min(files, MIN_STATIONS_FOR_MEAN):
        notices.append(notice("few_stations", files=files, n=counted))
    if runs and search.half_window < 3:
        notices.append(notice("coarse_window", n=search.half_window))
    standing = sum(run.ida.status == "no_collapse_found" for run in runs)
    if standing:
        notices.append(notice("no_collapse", n=standing, limit=search.q_limit))
    lowest = sum(run.ida.below_floor for run in runs)
    if lowest:
        notices.append(notice("below_floor", n=lowest, floor=TRILINEAR_FLOOR))
    clamped = sum(run.ida.clamped for run in runs)
    if clamped:
        notices.append(notice("clamped", n=clamped))
    if fragile and fragile.n < MIN_STATIONS_FOR_MEAN:
        notices.append(notice("few_runs", n=fragile.n))
    large = {run.motion for run in runs if run.scale and abs(run.scale) > LARGE_COLLAPSE_SCALE}
    if large:
        notices.append(notice("pga_too_small", n=len(large)))
    return notices


def _power_law_notices(wall, with_q, power_law) -> list[Sentence]:
    """Why the power law of a wall on the ground is not given, or that its SI hardly differ."""
    if wall.above_ground or len(with_q) < MIN_STATIONS_FOR_MINIMUM:
        return []
    low, high = (end(entry.intensity for entry in with_q) / CM for end in (min, max))
    if power_law is None:
        return [notice("no_power_law", low=low, high=high)]
    return [notice("narrow_si", low=low, high=high)] if high < NARROW_SI * low else []


def model_notices(mechanism, restitution, law) -> list[Sentence]:
    """Notice that a wall has another velocity ratio or law than Eq. 15 and 16."""
    fitted = "one_sided_theoretical" if kinematics(mechanism).one_way else "housner"
    if restitution.model == fitted and law.is_rigid:
        return []
    return [notice("eq15_model", fitted=fitted, used=restitution.model + ("" if law.is_rigid else " + D1, D2"))]


def _form_notices(wall, block, mechanism, restitution, law, per_record, demand, checks) -> list[Sentence]:
    """Notices on the closed forms, which are not shown above the ground or with loads."""
    if not wall.has_closed_forms:
        return [notice("no_closed_forms")] if wall.is_loaded and not (wall.above_ground or wall.bends) else []
    pgas: list = [(entry.record, entry.pga) for entry in per_record]
    if demand:
        pgas.append((sentence("word", "choice_demand"), demand.pga))
    notices = closed_forms.range_notices(block.slenderness, block.height, pgas)
    notices += model_notices(mechanism, restitution, law)
    if demand and demand.intensity_source == "records_scaled":
        notices.append(notice("si_from_records", si=demand.intensity / CM))
    if checks:
        histories, robust = checks[2], checks[4]
        if robust and robust.passed and not (histories and histories.passed):
            notices.append(notice("only_robust"))
    return notices
