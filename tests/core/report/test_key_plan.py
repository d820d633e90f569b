"""The key plan of a building: each wall in the colour of its outcome."""

from pathlib import Path

import pytest

from core.report.key_plan import key_plan
from core.report.note.content import full_note
from core.report.note.parts import Figures, Table
from core.report.verdict_words import tone_of
from core.study.run import run
from tests.clauses_alone import parse_case

WALL = {"mechanism": "one_sided", "height_m": 6.0, "length_m": 8.0, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
WALL |= {"hold": [{"kind": "contact"}], "unloaded_confirmed": True}
PLACES = {"north": (0.0, 9.0, 8.0, 9.0), "south": (0.0, 0.0, 8.0, 0.0), "east": (8.0, 0.0, 8.0, 9.0)}
THICK = {"north": 0.9, "south": 0.4, "east": 0.6}
DEMAND = {"ag_g": 0.12, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}


def walls(**changes):
    for name, (x1, y1, x2, y2) in PLACES.items():
        plan = {"x1_m": x1, "y1_m": y1, "x2_m": x2, "y2_m": y2}
        yield WALL | {"name": name, "thickness_m": THICK[name], "plan": plan} | changes.get(name, {})


def study(*tables):
    return run(parse_case({"wall": list(tables), "demand": DEMAND}), base_dir=Path())


@pytest.mark.shows("bodies.plan")
def test_that_each_wall_stands_in_its_place_the_worst_first():
    result = study(*walls())
    placed = key_plan(result)
    assert [one.name for one in placed] == ["south", "east", "north"]
    for one in placed:
        x1, y1, x2, y2 = PLACES[one.name]
        assert one.ends == ((x1, y1), (x2, y2))
        (verdict,) = [each for each in result.verdicts if each.wall.name == one.name]
        assert (one.zeta, one.result) == (verdict.zeta_least, verdict.governing)
        assert one.tone == tone_of(result, result.walls[one.result])


def test_that_of_variants_at_one_place_the_worse_is_drawn_whichever_way_it_is_written():
    tables = list(walls(north={"variant": "stato di fatto", "thickness_m": 0.4}))
    turned = {"x1_m": 8.0, "y1_m": 9.0, "x2_m": 0.0, "y2_m": 9.0}
    tables.append(tables[0] | {"variant": "progetto", "thickness_m": 0.9, "plan": turned})
    result = study(*tables)
    (north,) = [one for one in key_plan(result) if one.name == "north"]
    assert north.wall.thickness == 0.4


@pytest.mark.shows("bodies.plan")
def test_that_the_note_draws_it_in_the_tones_of_its_table():
    result = study(*walls())
    parts = full_note(result, "it")
    (at,) = [k for k, part in enumerate(parts) if getattr(part, "text", "") == "Pianta chiave"]
    figures, table = parts[at + 1 : at + 3]
    assert isinstance(figures, Figures) and isinstance(table, Table)
    placed = key_plan(result)
    assert [curve.color for curve in figures.figures[0].curves] == [one.tone for one in placed]
    assert [row[1] for row in table.rows] == [one.wall.name for one in placed]
    assert not any(getattr(part, "text", "") == "Key plan" for part in full_note(study(next(walls())), "en"))
