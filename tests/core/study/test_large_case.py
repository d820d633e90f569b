"""A case of more walls than a workbook holds: its table has the numbers of the same walls in a small case."""

import json
import math
import sys

import pytest

from app.look.language import set_language
from app.terminal import batch, large_batch
from core.case.reader import read_case
from core.errors import InputError, OutputError
from core.ground.artificial import filtered_noise
from core.report import json_report
from core.report.columns import COLUMNS
from core.report.large_report import Tally
from core.setting import plan
from core.study import large_case
from core.study.case_parts import part_path
from core.study.run import run
from core.units import G
from tests.conftest import ROOT
from tests.core.study.cases import DEMAND

parquet = pytest.importorskip("pyarrow.parquet", reason="no wheel of pyarrow")

CASE = f"""
walls = "walls.csv"
[[record]]
file = "short_*.txt"
unit = "m/s2"
time_step_s = 0.01
kind = "artificial"
[analysis]
q_step = 0.05
[building]
height_m = 10.0
storeys = 3
{DEMAND}"""

HEAD = (
    "name;variant;base_z_m;height_m;thickness_m;mechanism;unit_weight_kn_m3;load1_kind;load1_kn_m;load1_d_m;load1_h_m;load1_mass",
    ";;m;m;m;;kN/m3;;kN/m;m;m;",
)


def rows() -> list[str]:
    """Eight walls: some above the ground, some of two storeys, some by both mechanisms, a pair of variants apart."""
    found = []
    for k in range(6):
        shape = f"{3.0 + 0.6 * k:.2f};{0.3 + 0.05 * (k % 4):.2f}"
        mechanism = ("one_sided", "two_sided", "both")[k % 3]
        found.append(f"w{k};;{(0, 0, 3.5)[k % 3]};{shape};{mechanism};18;;;;;")
    found.insert(1, "pair;stato di fatto;0;5;0.4;one_sided;18;;;;;")
    found.insert(6, "pair;progetto;0;5;0.4;one_sided;18;vertical;20;0.1;5;none")
    return found


def written(folder, walls: list[str]):
    """The case file of these walls and its records, in a folder."""
    (folder / "walls.csv").write_text("\n".join([*HEAD, *walls]))
    for k in (1, 2, 3):
        samples = filtered_noise(k, 2.0)[200:500]
        (folder / f"short_{k}.txt").write_text("\n".join(f"{value:.5f}" for value in samples))
    path = folder / "many.toml"
    path.write_text(CASE)
    return path


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    return written(tmp_path_factory.mktemp("large"), rows())


@pytest.fixture(scope="module")
def three(tmp_path_factory):
    """The case of three of its walls, one of them above the ground."""
    return written(tmp_path_factory.mktemp("three"), [row for row in rows() if row[:2] in ("w0", "w1", "w2")])


@pytest.fixture(scope="module")
def small(case):
    """The keys of the same walls as a workbook's case has them."""
    return run(read_case(case), base_dir=case.parent, jobs=2)


@pytest.fixture
def few(monkeypatch):
    """So few walls are many, in groups of three."""
    monkeypatch.setattr(plan, "MAX_WALLS_IN_WORKBOOK", 7)
    monkeypatch.setattr(large_case, "MAX_GROUP", 3)


@pytest.fixture
def each(monkeypatch):
    """Three walls are many, and each is a group."""
    monkeypatch.setattr(plan, "MAX_WALLS_IN_WORKBOOK", 2)
    monkeypatch.setattr(large_case, "MAX_GROUP", 1)


@pytest.fixture(scope="module")
def table(case):
    """The files of the undivided run."""
    folder = case.parent / "whole"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(plan, "MAX_WALLS_IN_WORKBOOK", 7)
        patch.setattr(large_case, "MAX_GROUP", 3)
        assert batch.run(case, folder, 2, True, False) in (batch.DONE, batch.WITHOUT_NUMBER)
    return folder / "many.parquet"


def read(path) -> list[dict]:
    return parquet.read_table(path).to_pylist()


