"""Results that several tests of the report look at."""

from dataclasses import replace

import pytest

from core.case.reader import read_case
from core.case.site import HazardRow
from core.study.run import run
from tests.conftest import ROOT

BUILDING = ROOT / "resources" / "cases" / "building.toml"


@pytest.fixture(scope="session")
def building():
    """A facade, a gable and a parapet above the ground, all with loads."""
    case = read_case(BUILDING)
    facade = replace(case.wall[0], hinge_heights=None, tie_height_m=None)
    return run(replace(case, wall=(facade, *case.wall[2:])), base_dir=BUILDING.parent)


@pytest.fixture(scope="session")
def whole_building():
    """The same as it is and as it is designed, with the hazard of its site."""
    case = read_case(BUILDING)
    rows = ((30.0, 0.08), (50.0, 0.1), (475.0, case.demand.ag_g), (975.0, 0.34))
    hazard = tuple(HazardRow(years, ag, 2.4, 0.3) for years, ag in rows)
    none = dict.fromkeys(("tie_height_m", "tie_bar_length_m", "tie_elongation_m"))
    walls = tuple(replace(wall, **none) for wall in case.wall)
    asked = replace(case, wall=walls, demand=replace(case.demand, hazard=hazard))
    return run(replace(asked, analysis=replace(case.analysis, q_step=0.05)), base_dir=BUILDING.parent)


@pytest.fixture(scope="session")
def verdict():
    """Walls of a table without loads, NTC 2018, Italian."""
    path = ROOT / "resources" / "cases" / "verdict.toml"
    return run(read_case(path), base_dir=path.parent)
