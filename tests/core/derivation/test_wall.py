"""The description of a derivation is an independent way to the numbers of core/codes and core/wall."""

import math
import random
from pathlib import Path
from types import SimpleNamespace

import pytest

from core.codes.target_spectrum import ntc2018
from core.derivation import arch, bending, body, checks, closed_forms, demand
from core.derivation import wall as of_wall
from core.derivation.closed_forms import closed
from core.derivation.geometry import forces_at_limit, geometry, governing_side
from core.derivation.line import Columns
from core.derivation.quantity import Quantity
from core.derivation.site import demand_section
from core.errors import InputError
from core.report.stated.quantity import walk_quantities
from core.report.stated.walls import WALL, WallResultSource
from core.study.run import run
from core.units import G
from core.wall.restitution import MODELS
from tests.clauses_alone import parse_case
from tests.holds import BOUND, between, carries
from tests.validation.circolare import EN_B, NTC_C

LOADS = (
    {"kind": "vertical", "mass": "none"},
    {"kind": "vertical", "mass": "horizontal"},
    {"kind": "vertical", "mass": "moving"},
    {"kind": "carried_mass"},
    {"kind": "thrust"},
    {"kind": "tie"},
)
ACROSS = {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}
OF_MECHANISM = {
    mechanism: [name for name, model in MODELS.items() if model.one_sided == one_sided and name != "user"]
    for mechanism, one_sided in (("two_sided", False), ("one_sided", True))
}


def test_that_every_model_of_the_core_is_described():
    assert set(body.RATIOS) == set(MODELS) - {"costa_upper", "user"}


def load_of(draw, height, thickness):
    load = dict(draw.choice(LOADS))
    load |= {"h_m": round(height * draw.uniform(0.6, 1.0), 3), "kn_m": round(draw.uniform(0.2, 0.6), 3)}
    if load["kind"] in ("vertical", "carried_mass"):
        load |= {"d_m": round(thickness * draw.uniform(0.3, 0.8), 3), "kn_m": round(draw.uniform(1.0, 8.0), 3)}
    if load["kind"] == "tie":
        stands = draw.choice(({}, {"elongation_m": 0.03}, {"elongation_m": 0.4}))
        load |= {"out_kn_m": load.pop("kn_m"), "bar_length_m": 8.0} | stands
    return load


def body_of(draw, height, thickness):
    """A battered wall, a stepped one, one with a gable and a window, or one with wedges."""
    kind, face = draw.choice(("battered", "steps", "gable", "wedges")), round(0.5 * thickness, 3)
    wall = {"length_m": 5.0, "hinge_setback_m": draw.choice((0.0, 0.02))}
    if kind == "battered":
        corners = draw.choice(([[0, 0], [thickness, 0], [face, height], [0, height]],
                               [[0, 0], [thickness, 0], [thickness, height], [face, height]]))  # fmt: skip
        return wall | {"solid": [{"plane": "section", "polygon_m": corners, "to_m": 5.0}]}
    if kind == "steps":
        flush = draw.choice(("outer", "inner"))
        return wall | {"steps": [{"from_z_m": 0.5 * height, "thickness_m": 0.8 * thickness, "flush": flush}]}
    if kind == "gable":
        window = {"s_m": 2.0, "z_m": 0.3, "width_m": 1.0, "height_m": 0.6}
        return wall | {"gable_m": round(0.3 * height, 3), "openings": [window]}
    wedges = {"number": 1, "thickness_m": 0.4, "length_at_top_m": 0.5}
    return wall | {"mechanism": "one_sided", "restitution": "one_sided_theoretical", "return_wedges": wedges}


def held_at_top(draw, name):
    """A wall that bends, with one load on its top, two or none."""
    height, thickness = round(draw.uniform(2.5, 5.0), 3), round(draw.uniform(0.25, 0.5), 3)
    size = {"name": name, "mechanism": "vertical_bending", "height_m": height, "thickness_m": thickness}
    loads = [
        {
            "kind": "vertical",
            "mass": "none",
            "kn_m": round(draw.uniform(2.0, 40.0), 2),
            "d_m": round(thickness * draw.uniform(0.2, 0.8), 3),
            "h_m": height,
        }
        for _ in range(draw.randint(0, 2))
    ]
    setback = draw.choice(({}, {"hinge_setback_m": 0.02}, {"compressive_strength_mpa": 2.0}))
    size |= setback | {"base_z_m": draw.choice((0.0, 3.0)), "unit_weight_kn_m3": 18.0}
    if draw.random() < 0.4:
        size |= {"length_m": 4.0, "openings": [{"s_m": 1.0, "z_m": 0.6, "width_m": 1.1, "height_m": 1.2}]}
        if draw.random() < 0.5:
            size["steps"] = [{"from_z_m": 2.0, "thickness_m": round(0.8 * thickness, 3)}]
        loads = [load | {"h_m": round(draw.choice((0.5, 1.0)) * height, 3)} for load in loads]
        loads = [load | {"d_m": round(0.5 * thickness, 3)} for load in loads]
    return size | ({"load": loads} if loads else {})


