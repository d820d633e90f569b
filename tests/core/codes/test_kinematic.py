"""C8.7.1.2.1.1 to .8: quantities of the mechanism."""

import pytest

from core.case.rules import parse_case
from core.codes.kinematic import check_displacement, check_linear, check_sld
from tests.validation.circolare import FREE, HELD, case, mechanism_of


def test_that_a_wall_with_two_sides_is_free_until_something_is_shown_to_hold_it():
    both = case({"mechanism": "both"}).wall[0]
    assert both.in_si.is_free("two_sided") and not both.in_si.is_free("one_sided")
    assert not case(HELD).wall[0].in_si.is_free("two_sided")
    assert case({"hold": [{"kind": "cross_walls"}]}).wall[0].in_si.is_free("two_sided")


@pytest.mark.shows("kinematic.sld_free")
def test_that_a_free_element_without_its_period_has_no_linear_check():
    found, demand = mechanism_of(case({"unit_weight_kn_m3": 18.0}))
    assert found.missing == ("elastic_modulus_mpa",) and found.zeta_sld is None
    assert check_linear("linear_q_code", found, demand, 2.0) is None and check_sld(found, demand) is None
    assert check_displacement(found, demand).zeta == pytest.approx(0.9768, abs=5e-5)
    bare = {
        "wall": [
            {"name": "w", "height_m": 7.0, "thickness_m": 0.83, "base_z_m": 0.0, "mechanism": "two_sided", **FREE}
        ],
        "demand": {"ag_g": 0.26, "soil_factor": 1.2},
    }
    assert mechanism_of(parse_case(bare))[0].missing == ("spectrum",)


@pytest.mark.shows("kinematic.sld_restrained", "kinematic.sld_free")
def test_that_the_check_at_sld_is_against_the_ground_or_the_spectrum_at_t_0():
    for kind, demanded in ((HELD, 0.312), (FREE, 0.780)):
        asked = case({"height_m": 3.0, "thickness_m": 0.45, **kind}, {"limit_state": "SLD"})
        check = check_sld(*mechanism_of(asked))
        assert check.clause == "C8.7.1.2.1.5" and check.unit == "g"
        assert (check.name, check.label) == ("linear_q_code", "linear_sld")
        assert check.demand == pytest.approx(demanded, rel=1e-12)
        assert check.capacity == pytest.approx(0.45 / 3.0 / 1.35, rel=1e-12)
        assert check.zeta == pytest.approx(0.45 / 3.0 / 1.35 / demanded, rel=1e-12)


def test_that_only_the_check_of_sld_goes_without_its_q_in_words():
    found, demand = mechanism_of(case(HELD))
    assert check_linear("linear_q_code", found, demand, 2.0).label == "linear_q_code"
    assert check_linear("linear_q_slv", found, demand, 3.0).label == "linear_q_slv"
    assert check_displacement(found, demand).label == "nonlinear"