@pytest.mark.shows("files.parquet")
def test_that_the_numbers_are_those_of_the_same_walls_in_a_small_case(table, small):
    found = {(row["wall"], row["hinge_m"], row["mechanism"]): row for row in read(table)}
    known = json.loads(json_report.dumps(small))
    assert len(found) == len(small.walls) == len(known["walls"]) > 8
    for wall, keys in zip(small.walls, known["walls"], strict=True):
        row = found[wall.part.origin + 1, wall.part.hinge, wall.mechanism]
        for name in (
            "q_set",
            "q_min",
            "q_robust_set",
            "q_slv_set",
            "q_slv_low_set",
            "q_slv_robust_set",
            "set_rule",
            "name",
            "mechanism",
        ):
            assert row[name] == keys[name], name
        for name in ("height_m", "thickness_m", "slenderness_deg", "radius_m", "threshold_acceleration_g"):
            assert row[name] == keys[name], name
        for name in ("q", "q_robust", "q_slv", "polarity"):
            assert row[f"record_{name}"] == [one[name] for one in keys["per_record"]]
        assert row["analyses"] == sum(one["analyses"] for one in keys["runs"])
        verdict, checks = keys["verdict"], keys["kinematic_check"]["checks"]
        assert (row["verdict"], row["check"], row["zeta_e"]) == (
            verdict["code"],
            verdict["governing"],
            verdict["zeta_e"],
        )
        assert row["lower_bound_zeta"] == verdict["lower_bound_zeta"]
        assert all(row[f"zeta_{check['check']}"] == check["zeta"] for check in checks)
        assert row["pga_c_g"] == keys.get("risk", {"pga_c_g": None})["pga_c_g"]
        assert row["alpha0"] == keys["kinematic_check"]["alpha0"]
        assert row["warnings"] == [warning.code for warning in wall.warnings]
        ratios = [row[name] for name in row if name.startswith("eq9_")]
        stated = [one["ratio"] for one in keys["code_check"]]
        assert ratios == (stated or [None] * len(ratios))


def test_that_what_is_said_of_a_wall_is_said_of_all_its_hinges_and_variants(table, small):
    found = read(table)
    numbers = [row["wall"] for row in found]
    assert sorted({*numbers}) == [*range(1, 9)]
    assert numbers == sorted(numbers, key=lambda k: (2 if k == 7 else k, k))  # the variants of a wall side by side
    for k, one in enumerate(small.verdicts):
        mine = [row for row in found if row["wall"] == k + 1]
        worst = small.walls[one.governing]
        assert {row["wall_verdict"] for row in mine} == {worst.assessment.verdict.code}
        assert {row["wall_zeta_e"] for row in mine} == {worst.assessment.verdict.zeta_e}
        (deciding,) = [row for row in mine if row["decides"]]
        assert (deciding["hinge_m"], deciding["mechanism"]) == (worst.part.hinge, worst.mechanism)
        assert deciding["limits"] == [line.code for line in (*worst.assessment.verdict.limits, *one.extra)]
    assert {row["variant"] for row in found} == {None, "stato di fatto", "progetto"}
    assert not any("variant_alone" in row["warnings"] for row in found)


@pytest.mark.shows("files.parquet")
def test_that_the_summary_counts_the_verdicts_and_names_the_worst(table, small, case):
    told = json.loads(table.with_suffix(".json").read_text())
    assert told["walls"] == 8 and told["table"]["rows"] == len(small.walls)
    codes = [small.walls[verdict.governing].assessment.verdict.code for verdict in small.verdicts]
    assert told["verdicts"] == {code: codes.count(code) for code in sorted(set(codes))}
    worst = [row["zeta_e"] for row in told["worst"]]
    assert worst == sorted(worst) and len(worst) == 8
    assert told["case"]["wall"] == [] and told["case"]["walls"] == "walls.csv"
    assert told["demand"] == json_report.results(small)["demand"] and len(told["records"]) == 3
    assert [one["name"] for one in told["table"]["columns"]] == parquet.read_schema(table).names
    assert told["case_sha256"] == read_case(case).sha256


@pytest.mark.shows("files.parquet")
@pytest.mark.parametrize("n", [5, pytest.param(1, marks=pytest.mark.long)])
def test_that_parts_in_any_order_make_the_table_of_the_undivided_run(case, table, few, tmp_path, n):
    for k in reversed(range(1, n + 1)):
        assert batch.run_part(case, tmp_path, 1, True, k, n) == batch.DONE
    assert batch.run(case, tmp_path, 1, True, False, merge=True) in (batch.DONE, batch.WITHOUT_NUMBER)
    assert (tmp_path / "many.parquet").read_bytes() == table.read_bytes()
    part_path(tmp_path, "many", 1, n).unlink()
    if n == 1:
        with pytest.raises(InputError) as caught:
            batch.run(case, tmp_path, 1, True, False, merge=True)
        assert caught.value.code == "no_parts"


def test_that_a_part_that_does_not_belong_is_refused(three, each, tmp_path):
    for k in (1, 2):
        batch.run_part(three, tmp_path, 2, True, k, 2)
    whole = part_path(tmp_path, "many", 2, 2).read_bytes()

    def refused(code, content):
        part_path(tmp_path, "many", 2, 2).write_bytes(content)
        with pytest.raises(InputError) as caught:
            batch.run(three, tmp_path, 1, True, False, merge=True)
        assert caught.value.code == code and not (tmp_path / "many.parquet").exists()

    refused("part_of_another", part_path(tmp_path, "many", 1, 2).read_bytes())
    refused("part_not_finished", b"\n".join(whole.split(b"\n")[:-2]) + b"\n")
    lines = whole.split(b"\n")
    other = b"8" if lines[1][-9:-8] == b"7" else b"7"  # a digit of the hash
    refused("part_damaged", b"\n".join([lines[0], lines[1][:-9] + other + lines[1][-8:], *lines[2:]]))
    batch.run_part(three, tmp_path, 2, True, 2, 2)
    assert batch.run(three, tmp_path, 1, True, False, merge=True) in (batch.DONE, batch.WITHOUT_NUMBER)
    (tmp_path / "many.parquet").unlink()
    part_path(tmp_path, "many", 2, 2).unlink()
    with pytest.raises(InputError) as caught:
        batch.run(three, tmp_path, 1, True, False, merge=True)
    assert caught.value.code == "part_missing"


