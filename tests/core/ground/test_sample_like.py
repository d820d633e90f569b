"""A remark beside samples, a mark before them, a flag, a blank cell: never samples taken for a head."""

import numpy as np
import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.records import plausible
from core.ground.records.container import names_vertical
from core.ground.records.grammar import Options
from tests.core.ground.damage import damage_all, motions

REMARKS = ("letto a mano", "spike?", "OK", "da verificare", "note", "*", "x", "check!", "valore dubbio (2)", "rev. B")
DT = 0.01


def dialect(name: str, rng) -> tuple[list[str], list[str], str, dict]:
    """(head, samples, what stands between a sample and a remark, options) of a record in one way of writing it."""
    values = np.convolve(rng.normal(size=400), np.ones(3) / 3.0, "same")
    times = DT * np.arange(400) + (0.0 if rng.integers(2) else 3.0)
    if name == "semicolons":
        rows = [f"{t:.2f};{a:.6f}".replace(".", ",") for t, a in zip(times, values, strict=True)]
        return ["t (s);a (m/s2);nota"], rows, ";", {}
    if name == "commas":
        return ["time,acc (m/s2),note"], [f"{t:.3f},{a:.5f}" for t, a in zip(times, values, strict=True)], ",", {}
    if name == "tabs":
        return ["t [s]\ta [m/s2]"], [f"{t:.2f}\t{a:.5e}" for t, a in zip(times, values, strict=True)], "\t", {}
    if name == "spaces":
        return (
            ["Time (s)  Acceleration (m/s2)"],
            [f"{t:8.3f} {a:12.6f}" for t, a in zip(times, values, strict=True)],
            "  ",
            {},
        )
    assert name == "column"
    return ["acceleration in m/s2, dt = 0.01 s"], [f"{a:.6f}" for a in values], "  ", {}


DIALECTS = ("semicolons", "commas", "tabs", "spaces", "column")


REFUSALS = ("sample_in_head", "blank_among_samples", "text_among_samples", "not_numbers", "gap")


def read(lines: list[str], tmp_path, options: dict):
    path = tmp_path / "record.txt"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return records.read(path, Options(**options))


@pytest.mark.shows("records.refused")
@pytest.mark.parametrize("name", DIALECTS)
def test_that_a_remark_a_mark_or_a_blank_never_makes_samples_a_head(name, tmp_path):
    rng, refused = np.random.default_rng(11), 0
    for trial in range(40):
        head, rows, between, options = dialect(name, rng)
        whole = read([*head, *rows], tmp_path, options)
        damaged, many = list(rows), int(rng.integers(1, 150))
        kind = ("remark", "mark", "blank", "flag")[trial % 4]
        for k in range(many):
            if kind == "remark":
                damaged[k] += between + REMARKS[rng.integers(len(REMARKS))]
            elif kind == "mark":
                damaged[k] = "#%!"[rng.integers(3)] + " " + damaged[k]
            elif kind == "flag":
                damaged[k] += between + "qQA"[rng.integers(3)]
        if kind == "blank":
            damaged.insert(int(rng.integers(1, 300)), "")
        try:
            found = read([*head, *damaged], tmp_path, options)
        except RecordError as error:
            refused += 1
            assert error.code in REFUSALS, error
            continue
        assert found.acceleration.size == whole.acceleration.size, (kind, many)
        assert np.array_equal(found.acceleration, whole.acceleration)
    assert refused > 20


@pytest.mark.parametrize(
    "line",
    [
        "400 0.0100 NPTS, DT",
        "400 0.01",
        "2009 04 06 L'Aquila",
        "10 20 30 free text",
        "0.01 s sampling",
        "1 channel",
        "# 0.01 dt",
    ],
)
def test_that_a_head_that_begins_with_numbers_is_a_head(line, tmp_path):
    _, rows, _, _ = dialect("column", np.random.default_rng(2))
    motion = read(["acceleration in m/s2, dt = 0.01 s", line, *rows], tmp_path, {})
    assert motion.acceleration.size == 400


@pytest.mark.parametrize(("step", "samples"), [(0.00125, 9000), (0.005, 30_000), (1.0 / 240.0, 5000), (0.0025, 45_000)])
def test_that_times_with_six_significant_digits_give_their_step(step, samples, tmp_path):
    values = np.sin(0.01 * np.arange(samples)) * np.random.default_rng(3).normal(size=samples)
    lines = [f"{step * k:.6g}\t{a:.6g}" for k, a in enumerate(values)]
    found = read(["Time [s]\tAcceleration (g)", *lines], tmp_path, {})
    assert found.time_step == pytest.approx(step, rel=1e-6) and found.acceleration.size == samples


