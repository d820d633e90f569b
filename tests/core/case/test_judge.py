"""An edited case is judged as a whole one would be, and what did not change is read once."""

import hashlib
import json
import random
from dataclasses import replace

import pytest

from core.case import judge as judge_module
from core.case.judge import IncrementalParser
from core.case.loads import Load
from core.case.problems import find_problems
from core.case.rules import parse_case
from core.case.schema import Analysis, Case, Record, Report
from core.case.site import Building, Demand, Spectrum
from core.case.variant_names import DESIGNED
from core.case.wall import Wall
from core.case.writer import table_of
from core.errors import InputError
from tests.holds import shown


def case_of(count: int) -> Case:
    walls = tuple(
        Wall(f"w{k}", "two_sided", height_m=5.0 + 0.1 * k, thickness_m=0.5, base_z_m=0.0) for k in range(count)
    )
    return Case(wall=walls, demand=Demand(0.2, spectrum=Spectrum("EN1998", "B", type=1)), building=Building(12.0, 4))


def whole(case: Case) -> Case:
    return parse_case(table_of(case))


def judgement(judge, case: Case):
    """What is read of a case, with what is left out of a comparison of cases, or why not."""
    try:
        found = judge(case)
    except InputError as error:
        return str(error)
    return found, found.sha256, found.given


def of_wall(draw, **values):
    def edit(case: Case) -> Case:
        k = draw.randrange(len(case.wall))
        return replace(case, wall=(*case.wall[:k], replace(case.wall[k], **values), *case.wall[k + 1 :]))

    return edit


def edits(draw) -> list:
    """Edits of every part of a case, wrong and unfinished ones too."""
    of_demand = (
        {"confidence_factor": 1.2},
        {"confidence_factor": 1.35},
        {
            "confidence_factor": 1.2,
            "knowledge_level": "LC2",
            "evidence": shown(confidence_factor="three flat jacks in each front"),
        },
        {"ag_g": draw.choice((0.1, 0.3, ""))},
    )
    return [
        of_wall(draw, thickness_m=draw.choice((0.3, 0.45, None))),
        of_wall(draw, mechanism=draw.choice(("", "one_sided", "both"))),
        of_wall(draw, base_z_m=draw.choice((None, 3.0, 20.0))),
        of_wall(draw, name=draw.choice(("w0", "w1", "w0 (+3 m)", "w2 (progetto)"))),
        of_wall(draw, hinge_heights=draw.choice((None, "floors", (3.0,), (9.0,)))),
        of_wall(draw, velocity_ratio=draw.choice((None, 0.9))),
        of_wall(draw, variant=draw.choice((None, DESIGNED))),
        of_wall(draw, load=draw.choice(((), (Load("vertical", None, 3.0),), (Load("vertical", "", 3.0),)))),
        of_wall(draw, compressive_strength_mpa=2.0, unit_weight_kn_m3=18.0, hinge_setback_m=0.0),
        of_wall(draw, law="doherty"),
        lambda case: replace(case, wall=case.wall[::-1]),
        lambda case: replace(case, wall=case.wall[1:]),
        lambda case: replace(case, wall=(*case.wall, replace(case.wall[0], name=f"new {draw.random()}"))),
        lambda case: replace(case, analysis=Analysis(method=draw.choice(("auto", "linearised")))),
        lambda case: replace(case, analysis=Analysis(accuracy=draw.random() < 0.5)),
        lambda case: replace(case, report=Report(author=str(draw.random()))),
        lambda case: replace(case, record=(Record("a.txt", scale=draw.choice((1.0, 0.0))),)),
        lambda case: replace(case, demand=case.demand and replace(case.demand, **draw.choice(of_demand))),
        lambda case: replace(case, building=draw.choice((None, Building(12.0, 4), Building(9.0, 3), Building("", 3)))),
    ]


@pytest.mark.parametrize("seeds", [range(6), pytest.param(range(6, 200), marks=pytest.mark.long)])
def test_that_an_edited_case_is_judged_as_a_whole_one(seeds):
    for seed in seeds:
        draw, judge, case = random.Random(seed), IncrementalParser(), case_of(4)
        states = [case]
        for _ in range(30):
            case = draw.choice(states) if draw.random() < 0.2 else draw.choice(edits(draw))(case)
            if not case.wall:
                case = case_of(3)
            states.append(case)
            assert judgement(judge, case) == judgement(whole, case), seed
            assert [str(one) for one in find_problems(case, judge)] == [str(one) for one in find_problems(case)], seed


def test_that_a_wall_that_stands_twice_in_a_case_is_refused_as_two_of_one_name():
    twice = replace(case_of(2), wall=case_of(1).wall * 2)
    assert judgement(IncrementalParser(), twice) == judgement(whole, twice) and "same name" in judgement(whole, twice)


def test_that_walls_that_did_not_change_are_neither_read_nor_checked_again(monkeypatch):
    read, checked = [], []
    parsed, accepted = judge_module.parse_wall_entry, judge_module.replace_walls.__globals__["check_wall"]
    monkeypatch.setattr(judge_module, "parse_wall_entry", lambda entry, k: read.append(k) or parsed(entry, k))
    monkeypatch.setattr(
        "core.case.rules.check_wall",
        lambda case, wall, alone: checked.append((wall.name, alone)) or accepted(case, wall, alone),
    )
    judge, case = IncrementalParser(), case_of(20)
    first = judge(case)
    assert len(read) == len(checked) == 20
    changed = of_wall(random.Random(3), thickness_m=0.4)(case)
    k = next(k for k in range(20) if changed.wall[k] is not case.wall[k])
    found = judge(changed)
    assert read[20:] == [k] and checked[20:] == [(case.wall[k].name, True)]
    assert all((a is b) == (n != k) for n, (a, b) in enumerate(zip(first.wall, found.wall, strict=True)))
    judge(replace(changed, report=Report(author="A"), analysis=Analysis(q_step=0.01)))
    assert len(read) == len(checked) == 21
    judge(replace(changed, building=Building(15.0, 5)))
    assert len(read) == 21 and len(checked) == 41 and not any(alone for _, alone in checked[21:])


def test_that_the_digest_is_of_the_whole_content():
    case = whole(replace(case_of(3), title='a "wall": [] in a title'))
    text = json.dumps(case.as_dict(), sort_keys=True)
    assert case.sha256 == hashlib.sha256(text.encode()).hexdigest() and text.count('"name"') == 3
