"""Walls whose ties would open a hinge above their base: they bend between base and tie."""

import itertools
from pathlib import Path

import numpy as np
import pytest

from core.case.above_hinge import cut_above_hinge
from core.case.held_stretches import find_held_stretches
from core.case.held_top import mirror_inward
from core.case.hinges import make_wall_parts, turns_above_ties
from core.case.rules import parse_case
from core.case.spans_between_ties import cut_span, find_bending_spans, multiplier_at_yield
from core.codes.vertical_bending import bending
from core.errors import InputError
from core.study.run import run
from core.wall.wall_loads import hinge_inside
from tests.clauses_alone import parse_case as clauses_alone
from tests.holds import carries

FACADE = {
    "name": "facade",
    "height_m": 7.5,
    "thickness_m": 0.45,
    "length_m": 8.0,
    "unit_weight_kn_m3": 18.0,
    "base_z_m": 0.0,
    "mechanism": "one_sided",
    "hold": [{"kind": "cross_walls", "evidence": {"kind": "drawing"}}],
    "hinge_heights": "base",
}
ROOF = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.225, "h_m": 6.5, "mass": "none"}
BAR = {"number": 4, "diameter_mm": 24.0, "fy_mpa": 235.0, "fu_mpa": 360.0, "anchorage_kn": 200.0}
TIE = {"kind": "tie", "h_m": 6.5, "bar_length_m": 8.0, "elongation_m": 0.4, "bar": BAR}
ACROSS = {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}
DEMAND = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
BUILDING = {"height_m": 7.5, "storeys": 2, "period_s": 0.3}


def wall_of(*loads, **changes):
    return parse_case({"wall": [carries(*loads, **(FACADE | changes))]}).wall[0]


def study(*loads, **changes):
    table = {"wall": [carries(*loads, **(FACADE | changes))], "demand": DEMAND, "building": BUILDING}
    return run(clauses_alone(table), base_dir=Path())


@pytest.mark.shows("held.between")
def test_that_four_bars_give_an_answer_and_the_worst_of_turning_and_bending_decides():
    result = study(ROOF, TIE)
    turns, bends = result.walls
    assert (turns.mechanism, bends.mechanism) == ("one_sided", "vertical_bending")
    assert bends.name == "facade (0–6.5 m)" and bends.wall.height_m == 6.5
    (verdict,) = result.verdicts
    assert verdict.governing == 1
    assert bends.assessment.verdict.zeta_e < turns.assessment.verdict.zeta_e
    assert verdict.zeta_least == bends.assessment.verdict.zeta_e


def test_that_what_is_above_the_tie_stands_on_the_stretch_below_it():
    (low, high), wall = (0.0, 6.5), wall_of(ROOF, TIE)
    assert find_bending_spans(wall) == ((low, high),)
    part = cut_span(wall, low, high)
    assert sorted(load.kn_m for load in part.load) == pytest.approx([18.0 * 0.45 * 1.0, 12.0])
    assert all(load.h_m == 6.5 and load.mass == "none" for load in part.load)
    # by virtual work: W1 at the middle of the lower block, W2 and both loads lifted by the upper one
    found = bending(part.in_si)
    h1, t, w = found.h1, 0.45, 18e3 * 0.45
    k = h1 / (6.5 - h1)
    lifted = w * h1 * t / 2 + w * (6.5 - h1) * (t + k * t / 2) + (12e3 + w) * (t + k * t / 2)
    assert found.alpha0 == pytest.approx(lifted / (w * 6.5 * h1 / 2), rel=1e-12)


@pytest.mark.parametrize(
    ("loads", "changes"),
    [
        ((ROOF, {**TIE, "slack_mm": 2.0}), {}),
        ((ROOF, TIE, {"kind": "thrust", "kn_m": -1.0, "h_m": 3.0}), {}),
        (
            (ROOF, TIE),
            {"return_walls": {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}},
        ),
    ],
)
def test_that_where_it_cannot_bend_a_strong_tie_is_refused(loads, changes):
    with pytest.raises(InputError) as refused:
        wall_of(*loads, **changes)
    assert refused.value.code == "tie_too_strong"


def test_that_a_wall_too_stocky_to_bend_below_a_strong_tie_turns_above_it():
    wall = wall_of(ROOF, {**TIE, "h_m": 1.2})
    assert find_bending_spans(wall) == () and turns_above_ties(wall, 0.0)
    assert [part.hinge for part in make_wall_parts(0, wall, None)] == [0.0, 1.2]