def test_that_a_run_that_was_stopped_goes_on_with_the_groups_it_lacks(three, each, tmp_path, monkeypatch):
    undivided, made = three.parent / "whole", []
    assert batch.run(three, undivided, 2, True, False) in (batch.DONE, batch.WITHOUT_NUMBER)

    def stopping(large, todo, jobs, on_progress, cancelled):
        for g, result in large_case.group_results(large, todo, jobs, on_progress, cancelled):
            made.append(g)
            yield g, result
            if len(made) == 2:
                raise KeyboardInterrupt

    monkeypatch.setattr(large_batch, "group_results", stopping)
    with pytest.raises(KeyboardInterrupt):
        batch.run(three, tmp_path, 2, True, False)
    assert [path.name for path in tmp_path.iterdir() if path.is_file()] == ["many.journal"]
    assert batch.run(three, tmp_path, 1, True, True) in (batch.DONE, batch.WITHOUT_NUMBER)
    assert made == [0, 1, 2] and not (tmp_path / "many.journal").exists()
    assert (tmp_path / "many.parquet").read_bytes() == (undivided / "many.parquet").read_bytes()


def test_that_a_missing_package_is_refused_before_the_run(case, few, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    for language, said in (("en", "needs pyarrow"), ("it", "pyarrow")):
        set_language(language)
        try:
            with pytest.raises(OutputError) as caught:
                batch.run(case, tmp_path / "new", 1, True, False)
        finally:
            set_language("en")
        assert said in caught.value.text(language) and "\n" not in caught.value.text(language)
    assert not (tmp_path / "new").exists()


def test_that_neither_a_note_nor_a_statement_of_accuracy_is_made_of_so_many_walls(case, few, tmp_path):
    with pytest.raises(InputError) as caught:
        batch.run(case, tmp_path / "new", 1, True, False, report=tmp_path / "note.pdf")
    assert caught.value.code == "large_without" and "--report" in caught.value.text("it")
    stated = case.with_name("stated.toml")
    stated.write_text(CASE.replace("q_step", "accuracy = true\nq_step"))
    with pytest.raises(InputError):
        batch.run_part(stated, tmp_path / "new", 1, True, 1, 2)
    assert not (tmp_path / "new").exists()


def test_that_a_group_holds_so_many_searches_at_most(case, monkeypatch):
    asked = read_case(case)
    monkeypatch.setattr(large_case, "MAX_SEARCHES", 6)
    alone = large_case.prepare_large_case(asked, case.parent)
    assert sorted(len(group) for group in alone.groups) == [*[1] * 6, 2]  # variants stay together
    assert alone.longest == large_case.prepare_large_case(asked, case.parent)._replace().longest > 0.0


def test_that_the_terminal_shows_the_worst_walls_and_the_counts(table, tmp_path):
    tally = Tally()
    for k in range(300):
        row = {column.key: [None] for column in COLUMNS}
        row |= {"wall": [k], "name": [f"w{k}"], "hinge_m": [0.0], "decides": [True], "verdict": ["not_verified"]}
        row |= {"mechanism": ["two_sided"], "zeta_e": [1.0 / (1 + k)], "zeta_target": [1.0], "q_set": [2.0]}
        tally.add(row | {"check": ["dynamic"], "analyses": [5], "runs_without_q": [0]})
    said = large_batch.summary(tally, tmp_path, "many")
    assert (
        "300 walls, the worst above: not_verified 300" in said and said.count("\n") == large_batch.MAX_WALLS_SHOWN + 3
    )
    assert said.splitlines()[1].startswith("w299 ") and str(tmp_path / "many.parquet") in said
    assert len(tally.worst) == 100 and tally.analyses == 1500


def test_that_units_stand_in_the_table(table):
    schema = parquet.read_schema(table)
    assert schema.field("height_m").metadata == {b"unit": b"m"} and b"case_sha256" in schema.metadata
    assert all(math.isfinite(row["threshold_acceleration_g"] * G) for row in read(table))


def test_that_every_column_is_in_the_page_of_scale():
    page = (ROOT / "resources" / "docs" / "scale.md").read_text()
    assert [column.key for column in COLUMNS if f"`{column.key}`" not in page] == []
