"""Ways in which a hurried engineer may come to "verified" for a wall that falls, and what the program says to each:
`python -m tests.core.variation.hurried` prints the list.

Each way is one change to a wall that fails. It is refused, or the wall still fails, or the outcome is one that nobody
may sign without more (indicative and its like), or what was changed stands beside the verdict: in its table of
assumptions, its limits, what is to be done, its notes, or the warnings of the wall. Anything else is silent.
"""

import copy
import math
import tempfile
from pathlib import Path
from typing import NamedTuple

from core.case import rules
from core.codes.outcomes import FAILS, OUTCOMES, PASSES
from core.errors import InputError
from core.report import json_report
from core.study.run import run
from tests.conftest import ROOT
from tests.holds import at_top, behind, between, shown

NTC = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "C", "topography": "T1"}
HAZARD = [
    {"return_period_years": 30.0, "ag_g": 0.04, "f0": 2.4, "tc_star_s": 0.28},
    {"return_period_years": 475.0, "ag_g": 0.12, "f0": 2.45, "tc_star_s": 0.33},
    {"return_period_years": 2475.0, "ag_g": 0.21, "f0": 2.5, "tc_star_s": 0.36},
]
FACADE = {"name": "w", "height_m": 5.0, "thickness_m": 0.45, "mechanism": "one_sided", "base_z_m": 0.0}
FACADE |= {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "cross_walls", "evidence": {"kind": "drawing"}}]}
BARE = {"unloaded_confirmed": True}
PARAPET = {"name": "p", "height_m": 1.2, "thickness_m": 0.25, "mechanism": "two_sided", "base_z_m": 9.0}
PARAPET |= {"unit_weight_kn_m3": 18.0, "unloaded_confirmed": True}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
FLOOR = {"kind": "vertical", "kn_m": 40.0, "d_m": 0.225, "h_m": 5.0, "mass": "moving"}
TIE = {"kind": "tie", "out_kn_m": 0.3, "h_m": 4.8, "bar_length_m": 9.0}
LIFE = {"nominal_life_years": 50, "use_class_factor": 1.0, "hazard": HAZARD}

BASES = {
    "facade": {"wall": [FACADE | BARE], "demand": {"ag_g": 0.12, "spectrum": NTC}},
    "at a site": {"wall": [FACADE | BARE], "demand": {"ag_g": 0.12, "spectrum": NTC} | LIFE},
    "parapet": {"wall": [PARAPET], "building": BUILDING, "demand": {"ag_g": 0.07, "spectrum": NTC}},
    "loaded": {"wall": [FACADE | {"load": [FLOOR]}], "demand": {"ag_g": 0.115, "spectrum": NTC}},
    "tied": {"wall": [FACADE | BARE | {"hold": [*FACADE["hold"], TIE]}], "demand": {"ag_g": 0.115, "spectrum": NTC}},
}
"""Cases each of which falls a little short of its demand."""


class Way(NamedTuple):
    """base : of BASES; changes : path within it -> value, DROP to leave the key out; told : keys of the rows, limits
    and tasks one of which names it where the outcome passes"""

    name: str
    base: str
    changes: dict
    told: str = ""


DROP = object()
FILES = {
    "weak.txt": "0 0.05\n0.1 0.08\n0.3 0.08\n0.5 0.03\n1 0.02\n4 0.002\n",
    "narrow.txt": "0 0.12\n0.05 0.29\n0.1 0.29\n0.2 0.05\n1 0.01\n4 0.0006\n",
}
LC3 = {
    "demand.confidence_factor": 1.0,
    "demand.knowledge_level": "LC3",
    "demand.evidence": shown(confidence_factor="three flat jacks"),
}
LINEAR = {"demand.spectrum": DROP}
EUROPEAN = {"code": "EN1998", "type": 2, "soil": "A"}
WALL, LOAD, HOLD, SPECTRUM = "wall.0.", "wall.0.load.0.", "wall.0.hold.1.", "demand.spectrum."
MOTIONS = [{"file": str(ROOT / "tests" / "motions" / f"noise_{k}.txt"), "kind": "artificial"} for k in range(1, 8)]


