"""Ties a wall cannot have, and those to be designed that cannot be, are refused in one sentence."""

import pytest

from core.case.hold import HOLD_KINDS, Bars, Hold, hold_kind
from core.case.rules import parse_case, parse_draft
from core.case.tie_rules import OF_A_TIE
from core.case.wall_table import parse_wall_rows, text_rows
from core.errors import InputError
from tests.holds import sought
from tests.validation.test_loaded_walls import TIE, WALL, case_of

BAR = {"number": 4, "diameter_mm": 20.0}
OF_BARS = {**TIE, "out_kn_m": None, "bar": BAR}
REFUSED = [
    ("loads_need_weight", TIE, {"unit_weight_kn_m3": None}),
    ("unknown_key", {**TIE, "mass": "moving"}, {}),
    ("unknown_key_near", {**TIE, "elongation": 0.05}, {}),
    ("unknown_key_near", {**TIE, "d_m": 0.2}, {}),
    ("unknown_key_near", {**TIE, "kn_m": 5.0}, {}),
    ("hold_needs", {**TIE, "h_m": None}, {}),
    ("hold_outside", {**TIE, "h_m": 3.01}, {}),
    ("hold_key", {**TIE, "spacing_m": 3.0}, {}),
    ("tie_needs_length", {**TIE, "bar_length_m": None, "elongation_m": None}, {}),
    ("tie_needs_length", {**TIE, "bar_length_m": None}, {}),
    ("tie_size_or_bar", {**TIE, "out_kn_m": None}, {}),
    ("tie_size_or_bar", {**TIE, "bar": BAR}, {"length_m": 9.0}),
    ("tie_bar_says", {**OF_BARS, "fy_mpa": 235.0}, {}),
    ("tie_bar_needs_length", OF_BARS, {}),
    ("tie_bar_needs_length", {**OF_BARS, "elongation_m": None}, {}),
    ("tie_slack_and_prestress", {**TIE, "slack_mm": 2.0, "prestress": 0.2}, {}),
    ("tie_needs_rigid_law", TIE, {"law": "doherty"}),
    ("prestress_one_sided", {**TIE, "out_kn_m": 0.5, "prestress": 0.2}, {"mechanism": "both"}),
    ("tie_elongation_below_yield", {**TIE, "elongation_m": 0.009}, {}),
    ("tie_elongation_too_large", {**TIE, "elongation_m": 2.5}, {}),
    ("tie_existing_steel", {**OF_BARS, "bar": {**BAR, "existing": True}}, {"length_m": 9.0}),
    ("tie_fu_below_fy", {**OF_BARS, "bar": {**BAR, "fy_mpa": 400.0}}, {"length_m": 9.0}),
    ("tie_thread_too_large", {**OF_BARS, "bar": {**BAR, "thread_mm": 30.1}}, {"length_m": 9.0}),
    ("hold_needs", sought(None, bar_length_m=8.0), {}),
    ("hold_needs", sought(None, spacing_m=2.0), {}),
    ("hold_outside", sought(3.5), {}),
    ("tie_sought_low", sought(0.05), {}),
    ("tie_design_needs", sought(2.8, elongation_m=0.4), {}),
    ("tie_elongation_below_yield", sought(2.8, bar_length_m=8.0, elongation_m=0.005), {}),
    ("tie_elongation_too_large", sought(2.8, bar_length_m=8.0, elongation_m=2.5), {}),
    ("tie_needs_rigid_law", sought(2.8), {"law": "doherty"}),
    ("holds_one_side", sought(2.0), {"mechanism": "two_sided"}),
    ("loads_need_weight", sought(2.0), {"unit_weight_kn_m3": None}),
    ("tie_sought", sought(2.8, out_kn_m=5.0), {}),
    ("tie_sought", sought(2.8, fy_mpa=235.0), {}),
    ("tie_sought", sought(2.8, slack_mm=2.0), {}),
    ("tie_sought", sought(2.8, prestress=0.2), {}),
    ("tie_sought", sought(2.8, bar=BAR), {}),
]


def given(table):
    return {key: value for key, value in table.items() if value is not None}


@pytest.mark.shows("case.loads")
@pytest.mark.parametrize(("code", "tie", "changes"), REFUSED)
def test_that_ties_a_wall_cannot_have_are_refused(code, tie, changes):
    with pytest.raises(InputError) as caught:
        parse_case({"wall": [given({**WALL, **changes, "hold": [given(tie)]})]})
    error = caught.value
    assert error.code == code
    for language in ("en", "it"):
        text = error.text(language)
        assert '"w"' in text and "\n" not in text and "{" not in text


def test_that_one_tie_at_most_is_to_be_designed():
    with pytest.raises(InputError) as caught:
        case_of(sought(2.0), sought(2.8))
    assert (caught.value.code, caught.value.key, caught.value.values) == ("two_sought", "design", {"first": 1})


