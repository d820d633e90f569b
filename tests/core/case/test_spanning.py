"""A wall between its transverse walls: when it is looked at, what it needs, what decides."""

from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.case.spanning import make_spanning_part, whole_courses
from core.case.wall_table import parse_wall_rows, text_rows
from core.errors import InputError
from core.study.run import run
from tests.clauses_alone import parse_case as clauses_alone
from tests.holds import behind, between

BEYOND = {"shoulder_length_m": 3.0, "shoulder_thickness_m": 0.45}
TIE = {"tie_kn_m": 30.0, "tie_bar_length_m": 5.0, "tie_elongation_m": 0.06}
WALL = {
    "name": "facade",
    "mechanism": "one_sided",
    "height_m": 3.5,
    "thickness_m": 0.45,
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "compressive_strength_mpa": 2.4,
    "unloaded_confirmed": True,
    "hold": [{"kind": "cross_walls", "evidence": {"kind": "opening"}}],
}
DEMAND = {"ag_g": 0.08, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
BUILDING = {"height_m": 7.0, "storeys": 2, "period_s": 0.25}


def wall_of(**changes):
    table = {key: value for key, value in {**WALL, **changes}.items() if value is not None}
    return parse_case({"wall": [table]}).wall[0]


def study(building=BUILDING, demand=DEMAND, **changes):
    table = {"wall": [{**WALL, **changes}], "demand": demand} | ({"building": building} if building else {})
    return run(clauses_alone(table), base_dir=Path())


def outcome(result):
    (one,) = result.verdicts
    return result.walls[one.governing]


@pytest.mark.shows("arch.needed")
def test_that_cross_walls_without_their_spacing_give_no_more_than_an_indication():
    bare = study()
    verdict = outcome(bare).required_assessment.verdict
    assert verdict.code == "indicative" and [limit.code for limit in verdict.limits][:1] == ["no_arch"]
    assert "spacing_m" in verdict.to_do[0].text("en")
    assert outcome(study(hold=behind("opening"))).required_assessment.verdict.code == "verified"
    assert outcome(study(hold=between(5.0, "test", **TIE))).required_assessment.verdict.code == "verified"


@pytest.mark.shows("arch.needed")
def test_that_the_worse_of_overturning_and_spanning_decides_and_says_where():
    result = study(hold=between(evidence="test", **{"spacing_m": 8.0, **TIE, "tie_kn_m": 0.5, "tie_bar_length_m": 8.0}))
    assert [wall.mechanism for wall in result.walls] == ["one_sided", "horizontal_bending"]
    turns, spans = (wall.required_assessment.verdict for wall in result.walls)
    assert turns.zeta_e > 1.0 and spans.code == "not_verified"
    assert turns.code == "indicative" and "fails_elsewhere" in [limit.code for limit in turns.limits]
    worst = outcome(result)
    assert worst.name == "facade (L 8 m)" and worst.required_assessment.dynamic is None
    said = result.verdicts[0]
    assert said.zeta_least == spans.zeta_e
    from core.report.verdict_words import sentence_of

    assert "between the transverse walls, 8 m apart" in sentence_of(worst, "en")
    assert "fra i muri trasversali, distanti 8 m" in sentence_of(worst, "it")


@pytest.mark.shows("arch.needed")
def test_that_a_thrust_without_a_reason_is_no_more_than_an_indication_and_its_row_says_so():
    verdict = outcome(study(hold=between(4.0, **TIE))).required_assessment.verdict
    (row,) = [row for row in verdict.assumptions if row.key == "evidence"]
    assert verdict.code == "indicative" and row.turns and row.zeta == 0.0 and not row.has_switch
    thrust = next(limit for limit in verdict.limits if limit.code == "arch_thrust").text("en")
    assert "H = 30.0 kN" in thrust and "the ties along the wall" in thrust


def test_that_its_demand_is_that_at_its_top_and_needs_the_building():
    verdict = outcome(study(building=None, hold=between(4.0, **TIE))).required_assessment.verdict
    assert verdict.code == "undetermined" and verdict.decides.code == "upper_top"
    assert make_spanning_part(wall_of(hold=between(4.0, **TIE))).demand_height_m == 3.5


@pytest.mark.shows("arch.thrust")
def test_that_more_of_what_holds_it_never_lowers_zeta_of_its_linear_check():
    draw = np.random.default_rng(11)
    for _ in range(12):
        arch = {"spacing_m": round(draw.uniform(3.0, 7.0), 2), **BEYOND, "tie_kn_m": draw.uniform(3.0, 60.0)}
        arch |= {"tie_elongation_m": 0.3, "tie_bar_length_m": 9.0}

        def zetas(f=2.4, arch=arch, **changes):
            wall = study(hold=between(**(arch | changes)), compressive_strength_mpa=f).walls[1]
            return [check.zeta for check in wall.required_assessment.checks if check.name == "linear_q_code"]

        base = zetas()
        for more in (zetas(tie_kn_m=1.3 * arch["tie_kn_m"]), zetas(shoulder_length_m=3.5), zetas(f=3.0)):
            assert all(one >= other * (1.0 - 1e-9) for one, other in zip(more, base, strict=True))
        assert all(one <= other for one, other in zip(zetas(spacing_m=1.2 * arch["spacing_m"]), base, strict=True))


def test_that_loads_that_push_or_press_are_counted_and_weights_hold_nothing_there():
    hold = between(5.0, **TIE)
    loads = (
        ({"kind": "vertical", "kn_m": 10.0, "d_m": 0.2, "h_m": 3.5, "mass": "none"}, 0.0, 0.0),
        ({"kind": "vertical", "kn_m": 2.0, "d_m": 0.2, "h_m": 3.5, "mass": "horizontal"}, 10.0, 0.0),
        ({"kind": "thrust", "kn_m": 0.2, "h_m": 3.4}, 0.0, 1.0),
        ({"kind": "thrust", "kn_m": -0.2, "h_m": 3.4}, 0.0, 1.0),  # it bends inward as it does outward
    )
    for load, more, pressed in loads:
        from core.codes.vertical_bending import bending

        strip = bending(make_spanning_part(wall_of(hold=hold, load=[load], unloaded_confirmed=None)).in_si).strip
        assert strip.weight == pytest.approx(1e3 * (40.5 + more)) and strip.lies
        assert strip.pressed * strip.weight == pytest.approx(1e3 * pressed)
    both = [{"kind": "thrust", "kn_m": sign * 0.2, "h_m": h} for sign, h in ((1, 1.0), (-1, 3.4))]
    strip = bending(make_spanning_part(wall_of(hold=hold, load=both, unloaded_confirmed=None)).in_si).strip
    assert strip.pressed * strip.weight == pytest.approx(2e3)  # they act on different metres: none helps the other


def test_that_whole_courses_bear_the_weight_of_a_wall_with_openings_steps_and_a_gable():
    shape = {"length_m": 6.0, "gable_m": 0.9, "hold": between(5.0, **TIE)}
    shape["openings"] = [
        {"s_m": 1.0, "z_m": 0.0, "width_m": 1.0, "height_m": 1.2},
        {"s_m": 3.0, "z_m": 0.8, "width_m": 1.0, "height_m": 0.8},
    ]
    wall = wall_of(**shape)
    assert whole_courses(wall) == pytest.approx(1.0)  # from 1.6 to the eaves at 2.6
    part = make_spanning_part(wall)
    assert part.height_m == 3.5 and part.demand_height_m == pytest.approx(3.5)
    from core.codes.vertical_bending import bending

    weight = bending(part.in_si).strip.weight
    assert weight == pytest.approx(wall.in_si.weight * 5.0, rel=1e-12)  # over a metre of courses
    thin = wall_of(steps=[{"from_z_m": 2.0, "thickness_m": 0.3}], length_m=6.0, hold=shape["hold"])
    assert make_spanning_part(thin).thickness == 0.3


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"mechanism": "horizontal_bending"}, "spacing_m"),
        ({"mechanism": "two_sided", "hold": between(5.0, **TIE)}, "one_sided, both or horizontal_bending"),
        ({"hold": between(spacing_m=5.0)}, "nothing takes the thrust"),
        ({"hold": between(spacing_m=5.0, tie_kn_m=5.0)}, "tie_bar_length_m go together"),
        ({"hold": between(**{"spacing_m": 5.0, **TIE, "tie_elongation_m": 0.0})}, "0.0057"),
        ({"hold": between(spacing_m=5.0, shoulder_length_m=5.0)}, "shoulder_thickness_m go together"),
        ({"hold": between(**{"spacing_m": 1.2, **TIE})}, "L/t from 3 to 25"),
        ({"hold": between(**{"spacing_m": 12.0, **TIE, "tie_bar_length_m": 12.0})}, "L/t from 3 to 25"),
        (
            {"hold": between(**{"spacing_m": 5.0, **TIE, "tie_bar_length_m": 4.9})},
            "from one transverse wall to the other",
        ),
        ({"hold": between(**{"spacing_m": 5.0, **TIE, "tie_elongation_m": 1.6})}, "1.5"),
        ({"compressive_strength_mpa": None, "hold": between(5.0, **TIE)}, "compressive_strength_mpa is needed"),
        ({"hold": between(5.0, **TIE), "mechanism": "horizontal_bending", "law": "doherty"}, "law does not go"),
        (
            {
                "hold": between(**{"spacing_m": 5.0, **TIE, "tie_kn_m": 0.5}),
                "load": [{"kind": "thrust", "kn_m": 2.0, "h_m": 3.0}],
                "unloaded_confirmed": None,
                "thickness_m": 0.6,
            },
            "without any earthquake",
        ),
        (
            {
                "hold": between(5.0, **TIE),
                "length_m": 6.0,
                "openings": [{"s_m": 1.0, "z_m": 0.0, "width_m": 1.0, "height_m": 3.2}],
            },
            "no arch carries",
        ),
    ],
)
def test_that_what_is_missing_or_does_not_go_with_it_is_said_in_one_sentence(changes, words):
    with pytest.raises(InputError) as caught:
        wall_of(**changes)
    assert words in str(caught.value) and "facade" in str(caught.value)


