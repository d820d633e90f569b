"""The page Histories shows at the demand what the check had: peak and fall of every record and sign."""

from pathlib import Path

import pytest

from core.case.rules import parse_case
from core.rocking.outcome import COLLAPSED
from core.study.run import run
from tests.holds import at_top

SPECTRUM = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.35, "soil": "B", "topography": "T1"}
BASE = {"name": "w", "base_z_m": 0.0, "unit_weight_kn_m3": 18.0, "unloaded_confirmed": True}
FREE = BASE | {"mechanism": "two_sided", "height_m": 1.2, "thickness_m": 0.25, "elastic_modulus_mpa": 600.0}
ONE_SIDED = BASE | {"mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.3}
HELD = BASE | {"mechanism": "vertical_bending", "height_m": 3.4, "thickness_m": 0.3, "hold": at_top(3.4)}


@pytest.mark.shows("window.histories_of_the_check")
@pytest.mark.parametrize(("wall", "ag"), [(FREE, 0.25), (ONE_SIDED, 0.3), (HELD, 0.6)], ids=["free", "one", "held"])
def test_that_the_histories_at_the_demand_are_those_of_the_check(application, wall, ag):
    """The elastic branch of what is free to vibrate, the hinge of what bends: without them 3 of 28 stood that fall."""
    from app.views.histories_tab import HistoriesTab

    table = {"wall": [wall], "demand": {"ag_g": ag, "spectrum": SPECTRUM}, "generate": {"count": 3, "scatter": 0.65}}
    table["building"] = {"height_m": 6.8, "storeys": 2, "period_s": 0.25}
    result = run(parse_case(table), base_dir=Path())
    decides = result.walls[result.verdicts[0].governing]
    tab = HistoriesTab()
    tab.show_wall(result, decides)
    for done in decides.required_assessment.dynamic.runs:
        tab.show_run((done.motion, done.polarity))
        assert (tab.history.outcome == COLLAPSED) == (done.status == "overturned")
        if done.peak_ratio is not None:
            peak = tab.history.peak / tab.model.collapse_rotation
            assert peak == pytest.approx(done.peak_ratio, rel=1e-9, abs=1e-12)
    tab.deleteLater()
