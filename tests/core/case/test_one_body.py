"""The same body written in every way has the same hinges, numbers and refusals (issue BO)."""

from pathlib import Path

import numpy as np
import pytest

from core.case.above_hinge import cut_above_hinge
from core.case.drawn_solids import expand_drawings
from core.case.hinges import default_hinges
from core.case.rules import parse_case
from core.case.site import Building
from core.errors import InputError
from core.wall.masonry import base_length, period_share
from tests.core.case.bodies import random_body, ways

BUILDING = Building(9.0, 3, period_s=0.2)


def judged(table: dict, folder: Path = Path()):
    """Per hinge what every check is computed from, or the code of the refusal."""
    try:
        whole, _ = expand_drawings({"title": "t", "wall": [table]}, folder)
        wall = parse_case(whole).wall[0]
    except InputError as error:
        return error.code
    found = []
    for hinge in (0.0, *default_hinges(wall, BUILDING)):
        try:
            part = cut_above_hinge(wall, hinge)
            block, base = part.block(), base_length(part.parts, part.length_m, part.thickness)
        except InputError as error:
            found.append((hinge, error.code))
            continue
        sides = [block, part.in_si.inner_block or block]
        numbers = [x for side in sides for x in (side.slenderness, side.radius, side.inertia_over_mass)]
        share = period_share(part.in_si) if part.parts else 1.0
        found.append((hinge, *numbers, part.thickness, base, part.weight, share))
    return found


def assert_alike(one, other, way: str):
    if isinstance(one, str) or isinstance(other, str):
        assert one == other, way
        return
    assert [hinge for hinge, *_ in one] == pytest.approx([hinge for hinge, *_ in other]), way
    for first, second in zip(one, other, strict=True):
        if isinstance(first[1], str) or isinstance(second[1], str):
            assert first[1] == second[1], way
        else:
            assert first == pytest.approx(second, rel=2e-9), way


def check(seed: int, folder: Path | None = None) -> str | list:
    rng = np.random.default_rng(seed)
    body = random_body(rng)
    found = {way: judged(table, folder or Path()) for way, table in ways(body, rng, folder).items()}
    first = found["elevations"]
    for way, other in found.items():
        assert_alike(first, other, way)
    return first


@pytest.mark.shows("bodies.one")
@pytest.mark.parametrize("seed", [*range(16), *(pytest.param(k, marks=pytest.mark.long) for k in range(16, 100))])
def test_that_a_body_is_judged_alike_however_it_is_written(seed, tmp_path):
    check(seed, tmp_path)


@pytest.mark.long
def test_that_two_thousand_bodies_are_judged_alike_however_they_are_written(tmp_path):
    found = [check(seed, tmp_path if seed % 4 == 0 else None) for seed in range(100, 2100)]
    assert sum(not isinstance(one, str) for one in found) > 1500
