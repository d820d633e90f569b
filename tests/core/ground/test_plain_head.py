"""What the head of plain text states is used, and contradicts what else is said in a sentence."""

import numpy as np
import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.records import plain_head
from core.ground.records.grammar import Options
from core.ground.records.head_units import stated_unit
from tests.core.ground.record_texts import MOTION, column, two


@pytest.fixture
def read(tmp_path):
    def motion(text, **options):
        file = tmp_path / "motion.txt"
        file.write_text(text, encoding="utf-8")
        return records.read(file, Options(**options))

    return motion


@pytest.mark.parametrize(
    "head",
    [
        "# dt=0.005",
        "# DT 0.005",
        "Time step: 0.005 s",
        "Time step (ms) = 5",
        "dt = 5 ms",
        "passo di campionamento 0,005 s",
        "Sampling rate: 200 Hz",
        "sampling frequency (Hz): 200 Hz",
        "frequenza di campionamento 200 Hz",
        "# sampled at a sample rate of 200 sps",
    ],
)
def test_that_a_time_step_stated_in_words_is_used_and_not_contradicted(read, head):
    text = f"{head}\n{column()}\n"
    assert read(text, unit="g").time_step == pytest.approx(0.005, rel=1e-12)
    with pytest.raises(RecordError, match="states time_step_s 0.005, the case gives 0.01"):
        read(text, unit="g", time_step=0.01)


@pytest.mark.parametrize("head", ["Sampling instrument SMA-1, 200 m away", "Time  Acc (g)", "station dt01"])
def test_that_other_words_state_no_time_step(head):
    assert plain_head.time_steps(plain_head.head_of(head)) == []


def test_that_a_declared_count_must_agree(read):
    for head in ("NPTS 40", "# number of points: 40", "No. of samples = 40", "numero di campioni: 40"):
        assert read(f"{head}\n{two()}", unit="g").acceleration.size == 40
        other = head.replace("40", "80")
        with pytest.raises(RecordError, match="40 samples, but the header declares 80"):
            read(f"{other}\n{two()}", unit="g")


def test_that_a_time_column_in_milliseconds_or_minutes_is_taken_as_such(read):
    seconds = read(two(), unit="g")
    milli = "".join(f"{10 * k};{a:.5f}\n" for k, a in enumerate(MOTION))
    minutes = "".join(f"{0.01 * k / 60.0:.9f};{a:.5f}\n" for k, a in enumerate(MOTION))
    for text in (f"Time (ms);Acc\n{milli}", f"Tempo [min];Acc\n{minutes}"):
        motion = read(text, unit="g")
        assert motion.time_step == seconds.time_step == 0.01
        assert np.array_equal(motion.acceleration, seconds.acceleration)


@pytest.mark.parametrize(
    ("head", "unit"),
    [
        ("Time (s) Acc (ft/s2)", "ft/s2"),
        ("Time (s) Acc (mg)", "mg"),
        ("t [s]  a [%g]", "%g"),
        ("units: counts", "counts"),
        ("# raw counts", "raw counts"),
        ("t  a [counts]", "counts"),
    ],
)
def test_that_a_unit_no_option_names_is_refused_whatever_is_given(read, head, unit):
    for given in ({}, {"unit": "cm/s2"}):
        with pytest.raises(RecordError, match=f"the file is in {unit}: convert it"):
            read(f"{head}\n{two()}", **given)


def test_that_pairs_side_by_side_are_not_read_as_one_in_two_samples(read):
    rows = [f"{0.01 * k:.2f} {MOTION[k]:.5f}" for k in range(40)]
    text = "\n".join("  ".join(rows[k : k + 4]) for k in range(0, 40, 4)) + "\n"
    for given in ({}, {"column": 2}, {"column": 4}):
        with pytest.raises(RecordError, match="several pairs of time and acceleration"):
            read(text, unit="g", **given)


def test_that_tables_with_a_time_of_each_channel_are_read(read):
    text = "".join(f"{0.01 * k:.2f} {a:.5f} {0.01 * k:.2f} {a / 2:.5f}\n" for k, a in enumerate(MOTION))
    assert read(text, unit="g", column=4).pga == pytest.approx(read(two(), unit="g").pga / 2, rel=1e-4)


def test_that_a_count_on_the_second_line_is_no_sample(read):
    with pytest.raises(RecordError, match="the first value 40 looks like a count"):
        read(f"0.01\n40\n{column()}\n", unit="cm/s2", time_step=0.01)


def test_that_a_vertical_column_or_file_is_named(read):
    table = "Time (s),EW (g),UD (g)\n" + "".join(f"{0.01 * k:.2f},{a:.5f},{a:.5f}\n" for k, a in enumerate(MOTION))
    alone = f"# Component: UP\n{two()}"
    for text, given, said in (
        (table, {"column": 3}, True),
        (table, {"column": 2}, False),
        (alone, {"unit": "g"}, True),
        (f"# Component: N21E\n{two()}", {"unit": "g"}, False),
    ):
        codes = [warning.code for warning in read(text, **given).warnings]
        assert ("vertical" in codes) == said


def test_that_fields_in_double_quotes_are_read_and_a_cut_one_is_not(read):
    plain = read(two(",")[:-1] + "\n", unit="g").acceleration
    rows = [f'"{0.01 * k:.2f}","{a:.5f}"' for k, a in enumerate(MOTION)]
    commas = [row.replace(".", ",") for row in rows]
    for lines in (rows, commas):
        head = '"Time (s)","Acc (g)"\n'
        assert np.array_equal(read(head + "\n".join(lines) + "\n").acceleration, plain)
        with pytest.raises(RecordError):
            read(head + "\n".join(lines)[:-3] + "\n")