def test_that_a_table_of_walls_has_its_columns():
    head = (
        "Parete;H [m];t [m];Meccanismo;z [m];Peso specifico;f [MPa];vincolo 1;vincolo 1 L [m];vincolo 1 catena [kN/m];"
    )
    row = "a;3,5;0,45;flessione orizzontale;0;18;2,4;muri trasversali;5;30;6;6"
    (wall,) = parse_wall_rows(text_rows(f"{head}hold1_tie_elongation_m [cm];hold1_tie_bar_length_m [m]\n{row}"))
    assert (wall.mechanism, wall.arch.spacing_m, wall.arch.tie_elongation_m) == ("horizontal_bending", 5.0, 0.06)


def test_that_bands_too_low_for_an_arch_are_none_of_its_courses():
    """Five bands of 0.3 m between openings, one of 0.7 m below the eaves."""
    openings = [{"s_m": 1.0, "z_m": 0.3 + 0.5 * k, "width_m": 1.0, "height_m": 0.2} for k in range(5)]
    wall = wall_of(length_m=6.0, openings=openings, hold=between(5.0, **TIE))
    assert whole_courses(wall) == pytest.approx(3.5 - 2.5)


@pytest.mark.shows("arch.thrust")
def test_that_a_tie_holds_nothing_before_it_is_stretched():
    """At SLD, at rest and as the floor of the displacement check: read as an assumption of a wall that falls."""
    tied = study(hold=between(evidence="test", **{"spacing_m": 5.0, **TIE, "tie_elongation_m": 0.02})).walls[1]
    found = tied.assessment.kinematic
    assert found.chain.alpha0_bare < 1e-4 < found.alpha0
    check = next(one for one in tied.required_assessment.checks if one.name == "nonlinear")
    assert check.zeta == pytest.approx(check.capacity / check.demand, rel=1e-12)  # no a_g,SLD of the tie in it
    calm = {**DEMAND, "ag_g": 0.02}
    for more in ({}, {"limit_state": "SLD"}):
        table = {"wall": [{**WALL, "hold": between(5.0, "test", **TIE)}], "building": BUILDING}
        wall = run(clauses_alone({**table, "demand": calm | more}), base_dir=Path()).walls[1]
        assert wall.required_assessment.verdict.code == ("not_verified" if more else "verified")
    assert study(hold=between(5.0, **BEYOND)).walls[1].assessment.kinematic.chain.alpha0_bare > 0.1


