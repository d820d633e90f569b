"""[select]: from a folder of records to a set that the program then judges."""

import json
import shutil
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.reader import read_case
from core.case.rules import parse_case
from core.case.wall import Wall
from core.case.writer import table_of
from core.codes.limits import counted_mask
from core.codes.outcomes import OUTCOMES
from core.codes.record_compatibility import check_compatibility
from core.errors import Cancelled, InputError
from core.ground.provenance import Provenance
from core.ground.record_folder import SAME_MOTION, Candidate, ExcludedRecord, Limits, drop_duplicate_records, read_file
from core.report.json_report import results
from core.setting import plan, record_selection
from core.setting.demand_input import read_demand
from core.setting.plan import longest_mechanism_period, read_inputs, select_case_records
from core.setting.record_selection import select_records
from core.study import run as study
from core.study.sweep import SweepKey, sweep
from core.units import G
from tests.core.study.folder_of_records import EN, NTC, WALL, case, write_esm, write_folder


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    base = tmp_path_factory.mktemp("select")
    write_folder(base)
    return base


def found_in(base, asked):
    demand = read_demand(asked, base)
    return select_records(asked.select, base, demand, longest_mechanism_period(asked, demand))


@pytest.mark.shows("demand.select_accounts")
def test_that_the_files_of_a_folder_are_all_accounted_for(folder):
    found = found_in(folder, case())
    assert (found.files, found.candidates, found.every) == (23, 20, True)
    assert {reason.code: n for reason, n in found.reasons} == {
        "vertical_component": 1,
        "no_numbers": 1,
        "same_motion": 1,
    }
    assert "HNZ" in next(one for one in found.left_out if one.reason.code == "vertical_component").file.name


@pytest.mark.shows("demand.select")
@pytest.mark.parametrize("scaling", ["none", "common", "individual"])
@pytest.mark.parametrize("spectrum", [NTC, EN])
@pytest.mark.parametrize("ag", [0.08, 0.12, 0.2])
def test_that_what_is_chosen_is_what_the_rules_of_the_code_then_judge(folder, scaling, spectrum, ag):
    asked = case(demand={"ag_g": ag, "spectrum": spectrum}, scaling=scaling)
    chosen, found = select_case_records(asked, folder)
    demand, motions, kinds = read_inputs(chosen, folder)
    judged = check_compatibility(motions, kinds, demand, longest_mechanism_period(asked, demand))
    assert judged.compatible == found.chosen.fits
    by_name = {rule.name: rule.value for rule in judged.rules if rule.code == spectrum["code"][:-4]}
    assert by_name["mean_lower"] == pytest.approx(found.chosen.lowest[1] - 1.0, abs=1e-9)
    if spectrum is NTC:
        assert by_name["mean_upper"] == pytest.approx(found.chosen.highest[1] - 1.0, abs=1e-9)
    else:
        assert by_name["mean_pga"] * G == pytest.approx(found.chosen.pga_ratio * demand.pga, rel=1e-9)
    factors = [record.scale for record in found.chosen.records]
    assert all(0.5 <= factor <= 2.0 for factor in factors)
    assert all(counted_mask(motions, demand))
    assert len(set(factors)) == 1 or scaling == "individual"
    assert [motion.scale for motion in motions] == factors


def test_that_two_records_are_too_few_for_the_code_that_asks_for_three(folder):
    for spectrum, enough in ((EN, False), (NTC, True)):
        asked = case(demand={"ag_g": 0.12, "spectrum": spectrum}, count=2)
        chosen, found = select_case_records(asked, folder)
        demand, motions, kinds = read_inputs(chosen, folder)
        judged = check_compatibility(motions, kinds, demand, longest_mechanism_period(asked, demand))
        assert found.chosen.miss == 0.0 and found.chosen.fits == judged.compatible == enough


def test_that_a_sweep_keeps_the_records_that_were_chosen_once(folder, monkeypatch):
    """A thicker wall has a longer period, by which other records would be chosen."""
    calls = []
    real = plan.select_records
    monkeypatch.setattr(plan, "select_records", lambda *a, **k: calls.append(1) or real(*a, **k))
    asked = replace(case(), analysis=replace(case().analysis, q_step=0.1))
    points = list(sweep(asked, 0, SweepKey(Wall, "thickness_m"), [0.4, 0.6], base_dir=folder))
    assert [point.error for point in points] == [None, None] and len(calls) == 1


@pytest.mark.shows("demand.select")
def test_that_each_record_is_of_another_station_and_no_event_has_three(folder):
    _, motions, _ = read_inputs(case(count=5), folder)
    stations = [dict(motion.details)["STATION_CODE"] for motion in motions]
    events = [dict(motion.details)["EVENT_ID"] for motion in motions]
    assert len(set(stations)) == 5 and max(map(events.count, events)) <= 2
    with pytest.raises(
        InputError, match="no set of 6 of these 20 records has at most 1 of a station and 1 of an event"
    ):
        found_in(folder, case(count=6, per_event=1))


