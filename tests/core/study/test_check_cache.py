"""The dynamic checks a journal holds: the same digits, and another one for all that changes a result."""

from dataclasses import asdict, fields, replace

import pytest

from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import DynamicCheck, run_dynamic_check
from core.codes.multiplier_search import Precision
from core.rocking.methods import AUTO, METHODS
from core.study import check_cache
from core.study.check_cache import CheckCache, check_key
from core.study.journal import Journal, MemoryJournal, dataclass_from_json


@pytest.mark.parametrize("where", ["disk", "memory"])
def test_that_a_kept_check_is_the_one_that_was_made(result, tmp_path, monkeypatch, where):
    wall, motions = result.walls[1], list(result.motions)
    asked = (wall.model, motions, (1, -1), result.demand, AUTO, Precision(4))
    book = Journal(tmp_path / "c.journal", "key", True) if where == "disk" else MemoryJournal()
    first = CheckCache(book)
    made = first(*asked)
    assert made == run_dynamic_check(*asked) and first.made == 1
    if where == "disk":
        book.close()
        book = Journal(tmp_path / "c.journal", "key", True)
    monkeypatch.setattr(check_cache, "run_dynamic_check", lambda *_: pytest.fail("made again"))
    again = CheckCache(book)
    assert again(*asked) == made and again.made == 0
    book.close()


def test_that_all_that_decides_a_check_is_in_its_key(result):
    wall, motions, demand = result.walls[1], list(result.motions), result.demand
    asked = {"model": wall.model, "motions": motions, "polarities": (1, -1), "demand": demand, "method": AUTO}
    numbers = (Precision(), True)
    key = check_key(*asked.values(), *numbers)
    assert key == check_key(*asked.values(), *numbers)
    others = [
        {**asked, "model": wall.model._replace(p2=1.001 * wall.model.p2)},
        {**asked, "motions": motions[:-1]},
        {**asked, "motions": [replace(motions[0], name="x"), *motions[1:]]},
        {**asked, "motions": [replace(motions[0], acceleration=1.1 * motions[0].acceleration), *motions[1:]]},
        {**asked, "motions": [replace(motions[0], details=(("Station", "x"),)), *motions[1:]]},
        {**asked, "polarities": (1,)},
        {**asked, "method": METHODS["rk4"]},
    ]
    keys = {key, *(check_key(*other.values(), *numbers) for other in others)}
    for changed in ((Precision(2), True), (Precision(enough=1.1), True), (Precision(), False)):
        keys.add(check_key(*asked.values(), *changed))
    assert len(keys) == 1 + len(others) + 3


def test_that_every_number_of_the_demand_is_in_the_key(result):
    """But its spectrum and its words, which the check takes nothing of."""
    wall, motions, demand = result.walls[1], list(result.motions), result.demand
    left_out = set()
    key = check_key(wall.model, motions, (1,), demand, AUTO)
    for entry in fields(SeismicDemand):
        other = replace(demand, **{entry.name: "another"})
        if check_key(wall.model, motions, (1,), other, AUTO) == key:
            left_out.add(entry.name)
    assert left_out == {"target", "warnings"}


def test_that_a_line_that_is_no_check_is_made_again(result):
    check = result.walls[1].assessment.dynamic
    content = asdict(check)
    assert dataclass_from_json(DynamicCheck, content) == check
    wrong_parts = ({"runs": 5}, {"new": 1}, {"zeta_spread": [1.0]})
    for wrong in (None, {}, [], *({**content, **part} for part in wrong_parts)):
        assert dataclass_from_json(DynamicCheck, wrong) is None