def test_that_a_time_left_out_is_still_found_among_rounded_ones(tmp_path):
    lines = [f"{0.00125 * k:.6g}\t{np.sin(0.1 * k):.6g}" for k in range(9000) if k != 4000]
    with pytest.raises(RecordError) as caught:
        read(["Time [s]\tAcceleration (g)", *lines], tmp_path, {})
    assert caught.value.code == "uneven_times"


COLUMNS = "time,raw_acc,filtered_acc,filtered_velocity,displacement", "t,acc_raw,acc_f,vel_f,disp_f", "t,ax,ay,vx,dx"


@pytest.mark.parametrize("head", COLUMNS)
def test_that_a_column_is_what_its_name_says(head, tmp_path):
    rows = [f"{DT * k:.2f},{np.sin(0.3 * k):.5f},{np.cos(0.3 * k):.5f},0.1,0.2" for k in range(200)]
    for column in (2, 3):
        assert read([head, *rows], tmp_path, {"column": column, "unit": "g"}).acceleration.size == 200
    for column in (4, 5):
        with pytest.raises(RecordError) as caught:
            read([head, *rows], tmp_path, {"column": column, "unit": "g"})
        assert caught.value.code == "other_quantity"


@pytest.mark.parametrize("head", ["t,x,y,z", "t;N;E;V", "time NS EW UD"])
def test_that_the_names_of_components_are_no_velocities(head, tmp_path):
    between = next(mark for mark in ",; " if mark in head)
    rows = [
        between.join(f"{one:.4f}" for one in (DT * k, np.sin(0.3 * k), np.cos(0.3 * k), 0.1 * (k % 3)))
        for k in range(200)
    ]
    assert read([head, *rows], tmp_path, {"column": 2, "unit": "g"}).acceleration.size == 200


@pytest.mark.parametrize(
    ("name", "vertical"),
    [
        ("IT.AVZ..HGE.D.20090406.013240.C.ACC.MP.ASC", False),
        ("IT.AVZ..HGN.D.20090406.013240.C.ACC.MP.ASC", False),
        ("IT.CLN..HGZ.D.20090406.013240.C.ACC.MP.ASC", True),
        ("IV.AQU.00.HNZ.D.20090406.C.ACC.ASC", True),
        ("CHAN1.V2", False),
        ("CE13122.V1", False),
        ("AOM0010111031446.UD2", True),
        ("AOM0010111031446.NS2", False),
        ("RSN316_WESMORL_WSM-UP.AT2", True),
        ("AVZ.txt", False),
    ],
)
def test_that_a_name_says_the_direction_by_the_rule_of_its_format(name, vertical):
    assert names_vertical(name) == vertical and names_vertical(f"folder/{name}") == vertical


ADVICE = {
    "which_column": lambda error: [{"column": k} for k in range(2, error.values["most"] + 1)],
    "which_component": lambda error: [{"column": k} for k in range(1, error.values["n"] + 1)],
    "no_unit": lambda error: [{"unit": "g"}],
    "no_time_step_s": lambda error: [{"time_step": DT}],
    "no_time_column": lambda error: [{"time_step": DT}],
}
"""Code of a refusal -> what it advises to give."""


def made(kind: str, rng) -> list[str]:
    """A file that leaves something to be said."""
    table = [(DT * k, *rng.normal(size=3).tolist()) for k in range(200)]
    if kind == "components, count and step":
        return ["DATA: 200", "DT = 0.01 s", "N-S  E-W  U-D", *("  ".join(f"{x:.6f}" for x in row[1:]) for row in table)]
    if kind == "components alone":
        return ["N-S;E-W;U-D", *(";".join(f"{x:.6f}" for x in row[1:]) for row in table)]
    if kind == "time and components":
        return ["t  x  y  z", *("  ".join(f"{x:.6f}" for x in row) for row in table)]
    if kind == "column alone":
        return ["acceleration", *(f"{row[1]:.6f}" for row in table)]
    assert kind == "wrapped"
    return ["acceleration, dt = 0.01 s", *("  ".join(f"{x:.6f}" for x in row[1:] * 2) for row in table)]


