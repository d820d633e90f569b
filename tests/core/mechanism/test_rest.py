"""Reactions of a wall at rest: worked values of a linear programme over slices, closed forms of one hold, monotony."""

import math
import random
from dataclasses import replace

import pytest

from core.mechanism.rest import (
    Reach,
    base_reaction,
    greatest_at_top,
    least_at_top,
    simple_reactions,
    top_holds,
    top_multiplier,
)
from core.mechanism.sections import Sections
from core.wall.block import Block
from core.wall.masonry import Declared, Load, Masonry
from tests.core.mechanism.polygon import greatest_reaction, holds_at_rest, least_reaction, multiplier_at_rest

FREE = 1e7
"""A strength that is never reached [N/m]."""

SLICES = 2e-5
"""Relative error of a linear programme over some hundred slices, which sees a section at each slice alone."""


def wall(height, thickness, weight, loads=(), setback=0.0):
    """Sections of a wall. weight : [kN/m3]; loads : (kN/m, depth, height)"""
    on = tuple(Load("vertical", 1e3 * force, depth, level) for force, depth, level in loads)
    block = Block.rectangle(height, math.atan2(thickness, height))
    return Sections(
        Masonry(
            "w",
            "one_sided",
            block,
            height=height,
            thickness=thickness,
            setback=setback,
            unit_weight=1e3 * weight,
            length=1.0,
            loads=on,
        )
    )


MANY = pytest.mark.parametrize("count", [200, pytest.param(2000, marks=pytest.mark.long)])

GROUND_FLOOR = wall(3.4, 0.5, 21.0, [(42.4, 0.25, 3.4)])
TWO_FLOORS = wall(6.8, 0.5, 18.0, [(12.0, 0.33, 3.4), (8.0, 0.33, 6.7)])


def test_that_the_reactions_of_one_hold_at_rest_are_the_worked_ones():
    top = [Reach(3.4, FREE, 0.0)]
    assert least_reaction(GROUND_FLOOR, top, 0, 0.157010) == 0.0
    assert simple_reactions(GROUND_FLOOR, [3.4], 0.157010) == pytest.approx([2802.628], rel=1e-6)
    assert greatest_reaction(GROUND_FLOOR, top, 0, 0.157010) == pytest.approx(8545.275, rel=1e-6)


def test_that_a_hold_of_12_kn_carries_a_ground_floor_to_six_times_its_demand():
    assert multiplier_at_rest(GROUND_FLOOR, [Reach(3.4, FREE)], friction=FREE) == pytest.approx(1.488557, rel=1e-6)
    held = multiplier_at_rest(GROUND_FLOOR, [Reach(3.4, 12e3)], friction=FREE)
    assert held == pytest.approx(0.993986, rel=1e-6) and held / 0.157010 == pytest.approx(6.33, abs=5e-3)


def test_that_the_ranges_of_two_holds_are_the_worked_ones():
    holds = [Reach(3.4, FREE), Reach(6.7, FREE)]
    least = [least_reaction(TWO_FLOORS, holds, n, 0.3) for n in (0, 1)]
    greatest = [greatest_reaction(TWO_FLOORS, holds, n, 0.3) for n in (0, 1)]
    assert least == pytest.approx([1163.326, 1610.909], rel=SLICES)
    assert greatest == pytest.approx([20685.561, 5458.014], rel=SLICES)
    assert simple_reactions(TWO_FLOORS, [3.4, 6.7], 0.2) == pytest.approx([6027.273, 3152.727], rel=1e-6)


def test_that_simple_spans_are_in_equilibrium():
    """Forces sideways, and moments about the base."""
    reactions, base = simple_reactions(TWO_FLOORS, [3.4, 6.7], 0.2), TWO_FLOORS.at(0.0)
    assert base_reaction(TWO_FLOORS, reactions, 0.2) + sum(reactions) == pytest.approx(0.2 * base.pushed)
    # the base takes no moment: what is pushed is held by the lever of the holds
    assert reactions[0] * 3.4 + reactions[1] * 6.7 == pytest.approx(0.2 * base.push)


