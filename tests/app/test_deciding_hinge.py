"""The drawing marks the hinge that decides, in the colour of its outcome, with the zeta of the run."""

import pytest

from app.input.wall_text import deciding_hinge, hinge_zetas
from core.case.rules import parse_case
from core.study.run import run
from core.study.wall_verdict import zeta_by_hinge
from tests.conftest import ROOT

HOLDS = [
    {"kind": kind, "h_m": height, "out_kn_m": force, "evidence": {"kind": "calculation", "reference": "A1"}}
    for kind, height, force in (("floor", 3.4, 12.0), ("roof", 6.7, 12.0))
]
WALL = {"name": "w", "height_m": 6.8, "thickness_m": 0.5, "length_m": 8.0, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
WALL |= {"unloaded_confirmed": True}


class Done:
    """A session whose run is finished."""

    def __init__(self, wall, ag):
        spectrum = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
        table = {"wall": [wall], "demand": {"ag_g": ag, "spectrum": spectrum}, "analysis": {"histories": False}}
        self.case = parse_case(table | {"building": {"height_m": 7.0, "storeys": 2, "period_s": 0.25}})
        self.result, self.stale = run(self.case, base_dir=ROOT), False


@pytest.mark.parametrize("ag", [0.05, 0.3])
@pytest.mark.parametrize(
    "more", [{"hold": [{"kind": "contact", "to_m": 6.8}]}, {"mechanism": "two_sided"}, {"hold": HOLDS}]
)
def test_that_zetas_and_the_mark_are_those_of_the_run(more, ag):
    session = Done(WALL | more, ag)
    (verdict,) = session.result.verdicts
    governing = session.result.walls[verdict.governing]
    shown = dict(hinge_zetas(session, 0))
    assert {hinge: zeta for hinge, zeta in shown.items() if zeta is not None} == dict(
        zeta_by_hinge(session.result, governing)
    )
    marked = deciding_hinge(session, 0)
    if governing.part.turns:
        assert marked == (governing.part.hinge, marked[1]) and marked[1] in ("good", "amber", "bad")
    else:  # it bends: no hinge of it turns, and none is marked
        assert marked is None
    session.stale = True
    assert deciding_hinge(session, 0) is None and all(zeta is None for _, zeta in hinge_zetas(session, 0))
