"""The file of a parametric study: the shipped ones, what is refused and in what words."""

import tomllib

import pytest

from app.terminal.command_line import SHIPPED_STUDIES
from core.case.study_file import Cell, cells_of, parse_study, quick_study, read_record_list, read_study
from core.errors import InputError
from tests.conftest import ROOT

GRID = {"slenderness_deg": [6.8], "height_m": [7.0], "motions": "records"}


def group(name, spectrum, seed):
    shape = {"name": spectrum, "seed": seed, "code": "EN1998", "type": 1, "soil": "A"}
    return {"name": name, "pga_g": 0.1, "spectrum": [shape]}


STUDIES = [ROOT / "resources" / "studies" / f"{name}.toml" for name in SHIPPED_STUDIES]


@pytest.mark.parametrize("path", STUDIES, ids=lambda path: path.stem)
def test_that_shipped_studies_are_read_and_a_short_run_is_part_of_them(path):
    study, _ = read_study(path)
    assert set(cells_of(quick_study(study))) < set(cells_of(study))
    assert quick_study(study).count < study.count


def test_that_no_two_motions_of_the_shipped_studies_share_a_seed():
    seeds = []
    for path in STUDIES:
        study, _ = read_study(path)
        for group in study.group:
            for shape in group.spectrum:
                seeds += range(shape.seed, shape.seed + study.count)
    assert len(set(seeds)) == len(seeds)


def test_that_every_combination_is_a_cell_once():
    grid = {
        **GRID,
        "height_m": [3.0, 7.0],
        "mechanism": ["two_sided", "one_sided"],
        "law": ["rigid", "doherty"],
        "velocity_ratio": [0.9],
    }
    cells = cells_of(parse_study({"grid": [grid, GRID]}))
    assert len(cells) == 9
    assert {cell.restitution for cell in cells} == {"0.9", "housner"}
    assert set(cells.values()) == {frozenset(["records"])}
    assert next(iter(cells)).wall.restitution_of("two_sided").ratio_at_rest == 0.9


@pytest.mark.parametrize(
    "table, words",
    [
        ({}, "grid is missing"),
        ({"grid": [{"height_m": [7.0]}]}, "slenderness_deg"),
        ({"grid": [{**GRID, "height_m": []}]}, "a list in brackets"),
        ({"grid": [{**GRID, "height_m": [7.0, "x"]}]}, "height_m = 'x' is not accepted: from 0.1 to 60 m"),
        ({"grid": [{**GRID, "height_m": [float("nan")]}]}, "from 0.1 to 60 m"),
        ({"grid": [{**GRID, "heigth_m": [7.0]}]}, "did you mean height_m"),
        ({"grid": [{**GRID, "restitution": ["one_sided_theoretical"]}]}, "grid 1"),
        ({"grid": [{**GRID, "method": ["euler"]}]}, "one of taylor"),
        ({"grid": [{**GRID, "method": ["linearised"], "law": ["doherty"]}]}, "rigid law"),
        ({"grid": [{**GRID, "motions": "generated"}]}, "group is missing"),
        ({"grid": [GRID], "group": [{"name": "A", "pga_g": 0.1}]}, "spectrum is missing"),
        ({"grid": [GRID], "group": [{"name": "A", "spectrum": []}]}, "pga_g"),
        (
            {
                "grid": [GRID],
                "group": [
                    {"name": "A", "pga_g": 0.1, "spectrum": [{"name": "s", "code": "NTC2018", "soil": "A", "seed": 1}]}
                ],
            },
            "f0",
        ),
        ({"grid": 3}, "one or more tables [[grid]]"),
        ({"grid": [GRID], "group": [group("A", "s", 1), group("A", "t", 11)]}, 'the name "A" (group)'),
        ({"grid": [GRID], "group": [group("A", "s", 1), group("B", "s", 11)]}, 'the name "s" (spectrum)'),
        ({"grid": [GRID], "group": [group("A", "s", 1), group("B", "t", 7)]}, "seed 7 again"),
        ({"grid": [GRID], "colour": 1}, "colour"),
    ],
)
def test_that_what_is_wrong_is_said_with_its_place(table, words):
    with pytest.raises(InputError) as caught:
        parse_study(table)
    assert words in caught.value.text("en")


def test_that_a_list_of_records_holds_records_and_nothing_else(tmp_path):
    path = tmp_path / "list.toml"
    path.write_text('[[record]]\nfile = "a.txt"\nunit = "g"\n')
    assert [record.unit for record in read_record_list(path).record] == ["g"]
    for content in ("", "title = 'x'\n"):
        path.write_text(content)
        with pytest.raises(InputError, match="list.toml"):
            read_record_list(path)


def test_that_the_shapes_of_the_paper_are_different_and_spread_in_every_group():
    from core.lab.research.parametric import spectra_of
    from core.units import CM, G

    study = parse_study(tomllib.loads((ROOT / "resources" / "studies" / "paper.toml").read_text()))
    spectra = [spectrum for spectrum, _ in spectra_of(study)]
    assert [round(s.target.pga / G, 9) for s in spectra] == [0.106] * 3 + [0.312] * 3 + [0.205] * 3
    ratios = {s.name: s.intensity / CM / (s.target.pga / G) for s in spectra}
    assert len({round(ratio) for ratio in ratios.values()}) == 9
    for group in "ABC":
        own = [ratio for name, ratio in ratios.items() if name[0] == group]
        assert min(own) < 235.0 and max(own) > 620.0


def test_that_a_grid_of_walls_alone_is_of_rigid_two_sided_ones_at_half_a_percent():
    (cell,) = cells_of(parse_study({"grid": [GRID]}))
    assert cell == Cell(6.8, 7.0, "two_sided", "housner", "rigid", "taylor", 0.005)


@pytest.mark.parametrize(
    ("key", "low", "high", "words"),
    [
        ("slenderness_deg", 0.5, 45.0, "from 0.5 to 45 deg"),
        ("height_m", 0.1, 60.0, "from 0.1 to 60 m"),
        ("velocity_ratio", 0.0, 1.0, "from 0 to 1"),
        ("q_step", 1e-4, 0.1, "from 0.0001 to 0.1"),
    ],
)
def test_that_a_list_of_a_grid_has_values_up_to_both_ends_of_their_range(key, low, high, words):
    assert getattr(parse_study({"grid": [{**GRID, key: [low, high]}]}).grid[0], key) == (low, high)
    for beyond in (low - 1e-6, high * (1.0 + 1e-6)):
        with pytest.raises(InputError, match=words):
            parse_study({"grid": [{**GRID, key: [beyond]}]})


def test_that_a_short_run_keeps_what_the_study_says_else_two_motions_and_all_heights():
    grids = [{**GRID, "height_m": [3.0, 7.0, 9.0]}, {**GRID, "quick": False}]
    plain = quick_study(parse_study({"grid": grids}))
    assert plain.count == 2 and [grid.height_m for grid in plain.grid] == [(3.0, 7.0, 9.0)]
    said = quick_study(parse_study({"grid": grids, "quick": {"count": 3, "height_m": [3.0, 9.0]}}))
    assert said.count == 3 and [grid.height_m for grid in said.grid] == [(3.0, 9.0)]
    other = quick_study(parse_study({"grid": grids, "count": 1, "quick": {"count": 3, "height_m": [5.0]}}))
    assert other.count == 1 and [grid.height_m for grid in other.grid] == [(3.0, 7.0, 9.0)]
