"""NTC 2018 3.2.3.6 and EN 1998-1 3.2.3.1.2: records against their target."""

from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes import record_compatibility as rules
from core.codes.record_compatibility import check_compatibility
from core.errors import InputError, RecordError
from core.ground import records
from core.ground.provenance import stations
from core.setting.demand_input import generate_motions, read_demand
from core.study import run as study
from tests.conftest import ROOT


def case(**demand):
    spectrum = {"code": "EN1998", "soil": "B", "type": 1}
    return parse_case(
        {
            "wall": [{"name": "w", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "two_sided"}],
            "generate": {"scatter": 0.0, "count": 7},
            "demand": {"ag_g": 0.26, "spectrum": spectrum, **demand},
        }
    )


@pytest.mark.shows("demand.artificial")
def test_that_a_generated_set_complies_and_half_of_it_does_not(tmp_path):
    asked = case()
    demand = read_demand(asked, tmp_path)
    motions = generate_motions(asked, demand)
    found = check_compatibility(motions, ["artificial"] * 7, demand)
    assert found.compatible
    assert {rule.name for rule in found.rules if rule.passed} >= {
        "mean_lower",
        "records",
        "mean_pga",
        "strong_part",
        "duration",
    }
    halved = [replace(motion, acceleration=0.5 * motion.acceleration) for motion in motions]
    wrong = check_compatibility(halved, ["artificial"] * 7, demand)
    assert not wrong.compatible
    assert check_compatibility(motions[:2], ["artificial"] * 2, demand).compatible is False


def test_that_there_is_nothing_to_compare_without_records_or_without_a_spectrum(tmp_path):
    asked = case()
    demand = read_demand(asked, tmp_path)
    motions = generate_motions(asked, demand)
    assert check_compatibility([], [], demand) is None
    assert check_compatibility(motions, ["artificial"] * 7, replace(demand, target=None)) is None


@pytest.mark.shows("demand.artificial")
def test_that_artificial_motions_are_as_long_as_the_code_asks(tmp_path):
    """A strong part of 10 s, 25 s in all: the limits themselves pass."""
    demand = read_demand(case(), tmp_path)
    motions = generate_motions(case(), demand)
    size = round(25.0 / motions[0].time_step) + 1
    for samples, passed in ((size, True), (size - 1, False)):
        cut = [replace(motion, acceleration=motion.acceleration[:samples]) for motion in motions]
        found = {rule.name: rule for rule in check_compatibility(cut, ["artificial"] * 7, demand).rules}
        assert (found["duration"].limit, found["duration"].passed) == (25.0, passed)
        assert found["strong_part"].limit == 10.0


def test_that_one_factor_brings_the_mean_to_the_target_over_the_periods_asked(tmp_path):
    motions = [records.read(ROOT / "tests" / "motions" / f"noise_{k}.txt") for k in (1, 2, 3)]
    for more in ({}, {"period_range_s": [0.3, 2.6]}):
        demand = read_demand(case(**more), tmp_path)
        low, high = more.get("period_range_s", (0.15, 2.0))
        found = check_compatibility(motions, ["artificial"] * 3, demand)
        inside = (found.periods >= low) & (found.periods <= high)
        by_hand = np.exp(np.log(found.target / found.mean)[inside].mean())
        assert rules.common_factor(motions, demand) == pytest.approx(by_hand, rel=2e-3)


def test_that_natural_records_have_an_upper_bound_too(tmp_path):
    asked = case()
    demand = read_demand(asked, tmp_path)
    louder = [replace(m, acceleration=1.5 * m.acceleration) for m in generate_motions(asked, demand)]
    rules = check_compatibility(louder, ["natural"] * 7, demand).rules
    upper = next(rule for rule in rules if rule.name == "mean_upper" and rule.limit is not None)
    assert upper.limit == 0.30 and upper.passed is False


def test_that_two_components_of_a_station_count_once(tmp_path):
    asked = case()
    demand = read_demand(asked, tmp_path)
    motions = [
        replace(
            motion,
            format="PEER AT2",
            details=(("line 2", f"IMPERIAL VALLEY 5/19/40, EL CENTRO ARRAY #9, {component}"),),
        )
        for motion, component in zip(generate_motions(asked, demand), ("180", "270", "UP"), strict=False)
    ]
    assert len(stations(motions)) == 1
    assert check_compatibility(motions, ["natural"] * 3, demand).stations == 1


def test_that_scaling_to_pga_scales_the_spectra(tmp_path):
    plain, scaled = (read_demand(case(**more), tmp_path) for more in ({}, {"demand_scaling": "pga"}))
    motions = [replace(motion, acceleration=0.5 * motion.acceleration) for motion in generate_motions(case(), plain)]
    assert scaled.scaling(motions[0]) == pytest.approx(2.0, rel=1e-6)
    assert check_compatibility(motions, ["artificial"] * 7, scaled).compatible
    assert not check_compatibility(motions, ["artificial"] * 7, plain).compatible


