"""Random walls of every kind: on the ground and on floors, loaded, tied, shaped, held at their top."""

import random

from core.case.rules import parse_case
from core.case.schema import Case
from core.errors import InputError
from tests.holds import carries, shown

HAZARD = [
    {"return_period_years": 30.0, "ag_g": 0.3, "f0": 2.40, "tc_star_s": 0.28},
    {"return_period_years": 475.0, "ag_g": 1.0, "f0": 2.36, "tc_star_s": 0.35},
    {"return_period_years": 2475.0, "ag_g": 1.7, "f0": 2.42, "tc_star_s": 0.37},
]
"""Rows of a site, a_g as a share of that of 475 years."""


def _loads(draw: random.Random, height: float, thickness: float) -> list[dict]:
    """Up to three loads of a wall."""
    found: list[dict] = []
    for _ in range(draw.choice((0, 0, 1, 1, 2))):
        at = round(height * draw.uniform(0.4, 1.0), 2)
        if draw.random() < 0.7:
            mass = draw.choice(("none", "horizontal", "moving"))
            across = round(thickness * draw.uniform(0.2, 0.8), 3)
            force = round(draw.uniform(1.0, 25.0), 1)
            found.append({"kind": "vertical", "kn_m": force, "d_m": across, "h_m": at, "mass": mass})
        else:
            found.append({"kind": "thrust", "kn_m": round(draw.uniform(-0.5, 1.2), 2), "h_m": at})
    return found


def _tie(draw: random.Random, height: float) -> dict:
    strength, at = round(draw.uniform(0.3, 8.0), 2), round(height * draw.uniform(0.6, 0.98), 2)
    length = round(draw.uniform(4.0, 12.0), 1)
    tie = {"kind": "tie", "out_kn_m": strength, "h_m": at, "bar_length_m": length}
    if draw.random() < 0.7:
        tie["elongation_m"] = round(draw.uniform(0.005, 0.06), 3) * length
    if draw.random() < 0.2:
        tie["slack_mm"] = round(draw.uniform(1.0, 10.0), 1)
    return tie


def _wall(draw: random.Random, mechanism: str) -> dict:
    height = round(draw.uniform(2.5, 9.0), 2)
    thickness = round(height / draw.uniform(6.0, 16.0), 2)
    wall: dict = {"name": "w", "mechanism": mechanism, "height_m": height, "thickness_m": thickness, "base_z_m": 0.0}
    wall |= {"unit_weight_kn_m3": round(draw.uniform(14.0, 22.0), 1), "length_m": round(draw.uniform(3.0, 8.0), 1)}
    if draw.random() < 0.7:
        wall["hold"] = [{"kind": "cross_walls"}]
    loads = _loads(draw, height, thickness)
    if mechanism == "one_sided" and draw.random() < 0.35:
        loads.append(_tie(draw, height))
    wall = carries(*loads, **wall)
    if draw.random() < 0.4:
        wall["elastic_modulus_mpa"] = round(draw.uniform(500.0, 3000.0), 0)
    if draw.random() < 0.3:
        wall["compressive_strength_mpa"] = round(draw.uniform(1.0, 5.0), 1)
    if draw.random() < 0.2 and mechanism != "vertical_bending":
        wall["velocity_ratio"] = round(draw.uniform(0.2, 0.9), 2)
    if draw.random() < 0.2 and mechanism != "vertical_bending":
        wall["gable_m"] = round(draw.uniform(0.5, 2.0), 2)
    if draw.random() < 0.15 and mechanism == "one_sided" and "gable_m" not in wall:
        wall["return_walls"] = {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}
    return wall


def table_of(seed: int, histories: bool = False, hazard: bool = False) -> dict:
    """The table of a case with one random wall. histories : under three generated motions; hazard : of its site"""
    draw = random.Random(f"wall {seed}")
    mechanism = draw.choice(("one_sided", "one_sided", "one_sided", "two_sided", "both", "vertical_bending"))
    wall = _wall(draw, mechanism)
    ag = round(draw.uniform(0.05, 0.35), 3)
    demand: dict = {"ag_g": ag, "spectrum": {"code": "EN1998", "type": 1, "soil": draw.choice("ABC")}}
    demand["spectrum"] = {
        "code": "NTC2018", "soil": draw.choice("ABC"), "topography": "T1", "f0": 2.36, "tc_star_s": 0.35
    }  # fmt: skip
    if draw.random() < 0.2:
        demand["q_code"] = round(draw.uniform(1.5, 3.0), 1)
    if "compressive_strength_mpa" in wall and draw.random() < 0.6:
        demand |= {
            "confidence_factor": 1.2,
            "knowledge_level": "LC2",
            "evidence": shown(confidence_factor="flat jacks"),
        }
    if draw.random() < 0.25:
        demand["zeta_target"] = round(draw.uniform(0.8, 1.0), 2)
    if hazard or draw.random() < 0.3:
        rows = [{**row, "ag_g": round(row["ag_g"] * ag, 6)} for row in HAZARD]
        demand |= {"nominal_life_years": 50.0, "use_class_factor": 1.0, "return_period_years": 475.0, "hazard": rows}
    table = {"wall": [wall], "demand": demand, "analysis": {"q_step": 0.1}}
    if draw.random() < 0.5:
        storeys = draw.randint(2, 4)
        period = round(draw.uniform(0.15, 0.6), 2)
        table["building"] = {"height_m": round(3.2 * storeys, 1), "storeys": storeys, "period_s": period}
        if draw.random() < 0.4:
            wall["base_z_m"] = round(draw.uniform(2.0, 3.0 * storeys - 1.0), 1)
    if histories:
        table["generate"] = {"scatter": 0.0, "count": 3, "seed": draw.randint(1, 4)}
    return table


def accepted(table: dict) -> Case | None:
    """The case of a table, None where a rule refuses it."""
    try:
        return parse_case(table)
    except InputError:
        return None


def random_tables(count: int, histories: bool = False, hazard: bool = False, first: int = 0) -> list[dict]:
    """So many tables of accepted cases, one wall each, drawn by the seeds from the first on."""
    found: list[dict] = []
    seed = first
    while len(found) < count:
        table = table_of(seed, histories, hazard)
        if accepted(table) is not None:
            found.append(table)
        seed += 1
    return found