def _ways():
    """A row each: base, changes, what names it."""
    for key, value in {"limit_state": "SLD", "zeta_target": 0.4, "q_code": 6.0, "confidence_factor": 1.0}.items():
        yield Way(f"{key} = {value}", "facade", {f"demand.{key}": value}, key)
    yield Way("FC on the demand", "facade", {"demand.confidence_on": "demand"}, "confidence_on")
    yield Way("a range of long periods", "facade", {"demand.period_range_s": [1.5, 2.0]}, "not_compatible")
    yield Way("records scaled to the PGA", "facade", {"demand.demand_scaling": "pga"}, "not_compatible")
    yield Way("SLC with the a_g of SLV", "facade", {"demand.limit_state": "SLC"}, "limit_state")
    for reason in ("boh", "da definire", "xxx"):
        said = {
            "demand.confidence_factor": 1.0,
            "demand.knowledge_level": "LC3",
            "demand.evidence": shown(confidence_factor=reason),
        }
        yield Way(f"LC3 by {reason}", "facade", said, "confidence_factor")
        said = {"demand.zeta_target": 0.4, "demand.evidence": shown(zeta_target=reason)}
        yield Way(f"a target of 0.4 for {reason}", "facade", said, "zeta_target")
    yield Way("LC3 without the strength", "facade", LC3, "confidence_factor")
    strong = {WALL + "compressive_strength_mpa": 20.0}
    yield Way("LC3 with a strength of 20 MPa", "facade", LC3 | strong, "compressive_strength_mpa")
    yield Way("no spectrum, no S", "facade", {"demand.spectrum": DROP}, "no_soil_factor")
    spain = {"code": "EN1998-ES", "soil": "A", "vs30_m_s": 900.0, "contribution_k": 0.5}
    yield Way("an annex not seen in print", "facade", {"demand.spectrum": spain}, "annex_unseen")
    for soil in (0.9, 1.0):
        yield Way(f"S {soil}, no spectrum", "facade", LINEAR | {"demand.soil_factor": soil}, "linear_alone")
    small = LINEAR | {"demand.soil_factor": 1.0, "demand.housner_intensity_cm": 5.0}
    yield Way("an intensity of 5 cm", "facade", small, "linear_alone")
    for key, value in {"f0": 2.0, "tc_star_s": 0.05}.items():
        yield Way(f"{key} = {value}", "facade", {SPECTRUM + key: value}, key)
    of_soil_c = {"demand.spectrum": EUROPEAN | {"soil": "C"}}
    yield Way("EN 1998 type 2, no hazard", "facade", of_soil_c, "lift_type spectrum")
    # of the soil that is given: rock in place of soil C is the designer's statement, printed with the demand
    soil_c = {"demand.spectrum": EUROPEAN | {"soil": "C"}}
    yield Way("EN 1998 type 2", "at a site", soil_c, "lift_spectrum")
    weak = {"demand.spectrum": DROP, "demand.spectrum_file": "weak.txt"}
    yield Way("a spectrum that begins low, hazard known", "at a site", weak)
    yield Way("a spectrum that begins low", "facade", weak)
    yield Way(
        "a spectrum that falls early", "at a site", weak | {"demand.spectrum_file": "narrow.txt"}, "lift_spectrum"
    )
    yield Way("a_g of another return period", "at a site", {"demand.ag_g": 0.05})
    yield Way("T_R 50 years", "at a site", {"demand.ag_g": 0.048, "demand.return_period_years": 50.0})
    for life, share in ((10, 1.0), (50, 0.7), (35, 1.0)):
        years = life * share * 9.4912
        ag = 0.04 * (0.12 / 0.04) ** (math.log(years / 30.0) / math.log(475.0 / 30.0))
        said = {"demand.nominal_life_years": life, "demand.use_class_factor": share, "demand.ag_g": round(ag, 4)}
        yield Way(f"V_N {life}, C_U {share}", "at a site", said | LINEAR | {"demand.soil_factor": 1.3}, "lift_life")
    yield Way("histories off", "facade", {"analysis": {"histories": False}}, "histories")
    for base in ("facade", "parapet", "loaded"):
        yield Way("scatter 0", base, {"generate": {"count": 7, "scatter": 0.0}}, "scatter")
        yield Way("3 motions", base, {"generate": {"count": 3}}, "few_records not_compatible")
    for method in ("newmark_paper", "linearised"):
        yield Way(f"method {method}", "facade", {"analysis": {"method": method}}, "comparison")
    yield Way("records of the examples", "facade", {"record": MOTIONS}, "bundled")
    yield Way("one record", "facade", {"record": MOTIONS[:1]}, "few_records")
    yield Way("the same record seven times", "facade", {"record": MOTIONS[:1] * 7})
    weaker = [motion | {"scale": 0.2, "kind": "natural"} for motion in MOTIONS]
    yield Way("weak records as natural ones", "facade", {"record": weaker}, "weaker_records")
    one_way = {"record": MOTIONS, "analysis": {"polarity": "as_recorded"}}
    yield Way("records one way", "facade", one_way, "one_sign")
    for key, value, told in (
        ("restitution", "costa_upper", "restitution"),
        ("velocity_ratio", 0.3, "velocity_ratio"),
        ("law", "doherty", "law"),
        ("law", "rigid", "law"),
        ("hinge_heights", "base", "heights_left_out hinges_as_asked"),
        ("hinge_heights", [3.0], "heights_left_out hinges_as_asked"),
        ("hinge_setback_m", 0.0, "hinge_setback_m"),
        ("compressive_strength_mpa", 20.0, "compressive_strength_mpa"),
        ("elastic_modulus_mpa", 10000.0, "elastic_modulus_mpa"),
        ("unit_weight_kn_m3", 25.0, "unit_weight_kn_m3"),
        ("hold", behind(""), "hold"),
        ("hold", DROP, "hold"),
        ("hold", behind(kind="floor", h_m=2.0), "heights_left_out hinges_as_asked"),
        ("hold", behind(name="non c'è", evidence=""), "hold"),
        ("hold", between(evidence="test", name="da definire"), "hold"),
        ("thickness_m", 45.0, ""),
        ("height_over_thickness", 2.0, ""),
        ("length_m", 0.5, "length_m"),
        ("mechanism", "two_sided", "mechanism"),
        ("masonry", "squared_hard_stone", "masonry"),
        ("base_z_m", DROP, ""),
        ("variant", "progetto", "variant_alone"),
        ("unloaded_confirmed", DROP, "unloaded"),
    ):
        yield Way(f"{key} {'left out' if value is DROP else value}", "facade", {WALL + key: value}, told)
    across = {"number": 4, "thickness_m": 0.6, "brick_height_m": 0.2, "brick_length_m": 0.4}
    yield Way(
        "friction of four walls", "facade", {WALL + "return_walls": across, WALL + "length_m": 5.0}, "return_walls"
    )
    wedges = {"number": 2, "thickness_m": 0.6, "length_at_top_m": 1.0}
    yield Way("wedges behind", "facade", {WALL + "return_wedges": wedges, WALL + "length_m": 5.0}, "return_wedges")
    general = {
        WALL + "thickness_m": DROP,
        WALL + "height_m": DROP,
        WALL + "radius_m": 9.0,
        WALL + "slenderness_deg": 12.0,
    }
    yield Way("a radius of one's own", "facade", general)
    heavy, bare = FLOOR | {"kn_m": 300.0, "d_m": 0.45, "mass": "none"}, {WALL + "unloaded_confirmed": DROP}
    yield Way("a heavy floor at the inner face", "facade", bare | {WALL + "load": [heavy]}, "unasked_range")
    low = bare | {WALL + "load": [heavy | {"h_m": 0.1}], WALL + "hinge_heights": "base"}
    yield Way("a heavy floor just above the hinge", "facade", low, "h_m")
    inward = {"kind": "thrust", "kn_m": -0.5, "h_m": 5.0}
    yield Way("a force that pulls inward", "facade", bare | {WALL + "load": [inward]}, "load")
    yield Way("a held mass", "loaded", {LOAD + "mass": "none", LOAD + "kn_m": 150.0}, "lift_mass")
    yield Way("the lever of the whole thickness", "loaded", {LOAD + "d_m": 0.45, LOAD + "kn_m": 150.0}, "unasked_range")
    for change, told in (
        ({"elongation_m": 0.9}, "elongation_m"),
        ({"slack_mm": 40.0, "elongation_m": 0.9}, "slack_mm"),
        ({"prestress": 0.8}, "prestress anchorage_kn elongation_m"),
        ({"bar_length_m": 0.3}, "anchorage_kn elongation_m"),
        ({"fy_mpa": 1400.0}, "anchorage_kn elongation_m"),
        ({"out_kn_m": 40.0}, ""),
    ):
        name = ", ".join(f"{key} {value}" for key, value in change.items())
        of_tie = {HOLD + key: value for key, value in ({"out_kn_m": 2.2} | change).items()}
        yield Way(f"a tie with {name}", "tied", of_tie, told)
    bar = {WALL + "length_m": 5.0, HOLD + "out_kn_m": DROP, HOLD + "bar": {"number": 1, "diameter_mm": 8.0}}
    yield Way("a bar without a word of its anchorage", "tied", bar, "anchorage_kn elongation_m")
    held = bar | {HOLD + "bar": {"number": 1, "diameter_mm": 8.0, "anchorage_kn": 9000.0}, HOLD + "elongation_m": 0.9}
    yield Way("a bar with an anchorage of 9 MN", "tied", held, "elongation_m")
    for key, value, told in (
        ("storeys", 1, "odd_storeys"),
        ("period_s", 2.5, "period_s"),
        ("period_s", DROP, "period_s"),
        ("period_factor", 2.5, "building"),
        ("damping", 0.3, "building"),
        ("height_m", 60.0, "odd_storeys"),
    ):
        yield Way(
            f"[building] {key} {'left out' if value is DROP else value}", "parapet", {f"building.{key}": value}, told
        )
    modes = [{"period_s": 0.26, "damping": 0.1, "participation": 0.05}]
    idle = {"building.period_s": DROP, "building.modes": modes}
    yield Way("a mode that takes no part", "parapet", idle, "participation")
    yield Way(
        "a parapet that is not free", "parapet", {WALL + "hold": behind("", kind="cross_walls")}, "hold elastic_branch"
    )
    yield Way("a parapet by the rigid law", "parapet", {WALL + "law": "rigid"}, "law")
    yield Way("a parapet of stiff masonry", "parapet", {WALL + "elastic_modulus_mpa": 10000.0}, "law elastic_branch")
    held = {WALL + "hold": behind(name="tetto")}
    yield Way("a parapet that rocks one way", "parapet", held | {WALL + "mechanism": "one_sided"}, "hold")
    cancels = [{"period_s": 0.26, "damping": 0.1, "participation": share} for share in (9.0 / 7.0, -9.0 / 7.0)]
    yield Way("modes that cancel", "parapet", {"building.period_s": DROP, "building.modes": cancels}, "participation")
    yield from _ways_past_a_row()
    thick = [FACADE | BARE | {"name": "thick", "thickness_m": 1.2}, FACADE | BARE]
    yield Way("a thick wall first in the list", "facade", {"wall": thick})


