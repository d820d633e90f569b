"""The case of the tests of a study."""

from core.case.rules import parse_case

DEMAND = """[demand]
ag_g = 0.22
[demand.spectrum]
code = "NTC2018"
f0 = 2.4
tc_star_s = 0.33
soil = "B"
topography = "T1"
"""
"""The last sections of a case file, by the spectrum of the code."""


def case(**more):
    table = {
        "wall": [
            {"name": "w", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "both"},
            {
                "name": "v",
                "height_m": 4.0,
                "slenderness_deg": 8.0,
                "base_z_m": 0.0,
                "mechanism": "two_sided",
                "law": "doherty",
            },
        ],
        "record": [{"file": "r*.txt", "unit": "m/s2", "time_step_s": 0.01}],
        "analysis": {"q_step": 0.02},
        "demand": {"ag_g": 0.2, "soil_factor": 1.2},
    }
    return parse_case({**table, **more})