@pytest.mark.parametrize("key", OF_A_TIE)
@pytest.mark.parametrize("kind", [kind for kind in HOLD_KINDS if kind != "tie"])
def test_that_a_key_of_a_tie_is_of_no_other_hold(kind, key):
    """The rule before: a key of a tie at another load."""
    value = {"bar": BAR, "design": True, "fy_mpa": 235.0, "prestress": 0.2, "bar_length_m": 8.0}.get(key, 0.4)
    place = {"h_m": 2.8} if hold_kind(kind).has_height else {}
    with pytest.raises(InputError) as caught:
        case_of(hold=[{"kind": kind, **place, key: value}])
    assert (caught.value.code, caught.value.key) == ("hold_key", key)


def test_that_a_tie_among_the_loads_is_refused_with_its_new_writing():
    import tomllib

    older = {"kind": "tie", "kn_m": 5.0, "h_m": 2.8, "bar_length_m": 8.0, "elongation": 0.05}
    for read in (parse_case, parse_draft):
        with pytest.raises(InputError) as caught:
            read({"wall": [{**WALL, "load": [older]}]})
        assert (caught.value.code, caught.value.key) == ("old_tie", "kind")
        (written,) = tomllib.loads(caught.value.text("en").rpartition("the wall: ")[2])["hold"]
        assert written == TIE
    for share in ("0.04", [0.04], "4%"):
        with pytest.raises(InputError):
            parse_case({"wall": [{**WALL, "load": [{**older, "elongation": share}]}]})


def test_that_a_table_of_walls_has_ties_with_their_bars_and_refuses_a_tie_among_its_loads():
    head = "name;H [m];t [m];L [m];peso specifico [kN/m3];mechanism;vincolo 1;vincolo 1 h [m];"
    row = "A;3;0,45;6;18;one_sided;catena;2,8;"
    bars = "hold1_bar_length_m [m];hold1_bar_number;hold1_bar_diameter_mm [mm];hold1_bar_anchorage_kn [kN]"
    (wall,) = parse_wall_rows(text_rows(f"{head}{bars}\n{row}8;4;24;170\n"))
    assert wall.hold == (Hold("tie", h_m=2.8, bar_length_m=8.0, bar=Bars(4, 24.0, anchorage_kn=170.0)),)
    with pytest.raises(InputError) as caught:
        parse_wall_rows(text_rows("name;H [m];t [m];mechanism;Carico 1;Carico 1 h [m]\nA;3;0,45;one_sided;catena;2\n"))
    assert caught.value.code == "old_column" and "hold1_kind" in caught.value.text("en")


@pytest.mark.parametrize(
    "bad",
    [
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 1.0},
        {"kind": "tie", "h_m": 1.0, "bar_length_m": 8.0},
        {"kind": "tie", "out_kn_m": 0.0, "h_m": 1.0, "bar_length_m": 8.0},
        {"kind": "tie", "out_kn_m": -1.0, "h_m": 1.0, "bar_length_m": 8.0},
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 0.0, "bar_length_m": 8.0},
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0, "elongation_m": 0.001},
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0, "elongation_m": 0.1, "elongation": 0.1},
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0, "slack_mm": 3.0, "prestress": 0.1},
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0, "d_m": 0.2},
        {"kind": "tie", "out_kn_m": 1.0, "h_m": 1.0, "bar_length_m": 8.0, "bar": {"number": 2, "diameter_mm": 20.0}},
        {"kind": "tie", "h_m": 1.0, "bar_length_m": 8.0, "bar": {"number": 2, "diameter_mm": 20.0}},
    ],
)
def test_that_a_tie_that_is_none_is_refused(bad):
    with pytest.raises(InputError):
        parse_case({"wall": [{**WALL, "hold": [bad]}]})


def test_that_a_bar_elongates_by_thirty_percent_of_its_length_at_most():
    """Of a bar of 8 m 2.4 m."""
    ties = {**TIE, "out_kn_m": 4.0}, sought(2.8, bar_length_m=8.0)
    for tie in ties:
        (hold,) = case_of({**tie, "elongation_m": 2.4}).wall[0].hold
        assert hold.elongation_m == 2.4
        with pytest.raises(InputError) as caught:
            case_of({**tie, "elongation_m": 2.41})
        assert caught.value.code == "tie_elongation_too_large"
        assert caught.value.values == {"found": 2.41, "most": pytest.approx(2.4), "share": 0.3}


def test_that_bars_go_with_an_elongation():
    """As it was said by the share of their length."""
    bars = given(OF_BARS) | {"bar": {"number": 1, "diameter_mm": 8.0, "thread_mm": 12.0, "anchorage_kn": 50.0}}
    (tie,) = case_of(bars, length_m=9.0).wall[0].ties
    assert tie.tie(9.0).stands_more and tie.tie(9.0).bar.stands == 0.4