def _ways_past_a_row():
    """Changes that took away the row, or the hinge, that kept a wall from "verified"."""
    bare, unsaid = {WALL + "unloaded_confirmed": DROP}, {WALL + "hold": between(evidence="")}
    thrust, foot = {"kind": "thrust", "kn_m": 1.9, "h_m": 5.0}, {"kind": "vertical", "mass": "none", "kn_m": 60.0}
    low = bare | {WALL + "load": [thrust, foot | {"h_m": 0.5, "d_m": 0.4}]}
    yield Way("a thrust under which the wall falls without its low weight", "facade", low, "h_m")
    fixed = {"kind": "carried_mass", "kn_m": 60.0, "h_m": 2.05, "d_m": 0.45}
    snow = {
        "kind": "vertical",
        "mass": "moving",
        "g_kn_m": 0.01,
        "q_kn_m": 0.01,
        "psi_2": 0.3,
        "h_m": 5.0,
        "d_m": 0.225,
    }
    yield Way("a little snow beside a carried mass", "facade", bare | {WALL + "load": [fixed, snow]}, "load")
    thick = unsaid | {WALL + "thickness_m": 0.65}
    yield Way("no evidence, no histories", "facade", thick | {"analysis": {"histories": False}}, "hold")
    yield Way("no evidence, no spectrum", "facade", thick | LINEAR | {"demand.soil_factor": 1.5}, "hold")
    wire = {"kind": "tie", "out_kn_m": 0.01, "h_m": 5.0, "bar_length_m": 5.0}
    leans = thick | {WALL + "out_of_plumb_m": 0.001, WALL + "length_m": 5.0}
    leans |= {WALL + "hold": [*between(evidence=""), wire]}
    yield Way("no evidence, a tie of 10 N and a lean of 1 mm", "facade", leans, "hold")
    wedges = {"number": 2, "thickness_m": 1.0, "length_at_top_m": 3.0}
    behind = unsaid | {WALL + "length_m": 5.0, WALL + "return_wedges": wedges}
    behind |= {WALL + "evidence": shown(return_wedges="survey 3")}
    yield Way("no evidence, wedges behind", "facade", behind, "hold")
    halves = [
        {"plane": "section", "to_m": 5.0, "unit_weight_kn_m3": weight, "polygon_m": [[a, 0], [b, 0], [b, 5], [a, 5]]}
        for a, b, weight in ((0.0, 0.225, 5.0), (0.225, 0.45, 40.0))
    ]
    yield Way(
        "light outside, heavy inside", "facade", {WALL + "length_m": 5.0, WALL + "solid": halves}, "unit_weight_kn_m3"
    )
    plinth = {WALL + "thickness_m": 1.5, WALL + "length_m": 5.0}
    plinth |= {WALL + "steps": [{"from_z_m": 0.3, "thickness_m": 0.45, "flush": "outer"}]}
    yield Way("a plinth below the hinge", "facade", plinth, "heights_left_out")
    leans = [{"plane": "section", "to_m": 5.0, "polygon_m": [[0, 0], [0.65, 0], [1.35, 5], [0.7, 5]]}]
    unnamed = {WALL + "thickness_m": 0.65, WALL + "hold": DROP}
    bare_lean = {WALL + "thickness_m": 0.65, WALL + "length_m": 5.0, WALL + "solid": leans, "demand.ag_g": 0.05}
    yield Way("leans inward, nothing behind it", "facade", bare_lean | unnamed, "hold")
    held = {WALL + "mechanism": "vertical_bending", WALL + "thickness_m": 0.5, WALL + "height_m": 7.0}
    held |= {WALL + "hold": at_top(7.0, 50.0, evidence=""), "demand.ag_g": 0.08}
    held |= {"building": {"height_m": 7.0, "storeys": 2, "period_s": 0.2}, "analysis": {"histories": False}}
    yield Way("held at its top, no evidence, no histories", "facade", held, "hold")
    inside = [[0, 0], [0.65, 0], [0.65, 5], [0, 5]]
    heavy = [{"plane": "section", "to_m": 5.0, "unit_weight_kn_m3": 40.0, "polygon_m": inside}]
    pushed = bare | {WALL + "thickness_m": 0.65, WALL + "length_m": 5.0, WALL + "unit_weight_kn_m3": 40.0}
    pushed |= {WALL + "load": [{"kind": "thrust", "kn_m": 4.0, "h_m": 5.0}], WALL + "solid": heavy, "demand.ag_g": 0.06}
    yield Way("the weight of the wall once more in its solid", "facade", pushed, "unit_weight_kn_m3 unasked_range")
    step = {WALL + "height_m": 9.0, WALL + "thickness_m": 0.65, WALL + "length_m": 5.0, "demand.ag_g": 0.08}
    step |= {WALL + "steps": [{"from_z_m": 6.0, "thickness_m": 0.25, "flush": "outer"}], WALL + "hinge_heights": "base"}
    storeys = {"building": {"height_m": 9.0, "storeys": 3, "period_s": 0.26}}
    yield Way("a hinge left out of those of the building", "facade", step | storeys, "hinges_as_asked")
    one = {"record": MOTIONS[:1]}
    yield Way("scatter 0.33 beside a record", "facade", one | {"generate": {"count": 14, "scatter": 0.33}}, "scatter")
    # a seed is not asked about: that motions are generated is said, and the interval of other samples is beside zeta
    yield Way("a seed beside a record", "facade", one | {"generate": {"seed": 6}}, "generated_motions")


