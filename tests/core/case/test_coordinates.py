"""Coordinates pasted from maps."""

import pytest

from core.case.coordinates import parse_coordinates
from core.errors import InputError

AQUILA = (42.3498, 13.3995)


@pytest.mark.parametrize(
    "text",
    [
        "42.3498 13.3995",
        "42.3498, 13.3995",
        "42.3498,13.3995",
        "42,3498 13,3995",
        "42,3498; 13,3995",
        "42.3498 N 13.3995 E",
        "N 42.3498 E 13.3995",
        "42.3498°N, 13.3995°E",
        "E13.3995 N42.3498",
        "13.3995 E, 42.3498 N",
        "+42.3498, +13.3995",
        " 42.3498\t13.3995\n",
        "(42.3498, 13.3995)",
        "( 42.3498 N 13.3995 E )",
    ],
)
def test_that_decimal_degrees_are_read_in_any_usual_form(text):
    assert parse_coordinates(text) == pytest.approx(AQUILA, abs=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        "42°20'59\" 13°23'58\"",
        "42°20'59\"N 13°23'58\"E",
        "42° 20′ 59″ N, 13° 23′ 58″ E",
        "N42°20'59'' E13°23'58''",
        "42º20’59” 13º23’58”",
    ],
)
def test_that_degrees_minutes_and_seconds_are_read(text):
    assert parse_coordinates(text) == pytest.approx((42 + 20 / 60 + 59 / 3600, 13 + 23 / 60 + 58 / 3600), abs=1e-12)


def test_that_minutes_with_decimals_and_the_other_half_of_the_world_are_read():
    assert parse_coordinates("42°20.988' 13°23.97'") == pytest.approx(AQUILA, abs=1e-12)
    assert parse_coordinates("33.5 S 70.6 W") == (-33.5, -70.6) == parse_coordinates("-33.5, -70.6")
    assert parse_coordinates("33,5 S 70,6 O") == (-33.5, -70.6)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "42.3",
        "42.3 13.4 7",
        "42.3 N 13.4 N",
        "N 42.3 N 13 E",
        "100 13",
        "42°75'00\" 13°00'00\"",
        "L'Aquila",
        "42.3 x 13.4",
        "(42.3 13.4",
        "42 75 00 N 13 00 00 E",
        "42 20 59 13 23 58",
    ],
)
def test_that_anything_else_is_refused(text):
    with pytest.raises(InputError) as refused:
        parse_coordinates(text)
    assert refused.value.code == "coordinates_unread"


@pytest.mark.parametrize("text", ["42 20 59 N 13 23 58 E", "42 20 59.0 N, 13 23 58.0 E", "(42 20 59 N; 13 23 58 E)"])
def test_that_degrees_minutes_and_seconds_need_no_signs_before_a_letter(text):
    assert parse_coordinates(text) == pytest.approx((42 + 20 / 60 + 59 / 3600, 13 + 23 / 60 + 58 / 3600), abs=1e-12)
    assert parse_coordinates("42 20.5 N 13 23.5 E") == pytest.approx((42 + 20.5 / 60, 13 + 23.5 / 60), abs=1e-12)