@pytest.mark.shows("demand.natural")
def test_that_natural_records_are_compared_up_to_the_longest_period_of_the_walls(tmp_path):
    """Weak beyond 2 s, as a set at -22 % there that passed: kind and range decide whether it is seen."""
    asked = case()
    demand = read_demand(asked, tmp_path)
    motions = generate_motions(asked, demand)
    for kind, longest, high in (("natural", 3.4, 3.4), ("natural", 1.2, 2.0), ("artificial", 3.4, 2.0)):
        found = check_compatibility(motions, [kind] * 7, demand, longest)
        assert found.period_range == (0.15, high)
        inside = (found.periods >= 0.15 - 1e-9) & (found.periods <= high + 1e-9)
        assert found.periods[inside][[0, -1]] == pytest.approx([0.15, high])
        lower = next(rule for rule in found.rules if rule.code == "NTC" and rule.name == "mean_lower")
        assert lower.value == pytest.approx((found.mean / found.target - 1.0)[inside].min(), rel=1e-12)
    chosen = read_demand(case(period_range_s=[0.3, 2.6]), tmp_path)
    assert check_compatibility(motions, ["natural"] * 7, chosen, 3.4).period_range == (0.3, 2.6)


@pytest.mark.parametrize("asked", [(0.05, 2.0), (0.15, 2.0), (0.15, 3.4)])
def test_that_no_two_periods_compared_are_farther_apart_than_a_hundredth(asked):
    """From the shortest to the longest of those asked and those shown, 0.1 to 2.5 s."""
    shown, periods = rules.compared_periods(asked, 1.2)
    assert shown == pytest.approx((0.1, 2.5))
    assert periods[[0, -1]] == pytest.approx((min(0.1, asked[0]), max(2.5, asked[1])))
    ratios = periods[1:] / periods[:-1]
    assert ratios.min() > 1.0 and ratios.max() <= 1.01 + 1e-6


def test_that_a_range_beyond_the_spectrum_of_a_file_is_refused(tmp_path):
    rows = [(t, 0.312 * 2.5 / max(1.0, t)) for t in np.linspace(0.05, 3.0, 60)]
    (tmp_path / "s.txt").write_text("\n".join(f"{t} {s}" for t, s in rows))
    table = {
        "wall": [{"name": "w", "height_m": 3.0, "thickness_m": 0.4, "base_z_m": 0.0, "mechanism": "two_sided"}],
        "demand": {"ag_g": 0.26, "soil_factor": 1.2, "spectrum_file": "s.txt", "period_range_s": [0.15, 4.0]},
        "generate": {"scatter": 0.0, "count": 1},
    }
    with pytest.raises(InputError, match=r"period_range_s goes to 4.00 s, but s.txt ends at 3.00 s"):
        study.run(parse_case(table), base_dir=tmp_path)


@pytest.mark.long
def test_that_looks_ten_times_as_close_move_no_extreme_by_half_a_percent(shelf, monkeypatch):
    """Sets of seven of the shelf against a code spectrum: the rule of -10 % cannot flip between two looks."""
    asked = case(demand_scaling="pga")
    demand = read_demand(asked, shelf)
    paths = sorted(shelf.glob("PEER_AT2/*.[aA][tT]2"))
    motions = [records.read(path) for path in paths if _reads(path)]
    rng = np.random.default_rng(2)
    for _ in range(6):
        chosen = [motions[k] for k in rng.choice(len(motions), 7, replace=False)]
        found = []
        for step in (rules.PERIOD_STEP, 0.1 * rules.PERIOD_STEP):
            monkeypatch.setattr(rules, "PERIOD_STEP", step)
            made = rules.check_compatibility(chosen, ["natural"] * 7, demand)
            named = {rule.name: rule.value for rule in made.rules}
            found.append((named["mean_lower"], named["mean_upper"]))
            monkeypatch.undo()
        assert found[0] == pytest.approx(found[1], abs=0.005)


def _reads(path) -> bool:
    try:
        return bool(records.read(path))
    except RecordError:
        return False


def test_that_a_spectrum_that_is_kept_is_that_of_its_own_samples_step_and_periods():
    from core.codes.record_compatibility import cached_spectrum
    from core.ground.response_spectrum import pseudo_acceleration_spectrum

    chance = np.random.default_rng(5)
    first = chance.normal(size=400)
    other = first.copy()
    other[200] += 1e-9
    periods = np.geomspace(0.1, 2.0, 9)
    for _ in range(2):
        for ground, dt, asked in (
            (first, 0.01, periods),
            (other, 0.01, periods),
            (first, 0.02, periods),
            (first, 0.01, periods[:5]),
        ):
            found = cached_spectrum(ground, dt, asked)
            assert (found == pseudo_acceleration_spectrum(ground, dt, asked)).all()
    with pytest.raises(ValueError):
        found[0] = 0.0


@pytest.mark.shows("demand.natural")
@pytest.mark.parametrize(
    ("code", "bounds"), [("EN1998", (0.9, np.inf, 1.0)), ("NTC2018", (0.9, 1.3, 0.0)), (None, (0.9, 1.3, 1.0))]
)
def test_that_natural_records_keep_the_bounds_of_their_code_and_of_both_without_one(tmp_path, code, bounds):
    """NTC 3.2.3.6: -10 % and +30 %; EN 3.2.3.1.2(4): 90 %, and the mean PGA not below a_g S."""
    demand = replace(read_demand(case(), tmp_path), spectrum_code=code)
    assert rules.natural_bounds(demand) == pytest.approx(bounds, rel=1e-12)