def test_that_random_ties_are_accepted_where_the_wall_turns_or_bends_and_more_steel_never_lifts_bending():
    rng = np.random.default_rng(11)
    seen = set()
    for _ in range(40):
        height = float(rng.uniform(5.0, 9.0))
        tie = {**TIE, "h_m": float(rng.uniform(0.5, 1.0)) * height}
        bar = {**BAR, "number": int(rng.integers(1, 8)), "diameter_mm": float(rng.choice([12.0, 20.0, 30.0]))}
        wall = wall_of({**ROOF, "h_m": height}, {**tie, "bar": bar}, height_m=height)
        spans = find_bending_spans(wall)
        parts = make_wall_parts(0, wall, None)
        assert spans or hinge_inside(wall.in_si) is None
        bends = [part for part in parts if part.top is not None]
        assert [(part.hinge, part.top) for part in bends] == list(spans)
        seen.add(bool(spans))
        for part in bends:
            more = wall_of({**ROOF, "h_m": height}, {**tie, "bar": {**bar, "number": 20}}, height_m=height)
            assert bending(cut_span(more, part.hinge, part.top).in_si).alpha0 == bending(part.wall.in_si).alpha0
    assert seen == {True, False}


def test_that_what_shows_the_cross_walls_does_not_show_the_tie():
    """A stretch that passes is no verification before the engineer says what shows its tie."""
    gentle = {"demand": {"ag_g": 0.05, "spectrum": DEMAND["spectrum"]}, "building": BUILDING}
    codes = {}
    for document in ({}, {"evidence": {"kind": "calculation", "reference": "plates and masonry, 12"}}):
        tie = TIE | document
        table = {"wall": [carries({**ROOF, "d_m": 0.3}, tie, **(FACADE | {"thickness_m": 0.6}))], **gentle}
        walls = run(clauses_alone(table), base_dir=Path()).walls
        (stretch,) = (wall for wall in walls if wall.part.top is not None)
        found = stretch.wall.held_by.evidence
        assert (found.kind if found else None) == ("calculation" if document else None)
        codes[bool(document)] = stretch.assessment.verdict
    row = next(row for row in codes[False].assumptions if row.key == "hold")
    assert row.reason == "" and (codes[False].code == "indicative" or not row.turns)


def test_that_a_weak_tie_between_holds_nothing():
    """A wire at mid-height does not make two stretches of one, nor do bars before it is looked at what they stand."""
    wire = {**TIE, "h_m": 3.25, "bar": {**BAR, "number": 1, "diameter_mm": 4.0}}
    assert (0.0, 6.5) in find_bending_spans(wall_of(ROOF, TIE, wire))
    assert (0.0, 6.5) in find_bending_spans(
        wall_of(ROOF, TIE, {"kind": "tie", "out_kn_m": 0.01, "h_m": 3.25, "bar_length_m": 8.0})
    )
    strong = wall_of(ROOF, TIE, {**TIE, "h_m": 3.25})
    assert find_bending_spans(strong) == ((0.0, 3.25), (0.0, 6.5), (3.25, 6.5))
    assert [(held.low, held.high) for held in find_held_stretches(strong)] == [(0.0, 3.25), (3.25, 6.5)]


def test_that_more_steel_gives_no_lower_zeta_by_a_jump():
    zetas = []
    for force in (6.0, 8.0, 9.0, 10.0, 10.5, 11.0, 11.4, 15.0):
        tie = {"kind": "tie", "out_kn_m": force, "h_m": 6.5, "bar_length_m": 8.0, "elongation_m": 0.4}
        zetas.append(min(wall.assessment.verdict.zeta_e for wall in study(ROOF, tie).walls))
    assert all(later >= earlier * (1.0 - 0.02) for earlier, later in itertools.pairwise(zetas)), zetas


def test_that_a_weight_between_holds_only_what_is_below_it():
    """A floor that carries much at 3 m: from there to the tie the wall bends sooner than from its base."""
    floor = {**ROOF, "kn_m": 150.0, "h_m": 3.0}
    loads = ({**ROOF, "kn_m": 2.0, "h_m": 9.0}, {**TIE, "h_m": 9.0}, floor)
    wall = wall_of(*loads, height_m=9.0)
    assert find_bending_spans(wall) == ((0.0, 9.0), (3.0, 9.0))
    whole, upper = (bending(cut_span(wall, *span).in_si).alpha0 for span in find_bending_spans(wall))
    assert upper < whole
    alone = cut_span(wall_of(*loads[:2], height_m=9.0, base_z_m=0.0), 3.0, 9.0)
    assert bending(alone.in_si).alpha0 == upper


