"""Heads that an audit found read as something else: cells, two units, remarks, places, other columns (issue IN)."""

import numpy as np
import pytest

from core.errors import InputError, RecordError
from core.ground.records import read
from core.ground.records.grammar import Options
from core.setting.demand_input import _read_spectrum

TIMES = np.arange(600) * 0.02
VALUES = np.round(np.sin(21.0 * TIMES) * np.exp(-(((TIMES - 5.0) / 2.0) ** 2)) * 0.27, 4)
ONE = [f"{a:.4f}" for a in VALUES]
TWO = [f"{t:.2f} {a:.4f}" for t, a in zip(TIMES, VALUES, strict=True)]
FOUR = [f"{row} {a / 2:.4f} {a / 3:.4f}" for row, a in zip(TWO, VALUES, strict=True)]
COMMAS = [row.replace(" ", ";").replace(".", ",") for row in TWO]


def marked(rows: list[str], count: int, form: str) -> list[str]:
    return [form.format(row, *row.split()) for row in rows[:count]] + rows[count:]


REFUSED = {
    "a factor in a cell": ("factor_stated", ["dt = 0.02 s", "Scale factor,9.81", "Acc (m/s2)", *ONE]),
    "the same in Italian": ("factor_stated", ["Fattore di scala;9,81", "Tempo (s);Acc (g)", *COMMAS]),
    "a step above the names of columns": ("two_time_steps", ["dt,0.005", "Time (s),Acc (g)", *TWO]),
    "a unit above the names of columns": ("two_units", ["Units: m/s2", "time  acc g", *TWO]),
    "a unit it was converted to": ("two_units", ["acc (m/s2) converted to g", "dt 0.02 s", *ONE]),
    "a remark with a word of heads": ("sample_in_head", ["time acc (g)", *marked(TWO, 50, "{} campione dubbio")]),
    "few decimals": ("sample_in_head", ["dt = 0.02 s", "acc (g)", *marked([x[:-2] for x in ONE], 90, "{} forte")]),
    "a remark behind a semicolon": ("sample_in_head", ["time acc (g)", *marked(TWO, 1, "{};picco")]),
    "a word before": ("sample_in_head", ["time acc (g)", *marked(TWO, 9, "pre {}")]),
    "a mark of a gap": ("sample_in_head", ["time acc (g)", *marked(TWO, 9, "{1} n.d.")]),
    "brackets": ("sample_in_head", ["time acc (g)", *marked(TWO, 9, "[{}]")]),
    "samples left out": ("decimated", ["sampling rate 100 Hz (decimated by 2), acc in g", *ONE]),
    "a velocity among single blanks": ("other_quantity", ["Time (s) A (g) V (m/s) D (m)", *FOUR]),
    "a mass": ("other_quantity", ["time [s] acc (kg)", *TWO]),
    "volts over g": ("unit_not_read", ["time [s] acc [mV/g]", *TWO]),
    "spectra of all directions": (
        "rotated_spectra",
        ["Period(s),RotD50(g),RotD100(g)", *(x.replace(" ", ",") for x in TWO)],
    ),
    "a column of them beside a time": ("rotated_spectra", ["time (s) GMRotI50 (g)", *TWO]),
    "digits": ("unit_not_read", ["time [s] acc [digit]", *TWO]),
}
OPTIONS = {"a velocity among single blanks": Options(column=3)} | {
    name: Options(unit="g") for name in ("a mass", "volts over g", "digits")
}


@pytest.mark.parametrize("name", REFUSED)
def test_that_what_could_be_read_two_ways_is_refused(name, tmp_path):
    code, lines = REFUSED[name]
    (tmp_path / "a.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    with pytest.raises(RecordError) as refused:
        read(tmp_path / "a.txt", OPTIONS.get(name, Options()))
    assert refused.value.code == code


READ = {
    "a rate in a cell": (0.005, None, ["Sampling rate,200", "acc (g)", *ONE]),
    "sample numbers": (0.02, None, ["n;acc (g)", "dt = 0.02 s", *(f"{k};{a}" for k, a in enumerate(ONE, start=1))]),
    "directions above columns": (
        0.02,
        None,
        ["dt 0.02 s, g", "N-S E-W U-D", *(f"{a} {float(a) / 2:.4f} {float(a) / 3:.4f}" for a in ONE)],
    ),
    "decimal commas of one column": (0.02, None, ["dt 0.02 s, g", *(a.replace(".", ",") for a in ONE)]),
    "true minus signs": (0.02, None, ["time acc (g)", *(row.replace("-", "−") for row in TWO)]),
    "names of columns": (0.02, None, ["time raw_acc vel_f disp_f", *FOUR]),
    "soil in Italian": (0.02, None, ["su roccia", "time acc (g)", *TWO]),
    "a peak that is another": (0.02, "peak_differs", ["PGA = 0.9 g", "time acc (g)", *TWO]),
    "a vertical with a point": (0.02, "vertical", ["comp. Z", "time acc (g)", *TWO]),
    "a vertical behind an angle": (0.02, "vertical", ["dir 90 deg, UD", "time acc (g)", *TWO]),
    "a borehole": (0.02, "in_structure", ["Borehole 30 m", "time acc (g)", *TWO]),
    "a roof in Italian": (0.02, "in_structure", ["sensore sul tetto", "time acc (g)", *TWO]),
    "a roof in the name of a column": (0.02, "in_structure", ["time acc_copertura (g)", *TWO]),
    "a floor": (0.02, "in_structure", ["Piano: 3", "time acc (g)", *TWO]),
    "a floor in capitals": (0.02, "in_structure", ["2ND FL.", "time acc (g)", *TWO]),
    "a depth": (0.02, "in_structure", ["SENSOR_DEPTH_M: 100.0", "time acc (g)", *TWO]),
}


COLUMNS = {"directions above columns": Options(column=1), "names of columns": Options(column=2, unit="g")}


@pytest.mark.parametrize("name", READ)
def test_that_what_is_said_is_taken(name, tmp_path):
    step, code, lines = READ[name]
    (tmp_path / "a.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    motion = read(tmp_path / "a.txt", COLUMNS.get(name, Options()))
    assert motion.time_step == step
    np.testing.assert_allclose(motion.acceleration, VALUES * 9.80665, atol=1e-12)
    codes = {warning.code for warning in motion.warnings}
    assert codes - {"number_not_understood", "unit_as_given"} == ({code} if code else set())


@pytest.mark.parametrize("head", ["frequenza Sa", "f freq [Hz] Sa [g]", "T Sa mg", "T Sa [m s-2]", "0.0 0.26 plateau"])
def test_that_a_spectrum_of_another_kind_is_refused(head, tmp_path):
    path = tmp_path / "s.txt"
    path.write_text(f"{head}\n0.1 0.5\n0.5 0.6\n1.0 0.2\n", encoding="utf-8")
    with pytest.raises(InputError):
        _read_spectrum(path)[1]


@pytest.mark.parametrize("head", ["T Se(T)", "T [s] Se/g", "T (s) Sa (g)"])
def test_that_a_spectrum_of_its_own_kind_is_read(head, tmp_path):
    path = tmp_path / "s.txt"
    path.write_text(f"{head}\n0.1 0.5\n0.5 0.6\n1.0 0.2\n", encoding="utf-8")
    assert len(_read_spectrum(path)[1]) == 3