@MANY
def test_that_one_hold_has_the_closed_form_of_its_least_and_greatest_reaction(count):
    """R_lo = max over z of (alpha S - M_o)/(h - z), R_hi = min over z of (alpha S + M_i)/(h - z), z up to h - t."""
    draw = random.Random(1)
    for _ in range(count):
        height, thickness = draw.uniform(2.0, 6.0), draw.uniform(0.25, 0.8)
        loads = [(draw.uniform(0.0, 30.0), draw.uniform(0.1, 0.9) * thickness, height)]
        sections, alpha = wall(height, thickness, draw.uniform(14.0, 22.0), loads), draw.uniform(0.02, 0.3)
        hold = [Reach(height, FREE, FREE)]
        highest = height - thickness  # nearer to the top nothing opens, as no hinge does
        levels = [sections.at(highest * n / 4000) for n in range(4001)]
        arms = [height - highest * n / 4000 for n in range(4001)]
        low = max(section.least_moment(alpha) / arm for section, arm in zip(levels, arms, strict=True))
        high = min(section.greatest_moment(alpha) / arm for section, arm in zip(levels, arms, strict=True))
        if low < high:
            assert least_reaction(sections, hold, 0, alpha) == pytest.approx(low, rel=1e-6, abs=1e-3)
            assert greatest_reaction(sections, hold, 0, alpha) == pytest.approx(high, rel=1e-6)
        else:
            assert not holds_at_rest(sections, hold, alpha, friction=FREE)


@pytest.mark.parametrize("count", [60, pytest.param(600, marks=pytest.mark.long)])
def test_that_one_hold_at_the_top_is_that_of_the_polygon_under_loads_and_thrusts(count):
    draw, held = random.Random(4), 0
    for _ in range(count):
        height, thickness = draw.uniform(2.0, 6.0), draw.uniform(0.25, 0.6)
        loads = [(draw.uniform(0.0, 30.0), draw.uniform(0.2, 0.8) * thickness, height)]
        plain = wall(height, thickness, draw.uniform(14.0, 22.0), loads)
        thrusts = (Load("thrust", draw.uniform(-2e3, 2e3), 0.0, draw.uniform(0.1, 0.9) * height) for _ in "ab")
        sections = Sections(replace(plain.wall, loads=(*plain.wall.loads, *thrusts)))
        reach = Reach(height, draw.uniform(0.0, 3e4), draw.choice([0.0, 1e4]))
        for friction in (0.4, FREE):
            expected = multiplier_at_rest(sections, [reach], friction)
            assert top_multiplier(sections, reach, friction) == pytest.approx(expected, rel=1e-5, abs=1e-7)
            held += expected > 0.0
            alpha = draw.uniform(0.0, 2.0) * (expected + 0.01)
            if abs(alpha - expected) > 1e-5 * alpha:
                assert top_holds(sections, reach, alpha, friction) == holds_at_rest(sections, [reach], alpha, friction)
    assert held > count


@pytest.mark.parametrize("count", [40, pytest.param(600, marks=pytest.mark.long)])
def test_that_a_stronger_or_an_added_hold_never_lowers_what_a_wall_stands_at_rest(count):
    draw = random.Random(2)
    for _ in range(count):
        height = draw.uniform(4.0, 9.0)
        loads = [(draw.uniform(0.0, 20.0), 0.25, level * height) for level in (0.5, 1.0)]
        sections = wall(height, draw.uniform(0.3, 0.7), 18.0, loads)
        holds = [Reach(draw.uniform(0.2, 1.0) * height, draw.uniform(0.0, 3e4), draw.uniform(0.0, 3e4)) for _ in "ab"]
        plain = multiplier_at_rest(sections, holds)
        stronger = [Reach(holds[0].height, 2.0 * holds[0].outward, holds[0].inward), holds[1]]
        more = [*holds, Reach(draw.uniform(0.2, 1.0) * height, 1e4, 0.0)]
        nothing = [*holds, Reach(0.5 * height, 0.0, 0.0)]
        assert multiplier_at_rest(sections, stronger) >= plain * (1.0 - 1e-9)
        assert multiplier_at_rest(sections, more) >= plain * (1.0 - 1e-9)
        assert multiplier_at_rest(sections, nothing) == pytest.approx(plain, rel=1e-9)


