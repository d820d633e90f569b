"""Faces of an expression: brackets come from precedence, whatever the face."""

import pytest

from core.derivation import body, checks
from core.derivation.faces import Branches, Shown, formula, in_numbers, in_symbols
from core.derivation.functions import cos, sqrt
from core.derivation.quantity import quantity

LETTERS = {name: name for name in "abcdxt"}


@quantity("r", "–")
def nested(a, b, c, d):
    return (a - (b - c)) / (d * (a + b)) - a * (b / c) ** 2


@quantity("r", "–")
def negative(a, b):
    return a * -b + sqrt(a**b)


@quantity("r", "–")
def of_angle(x):
    return 2 * cos(x)


def evaluated(live: str, **values) -> float:
    """A formula of a spectrum of letters, by Python."""
    return eval(live[1:].replace("^", "**").replace("SQRT", "sqrt"), {"sqrt": lambda v: v**0.5, **values})


def test_that_a_formula_has_the_value_of_its_function():
    values = {"a": 7.0, "b": 2.0, "c": 5.0, "d": 3.0}
    live = formula(nested, LETTERS)
    assert live == "=(a-(b-c))/(d*(a+b))-a*(b/c)^2"
    assert evaluated(live, **values) == nested.function(**values)
    assert formula(negative, LETTERS) == "=a*(-b)+SQRT(a^b)"
    assert formula(negative, {"a": "-3.0", "b": "2.0"}) == "=(-3.0)*(-2.0)+SQRT((-3.0)^2.0)"


def test_that_symbols_and_numbers_are_written_as_by_hand():
    assert in_symbols(nested, LETTERS, "en") == "(a − (b − c))/(d (a + b)) − a (b/c)²"
    shown = {name: Shown(value, 1, None) for name, value in zip("abcd", (7.0, -2.0, 5.0, 3.0), strict=True)}
    assert "".join(p if isinstance(p, str) else p.text("it") for p in in_numbers(nested, shown, "it")) == (
        "(7,0 − ((-2,0) − 5,0))/(3,0 · (7,0 + (-2,0))) − 7,0 · ((-2,0)/5,0)²"
    )
    assert in_symbols(of_angle, {"x": "α"}, "en") == "2 cos α"
    assert in_symbols(of_angle, {"x": "S a_g"}, "en") == "2 cos S a_g"


def test_that_a_quantity_whose_symbol_is_a_product_stands_in_brackets_where_it_divides():
    symbols = {"a0_star": "a_0*", "demand_pga": "S a_g"}
    assert in_symbols(checks.zeta_sld, symbols, "en") == "a_0*/(S a_g)"


def test_that_a_sum_over_the_loads_is_one_over_their_columns():
    cells = {"load.q": "F1:F3", "load.d": "(D1:D3-u)", "load.h": "E1:E3", "w": "W", "x": "X", "y": "Y"}
    live = formula(body.slenderness_with_loads, cells)
    assert live == "=DEGREES(ATAN((W*X+SUMPRODUCT(F1:F3*(D1:D3-u)))/(W*Y+SUMPRODUCT(F1:F3*E1:E3))))"
    symbols = {**body.LOADS, "w": "W", "x": "x", "y": "y"}
    assert in_symbols(body.slenderness_with_loads, symbols, "en") == "arctan((W x + ΣQ d)/(W y + ΣQ h))"


def test_that_a_spectrum_of_branches_is_a_formula_and_no_line():
    names = dict.fromkeys(checks.se_t0.needs, "1")
    assert "IF(" in formula(checks.se_t0, names)
    with pytest.raises(Branches):
        in_symbols(checks.se_t0, dict.fromkeys(checks.se_t0.needs, "T"), "en")


def test_that_what_no_line_before_it_gives_is_refused():
    with pytest.raises(ValueError, match="needs what no line before it gives"):
        in_symbols(nested, {"a": "a"}, "en")


def test_that_a_function_of_more_than_one_expression_is_no_quantity():
    @quantity("r", "–")
    def two(a):
        b = a
        return b

    with pytest.raises(ValueError, match="more than one expression"):
        formula(two, {"a": "1"})
