"""Cases of one wall for the checks of the Circolare."""

from core.codes.kinematic import analyse_mechanism
from core.setting.demand_input import read_demand
from tests.clauses_alone import parse_case
from tests.holds import BOUND

EN_B = {"code": "EN1998", "soil": "B", "type": 1}
NTC_C = {"code": "NTC2018", "f0": 2.364, "tc_star_s": 0.347, "soil": "C", "topography": "T1"}


def case(wall=None, demand=None, **more):
    return parse_case(
        {
            "wall": [
                {
                    "name": "w",
                    "height_m": 7.0,
                    "thickness_m": 0.83,
                    "base_z_m": 0.0,
                    "mechanism": "two_sided",
                    **(wall or {}),
                }
            ],
            "demand": {"ag_g": 0.26, "spectrum": EN_B, **(demand or {})},
            "analysis": {"q_step": 0.01},
            **more,
        }
    )


def mechanism_of(asked):
    """(mechanism, demand) of a case of one wall."""
    demand = read_demand(asked, None)
    return analyse_mechanism(asked.wall[0].in_si, asked.wall[0].mechanism, demand), demand


FREE = {"elastic_modulus_mpa": 600.0, "unit_weight_kn_m3": 18.0}
HELD = BOUND