@pytest.mark.shows("demand.select_accounts")
def test_that_the_order_of_the_files_and_their_names_change_no_set(folder, tmp_path):
    """The same motions under other names, so that they come in another order."""
    (tmp_path / "recs").mkdir()
    names = {}
    for k, path in enumerate(sorted((folder / "recs").glob("IT.*"), reverse=True)):
        names[f"{k:02d}.ASC"] = path.name
        shutil.copy(path, tmp_path / "recs" / f"{k:02d}.ASC")
    there, here = found_in(folder, case()), found_in(tmp_path, case())
    for one, other in zip(there.sets, here.sets, strict=True):
        renamed = [(names[Path(record.file).name], record.scale) for record in other.records]
        assert renamed == [(Path(record.file).name, record.scale) for record in one.records]
        assert one.deviation == other.deviation


def test_that_a_zip_is_chosen_from_as_the_folder_it_holds(folder, tmp_path):
    with zipfile.ZipFile(tmp_path / "recs.zip", "w") as packed:
        for path in sorted((folder / "recs").glob("IT.*")):
            packed.write(path, path.name)
    inside, beside = found_in(tmp_path, case("recs.zip")), found_in(folder, case())
    channels = [[record.channel for record in one.records] for one in inside.sets]
    assert channels == [[Path(record.file).name for record in one.records] for one in beside.sets]
    assert {reason.code for reason, _ in inside.reasons} == {"vertical_component"}
    _, motions, _ = read_inputs(case("recs.zip"), tmp_path)
    assert [motion.channel for motion in motions] == channels[0]


def test_that_limits_leave_out_what_is_beyond_and_what_does_not_say(folder):
    found = found_in(folder, case(distance_km=[0.0, 20.0]))
    assert found.candidates == 10
    assert {reason.code: n for reason, n in found.reasons}["selected_beyond"] == 10
    found = found_in(folder, case(soil="B"))
    assert found.candidates == 10
    assert {reason.code: n for reason, n in found.reasons}["selected_unsaid"] == 10
    assert "does not say: soil" in next(r.text() for r, _ in found.reasons if r.code == "selected_unsaid")
    with pytest.raises(
        InputError, match=r"\[select\]: 0 records of 23 files can be chosen, and 3 are asked for.*magnitude"
    ):
        found_in(folder, case(magnitude=[7.0, 8.0]))


@pytest.mark.shows("demand.select")
def test_that_what_cannot_be_met_is_the_nearest_set_and_said_so(folder):
    asked = case(demand={"ag_g": 1.5, "spectrum": NTC})
    result = study.run(asked, base_dir=folder)
    found = result.selection
    assert not found.chosen.fits and found.chosen.miss > 0.1
    assert {record.scale for record in found.chosen.records} == {2.0}
    assert not result.compliance.compatible
    assert [one.miss for one in found.sets] == sorted(one.miss for one in found.sets)
    keys = results(result)["selection"]
    assert keys["fits"] is False and keys["sets"][0]["miss"] == found.chosen.miss


def test_that_a_folder_given_absolutely_names_its_records_so(folder):
    asked = case()
    shelf = (folder / asked.select.folder).resolve().as_posix()
    absolute = replace(asked, select=replace(asked.select, folder=shelf))
    by_name = [study.run(one, base_dir=folder).selection.chosen.records for one in (asked, absolute)]
    assert [one.file for one in by_name[1]] == [f"{shelf}/{one.file.rpartition('/')[2]}" for one in by_name[0]]
    assert all(one.file.startswith(f"{asked.select.folder}/") for one in by_name[0])


def test_that_a_run_takes_the_chosen_as_records_written_by_hand(folder):
    chosen = study.run(case(), base_dir=folder)
    content = results(chosen)
    entries = [{key: record[key] for key in ("file", "scale")} for record in content["selection"]["sets"][0]["records"]]
    by_hand = parse_case({"wall": [WALL], "record": entries, "demand": {"ag_g": 0.2, "spectrum": NTC}})
    other = study.run(by_hand, base_dir=folder)
    assert chosen.walls[0].q_set == other.walls[0].q_set
    assert chosen.walls[0].assessment.verdict == other.walls[0].assessment.verdict
    assert [motion.file_sha256 for motion in chosen.motions] == [motion.file_sha256 for motion in other.motions]
    assert chosen.selection and other.selection is None and "selection" not in results(other)
    assert json.loads(json.dumps(content["selection"]))["left_out"][0]["reason"]


