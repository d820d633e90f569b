"""The numbers by which a machine shows that it computes what was computed elsewhere."""

import math
from pathlib import Path

import pytest

from core.case.rules import parse_case
from core.jit.shipped import Library
from core.rocking.methods import AUTO, METHODS
from core.setting.check_input import make_rocking_model
from core.study import self_test


@pytest.mark.shows("window.self_test")
def test_that_the_stored_answers_come_out_to_the_last_bit_by_both_orders():
    assert self_test.compare_answers() == ((), True)


def test_that_the_answers_are_of_walls_that_overturn_and_follow_from_the_clauses():
    found = {name: list(map(float.fromhex, values)) for name, values in self_test.compute_answers("taylor").items()}
    assert all(len(set(values)) > 1 and max(map(abs, values)) > 1e-3 for name, values in found.items() if "_" in name)
    assert all(values[0] > values[1] > 1.0 for name, values in found.items() if name.endswith("_q"))
    alpha0, d0, period, s_de = found["kinematic"]
    assert alpha0 == pytest.approx(math.tan(0.13)) and d0 == pytest.approx(1.5 * math.tan(0.13))
    assert period == pytest.approx(1.68 * math.pi * math.sqrt(0.4 * d0 / (0.6 * alpha0 * 9.80665 / 1.35)))
    assert s_de > 0.1


def test_that_the_last_digit_of_one_tells_right_from_wrong(monkeypatch):
    right = self_test.compute_order_8_answers()
    assert len(right) > 20
    wrong = [*right[:-1], math.nextafter(float.fromhex(right[-1]), 9.9).hex()]
    for known, expected in ((right, True), (wrong, False), ([], False)):
        shipped = Library(Path(), {}, known, {})
        monkeypatch.setattr(self_test.shipped, "library", lambda shipped=shipped: shipped)
        assert self_test.numbers_are_right() is expected


@pytest.mark.parametrize(
    "name, factor, outcome",
    [
        ("one_sided_q", 1.0 + 1e-4, (("one_sided_q",), False)),
        ("kinematic", 1.0 + 1e-8, (("kinematic",), False)),
        ("trilinear_history", 1.0 + 1e-15, ((), False)),
    ],
)
def test_that_a_stored_answer_that_is_not_what_comes_out_is_named(monkeypatch, name, factor, outcome):
    found = self_test.compute_answers("taylor")
    moved = {**found, name: [(factor * float.fromhex(number)).hex() for number in found[name]]}
    monkeypatch.setattr(self_test, "compute_answers", lambda method: moved)
    assert self_test.compare_answers(["taylor"]) == outcome


def test_that_a_kernel_that_takes_another_loss_at_an_impact_is_seen(monkeypatch):
    right = self_test.integrate_history

    def wrong_kernel(ground, dt, scale, model, method):
        return right(ground, dt, scale, model._replace(ratio_at_rest=model.ratio_at_rest - 1e-4), method)

    monkeypatch.setattr(self_test, "integrate_history", wrong_kernel)
    wrong, exact = self_test.compare_answers(["taylor"])
    assert set(wrong) == {"two_sided_history", "trilinear_history", "one_sided_history"} and not exact


def test_that_a_start_is_told_the_order_whose_kernels_its_first_wall_needs():
    wall = {"name": "w", "height_m": 3.0, "thickness_m": 0.4, "mechanism": "one_sided", "unit_weight_kn_m3": 18.0}
    tie = {"kind": "tie", "out_kn_m": 2.0, "h_m": 2.8, "bar_length_m": 6.0}
    plain, tied = (
        make_rocking_model(parse_case({"wall": [{**wall, **more}]}).wall[0], "one_sided")
        for more in ({}, {"hold": [tie]})
    )
    assert self_test.find_kernel_order(AUTO, plain, 0.01) == ("taylor",)
    assert self_test.find_kernel_order(AUTO, plain, 0.001) == ("taylor_6",)
    assert (
        self_test.find_kernel_order(METHODS["rk4"], plain, 0.01) == self_test.find_kernel_order(AUTO, tied, 0.01) == ()
    )
