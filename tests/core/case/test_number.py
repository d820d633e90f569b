"""Numbers as people type them."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.case.number import parse_formula, parse_number, parse_quantity
from core.errors import InputError


@pytest.mark.parametrize("text", ["0.312", "0,312", " 0,312 ", ".312", ",312", "+0.312", "3.12e-1"])
def test_that_comma_and_point_mean_the_same(text):
    assert parse_number(text) == 0.312


@pytest.mark.parametrize("text", ["1.000,5", "1,000.5", "1.2.3", "1_000", "nan", "inf", "1e400", "", "٣", "0x1"])
def test_that_anything_else_is_refused(text):
    with pytest.raises(InputError):
        parse_number(text)


@given(st.floats(-1e12, 1e12, allow_nan=False))
def test_that_every_number_python_writes_is_read_back(value):
    assert parse_number(repr(value)) == value
    assert parse_number(repr(value).replace(".", ",")) == value


@pytest.mark.parametrize(("text", "unit", "value"), [("4,5", "m", 4.5), ("50 cm", "m", 0.5), ("12", "", 12.0)])
def test_that_a_number_without_a_unit_is_in_that_of_its_key(text, unit, value):
    assert parse_quantity(text, unit) == value


SUMS = {"7*0,83": 5.81, "7×0.83": 5.81, "(30+40)/2 cm": 0.35, "2*(1,5-0,5) m": 2.0, "-2*-3": 6.0, "1+2*3-4/2": 5.0}
SUMS |= {"3 * 1e-3": 0.003, "0,60+0,02": 0.62}
NONE = ["", "7", "7*", "*7", "7**2", "7//2", "(7", "7)", "7*(2", "1/0", "7*x", "2*3 kN", "7 8", "()", "7*1.2.3"]


@pytest.mark.parametrize("text", SUMS)
def test_that_a_sum_or_product_is_computed(text):
    assert parse_formula(text, "m") == pytest.approx(SUMS[text], rel=1e-14)


@pytest.mark.parametrize("text", [*NONE, "1+" * 60 + "1", "(" * 1000, "1e308*10"])
def test_that_what_is_no_sum_or_product_is_refused(text):
    with pytest.raises(InputError):
        parse_formula(text, "m")


NUMBERS = st.integers(0, 999).map(str)
PAIRS = st.recursive(
    NUMBERS, lambda part: st.tuples(part, st.sampled_from("+-*"), part).map(lambda three: f"({''.join(three)})")
)


@given(PAIRS, st.sampled_from("+-*"), NUMBERS)
def test_that_every_sum_and_product_is_that_of_python(left, operator, right):
    text = f"{left}{operator}{right}"
    try:
        found = parse_formula(text, "")
    except InputError:
        assert sum(text.count(mark) for mark in "+-*()") > 15, "only what is very long is refused"
        return
    assert found == eval(re.sub(r"\d+", r"\g<0>.0", text)), "of numbers as they are computed with: beyond 2^53 rounded"