WAYS = tuple(_ways())


def changed(way: Way) -> dict:
    """The case of a way."""
    table = copy.deepcopy(BASES[way.base])
    for path, value in way.changes.items():
        at, *rest = path.split(".")
        here, names = table, [at, *rest]
        for name in names[:-1]:
            here = here[int(name)] if name.isdigit() else here[name]
        last = names[-1]
        if value is DROP:
            here.pop(last, None)
        else:
            here[last] = value
    return table


REFUSED, FALLS, UNSIGNED, NAMED, SILENT = "refused", "falls", "not to be signed", "named", "SILENT"


def said_to(way: Way) -> tuple[str, str]:
    """What becomes of a way, one of the five words, and the outcome of the wall with what names it."""
    with tempfile.TemporaryDirectory() as folder:
        for name, rows in FILES.items():
            (Path(folder) / name).write_text(rows)
        try:
            result = run(rules.parse_case(changed(way)), base_dir=Path(folder))
        except InputError as error:
            return REFUSED, error.text("en")
    verdict = next(one for one in json_report.results(result)["verdicts"] if one["wall"] in ("w", "p"))
    judgement = OUTCOMES[verdict["code"]].judgement
    if judgement != PASSES:
        return (FALLS if judgement == FAILS else UNSIGNED), verdict["code"]
    known = {one["key"] for part in ("assumptions", "to_do", "limits", "notes") for one in verdict[part]}
    named = known & set(way.told.split())
    return (NAMED if named else SILENT), f"{verdict['code']} {verdict['zeta_e']:.2f}: {', '.join(sorted(named))}"


if __name__ == "__main__":
    for one in WAYS:
        print(f"| {one.base} | {one.name} | {' | '.join(said_to(one))} |", flush=True)
