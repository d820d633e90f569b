"""The hazard of a site as text."""

import pytest

from core.case.hazard_table import parse_hazard, read_hazard
from core.errors import InputError

PASTED = (
    "T_R\ta_g\tF0\tT_C*\n[anni]\t[g]\t[-]\t[s]\n30\t0,080\t2,40\t0,28\n\n475\t0,260\t2,36\t0,35\n"
    "2475\t0,45\t2,4\t0,37\n"
)


def test_that_rows_pasted_with_their_heads_and_commas_are_read():
    rows = parse_hazard(PASTED)
    assert [(r.return_period_years, r.ag_g, r.f0, r.tc_star_s) for r in rows] == [
        (30.0, 0.08, 2.4, 0.28),
        (475.0, 0.26, 2.36, 0.35),
        (2475.0, 0.45, 2.4, 0.37),
    ]


def test_that_commas_separate_where_the_point_is_the_decimal():
    rows = parse_hazard("30,0.08,2.4,0.28\n475,0.26,2.4,0.35\n")
    assert [row.tc_star_s for row in rows] == [0.28, 0.35]


def test_that_two_columns_are_enough():
    rows = parse_hazard("30 0.08\n475; 0.26\n")
    assert [(r.ag_g, r.f0) for r in rows] == [(0.08, None), (0.26, None)]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "no_hazard_rows"),
        ("words only", "no_hazard_rows"),
        ("30 0.08", "hazard_not_rising"),
        ("475 0.26\n30 0.08", "hazard_not_rising"),
        ("30 0.08\n475 0.26 2.4", "hazard_line"),
        ("30 0.08\nend", "hazard_line"),
        ("30 nan\n475 0.26", "hazard_line"),
        ("nan 30\n475 0.26", "hazard_not_rising"),
        ("30 0.08\n475 9.9", "not_accepted"),
        ("\n".join(f"{30 + k} {0.01 + 1e-4 * k:.4f}" for k in range(101)), "hazard_line"),
    ],
)
def test_that_other_text_is_refused_in_one_sentence(text, code):
    with pytest.raises(InputError) as caught:
        parse_hazard(text)
    assert caught.value.code == code
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("first", ["30 anni;0,052;2,4;0,27", "30;0,052 g;2,4;0,27", "+30 0,05x", ".5 anni 0,05"])
def test_that_no_row_is_taken_for_a_head(first):
    """A head does not begin with a number: of seven rows, five written otherwise must not leave two."""
    with pytest.raises(InputError) as caught:
        parse_hazard(f"T_R;a_g;F0;T_C*\n{first}\n475;0,26;2,4;0,35\n975;0,3;2,4;0,36\n")
    assert caught.value.code == "hazard_line" and first in str(caught.value)


def test_that_a_file_is_read_and_a_missing_or_large_one_refused(tmp_path):
    path = tmp_path / "hazard.txt"
    path.write_text(PASTED, encoding="utf-8")
    assert len(read_hazard(path)) == 3
    for name, content, code in (("none.txt", None, "no_hazard_file"), ("large.txt", "x" * 200_000, "hazard_too_large")):
        if content:
            (tmp_path / name).write_text(content)
        with pytest.raises(InputError) as caught:
            read_hazard(tmp_path / name)
        assert caught.value.code == code and name in str(caught.value)


@pytest.mark.parametrize("line", [2, 3, 5])
def test_that_the_line_that_is_named_is_the_one_that_is_wrong(line):
    rows = ["TR ag F0 TC", "30 0.05 2.4 0.28", "101 0.1 2.4 0.3", "475 0.19 2.5 0.33", "975 0.3 2.5 0.34"]
    rows[line - 1] = "30 o 2.4 0.28"
    with pytest.raises(InputError) as refused:
        parse_hazard("\n".join(rows))
    assert str(refused.value).startswith(f"line {line}:")
