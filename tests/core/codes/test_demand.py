"""The demand in SI units: factors of records, the hazard at a return period, what is warned of."""

import numpy as np
import pytest

from core.codes.demand import SeismicDemand, complete_with_records, mean_intensity
from core.ground.ground_motion import GroundMotion
from core.units import G


def demand(ag=0.1 * G, soil=1.2, **changes) -> SeismicDemand:
    return SeismicDemand(
        "SLV", ag, soil, ag * soil, changes.pop("intensity", None), None, 2.0, 1.35, 1.0, None, **changes
    )


def motion(pga, **changes) -> GroundMotion:
    return GroundMotion("m", pga * np.sin(np.arange(3000) * 0.05 * np.pi), 0.01, **changes)


def codes(found: SeismicDemand) -> list[str]:
    return [warning.code for warning in found.warnings]


def test_that_a_record_is_taken_as_given_or_scaled_to_the_pga_of_the_demand():
    assert demand().scaling(motion(0.5)) == 1.0
    scaled = demand(record_scaling="pga")
    assert scaled.scaling(motion(0.5)) == pytest.approx(0.12 * G / 0.5, rel=1e-14)
    # a floor motion by the record it comes from
    assert scaled.scaling(motion(0.5, ground_pga=0.3)) == pytest.approx(0.12 * G / 0.3, rel=1e-14)


def test_that_an_acceleration_no_site_has_is_warned_of():
    assert codes(complete_with_records(demand(0.6 * G), [])) == []
    found = complete_with_records(demand(0.61 * G), [])
    assert codes(found) == ["large_ag"]
    # 2.45 m/s2 typed as 2.45 g
    assert dict(found.warnings[0].values)["ag"] == pytest.approx(0.61, rel=1e-12)
    (meant,) = complete_with_records(demand(2.45 * G), []).warnings
    assert "2.45" in meant.text("en") and "0.25" in meant.text("en")


def test_that_records_scaled_far_or_weaker_than_the_demand_are_warned_of():
    """a_g S = 0.12 g."""
    scaled = demand(record_scaling="pga", intensity=0.5)
    assert codes(complete_with_records(scaled, [motion(0.041 * G)])) == ["pga_scaling"]
    found = complete_with_records(scaled, [motion(0.039 * G), motion(0.2 * G), motion(0.01 * G)])
    assert codes(found) == ["pga_scaling", "large_scaling"]
    assert dict(found.warnings[1].values)["n"] == 2 and found.weak_share is None
    given = demand(intensity=0.5)
    assert codes(complete_with_records(given, [motion(0.109 * G)])) == []
    weak = complete_with_records(given, [motion(0.10 * G), motion(0.11 * G)])
    assert codes(weak) == ["weaker_records"]
    assert weak.weak_share == pytest.approx(0.105 / 0.12, rel=1e-12)


def test_that_an_intensity_that_nothing_states_is_that_of_the_scaled_records():
    motions = [motion(0.05 * G), motion(0.2 * G)]
    by_hand = np.mean([0.12 * G / one.pga * one.housner_intensity for one in motions])
    assert mean_intensity(demand(), motions) == pytest.approx(by_hand, rel=1e-14)
    found = complete_with_records(demand(), motions)
    assert (found.intensity, found.intensity_source) == (pytest.approx(by_hand), "records_scaled")
    stated = complete_with_records(demand(intensity=0.5), motions)
    assert (stated.intensity, stated.intensity_source) == (0.5, None)
