"""The small form of a benchmark is the same code on the same inputs, fewer of them."""

import re
import tokenize

import numpy as np
import pytest

from tests.benchmarks import bench
from tests.conftest import ROOT

INPUTS = ROOT / "tests" / "benchmarks" / "inputs.py"


def names_of(path) -> set[str]:
    """Names of the code of a module."""
    with tokenize.open(path) as stream:
        return {token.string for token in tokenize.generate_tokens(stream.readline) if token.type == tokenize.NAME}


def asks(names: set[str]) -> set[str]:
    """Names by which code asks whether it is small."""
    return {name for name in names if re.search(r"(^|_)small(_|$)", name)}


def test_that_no_benchmark_asks_whether_it_is_small():
    """It takes what `Command` of inputs.py gives: so no form has a case, a branch or an amount of its own."""
    modules = sorted((ROOT / "tests" / "benchmarks").glob("*.py"))
    asking = {path.name: found for path in modules if (found := asks(names_of(path)))}
    assert asking == {INPUTS.name: {"_small"}}
    words = {path.name for path in modules if '"--small"' in path.read_text(encoding="utf-8")}
    assert words == {"bench.py"}, "a process of a benchmark takes numbers, not a word"


@pytest.mark.parametrize("inputs", [("a", "b", "c"), [1, 2, 3, 4], range(9), np.arange(5.0)])
def test_that_the_small_form_takes_some_of_the_same_inputs(inputs):
    real, small = bench.options_of([]), bench.options_of(["--small"])
    assert list(real.few(inputs, 2, 1)) == list(inputs)
    assert list(small.few(inputs, 2, 1)) == list(inputs)[1:3]
    assert real.number(1000, 3) == 1000 and small.number(1000, 3) == 3 and small.number(2, 3) == 2


@pytest.mark.parametrize(("count", "first"), [(0, 0), (3, 0), (2, 2), (1, -1)])
@pytest.mark.parametrize("words", [[], ["--small"]])
def test_that_both_forms_refuse_inputs_that_are_not_fewer(words, count, first):
    with pytest.raises(ValueError, match="are not fewer than 3"):
        bench.options_of(words).few((1, 2, 3), count, first)