def test_that_ends_which_push_against_nothing_fail_and_are_not_refused():
    wall = study(hold=between(spacing_m=5.0, shoulder_length_m=0.1, shoulder_thickness_m=0.45)).walls[1]
    assert wall.required_assessment.verdict.code == "not_verified" and wall.required_assessment.verdict.zeta_e < 1e-3


@pytest.mark.shows("arch.needed")
def test_that_a_wall_said_to_span_shows_the_wall_that_overturns():
    table = {"mechanism": "horizontal_bending", "hold": between(5.0, "test", **TIE)}
    verdict = study(demand=DEMAND | {"ag_g": 0.15}, **table).walls[0].required_assessment.verdict
    (row,) = [row for row in verdict.assumptions if row.key == "hold"]
    assert row.words.code == "ends_fail" and row.zeta == pytest.approx(
        study(demand=DEMAND | {"ag_g": 0.15}).walls[0].required_assessment.checks[0].zeta, rel=0.02
    )
    with pytest.raises(InputError, match="spacing_m"):  # a floor does not hold the ends of a wall
        study(mechanism="horizontal_bending", hold=behind())


@pytest.mark.parametrize("kind", ["cross_walls", "buttress"])
def test_that_what_holds_in_places_does_not_pass_without_their_spacing(kind):
    verdict = outcome(study(hold=behind(kind=kind, name="pareti di spina"))).required_assessment.verdict
    assert "no_arch" in [limit.code for limit in verdict.limits] and verdict.code == "indicative"


def test_that_a_wall_that_also_bends_between_ties_across_it_has_both_with_its_note():
    from core.report.note.content import full_note

    tie = {"kind": "tie", "out_kn_m": 60.0, "h_m": 3.0, "bar_length_m": 6.0}
    result = study(hold=[*between(5.0, **TIE), tie])
    assert [wall.mechanism for wall in result.walls][1:] == ["vertical_bending", "horizontal_bending"]
    assert full_note(result, "it") and full_note(result, "en")


@pytest.mark.shows("arch.thrust")
def test_that_a_tie_that_breaks_early_takes_nothing_from_the_masonry_beyond():
    from core.report.note.content import full_note

    brittle = {**BEYOND, "tie_kn_m": 24.0, "tie_bar_length_m": 5.0, "tie_elongation_m": 0.0065}

    def zeta_of(arch):
        result = study(hold=between(5.0, "test", **arch))
        assert full_note(result, "en")
        return next(check.zeta for check in result.walls[1].required_assessment.checks if check.name == "nonlinear")

    assert zeta_of(brittle) == pytest.approx(zeta_of(BEYOND), rel=1e-9)
    lasting = {**brittle, "tie_elongation_m": 0.5}
    assert zeta_of(lasting) > zeta_of(BEYOND)