def test_that_a_choice_can_be_cancelled(folder):
    asked = case()
    demand = read_demand(asked, folder)
    with pytest.raises(Cancelled):
        select_records(asked.select, folder, demand, 0.0, cancelled=lambda: True)


def test_that_a_choice_tells_hundredths_half_of_reading_and_half_of_search(folder, monkeypatch):
    """Of 23 files, then of a search that tells its beginning, its half and its end."""
    real = record_selection.nearest_sets

    def slowly(*given):
        for share in (0.0, 0.5, 1.0):
            assert not given[-1](share)
        return real(*given)

    monkeypatch.setattr(record_selection, "nearest_sets", slowly)
    asked, told = case(), []
    demand = read_demand(asked, folder)
    select_records(asked.select, folder, demand, 0.0, lambda done, planned: told.append((done, planned)))
    assert told == [*((50 * k // 23, 100) for k in range(1, 24)), (50, 100), (75, 100), (100, 100)]


def test_that_a_folder_that_is_not_there_is_named(tmp_path):
    with pytest.raises(InputError, match="nothing: there is no such folder or zip of records"):
        found_in(tmp_path, case("nothing"))


def test_that_a_scaled_copy_of_a_record_is_no_second_record(folder, tmp_path):
    (tmp_path / "recs").mkdir()
    for k in range(4):
        write_esm(tmp_path / "recs" / f"{k}.ASC", k + 1, f"S{k}", f"EV-{k}")
    samples = np.array((tmp_path / "recs" / "0.ASC").read_text().splitlines()[13:], dtype=float)
    text = "\n".join(f"{value:.6f}" for value in 1.37 * samples)
    (tmp_path / "recs" / "5.txt").write_text("# acceleration (cm/s2), dt=0.01 s\n" + text + "\n")
    found = found_in(tmp_path, case())
    assert found.candidates == 4
    assert [(one.file.name, one.reason.code) for one in found.left_out] == [("5.txt", "same_motion")]


def silent_folder(base, amplitudes, strong=4.0):
    """Four stations of strong records, and one of each amplitude."""
    (base / "recs").mkdir()
    for k, times in enumerate([*[strong] * 4, *amplitudes]):
        write_esm(base / "recs" / f"{k}.ASC", k + 1, f"S{k}", f"EV-{k}", times=times)


@pytest.mark.shows("demand.select")
@pytest.mark.parametrize("scaling", ["none", "common", "individual"])
def test_that_silent_records_do_not_fill_up_the_seven_stations(scaling, tmp_path):
    """Of PGA below 0.001 g, and of a hundredth of what is asked."""
    silent_folder(tmp_path, [0.002, 0.003, 0.02], strong=1.0)
    found = found_in(tmp_path, case(count=4, scaling=scaling))
    assert {one.file.name: one.reason.code for one in found.left_out} == {
        "4.ASC": "doubted_record",
        "5.ASC": "doubted_record",
        "6.ASC": "selected_far",
    }
    assert "below 0.001 g" in found.left_out[0].reason.text("en")
    with pytest.raises(InputError, match=r"4 records of 7 files can be chosen, and 7.*Left out for example: its"):
        found_in(tmp_path, case(count=7, scaling=scaling))


@pytest.mark.shows("dynamic.silent")
def test_that_silent_records_written_by_hand_verify_nothing(tmp_path):
    """Four records alone take the most unfavourable; with four that move no wall the mean of eight was taken."""
    silent_folder(tmp_path, [0.04, 0.04, 0.04, 0.04], strong=2.0)
    entries = [{"file": f"recs/{k}.ASC"} for k in range(8)]
    demand = {"ag_g": 0.2, "spectrum": NTC}
    four, eight = (
        study.run(parse_case({"wall": [WALL], "record": entries[:n], "demand": demand}), base_dir=tmp_path)
        for n in (4, 8)
    )
    found, alone = (result.walls[0].assessment for result in (eight, four))
    assert (found.dynamic.set_rule, found.dynamic.zeta) == ("maximum", alone.dynamic.zeta)
    assert len(found.dynamic.not_counted) == 4 and alone.dynamic.not_counted == ()
    assert eight.compliance.stations == four.compliance.stations == 4
    said = [reason.code for reason in found.verdict.limits[: found.verdict.blocking]]
    assert "too_weak" in said and "too_weak" not in [limit.code for limit in alone.verdict.limits]
    assert OUTCOMES[found.verdict.code].tone != "good"


def test_that_an_empty_folder_is_said_without_an_example(tmp_path):
    (tmp_path / "recs").mkdir()
    with pytest.raises(InputError, match="0 records of 0 files can be chosen, and 3 are asked for") as caught:
        found_in(tmp_path, case())
    assert str(caught.value).endswith("add files or ask for fewer")


@pytest.mark.long
def test_that_a_folder_of_real_records_gives_a_compatible_set(shelf, tmp_path):
    """The shelf itself, from its case file to the keys of the results, with every file accounted for."""
    text = f"""
[[wall]]
name = "w"
height_m = 4.0
thickness_m = 0.5
base_z_m = 0.0
mechanism = "one_sided"
[select]
folder = '{shelf.as_posix()}'
count = 7
[demand]
ag_g = 0.2
spectrum = {{ code = "NTC2018", f0 = 2.4, tc_star_s = 0.33, soil = "B", topography = "T1" }}
[analysis]
q_step = 0.05
"""
    (tmp_path / "case.toml").write_text(text)
    result = study.run(read_case(tmp_path / "case.toml"), base_dir=tmp_path)
    found = result.selection
    assert found.chosen.fits and result.compliance.compatible and result.compliance.stations == 7
    assert result.walls[0].assessment.dynamic.not_counted == ()
    assert not any(warning.code in ("vertical", "borehole") for motion in result.motions for warning in motion.warnings)
    reasons = {reason.code: n for reason, n in found.reasons}
    assert found.candidates + reasons["doubted_record"] + reasons["selected_far"] > 30
    places = {str(one.file) for one in found.left_out}
    whole = sum(1 for path in shelf.rglob("*") if path.is_file())
    assert found.files == whole and len(places) >= whole - found.candidates


def test_that_a_case_with_a_choice_is_written_and_read_back():
    asked = case(scaling="individual", scale_limits=[0.8, 1.5], magnitude=[5.5, 7.0])
    assert parse_case(table_of(asked)).select == asked.select
    assert asked.select.scale_limits == (0.8, 1.5)


def test_that_of_a_recording_in_both_forms_the_processed_one_stays(tmp_path):
    """Whichever comes first by its name; both components of a recording stay, and a raw one that has no other form."""
    raw = {"a raw.ASC": ("S0", "EV-0"), "d raw.ASC": ("S0", "EV-1"), "e raw.ASC": ("S1", "EV-0")}
    processed = {"b.ASC": ("S0", "EV-0"), "c.ASC": ("S0", "EV-0")}
    for k, (name, (station, event)) in enumerate({**raw, **processed}.items()):
        write_esm(tmp_path / name, k + 1, station, event)
        if name in raw:
            text = (tmp_path / name).read_text().replace("PROCESSING: manual", "PROCESSING: none")
            (tmp_path / name).write_text(text)
    found = [one for path in tmp_path.iterdir() for one in read_file(path, np.array([0.1, 1.0]), Limits())]
    assert all(isinstance(one, Candidate) for one in found)
    kept, left = drop_duplicate_records(found)
    assert {one.file.name for one in kept} == {"b.ASC", "c.ASC", "d raw.ASC", "e raw.ASC"}
    assert [(one.file.name, one.reason.code) for one in left] == [("a raw.ASC", "processed_beside")]
    assert "b.ASC" in left[0].reason.text()


@pytest.mark.parametrize(
    ("limits", "within"),
    [
        (Limits(distance_km=(15.0, 20.0)), True),
        (Limits(distance_km=(15.1, 20.0)), False),
        (Limits(distance_km=(0.0, 15.0)), True),
        (Limits(distance_km=(0.0, 14.9)), False),
        (Limits(magnitude=(6.1, 6.1)), True),
    ],
)
def test_that_a_record_on_a_limit_is_within_it(limits, within, tmp_path):
    """15 km away, of magnitude 6.1."""
    write_esm(tmp_path / "one.ASC", 5, "S0", "EV-0")
    (found,) = read_file(tmp_path / "one.ASC", np.array([0.1]), limits)
    if within:
        assert isinstance(found, Candidate)
    else:
        assert isinstance(found, ExcludedRecord) and found.reason.code == "selected_beyond"


@pytest.mark.parametrize(("apart", "same"), [(SAME_MOTION, True), (1.01 * SAME_MOTION, False)])
def test_that_records_whose_spectra_differ_by_a_thousandth_are_still_one_motion(apart, same):
    said = [Provenance("EV-0", station, "", "", "", "", "", "") for station in ("S0", "S1")]
    first, second = (
        Candidate(Path(f"{k}.ASC"), "", "", str(k), str(k), said[k], 1.0, False, np.array([ordinate, 1.0]))
        for k, ordinate in enumerate((1.0, 1.0 + apart))
    )
    kept, left = drop_duplicate_records([second, first])
    assert [one.file.name for one in kept] == (["0.ASC"] if same else ["0.ASC", "1.ASC"])
    assert [(one.file.name, one.reason.code) for one in left] == ([("1.ASC", "same_motion")] if same else [])
