"""Walls of solved cases, by the keys of a case file."""

from collections.abc import Mapping
from functools import cached_property
from pathlib import Path

from core.case.rules import parse_case
from core.case.schema import Case
from core.case.wall import Wall
from core.codes.demand import SeismicDemand
from core.codes.floor_spectrum import FloorSpectrum
from core.codes.kinematic import KinematicAnalysis, analyse_mechanism, check_linear
from core.known import require_value
from core.lab.solved.solved import Outline, Sketch
from core.report.outlines import section_outlines
from core.setting.check_input import make_rocking_model
from core.setting.demand_input import read_demand
from core.setting.floors import make_floor
from core.wall.rocking_model import RockingModel

EN_B = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
"""EN 1998-1 type 1, ground B: a_g 0.26 g, S 1.2, T_B 0.15 s, T_C 0.5 s, T_D 2.0 s."""

NTC_C = {
    "ag_g": 0.261,
    "spectrum": {"code": "NTC2018", "f0": 2.364, "tc_star_s": 0.347, "soil": "C", "topography": "T1"},
}


class Asked:
    """A case of one wall, and what the program finds by the clauses.

    wall : keys of [[wall]]; demand, sections : of the case
    """

    def __init__(self, wall: Mapping[str, object], demand: Mapping[str, object] | None = EN_B, **sections: object):
        wall = {"name": "w", "mechanism": "one_sided", "base_z_m": 0.0, "unit_weight_kn_m3": 18.0, **wall}
        self.table: dict[str, object] = {"title": "Ribalta", "wall": [wall], **sections}
        if demand is not None:
            self.table["analysis"] = {"histories": False}
            self.table["demand"] = dict(demand)

    @cached_property
    def case(self) -> Case:
        return parse_case(self.table)

    @property
    def wall(self) -> Wall:
        return self.case.wall[0]

    @property
    def mechanism(self) -> str:
        return self.wall.mechanisms()[0]

    @cached_property
    def model(self) -> RockingModel:
        return make_rocking_model(self.wall, self.mechanism)

    @cached_property
    def demand(self) -> SeismicDemand:
        return require_value(read_demand(self.case, Path()))

    @cached_property
    def floor(self) -> FloorSpectrum | None:
        """Spectrum of the floor that moves the wall; there is none on the ground."""
        if self.case.building is None or not self.wall.above_ground:
            return None
        return require_value(make_floor(self.wall, self.case.building, self.demand, ())).spectrum

    @cached_property
    def checked(self) -> KinematicAnalysis:
        return analyse_mechanism(self.wall.in_si, self.mechanism, self.demand, self.floor)

    def zeta_linear(self, q: float = 2.0) -> float:
        """zeta of the linear check with a behaviour factor q, which C8.7.1.2.1.7 takes as 2."""
        return require_value(require_value(check_linear("linear_q_code", self.checked, self.demand, q)).zeta)

    @property
    def zeta_displacement(self) -> float:
        """d_SLV over the demand, before a_g,SLD is counted."""
        return require_value(self.checked.d_limit) / require_value(self.checked.s_de)

    def sketch(self) -> Sketch:
        """Its section with its loads."""
        wall = self.wall
        height = require_value(wall.height_m)
        solids = [tuple(points) for points, _ in section_outlines(wall)]
        thickness = require_value(wall.thickness)
        box: Outline = ((0.0, 0.0), (thickness, 0.0), (thickness, height), (0.0, height))
        loads = [(0.0, require_value(tie.h_m), 1.0, 0.0) for tie in wall.ties]
        for load in wall.load:
            across = 0.0 if load.is_weight else 1.0 if require_value(load.kn_m) < 0.0 else -1.0
            loads.append((load.d_m or 0.0, load.h_m, across, -1.0 if load.is_weight else 0.0))
        outline, *others = solids or [box]
        return Sketch(outline, tuple(loads), others=tuple(others))