def test_that_the_wall_above_a_tie_is_looked_at_whatever_hinges_are_asked():
    wall = wall_of({**ROOF, "h_m": 4.5}, {**TIE, "h_m": 4.5, "bar": {**BAR, "number": 8}}, height_m=9.0)
    assert find_bending_spans(wall) == ((0.0, 4.5),) and wall.hinge_heights == "base"
    assert [(part.hinge, part.top) for part in make_wall_parts(0, wall, None)] == [(0.0, None), (4.5, None), (0.0, 4.5)]
    weak = wall_of(
        {**ROOF, "h_m": 4.5}, {**TIE, "h_m": 4.5, "bar": {**BAR, "number": 1, "diameter_mm": 8.0}}, height_m=9.0
    )
    assert [part.hinge for part in make_wall_parts(0, weak, None)] == [0.0]


def shaped(rng):
    """A facade with a step, a door, a window and a gable, tied below the eaves, and where its bars are [m]."""
    height, gable, length = float(rng.uniform(6.0, 11.0)), float(rng.uniform(0.8, 3.0)), float(rng.uniform(5.0, 12.0))
    thickness = float(rng.uniform(0.4, 0.7))
    at = float(rng.uniform(0.85, 1.0)) * (height - gable)
    door = {"s_m": 0.4 * length, "z_m": 0.0, "width_m": 0.2 * length, "height_m": 0.3 * at}
    window = {"s_m": 0.3 * length, "z_m": 0.5 * at, "width_m": 0.3 * length, "height_m": 0.3 * at}
    step = {"from_z_m": float(rng.uniform(0.35, 0.45)) * at, "thickness_m": float(rng.uniform(0.7, 0.95)) * thickness}
    roof = {**ROOF, "d_m": 0.3 * thickness, "h_m": height - gable, "kn_m": float(rng.uniform(1.0, 20.0))}
    tie = {**TIE, "h_m": at, "bar": {**BAR, "number": 12}}
    changes = {"height_m": height, "gable_m": gable, "length_m": length, "thickness_m": thickness}
    flush = str(rng.choice(["outer", "inner", "middle"]))
    return (roof, tie), {**changes, "openings": [door, window], "steps": [{**step, "flush": flush}]}, at


FACE = {"outer": 0.0, "inner": 1.0, "middle": 0.5}


def boxes_of(wall, low, high, slices=400):
    """(weight [N/m], x from the outer face at its base [m], z) of thin layers of a facade as `shaped` makes it."""
    (step,), t, found = wall.steps, wall.thickness_m, []
    face = FACE[step.flush] * (t - step.thickness_m)
    for k in range(slices):
        z = low + (k + 0.5) * (high - low) / slices
        wide = wall.length_m * min(1.0, (wall.height_m - z) / wall.gable_m)
        wide -= sum(opening.width_m for opening in wall.openings if opening.z_m < z < opening.z_m + opening.height_m)
        outer, thick = (face, step.thickness_m) if z > step.from_z_m else (0.0, t)
        found.append((18e3 * wide * thick * (high - low) / slices / wall.length_m, outer + 0.5 * thick, z))
    return found


@pytest.mark.shows("held.between")
@pytest.mark.parametrize("seeds", [range(12), pytest.param(range(12, 1012), marks=pytest.mark.long)], ids=len)
def test_that_a_facade_of_any_shape_bends_as_its_layers_do(seeds):
    for seed in seeds:
        bends_as_its_layers(seed)


def bends_as_its_layers(seed):
    """Virtual work of layers in coordinates, at the hinge found; a gable and a roof above the tie stand on it."""
    loads, changes, at = shaped(np.random.default_rng(seed))
    wall = wall_of(*loads, **changes)
    assert (0.0, at) in find_bending_spans(wall)
    part = cut_span(wall, 0.0, at)
    found, t = bending(part.in_si), wall.thickness_m
    (step,), h1 = wall.steps, found.h1
    face = FACE[step.flush] * (t - step.thickness_m)
    inner = min(t, face + step.thickness_m) if h1 >= step.from_z_m - 1e-6 else t
    k = h1 / (at - h1)
    roof, gable = loads[0], boxes_of(wall, at, wall.height_m, 4000)
    over, x = sum(w for w, _, _ in gable), sum(w * x for w, x, _ in gable) / sum(w for w, _, _ in gable)
    depth = min(max(roof["d_m"], face), face + step.thickness_m)
    held = [(over, x), (1e3 * roof["kn_m"], depth)]
    lifted = pushed = 0.0
    for weight, x, z in boxes_of(wall, 0.0, at, 4000):
        below = z < h1
        lifted += weight * (x if below else inner + k * (inner - x))
        pushed += weight * (z if below else h1 - k * (z - h1))
    lifted += sum(weight * (inner + k * (inner - x)) for weight, x in held)
    assert found.alpha0 == pytest.approx(lifted / pushed, rel=2e-3)