def between_walls(draw, name):
    """A wall that spans between transverse walls, by a tie, by masonry beyond or by both."""
    thickness = round(draw.uniform(0.3, 0.6), 3)
    tie = {"tie_kn_m": round(draw.uniform(8.0, 600.0), 1), "tie_elongation_m": draw.choice((0.03, 0.3))}
    tie["tie_bar_length_m"] = draw.choice((5.0, 15.0))
    beyond = {"shoulder_length_m": 2.5, "shoulder_thickness_m": 0.6}
    arch = {"spacing": round(draw.uniform(3.0, 6.0), 2), **draw.choice((tie, beyond, tie | beyond))}
    size = {"name": name, "mechanism": "horizontal_bending", "height_m": 3.5, "thickness_m": thickness}
    size["hold"] = between(**arch)
    size |= {"compressive_strength_mpa": 1.5, "unit_weight_kn_m3": 18.0, "base_z_m": draw.choice((0.0, 3.0))}
    push = {"kind": "thrust", "kn_m": 0.5, "h_m": 3.4}
    roof = {"kind": "vertical", "kn_m": 6.0, "d_m": round(0.5 * thickness, 3), "h_m": 3.5, "mass": "horizontal"}
    return size | draw.choice(({}, {"load": [push]}, {"load": [roof]}, {"load": [roof, push]}))


def wall_of(draw, k):
    """A wall of any kind."""
    height, thickness = round(draw.uniform(2.0, 8.0), 3), round(draw.uniform(0.3, 0.8), 3)
    mechanism = draw.choice(("one_sided", "two_sided"))
    wall = {
        "name": f"w{k}",
        "mechanism": mechanism,
        "base_z_m": draw.choice((0.0, 0.0, 6.0)),
        "hinge_heights": "base",
        **(BOUND if draw.random() < 0.6 else {}),
        "unit_weight_kn_m3": round(draw.uniform(16.0, 21.0), 2),
        "elastic_modulus_mpa": round(draw.uniform(600.0, 2000.0)),
        "restitution": draw.choice(OF_MECHANISM[mechanism]),
    }
    kinds = (
        "sizes",
        "setback",
        "strength",
        "slenderness",
        "general",
        "friction",
        "loads",
        "loads",
        "body",
        "body",
        "bends",
        "spans",
    )
    kind = draw.choice(kinds)
    if kind == "spans":
        return between_walls(draw, wall["name"])
    if kind == "bends":
        return held_at_top(draw, wall["name"])
    if kind == "general":
        del wall["hinge_heights"]
        alpha, radius = draw.uniform(4.0, 9.0), draw.uniform(1.5, 3.5)
        return wall | {"slenderness_deg": alpha, "radius_m": radius, "inertia_over_mass_m2": 1.4 * radius**2}
    wall |= {"height_m": height}
    if kind == "slenderness":
        return wall | {"slenderness_deg": draw.uniform(4.0, 9.0)}
    wall |= {"thickness_m": thickness}
    if kind == "body":
        wall |= body_of(draw, height, thickness)
        loads = [{**load_of(draw, height, thickness), "kind": "carried_mass"} for _ in range(draw.randint(0, 2))]
        loads = [{key: load[key] for key in ("kind", "kn_m", "h_m", "d_m") if key in load} for load in loads]
        carried = [load for load in loads if "d_m" in load]
        return wall | ({"load": carried} if carried else {})
    if kind == "setback" or (kind == "loads" and draw.random() < 0.5):
        wall |= {"hinge_setback_m": 0.02}
    if kind == "strength":
        wall |= {"compressive_strength_mpa": 2.0}
    if kind == "friction":
        wall |= {"mechanism": "one_sided", "restitution": "one_sided_theoretical", "return_walls": ACROSS}
        wall |= {"length_m": 5.0}
    if kind == "loads":
        loads = [load_of(draw, height, thickness) for _ in range(draw.randint(1, 3))]
        inward = any(load["kind"] == "tie" for load in loads)
        if inward:
            wall |= {"mechanism": "one_sided", "restitution": "one_sided_theoretical"}
        return carries(*loads, **wall)
    return wall