def test_that_without_a_hold_a_wall_turns_about_its_base_or_slides():
    sections = wall(3.0, 0.6, 18.0)
    assert multiplier_at_rest(sections, []) == pytest.approx(0.2, rel=1e-9)
    assert multiplier_at_rest(wall(1.0, 0.6, 18.0), []) == pytest.approx(0.4, rel=1e-9)
    assert multiplier_at_rest(wall(1.0, 0.6, 18.0), [], friction=FREE) == pytest.approx(0.6, rel=1e-9)


def test_that_a_stocky_held_wall_slides_at_its_base_before_it_bends():
    held = wall(3.0, 0.8, 18.0, [(20.0, 0.30, 3.0)])
    assert multiplier_at_rest(held, [Reach(3.0, FREE)]) == pytest.approx(1.137492, rel=1e-6)
    inward = wall(3.0, 0.8, 18.0, [(20.0, 0.50, 3.0)])
    assert multiplier_at_rest(inward, [Reach(3.0, FREE)]) == pytest.approx(1.026870, rel=1e-6)


def test_that_four_rows_of_connectors_that_yield_hold_a_leaf_with_the_least_equal_force():
    """Worked value 18: 1.246875 kN/m a row, where stiff ones ask 1.6625 of the highest."""
    leaf, rows = wall(4.0, 0.25, 21.0), (0.5, 1.5, 2.5, 3.5)
    for force, stays in ((1246.8749, False), (1246.8751, True)):
        assert holds_at_rest(leaf, [Reach(h, force) for h in rows], 0.3, friction=FREE) == stays


@pytest.mark.shows("held.yields")
@MANY
def test_that_the_least_reaction_at_a_top_is_that_of_the_polygons(count):
    """Two ways: in closed form over the sections, and what is left of the polygons; and with 12 kN/m that yield the
    ground floor stays at rest to 0.993986 (worked value 2)."""
    assert least_at_top(GROUND_FLOOR, 3.4, 0.157010) == 0.0
    assert least_at_top(GROUND_FLOOR, 3.4, 0.993986) == pytest.approx(12000.0, rel=1e-6)
    draw, compared = random.Random(6), 0
    for _ in range(count):
        height = draw.uniform(2.5, 4.0)
        loads = [(draw.uniform(1.0, 40.0), draw.uniform(0.1, 0.3), draw.uniform(0.3, 1.0) * height)]
        sections = wall(height, draw.uniform(0.2, 0.8), 18.0, loads * draw.choice((0, 1)), draw.uniform(0.0, 0.03))
        held = Sections(replace(sections.wall, declared=Declared(foot_strength=FREE)))
        for alpha in (0.1, 0.2, 0.4):
            if (polygons := least_reaction(held, [Reach(height, FREE)], 0, alpha)) is not None:
                assert least_at_top(held, height, alpha) == pytest.approx(polygons, rel=1e-6, abs=1e-3)
                compared += polygons > 0.0
            if holds_at_rest(sections, [Reach(height, FREE)], alpha):  # with the friction of its base
                least = least_at_top(sections, height, alpha)
                assert holds_at_rest(sections, [Reach(height, least * (1.0 + 1e-6) + 1e-3)], alpha)
                assert least < 1.0 or not holds_at_rest(sections, [Reach(height, 0.999 * least)], alpha)
    assert compared > 15


def test_that_the_greatest_reaction_at_a_top_is_that_of_the_polygons():
    """Two ways: in closed form over the sections, and what is left of the polygons, whose sections are a sample."""
    draw, compared = random.Random(5), 0
    for _ in range(12):
        height = draw.uniform(2.5, 4.0)
        loads = [(draw.uniform(1.0, 40.0), draw.uniform(0.1, 0.3), draw.uniform(0.3, 1.0) * height)]
        sections = wall(height, draw.uniform(0.35, 0.8), 18.0, loads * draw.choice((0, 1)), draw.uniform(0.0, 0.03))
        for alpha in (0.05, 0.2):
            if (polygons := greatest_reaction(sections, [Reach(height, FREE)], 0, alpha)) is not None:
                assert greatest_at_top(sections, height, alpha) == pytest.approx(polygons, rel=1e-6)
                compared += 1
    assert compared > 15