def test_that_a_shape_that_becomes_a_rectangle_bends_as_one():
    plain = wall_of(ROOF, TIE)
    (expected,) = (bending(cut_span(plain, *span).in_si) for span in find_bending_spans(plain))
    shapes = (
        {"openings": [{"s_m": 4.0, "z_m": 3.0, "width_m": 0.05, "height_m": 0.05}]},
        {"steps": [{"from_z_m": 7.4, "thickness_m": 0.449999}]},
        {"out_of_plumb_m": 1e-6},
        {"return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 1.0}},
    )
    for shape in shapes:
        wall = wall_of(ROOF, TIE, **shape)
        (found,) = (bending(cut_span(wall, *span).in_si) for span in find_bending_spans(wall))
        assert found.alpha0 == pytest.approx(expected.alpha0, rel=2e-3), shape


def test_that_a_mirrored_body_bends_outward_as_it_does_inward():
    wall = wall_of(*(made := shaped(np.random.default_rng(3)))[0], **made[1])
    part = cut_span(wall, 0.0, made[2])
    assert part.solid
    twice = mirror_inward(mirror_inward(part))
    assert bending(twice.in_si).alpha0 == pytest.approx(bending(part.in_si).alpha0, rel=1e-12)
    assert bending(mirror_inward(part).in_si).alpha0 != pytest.approx(bending(part.in_si).alpha0, rel=1e-3)


def test_that_a_facade_leaning_outward_bends_the_sooner():
    alphas = []
    for lean in (0.0, 0.02, 0.05, 0.1):
        wall = wall_of(ROOF, TIE, **({"out_of_plumb_m": lean} if lean else {}))
        (span,) = find_bending_spans(wall)
        part = cut_span(wall, *span)
        alphas.append(min(bending(one.in_si).alpha0 for one in (part, mirror_inward(part))))
    assert alphas == sorted(alphas, reverse=True) and alphas[0] > alphas[-1]


@pytest.mark.parametrize("shape", [{"openings": [{"s_m": 2.0, "z_m": 1.0, "width_m": 1.0, "height_m": 1.4}]},
                                   {"steps": [{"from_z_m": 3.0, "thickness_m": 0.4}]}, {"out_of_plumb_m": 0.05},
                                   {"gable_m": 1.5}])  # fmt: skip
def test_that_a_tie_at_the_very_top_holds_a_wall_of_any_shape(shape):
    wall = wall_of({**TIE, "h_m": 7.5}, **shape)
    for span in find_bending_spans(wall):
        part = cut_span(wall, *span)
        assert bending(part.in_si).alpha0 > 0.0
        assert span[1] < 7.5 or not part.load


def test_that_a_stretch_above_a_tie_is_looked_at_where_the_part_from_there_up_is_no_block():
    """The whole wall turns long before, as one block; of the part above the lower tie the upper one opens a hinge."""
    ties = [{"kind": "tie", "out_kn_m": f, "h_m": z, "bar_length_m": 9.0} for f, z in ((5.0, 3.49), (10.0, 5.94))]
    floor = {"kind": "vertical", "kn_m": 13.9, "d_m": 0.374, "h_m": 5.94, "mass": "moving"}
    table = {"name": "w", "height_m": 8.78, "thickness_m": 0.624, "mechanism": "one_sided", "base_z_m": 0.0}
    table |= {"unit_weight_kn_m3": 18.0, "load": [floor], "hold": ties}
    wall = parse_case({"wall": [table]}).wall[0]
    assert (3.49, 5.94) in find_bending_spans(wall)
    assert hinge_inside(wall.in_si) is None is not hinge_inside(cut_above_hinge(wall, 3.49).in_si)
    assert multiplier_at_yield(wall) < 0.8 * bending(cut_span(wall, 3.49, 5.94).in_si).alpha0
