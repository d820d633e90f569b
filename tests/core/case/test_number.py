"""Numbers as people type them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.case.number import parse_number, parse_quantity
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