@pytest.mark.parametrize(
    ("head", "unit"),
    [
        ("Time s,Acc m/s2", "m/s2"),
        ("Time_s,Acc_cm/s2", "cm/s2"),
        ("time;acc_cm_s2", "cm/s2"),
        ("time;acc [m s-2]", "m/s2"),
        ("t  a m·s⁻²", "m/s2"),
        ("acceleration, mm/s²", "mm/s2"),
        ("values in m/s^2", "m/s2"),
        ("Acc. gal", "cm/s2"),
        ("Time,Acc\ns,g", "g"),
        ("Time;Acc\ns;m/s2", "m/s2"),
    ],
)
def test_that_a_unit_in_words_is_that_of_the_samples(read, head, unit):
    other = "g" if unit != "g" else "cm/s2"
    assert read(f"{head}\n{two()}").unit == unit
    with pytest.raises(RecordError, match=f"states unit {unit}, the case gives {other}"):
        read(f"{head}\n{two()}", unit=other)


@pytest.mark.parametrize("head", ["g = 9.81 m/s2", "PGA 3.2 m/s2", "peak acceleration, cm/s2: 310", "Galileo station"])
def test_that_the_unit_of_a_value_is_not_taken(read, head):
    with pytest.raises(RecordError, match="does not state its unit"):
        read(f"{head}\n{two()}")


@pytest.mark.parametrize(
    "word", ["dt", "time step (", "npts", "number of points", "sampling rate", "t", "Acc m", "comp"]
)
def test_that_a_head_of_blanks_takes_linear_time(word):
    head = "\n".join([(word + " " * 19_000) + "x"] * 20)
    lines = plain_head.head_of(head)
    plain_head.seconds_of_time(head), plain_head.vertical(head, 2, 2)
    stated = [plain_head.time_steps(lines), *plain_head.counts(lines, 40), *plain_head.factors(lines)]
    assert not any(stated) and stated_unit(head) is None


@pytest.mark.parametrize(("other", "same"), [("1001", True), ("999", True), ("1001.0005", False), ("998.9", False)])
def test_that_two_steps_are_the_same_in_print_to_a_thousandth_of_the_first(other, same):
    """1000 s, of which a thousandth is a whole number, and the limit is met exactly."""
    head = plain_head.head_of(f"dt = 1000 s\ndt = {other} s")
    if same:
        assert [one.value for one in plain_head.time_steps(head)] == [1000.0, float(other)]
    else:
        with pytest.raises(RecordError) as refused:
            plain_head.time_steps(head)
        assert (refused.value.code, refused.value.values["other"]) == ("two_steps_stated", float(other))


@pytest.mark.parametrize(
    ("number", "said"),
    [("0.1", True), ("0.11", False), ("1e-6", True), ("38", True), ("37", False), ("42", True), ("43", False)],
)
def test_that_a_lone_number_is_doubted_where_it_could_be_a_factor_or_nearly_the_count(read, number, said):
    """Of 40 samples: within two of them."""
    warnings = {warning.code: warning for warning in read(f"title\n# K {number}\n{two()}", unit="g").warnings}
    assert ("number_not_understood" in warnings) == said


@pytest.mark.parametrize(("number", "said"), [(1176, True), (1224, True), (1174, False), (1226, False)])
def test_that_a_number_is_nearly_the_count_of_a_long_record_within_a_fiftieth(number, said):
    assert bool(plain_head.not_understood(plain_head.head_of(f"K {number}"), [], 0.01, 1200)) == said


@pytest.mark.parametrize(("head", "step"), [("sampling: 200", 0.005), ("sampling 0.02", 0.02), ("sampled at 50", 0.02)])
def test_that_a_sampling_without_a_unit_is_a_rate_from_ten_on_and_a_step_below_one(head, step):
    assert [one.value for one in plain_head.time_steps(plain_head.head_of(head))] == [pytest.approx(step)]


def test_that_a_step_of_any_size_is_a_step_where_its_label_says_so():
    for head in ("dt = 20", "dt: 2", "dt 0.02"):
        (one,) = plain_head.time_steps(plain_head.head_of(head))
        assert one.value == float(head.split()[-1])


@pytest.mark.parametrize(
    "head", ["time,acc,velocity,", "time;acc;vel;note", "t [s]\tacc [g]\tdisp [cm]\t\t", "time  acc  vel", "t acc vel"]
)
def test_that_a_name_stands_above_its_column_though_the_head_has_cells_more(head):
    plain_head.refuse_column(head, 3, 2)
    with pytest.raises(RecordError) as refused:
        plain_head.refuse_column(head, 3, 3)
    assert refused.value.code == "other_quantity"


def test_that_words_with_blanks_between_are_no_names_of_columns_unless_they_are_as_many():
    plain_head.refuse_column("record of vel station", 3, 3)
    assert not plain_head.vertical("from the up hole", 3, 3)


@pytest.mark.parametrize("head", ["N-S  U-D", "N-S;U-D", "EW,UP"])
def test_that_of_two_columns_the_one_read_says_the_direction(head):
    assert not plain_head.vertical(head, 2, 1)
    assert plain_head.vertical(head, 2, 2)
