"""Whatever document an outcome asks for can be given where it says, and is asked for no more once it is given."""

import copy

import pytest

from core.answer.answer import collect_actions
from core.study.run import run
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.variation.random_walls import random_tables

ROUNDS = 6
"""Times that documents are given: what one settles may turn an outcome that asks for another."""

ODD = ({}, {"zeta_target": 0.8}, {"q_code": 1.5})
"""Keys of a demand that ask for documents of their own."""


def asked(table):
    """The actions of the run of a case with one wall."""
    result = run(parse_case(table), base_dir=ROOT)
    return [action for action in collect_actions(result, result.verdicts) if action.group == "reason"]


def give(table, action):
    """Write the document that an action asks for; what was given, None of another action."""
    said, wall = dict(action.values), table["wall"][0]
    where = said.get("evidence")
    if where is None:
        return None
    kind = str(dict(where.values)["kinds"]).split(" | ")[0]
    document = {"kind": kind, "reference": "report A1"}
    if where.code == "in_hold":
        for hold in wall["hold"]:
            if action.code == "to_evidence" and "evidence" in hold:
                continue
            hold["evidence"] = document
        return action.code, str(said.get("hold"))
    key, section = str(dict(where.values)["key"]), wall if "wall" in str(where.values) else table["demand"]
    section.setdefault("evidence", []).append({"of": key} | document)
    return action.code, key


@pytest.mark.shows("lifts.settled")
@pytest.mark.parametrize(("count", "first"), [(60, 0), pytest.param(150, 1000, marks=pytest.mark.long)])
def test_that_what_is_asked_for_can_be_given_and_is_then_settled(count, first):
    given_of = set()
    for n, table in enumerate(random_tables(count, first=first)):
        table = copy.deepcopy(table)
        table["demand"] = table["demand"] | ODD[n % len(ODD)]
        given: list[tuple[str, str]] = []
        for _ in range(ROUNDS):
            wanted = [what for action in asked(table) if (what := give(table, action)) is not None]
            again = [what for what in wanted if what in given]
            assert again == [], (n, table)
            if not wanted:
                break
            given += wanted
        else:
            pytest.fail(f"still asked after {ROUNDS} rounds: {given}")
        given_of |= {key for _, key in given}
    assert len(given_of) > 4
