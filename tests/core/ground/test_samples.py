"""Marks of missing samples, lines written twice or left out, and two records in one file are asked about."""

from pathlib import Path

import numpy as np
import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.records.grammar import Options
from core.ground.records.samples import jumps, refuse_marks
from tests.core.ground import dialects
from tests.core.ground.record_texts import MOTION, column, two


def noise(n=2000, peak=0.3, seed=5):
    """A smooth motion: white noise without what is above an eighth of the rate."""
    lines = np.fft.rfft(np.random.default_rng(seed).normal(size=n))
    lines[0], lines[n // 8 :] = 0.0, 0.0
    values = np.fft.irfft(lines, n)
    return peak * values / np.abs(values).max()


def peer(values, digits=7) -> str:
    fields = [f"{value:15.{digits}E}" for value in values]
    rows = ["".join(fields[k : k + 5]) for k in range(0, len(fields), 5)]
    head = [
        "PEER NGA STRONG MOTION DATABASE RECORD",
        "EVENT, 1, STATION, 90",
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {len(values)}, DT= .01000 SEC",
    ]
    return "\n".join([*head, *rows, ""])


def table(values) -> str:
    return "".join(f"{0.01 * k:.2f} {a:.6f}\n" for k, a in enumerate(values))


def alone(values) -> str:
    return "".join(f"{a:.6f}\n" for a in values)


def read(text, **given):
    content = text if isinstance(text, bytes) else text.encode()
    return records._motion(content, Path("x.txt"), Options(**given), 1.0, "x")


SHAPES = {
    "PEER": (peer, {}),
    "two columns": (table, {"unit": "g"}),
    "one column": (alone, {"unit": "g", "time_step": 0.01}),
}


@pytest.mark.shows("records.refused")
@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("where", [[0], [1999], [0, 1, 2], [1997, 1998, 1999], [700, 701, 702, 703], [100, 800, 1500]])
@pytest.mark.parametrize("mark", [-999.0, 9999.0, 99.99, -32768.0, 999.9, -1.0, -9.0, 10.0])
def test_that_marks_of_missing_samples_are_asked_about_wherever_they_stand(shape, where, mark):
    if len(where) == 1 and mark in (-1.0, 10.0):
        return  # one value three times as large as the others may be one of the motion
    write, given = SHAPES[shape]
    values = noise()
    values[where] = mark
    with pytest.raises(RecordError) as caught:
        read(write(values), **given)
    assert caught.value.code == "marks_of_gaps"
    said = dict(caught.value.values)
    assert (said["mark"], said["n"], said["sample"]) == (mark, len(where), where[0] + 1)
    for language, word in (("en", "without gaps"), ("it", "senza buchi")):
        text = caught.value.text(language)
        assert word in text and "\n" not in text


@pytest.mark.parametrize("mark", [-1.0, 99.99, -99.0])
def test_that_a_mark_within_the_range_of_the_motion_is_found_by_its_runs(mark):
    values = noise(peak=300.0)
    values[600:640] = mark
    with pytest.raises(RecordError, match=f"40 samples are {mark:g}, the first of them sample 601"):
        read(table(values), unit="cm/s2")
    values = noise(peak=300.0)
    k = int(np.argmin(np.abs(values + 1.0)[100:-100])) + 100
    values[k] = -1.0  # the motion itself passes there
    read(table(values), unit="cm/s2")


def test_that_motions_with_equal_or_single_peaks_are_no_gaps():
    pulse = np.zeros(200)
    pulse[50:80] = 0.3
    clipped = np.clip(noise(), -0.1, 0.1)
    square = np.where(np.arange(400) // 25 % 2, -1.0, 1.0)
    spike = noise(peak=0.1)
    spike[500] = 0.5
    sine = np.sin(np.arange(500) * 0.1)
    coarse = np.round(noise(), 2)
    for values in (pulse, clipped, square, spike, sine, coarse):
        assert read(table(values), unit="g").acceleration.size == values.size


def test_that_every_bundled_and_generated_motion_passes():
    folder = Path(__file__).parents[3] / "tests" / "motions"
    for path in sorted(folder.glob("*.txt")):
        codes = {warning.code for warning in records.read(path).warnings}
        assert not codes & {"jump", "number_not_understood", "vertical"}, path


@pytest.mark.parametrize("step", [6, pytest.param(1, marks=pytest.mark.long)])
def test_that_no_true_record_of_the_shelf_has_a_mark_or_a_line_twice(shelf, index, step):
    """step : one file of so many"""
    asked = ("marks_of_gaps", "line_twice", "blank_among_samples", "text_among_samples")
    for file, row in list(index.items())[::step]:
        if not row["pga_g"]:
            continue
        for given in (Options(), Options(unit="g"), Options(unit="g", time_step=0.01)):
            try:
                found = records.read(shelf / file, given)
            except RecordError as error:
                assert error.code not in asked, file
            else:
                assert "number_not_understood" not in {w.code for w in found.warnings}, file


def doubled(rows, k):
    return [*rows[: k + 1], *rows[k:-1]]


def swapped(rows, k):
    return [*rows[:k], rows[k + 1], rows[k], *rows[k + 2 :]]


def gone(rows, k):
    return [*rows[:k], *rows[k + 1 :], rows[-1]]


@pytest.mark.parametrize("damage", [doubled, swapped, gone])
def test_that_lines_doubled_swapped_or_gone_are_said_where_the_count_still_fits(damage):
    lines = peer(noise()).splitlines()
    for k in (150, 200, 250):
        text = "\n".join([*lines[:4], *damage(lines[4:], k)]) + "\n"
        if damage is swapped:
            assert "jump" in {warning.code for warning in read(text).warnings}
        else:
            with pytest.raises(RecordError, match="appears twice"):
                read(text)
    whole = read("\n".join(lines) + "\n")
    assert not whole.warnings
    rows = alone(noise()).splitlines()
    count = f"npts: {len(rows)}\n"
    for k in (700, 1100):
        block = [*rows[:k], *rows[k + 5 :], *["0.000000"] * 5]
        found = read(count + "\n".join(block) + "\n", unit="g", time_step=0.01)
        assert "jump" in {warning.code for warning in found.warnings}


@pytest.mark.parametrize("damage", [doubled, swapped, gone])
def test_that_lines_doubled_swapped_or_gone_are_refused_beside_their_times(damage):
    rows = table(noise()).splitlines()
    for k in (0, 5, 1000, 1997):
        with pytest.raises(RecordError, match="increase in even steps"):
            read("\n".join(damage(rows, k)) + "\n", unit="g")


def test_that_a_count_one_off_is_refused():
    rows = table(noise()).splitlines()
    for text in (f"NPTS 2000\n{chr(10).join(rows[:-1])}\n", f"NPTS 2001\n{chr(10).join(rows)}\n"):
        with pytest.raises(RecordError, match="declares 200[01] in 'NPTS 200[01]'"):
            read(text, unit="g")


@pytest.mark.parametrize("between", ["", "\n", " \t \n", "% EW\n", "\n% EW\n", "# EW\n", "// EW\n", "! EW\n", "EW\n"])
@pytest.mark.parametrize("sep", [" ", ";", ", "])
def test_that_two_channels_one_below_the_other_are_not_one_record(between, sep):
    first, second = two(sep), two(sep)
    one = column() + "\n"
    for text, given in ((first + between + second, {}), (one + between + one, {"time_step": 0.01})):
        if not between and given:
            continue
        with pytest.raises(RecordError) as caught:
            read(text, unit="g", **given)
        codes = ("blank_among_samples", "text_among_samples", "not_numbers", "uneven_times")
        assert caught.value.code in codes
        assert "line 4" in str(caught.value)


@pytest.mark.parametrize("end", ["\n", "\n\n \t\n\n", "\r\n\r\n"])
def test_that_blank_lines_at_the_end_and_below_the_count_are_none_among_samples(end):
    assert np.array_equal(read(two() + end, unit="m/s2").acceleration, MOTION)
    for below in ("\n", "# acceleration\n", "\n# second\n\n"):
        found = read(f"title\n40 0.01\n{below}{column()}\n{end}", unit="m/s2")
        assert np.array_equal(found.acceleration, MOTION)


def test_that_the_motion_of_every_dialect_repeats_and_is_no_line_twice():
    for content, given in dialects.DIALECTS.values():
        read(content, **given)


def test_that_a_peer_unit_with_a_factor_is_refused_until_scale_says_the_same():
    text = peer(noise()).replace("UNITS OF G", "UNITS OF MG")
    with pytest.raises(RecordError, match="the file is in mg"):
        read(text)
    found = records._motion(text.encode(), Path("x.at2"), Options(), 0.001, "x")
    assert found.unit == "g" and found.scale == 0.001


@pytest.mark.parametrize(("where", "first"), [(slice(0, 40), 1), (slice(-40, None), 1961)])
def test_that_a_run_of_marks_at_an_end_of_the_record_is_found(where, first):
    """The motion jumps by 50 of its peak of 300 to them."""
    values = noise(peak=300.0)
    values[[40, -41]] = 49.5
    values[where] = -1.0
    with pytest.raises(RecordError) as caught:
        refuse_marks(values)
    assert (caught.value.code, caught.value.values["sample"]) == ("marks_of_gaps", first)


@pytest.mark.parametrize(("share", "said"), [(0.0119, []), (0.0121, [("jump", 401)])])
def test_that_a_jump_where_nothing_moves_is_held_against_the_largest_step(share, said):
    """Twelve times its thousandth; the fourth difference of a lone sample is six times it, of alternating ones 16."""
    values = np.zeros(2000)
    values[1000:1400] = np.where(np.arange(400) % 2, -1.0, 1.0)
    values[400] = share * 16.0 / 6.0
    assert [(one.code, dict(one.values)["sample"]) for one in jumps(values)] == said
