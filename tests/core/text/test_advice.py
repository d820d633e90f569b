"""What errors and verdicts advise never lifts zeta without saying what it takes."""

import re

import pytest

from core.case.asked import DEMAND, WALL, evidence_keys
from core.text.catalogue import CATALOGUE
from tests.conftest import ROOT

LIFTING = re.compile(
    r"one[- _]sided|velocity[ _]ratio|restitution|free_element|free to vibrate|q_code|confidence_factor|\bFC\b"
    r"|participation|generat|return[ _]walls|\btie\b|leave .*out|left out|fewer|restraint|behind"
)
"""Inputs that lift zeta, and what is left out, in the English of a sentence; the Italian says the same."""

STATES = {
    "directions_by_themselves",
    "old_column",
    "old_tie",
    "tie_sought",
    "tie_sought_low",
    "two_sought",
    "arch_bar",
    "ends_fail",
    "odd_leaf",
    "hold_not_counted",
    "hold_nothing_behind",
    "hold_thrust_between",
    "old_free",
    "thrust_on_hold",
    "arch_tie",
    "arch_without_thrust",
    "arch_parts",
    "arch_mechanism",
    "leaf_mechanism",
    "arch_key",
    "arch_openings",
    "decimated",
    "solid_too_far",
    "alone",
    "by_default",
    "elastic_branch",
    "lift_rigid",
    "lift_scatter",
    "bending_finds_hinge",
    "bending_no_histories",
    "bending_rectangle",
    "bending_return_walls",
    "few_records",
    "friction_hinge",
    "generated_motions",
    "lift_anchorage",
    "lift_confidence_factor",
    "lift_inward",
    "floor_on_itself",
    "restraint_stands",
    "restraint_of_stretch",
    "restraint_unfollowed",
    "lift_participation",
    "lift_modes",
    "lift_return_walls",
    "lift_return_wedges",
    "body_leans_back",
    "lift_contact",
    "contact_outside",
    "solids_need",
    "tie_on_unlike_sides",
    "lift_velocity_ratio",
    "leans_inward",
    "ties_at_sld",
    "no_period",
    "no_restraint",
    "one_sign",
    "restitution_not_accepted",
    "restraint_fails",
    "top_fails",
    "return_walls_too_many",
    "rigid_free",
    "velocity_ratio_user",
    "vertical_component",
    "wedges_off_step",
    "demand_fails",
    "return_walls_need_length",
    "tie_bar_needs_length",
    "tie_design_needs",
    "tie_needs_length",
    "tie_size_or_bar",
}
"""They say what is the case, or what is accepted, and advise nothing that lifts zeta."""

LOWERS = {
    "column_of_plain_text",
    "confidence_below_level",
    "eq7_above_one",
    "generate_needs_spectrum",
    "holds_one_side",
    "intensity_follows",
    "modes_at_one_height",
    "no_number",
    "one_channel",
    "record_twice",
    "select_alone",
    "select_and_pga_scaling",
    "select_few_files",
    "select_too_few",
    "select_too_many",
    "skip_lines_of_plain_text",
    "site_disagrees",
    "site_elsewhere",
    "site_gives",
    "soil_factor_follows",
    "to_no_restraint",
    "to_not_compatible",
    "two_hazards",
    "load_mass_refused",
    "tie_accuracy",
    "unlike_accuracy",
    "tie_bar_says",
    "tie_elongation_below_yield",
    "ties_displacement",
    "ties_histories",
}
"""What they advise lowers zeta or leaves it: less is counted, the file decides, the spectrum does."""

CONDITION = {
    "stretches_left_out": "why it cannot",
    "bending_tie": "where it holds the top",
    "to_no_top_restraint": "and how",
    "confidence_needs_strength": "whose alpha includes",
    "strength_of_no_test": "whose alpha includes",
    "eq4_negative": "must come from tests",
    "loads_contradict": "if they do not exist",
    "low_confidence_factor": "the document of the investigations",
    "corner_pushed_over": "if the wall that spans",
    "leaf_held": "model the leaf as a separate wall",
    "modes_or_period": "state their period",
    "no_check": "for an element free to vibrate",
    "restitution_one_sided": "is for",
    "hold_inward": "is compared of a floor",
    "hold_yields": "is what a hold at a height is stretched by",
    "hold_yields_less": "that of a brittle hold",
    "measure_tie": "makes it pass",
    "no_measure": "makes it pass",
    "no_tie_there": "makes it pass",
    "two_sided_loads_rigid": "assume a restraint behind",
    "tie_needs_rigid_law": "may overturn later",
    "to_set_aside": "each with a document",
    "no_arch": "was not checked",
    "to_no_arch": "by a calculation",
    "base_friction_unused": "is not looked at",
    "to_set_aside_stretch": "with a document",
}
"""They name such an input together with what it takes: code -> words of it."""


@pytest.mark.shows("verdict.advice")
def test_that_every_sentence_that_names_what_lifts_zeta_was_read():
    """A new one is read for advice to the unsafe side, and put where it belongs."""
    found = {
        code
        for group in ("error", "reason", "missing")
        for code, (english, _) in CATALOGUE[group].items()
        if LIFTING.search(english)
    }
    assert found == STATES | LOWERS | set(CONDITION)
    for code, words in CONDITION.items():
        assert any(words in CATALOGUE[group].get(code, ("",))[0] for group in ("error", "reason"))


@pytest.mark.shows("verdict.advice")
def test_that_no_wall_is_sent_to_the_one_sided_mechanism_without_what_is_behind_it():
    """A free pillar: zeta 0.64 two-sided, 1.04 one-sided."""
    for group in ("error", "reason", "notice", "missing"):
        for code, (english, italian) in CATALOGUE[group].items():
            if "one-sided mechanism" in english or "as a one-sided" in english:
                assert "behind" in english, code
                assert "dietro" in italian or "posteriore" in italian, code
            assert "come parete su un lato" not in italian, code


@pytest.mark.shows("verdict.advice")
def test_that_no_lower_fc_and_no_other_restitution_is_offered_for_nothing():
    for english, italian in CATALOGUE["window"].values():
        assert "lower with a hinge setback" not in english, italian
    for group in ("error", "reason", "notice"):
        for english, _ in CATALOGUE[group].values():
            assert not re.search(r"another restitution|leave that record|or generate them", english)


REASONED = [*evidence_keys(WALL), *evidence_keys(DEMAND)]


@pytest.mark.parametrize("key", [*REASONED, "period_factor", "damping", "number", "knowledge_level"])
def test_that_help_says_what_a_key_that_lifts_zeta_does_to_the_verdict(key):
    assert all("ζ" in words for words in CATALOGUE["key"][f"{key}.help"])


def test_that_the_documents_name_every_reason_and_every_code_of_a_verdict():
    page = (ROOT / "resources" / "docs" / "case.md").read_text(encoding="utf-8")
    written = page[page.index("[[wall.evidence]]") :]
    assert all(key in written for key in [*REASONED, "knowledge_level"])
    table = (ROOT / "resources" / "docs" / "verdict.md").read_text(encoding="utf-8")
    codes = set(CATALOGUE["verdict"]) - {"not_activated_floor", "not_activated_bending"}
    assert {code for code in codes if f"`{code}`" not in table} == set()