@pytest.mark.parametrize(
    "kind", ["components, count and step", "components alone", "time and components", "column alone", "wrapped"]
)
def test_that_what_a_refusal_advises_leads_to_a_result_or_to_a_last_word(kind, tmp_path):
    lines, results, last = made(kind, np.random.default_rng(6)), 0, set()
    todo: list[dict] = [{}]
    for _ in range(60):
        if not todo:
            break
        options = todo.pop()
        try:
            results += read(lines, tmp_path, options).acceleration.size == 200
        except RecordError as error:
            new = [one for one in ADVICE.get(error.code, lambda _: [])(error) if not one.keys() & options.keys()]
            todo += [options | one for one in new]
            if not new:
                last.add(error.code)
    assert not todo
    assert results or last
    assert bool(results) == (kind != "wrapped"), last


@pytest.mark.parametrize("value", ["0.0", "1e-300", "0.001", "1e300"])
def test_that_a_record_without_motion_is_refused_without_a_warning(value, tmp_path):
    """Warnings are errors in the tests."""
    with pytest.raises(RecordError):
        read(["acceleration in m/s2, dt = 0.01 s", *[value] * 500], tmp_path, {})


def strong(rng) -> np.ndarray:
    """A motion with a weak beginning and end."""
    return np.convolve(rng.normal(size=900), np.ones(5) / 5.0, "same") * np.hanning(900)


DAMAGE = {
    "sorted": lambda a, rng: np.sort(a),
    "sorted down": lambda a, rng: np.sort(a)[::-1],
    "twice": lambda a, rng: np.concatenate([a, a]),
    "three times, cut": lambda a, rng: np.concatenate([a, a, a])[:2300],
    "frozen": lambda a, rng: np.where((np.arange(a.size) > 400) & (np.arange(a.size) < 500), a[np.abs(a).argmax()], a),
    "filled with zeros": lambda a, rng: np.where((np.arange(a.size) > 400) & (np.arange(a.size) < 560), 0.0, a),
}


@pytest.mark.shows("records.refused")
@pytest.mark.parametrize("every", [100, pytest.param(5, marks=pytest.mark.long)])
def test_that_damage_one_could_see_is_refused_or_said(shelf, every):
    """Of every so many-th file of the shelf; all of it by the command of damage.py."""
    told, silent, false = damage_all(motions(shelf, every))
    assert not silent
    assert not false
    hidden = sum(counts["hidden"] for counts in told.values())
    assert hidden <= 0.03 * sum(counts.total() for counts in told.values())  # 37 of 2 457 of the whole shelf


def test_that_a_step_ten_times_too_long_or_short_is_doubted_in_a_format_too(tmp_path):
    """The head of a PEER file says DT, and nothing beside it does."""
    values = strong(np.random.default_rng(3)) / 981.0
    for step, codes in ((0.01, set()), (0.02, set()), (0.1, {"long_step"}), (0.001, {"content", "pace"})):
        head = ["PEER STRONG MOTION DATABASE RECORD", "A quake, a station, 000", "ACCELERATION IN UNITS OF G"]
        rows = [" ".join(f"{a:14.7E}" for a in values[k : k + 5]) for k in range(0, values.size, 5)]
        text = [*head, f"NPTS= {values.size}, DT= {step:.4f} SEC", *rows]
        found = {warning.code for warning in read(text, tmp_path, {}).warnings}
        assert (not codes and not found & {"long_step", "content"}) or found & codes, (step, found)


def of_head(format: str, peak_time: float, corner: float, rng) -> tuple[str, float]:
    """(text, time of the peak [s]) of a file whose head states the time of its peak, off by so much, and a filter."""
    values = strong(rng)
    when = 0.01 * float(np.abs(values).argmax()) + peak_time
    peak = float(np.abs(values).max())
    if format == "ESM":
        head = [
            "DATA_TYPE: ACCELERATION",
            "SAMPLING_INTERVAL_S: 0.01",
            f"NDATA: {values.size}",
            "UNITS: cm/s^2",
            f"PGA_CM/S^2: {peak:.6f}",
            f"TIME_PGA_S: {when:.6f}",
            f"HIGH_CUT_FREQUENCY_HZ: {corner}",
        ]
        return "\n".join([*head, *(f"{value:.6f}" for value in values), ""]), when
    head = [
        "Corrected accelerogram   00001-S0001-00001.01       Chan  1:  90 Deg",
        f"Accelerogram bandpass filtered with 3 dB pts at   .07 and {corner:.2f} cyc/sec",
        f"Peak acceleration = {peak:9.3f}    cm/sec/sec  at   {when:.3f}   sec.",
        f"{values.size:6d} points of accel data equally spaced at   .010 sec, in cm/sec2. (8f10.5)",
    ]
    fields = [f"{value:10.5f}" for value in values]
    return "\n".join([*head, *("".join(fields[k : k + 8]) for k in range(0, len(fields), 8)), ""]), when


