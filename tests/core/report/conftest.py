"""Results that several tests of the report look at."""

from dataclasses import replace

import pytest

from core.case.reader import read_case
from core.case.site import HazardRow
from core.study.run import run
from tests.conftest import ROOT

BUILDING = ROOT / "resources" / "cases" / "building.toml"


@pytest.fixture(scope="session")
def building(kept):
    """A facade, a gable and a parapet above the ground, all with loads."""
    case = read_case(BUILDING)
    facade = replace(case.wall[0].without_sought(), hinge_heights=None)
    walls = (facade, *(replace(wall, law="rigid") for wall in case.wall[2:]))
    case = replace(case, generate=replace(case.generate, count=3), wall=walls)
    return kept("building_of_reports", lambda: run(case, base_dir=BUILDING.parent))


@pytest.fixture(scope="session")
def whole_building(kept):
    """The same as it is and as it is designed, with the hazard of its site."""
    case = read_case(BUILDING)
    rows = ((30.0, 0.08), (50.0, 0.1), (475.0, case.demand.ag_g), (975.0, 0.34))
    hazard = tuple(HazardRow(years, ag, 2.4, 0.3) for years, ag in rows)
    walls = tuple(replace(wall.without_sought(), law="rigid") for wall in case.wall)
    walls = tuple(replace(wall, hinge_heights=(3.0,)) if wall.name == "facade" else wall for wall in walls)
    asked = replace(
        case, generate=replace(case.generate, count=7), wall=walls, demand=replace(case.demand, hazard=hazard)
    )
    asked = replace(asked, analysis=replace(case.analysis, q_step=0.05))
    return kept("whole_building", lambda: run(asked, base_dir=BUILDING.parent))


@pytest.fixture(scope="session")
def verdict(of_seven):
    """Walls of a table without loads, NTC 2018, Italian."""
    return of_seven
