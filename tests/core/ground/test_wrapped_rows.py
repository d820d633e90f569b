"""Samples side by side in rows, and a text in UTF-16 without its mark."""

import numpy as np
import pytest

from core.errors import RecordError
from core.ground.records import read
from core.ground.records.grammar import Options
from tests.conftest import ROOT


@pytest.fixture
def write(tmp_path):
    """A record file of a text."""

    def file_of(text, encoding="utf-8"):
        path = tmp_path / "motion.txt"
        path.write_bytes(text.encode(encoding))
        return path

    return file_of


def in_rows(values, width, form="{:14.7E}"):
    """Samples side by side, so many to a line."""
    rows = [values[k : k + width] for k in range(0, len(values), width)]
    return "\n".join("".join(form.format(value) for value in row) for row in rows) + "\n"


@pytest.mark.parametrize("width", [3, 5, 8, 10])
def test_that_samples_wrapped_in_rows_are_read_one_after_the_other(write, width):
    """Of four motions, with a short last row, a head, a count and a step: as one column; without a step it is asked
    for."""
    for k in range(1, 5):
        values = np.round(np.loadtxt(ROOT / f"tests/motions/noise_{k}.txt", ndmin=2)[:, -1][:1801], 9)
        text = in_rows(values, width)
        for head in ("", "acceleration of a station\n"):
            found = read(write(head + text), Options("g", time_step=0.01))
            assert np.allclose(found.acceleration, values * 9.80665, rtol=1e-6, atol=1e-12)
            assert "wrapped_rows" in {note.code for note in found.warnings}
        counted = read(write(f"{values.size} 0.01\n{text}"), Options("g"))
        assert counted.acceleration.size == values.size and counted.time_step == 0.01
        with pytest.raises(RecordError, match="time_step_s"):
            read(write(text), Options("g"))


def test_that_components_side_by_side_are_never_taken_for_rows_of_samples(write):
    motions = [np.loadtxt(ROOT / f"tests/motions/noise_{k}.txt", ndmin=2)[:, -1] for k in range(1, 7)]
    count = min(map(len, motions))
    for width in (3, 4, 6):
        side = np.column_stack([motion[:count] for motion in motions[:width]])
        with pytest.raises(RecordError) as refused:
            read(write(in_rows(side.ravel(), width)), Options("g", time_step=0.01))
        assert refused.value.code != "wrapped_rows"


def test_that_a_text_in_utf_16_without_its_mark_is_read(write):
    text = "t (s)\tacc (g)\r\n" + "".join(f"{0.01 * k:.2f}\t{0.1 * np.sin(k / 5.0):.6f}\r\n" for k in range(400))
    found = [read(write(text, encoding), Options("g")) for encoding in ("utf-8", "utf-16-le", "utf-16-be")]
    assert all((motion.acceleration == found[0].acceleration).all() for motion in found)


def test_that_a_spectrum_above_the_samples_is_said_with_the_lines_to_skip(write):
    rows = [f"{0.01 * k:.3f}\t{0.1 * np.sin(k / 5.0):.7f}\t{0.3 * np.cos(k / 5.0):.7f}" for k in range(800)]
    spectrum = [f"{0.05 * k:.4f}\t, 1.000\t, 1.000\t, {0.5 / k:.3f}" for k in range(1, 60)]
    head = ["PGA:,  0.12 g", "Damping ratio for spectra:  0.05", " ", "period [s]\tSD. [cm]\tPSV [cm/s]\tPSA [g]"]
    text = "\n".join(
        [
            *head,
            *spectrum,
            " ",
            "acceleration and velocity time histories",
            "time [s]\taccel. [g]\tvel. [cm/s]",
            *rows,
            "",
        ]
    )
    path = write(text)
    with pytest.raises(RecordError, match="skip_lines = 65") as refused:
        read(path)
    skip = refused.value.values["skip"]
    found = read(path, Options(skip_lines=skip, column=2))
    assert found.unit == "g" and found.acceleration.size == 800 and found.time_step == 0.01
    with pytest.raises(RecordError, match="vel"):
        read(path, Options(skip_lines=skip, column=3))