DEMANDS = {
    "SLV, NTC": {"ag_g": 0.18, "spectrum": NTC_C, "return_period_years": 475},
    "SLC, EN": {"ag_g": 0.25, "spectrum": EN_B, "limit_state": "SLC"},
    "SLD, NTC": {"ag_g": 0.08, "spectrum": NTC_C, "limit_state": "SLD"},
    "SLV, S and SI": {"ag_g": 0.2, "soil_factor": 1.2, "housner_intensity_cm": 90.0},
}


def result_of(demand, walls):
    """A result without records of the walls that can be made."""
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.3}
    return run(parse_case({"wall": walls, "building": building, "demand": demand}), base_dir=Path())


def results(which, count):
    """Results of so many random walls, one by one: some are refused (a stocky block, a strong force)."""
    draw, found = random.Random(which), []
    for k in range(count):
        try:
            found.append(result_of(DEMANDS[which], [wall_of(draw, k)]))
        except InputError:
            continue
    return found


def sections_of(result, wall):
    return [demand_section(result), geometry(wall), closed(wall), *of_wall.checks_of(result, wall)]


def evaluate(sections):
    """Value of each described line by its function, from what is given and of the run. Asserts that it is that of the
    program; gives how many were compared."""
    known, compared = {}, 0
    for section in sections:
        known |= section.constants
        for line in section.lines:
            if isinstance(line, Columns):
                rows = []
                for _, values in line.rows:
                    item = dict(zip((key.split(".")[1] for key in line.symbols), values, strict=True))
                    for key, cell in line.shift.items():
                        item[key.split(".")[1]] -= known[cell]
                    rows.append(SimpleNamespace(**item))
                known[{"load": "loads", "mode": "modes", "solid": "solids"}[next(iter(line.symbols)).split(".")[0]]] = (
                    rows
                )
                continue
            value = line.value
            if line.quantity is not None and value is not None:
                values = known | {one: known[other] for one, other in line.other.items()}
                value = line.quantity.function(**{name: values[name] for name in line.quantity.needs})
                assert value == pytest.approx(line.value, rel=1e-9, abs=1e-12), (section.title, line.of.name)
                compared += 1
            known[line.of.name] = value
            if line.run_name:
                known[line.run_name] = line.value
    return compared


ABOUT_A_HINGE = {"slenderness", "radius", "p", "velocity_ratio"}
OF_RECORDS = {"dynamic_zeta", "peak_limit", "zeta_16", "zeta_other", "q_slv", "q_slv_low", "q_slv_robust", "q_slv_safe"}


def derived_of(group, source):
    """(name of its line, value, unit) of the results that the sheet Check derives."""
    for one in group:
        value = one.of(source)
        if value is None:
            continue
        if one.group and one.kind == "one":
            yield from derived_of(one.group, value)
        elif one.line:
            yield one.line, value, one.unit


def results_agree(result, wall, lines):
    """Assert that a number of the results which has a line has its value and unit; gives the lines that were there."""
    there = {}
    for line in lines:
        if not isinstance(line, Columns) and line.value is not None:
            there.setdefault(line.of.name, []).append(line)
    compared = set()
    for name, value, unit in derived_of(WALL, WallResultSource(wall, result)):
        if name in ABOUT_A_HINGE and governing_side(wall) < 0.0:  # the results are about the outer one
            continue
        for line in there.get(f"{name}_friction") or there.get(name, []):
            assert line.value == pytest.approx(value, rel=1e-9, abs=1e-12), name
            shown = line.of.unit.format(years="years").replace("–", "-").replace("°", "deg")
            assert shown.replace("²", "2").replace("³", "3") == unit, name
            compared.add(name)
    return compared


@pytest.mark.shows("files.derivations")
@pytest.mark.parametrize("walls", [44, pytest.param(90, marks=pytest.mark.long)])
def test_that_every_description_gives_the_number_of_the_program_and_none_is_of_nothing(walls):
    described = {
        value.function.__name__
        for module in (arch, bending, body, checks, closed_forms, demand)
        for value in vars(module).values()
        if isinstance(value, Quantity)
    }
    seen = {"q", "q_eff", "demand_over_q", "capacity_over_demand"}  # of the table of records, and of Eq. 9
    seen |= {"intensity_of_records", "linear_q_slv", "linear_q_slv_with_friction", "linear_q_slv_zeta"}  # with records
    seen |= {"linear_q_slv_with_ties", "linear_q_slv_with_ties_and_friction", "zeta_floor_with_ties_and_friction"}
    told = set()
    for which in DEMANDS:
        compared, found = 0, results(which, walls)
        for result in found:
            for wall in result.walls:
                sections = sections_of(result, wall)
                compared += evaluate(sections)
                lines = [line for section in sections for line in section.lines]
                told |= results_agree(result, wall, lines)
                seen |= {line.quantity.function.__name__ for line in lines if getattr(line, "quantity", None)}
                seen |= {line.shown_by.function.__name__ for line in lines if getattr(line, "shown_by", None)}
        assert len(found) > 0.6 * walls and compared > 15 * len(found), which
    branches = {branch.function.__name__ for branch in (*checks.SE_BRANCHES, *checks.S_DE_BRANCHES)}
    assert described - seen - branches == set()
    assert {one.line for _, one in walk_quantities(WALL) if one.line} - told == OF_RECORDS


