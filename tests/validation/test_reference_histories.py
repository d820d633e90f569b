"""The 40-digit histories `standard` and `hard` of resources/reference (see its README)."""

import mpmath as mp
import numpy as np
import pytest

from core.rocking.history import integrate_history
from core.rocking.methods import AUTO, METHODS, resolve_auto
from tests.conftest import ROOT
from tests.validation import high_precision

DT = 0.01


def error(reference, make_model, name, method) -> float:
    ground, truth, _, _ = reference(name)
    model = make_model()
    found = integrate_history(ground, DT, 1.0, model, method)
    return float(np.abs(found.rotation / model.slenderness - truth).max())


@pytest.mark.shows("mechanics.exact")
@pytest.mark.parametrize("name, tolerance", [("standard", 1e-12), ("hard", 1e-10)])
def test_that_order_six_cuts_its_steps_until_it_is_as_close(reference, make_model, name, tolerance):
    assert error(reference, make_model, name, METHODS["taylor_6"]) <= tolerance


@pytest.mark.shows("mechanics.orders")
def test_that_auto_takes_order_eight_where_a_sample_is_long_for_the_wall(make_model):
    eight = METHODS["taylor"]
    assert resolve_auto(AUTO, make_model(), 0.003) is METHODS["taylor_6"]
    assert resolve_auto(AUTO, make_model(), DT) is eight
    assert resolve_auto(AUTO, make_model(height=2.0), 0.003) is eight
    assert resolve_auto(AUTO, make_model(law="al_shawa"), 0.003) is eight
    assert resolve_auto(METHODS["rk4"], make_model(), DT) is METHODS["rk4"]


@pytest.mark.shows("mechanics.impact")
@pytest.mark.parametrize("name, tolerance", [("standard", 1e-12), ("hard", 1e-11)])
def test_that_impacts_have_the_reference_speeds(reference, make_model, name, tolerance):
    ground, _, _, before = reference(name)
    model = make_model()
    found = integrate_history(ground, DT, 1.0, model)
    assert np.abs(found.impact_velocity - model.ratio_at_rest * before).max() <= tolerance


def test_that_the_reference_velocities_are_those_before_the_impact(reference, make_model):
    """Settles the heading of *_impacts.csv by a third way: 30 digits, another program."""
    ground, _, times, column = reference("hard")
    with mp.workdps(30):
        alpha = mp.mpf("6.8") * mp.pi / 180
        p2 = 3 * mp.mpf("9.80665") / 4 / (mp.mpf(7) / 2 / mp.cos(alpha))
        ratio = 1 - mp.mpf("1.5") * mp.sin(alpha) ** 2
        _, impacts = high_precision.history(ground[:200], DT, alpha, p2, False, lambda v: ratio)
    assert len(impacts) == 2
    for (time, before, after), known, velocity in zip(impacts, times, column, strict=False):
        assert abs(time - known) < 1e-14
        assert abs(before / velocity - 1) < 1e-12
        assert abs(after / velocity - ratio) < 1e-12


@pytest.mark.shows("mechanics.errors")
@pytest.mark.parametrize(
    "method, name, stated",
    [
        ("newmark_paper", "standard", 0.63),
        ("newmark_paper", "hard", 1.42),
        ("newmark_paper_reset", "standard", 1.10),
        ("newmark_paper_reset", "hard", 0.41),
    ],
)
def test_that_the_papers_integrator_errs_as_stated(reference, make_model, method, name, stated):
    # to two digits, from another program
    assert error(reference, make_model, name, METHODS[method]) == pytest.approx(stated, abs=0.005)


def stated_errors() -> dict[str, tuple[float, float]]:
    """method -> its errors on `standard` and `hard`, of the table of physics.md, section 14."""
    page = (
        (ROOT / "resources" / "docs" / "physics.md").read_text(encoding="utf-8").split("## 14 ")[1].split("## 15 ")[0]
    )
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in page.splitlines() if line.startswith("| ")
    ]
    return {row[0]: (float(row[2].split(";")[0]), float(row[3].split(";")[0])) for row in rows[1:]}


@pytest.mark.shows("mechanics.errors")
@pytest.mark.parametrize("name, place", [("standard", 0), ("hard", 1)])
@pytest.mark.parametrize("method", stated_errors())
def test_that_each_method_errs_as_the_page_says(reference, make_model, method, name, place):
    """To the one digit that is printed; what is of the order of rounding within a factor of two."""
    stated = stated_errors()[method][place]
    within = 0.5 if stated < 1e-11 else 0.12
    assert error(reference, make_model, name, METHODS[method]) == pytest.approx(stated, rel=within)