@pytest.mark.parametrize("format", ["ESM", "CSMIP"])
@pytest.mark.parametrize(("late", "corner", "said"), [(0.0, 40.0, set()), (1.0, 40.0, {"peak_elsewhere"})])
def test_that_the_time_of_the_peak_and_the_filter_of_a_head_are_held_against_the_samples(
    format, late, corner, said, tmp_path
):
    rng = np.random.default_rng(5)
    for beyond in (False, True):
        text, _ = of_head(format, late, 80.0 if beyond else corner, rng)
        found = {warning.code for warning in read(text.split("\n")[:-1], tmp_path, {}).warnings}
        assert found & {"peak_elsewhere", "beyond_nyquist"} == said | ({"beyond_nyquist"} if beyond else set())


@pytest.mark.parametrize("kind", DAMAGE)
def test_that_what_no_ground_does_is_refused_or_said(kind, tmp_path):
    for seed in range(5):
        rng = np.random.default_rng(seed)
        whole = strong(rng)
        head = "acceleration in m/s2, dt = 0.01 s"
        intact = read([head, *(f"{a:.6f}" for a in whole)], tmp_path, {})
        assert not {warning.code for warning in intact.warnings} & {"repeats", "frozen"}
        try:
            found = read([head, *(f"{a:.6f}" for a in DAMAGE[kind](whole, rng))], tmp_path, {})
        except RecordError as error:
            assert error.code == "sorted_samples"
            continue
        assert {warning.code for warning in found.warnings} & {"repeats", "frozen"}


def test_that_samples_that_only_rise_or_fall_are_refused_from_eighty_on():
    """However small their steps; zeros alone, and samples that turn once, are not sorted."""
    for values in (0.001 * np.arange(80), -0.001 * np.arange(80), np.repeat(np.arange(40), 2.0)):
        with pytest.raises(RecordError) as refused:
            plausible.refuse_sorted(values)
        assert (refused.value.code, refused.value.values["n"]) == ("sorted_samples", 80)
    turned = 0.001 * np.append(np.arange(79), 77)
    for values in (0.001 * np.arange(79), np.zeros(80), turned, -turned, 0.09 * np.sin(np.arange(200))):
        plausible.refuse_sorted(values)


def notices(values) -> dict:
    return {one.code: dict(one.values) for one in plausible.doubts(values, DT)}


@pytest.mark.parametrize(("many", "said"), [(7, False), (8, True), (9, True)])
def test_that_eight_samples_in_a_row_do_not_come_twice(many, said):
    """Of a record whose samples are nearly all different."""
    values = strong(np.random.default_rng(8))
    assert "repeats" not in notices(values)
    values[600 : 600 + many] = values[300 : 300 + many]
    found = notices(values)
    assert ("repeats" in found) == said
    if said:
        assert found["repeats"] == {"sample": 601, "first": 301}


def test_that_a_trace_that_was_cut_at_its_peak_is_said():
    """At a third of its peak: equal samples at both ends of the range."""
    whole = strong(np.random.default_rng(8))
    assert "clipped" not in notices(whole)
    most = 0.33 * np.abs(whole).max()
    values = np.clip(whole, -most, most)
    flat = np.abs(values) == most
    first = next(k for k in range(flat.size) if flat[k : k + 3].all() and np.ptp(values[k : k + 3]) == 0.0)
    lasts = next(k for k in range(first, flat.size) if values[k] != values[first])
    assert notices(values)["clipped"] == {"n": lasts - first, "sample": first + 1}


@pytest.mark.parametrize("first", ["0.00 n.d.", "0 0.5 letto a mano"])
def test_that_a_line_at_the_time_before_the_first_one_is_a_sample(first, tmp_path):
    """A mark of a gap beside it, or a time of nought in fewer decimals than the others have."""
    rows = [f"{DT * k:.2f} {np.sin(0.3 * k):.5f}" for k in range(1, 100)]
    with pytest.raises(RecordError) as caught:
        read(["Time (s)  Acceleration (m/s2)", first, *rows], tmp_path, {})
    assert caught.value.code == "sample_in_head"
    assert f"line 2: '{first}' begins as the samples below it do" in str(caught.value)
    late = first.replace("0", "7", 1)  # at no time of the samples
    assert read(["Time (s)  Acceleration (m/s2)", late, *rows], tmp_path, {}).acceleration.size == 99