@pytest.mark.shows("demand.branches")
@pytest.mark.parametrize("damping", [5.0, 8.0, 10.0])
def test_that_each_branch_of_the_note_is_the_spectrum_of_the_program(damping):
    target = ntc2018(2.0, 2.45, 0.33, "C", "T1")
    ends = [0.0, target.t_b, target.t_c, target.t_d, 4.0]
    for k, (se, s_de) in enumerate(zip(checks.SE_BRANCHES, checks.S_DE_BRANCHES, strict=True)):
        period = 0.3 * ends[k] + 0.7 * ends[k + 1]
        known = {"demand_pga": target.pga / G, "period_0": period, "period": period, "gravity": G, "damping": damping}
        known |= {"spectrum_f0": 2.45, "spectrum_tb": target.t_b, "spectrum_tc": target.t_c, "spectrum_td": target.t_d}
        (elastic,), (damped,) = target.acceleration([period]), target.acceleration([period], damping / 100.0)
        assert se.function(*(known[name] for name in se.needs)) == pytest.approx(elastic / G, rel=1e-12)
        found = s_de.function(*(known[name] for name in s_de.needs))
        assert found == pytest.approx(damped * (period / (2.0 * math.pi)) ** 2, rel=1e-12)


def test_that_the_sections_of_a_run_with_records_agree_too(reference, tmp_path):
    ground = reference("standard")[0][:900]
    for k in range(3):
        (tmp_path / f"r{k}.txt").write_text("\n".join(f"{value:.9e}" for value in ground * (0.9 + 0.1 * k)))
    wall = {"name": "w", "height_m": 6.0, "thickness_m": 0.6, "mechanism": "one_sided", "base_z_m": 0.0}
    friction = {"unit_weight_kn_m3": 18.0, "length_m": 5.0, "return_walls": ACROSS}
    tie = {"kind": "tie", "out_kn_m": 1.5, "h_m": 5.5, "bar_length_m": 8.0, "elongation_m": 0.3}
    tied = {"name": "t", "unit_weight_kn_m3": 18.0, "hold": [tie], "hinge_heights": "base"}
    records = [{"file": f"r{k}.txt", "unit": "m/s2", "time_step_s": 0.01} for k in range(3)]
    case = parse_case(
        {
            "wall": [wall, wall | friction | {"name": "f"}, wall | tied, wall | friction | tied | {"name": "tf"}],
            "record": records,
            "demand": {"ag_g": 0.2, "soil_factor": 1.2},
            "analysis": {"q_step": 0.02},
        }
    )
    result = run(case, base_dir=tmp_path)
    told = set()
    for found in result.walls:
        sections = sections_of(result, found)
        assert evaluate(sections) > 10
        told |= results_agree(result, found, [line for section in sections for line in section.lines])
    assert told >= OF_RECORDS


def test_that_a_slack_tie_beside_one_that_counts_adds_nothing_to_what_the_ties_hold(tmp_path):
    """Both are of one wall: the formula has all of them, and the slack one with no force."""
    tie = {"kind": "tie", "out_kn_m": 1.5, "h_m": 5.5, "bar_length_m": 8.0, "elongation_m": 0.3}
    slack = tie | {"h_m": 4.5, "slack_mm": 5.0}
    sizes = {"height_m": 6.0, "thickness_m": 0.5, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
    table = {
        "wall": [{"name": "w", "mechanism": "one_sided", **sizes, "hold": [slack, tie], "hinge_heights": "base"}],
        "demand": {"ag_g": 0.1, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
        "analysis": {"histories": False},
    }
    result = run(parse_case(table), base_dir=tmp_path)
    for wall in result.walls:
        assert evaluate([demand_section(result), geometry(wall), *of_wall.checks_of(result, wall)]) > 10
    first, second = forces_at_limit(result.walls[0])
    assert first == 0.0 and second > 0.0
