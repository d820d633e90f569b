"""Units as people write them."""

import itertools
import math

import numpy as np
import pytest

from core.case.hazard_table import parse_hazard
from core.case.wall_columns import columns
from core.case.wall_table import parse_wall_rows
from core.errors import InputError, RecordError
from core.ground import records
from core.quantities import BASES, factor_to, foreign_unit, unit_of

KNOWN = {
    ("t/m", "kN/m"): 9.80665,
    ("kg/m", "kN/m"): 0.00980665,
    ("N/m", "kN/m"): 0.001,
    ("daN/m", "kN/m"): 0.01,
    ("q/ml", "kN/m"): 0.980665,
    ("kN per metro", "kN/m"): 1.0,
    ("kg/cmq", "MPa"): 0.0980665,
    ("kgf/cm²", "MPa"): 0.0980665,
    ("N/mm2", "MPa"): 1.0,
    ("kg/m³", "kN/m3"): 0.00980665,
    ("t/mc", "kN/m3"): 9.80665,
    ("in cm", "m"): 0.01,
    ("piedi", "m"): 0.3048,
    ("in", "m"): 0.0254,
    ("°", "deg"): 1.0,
    ("rad", "deg"): 180.0 / math.pi,
    ("metri quadrati", "m2"): 1.0,
    ("%", ""): 0.01,
}
"""Typed from the definitions: 1 kgf = 9.80665 N, 1 ft = 0.3048 m, 1 in = 0.0254 m."""


@pytest.mark.shows("case.units")
@pytest.mark.parametrize(("text", "unit"), KNOWN)
def test_that_a_unit_is_converted_by_its_definition(text, unit):
    assert factor_to(text, unit) == pytest.approx(KNOWN[text, unit], rel=1e-14)


@pytest.mark.parametrize("text", ["al piede", "MN/m", "m/m/m2x", "", "circa", "P", "t/m (SLU)", "a" * 50])
def test_that_what_names_no_unit_is_none(text):
    assert unit_of(text) is None


def two_hundred_units() -> list[str]:
    """Units of every dimension, and texts that are none."""
    lengths = ("m", "cm", "mm", "dm", "ft", "in", "piedi")
    forces = ("N", "kN", "daN", "kg", "kgf", "t", "q", "lb", "kip")
    found = [*BASES, *(f"{force}/{length}" for force in forces for length in lengths)]
    found += [f"{force}/{one}{power}" for force, one, power in itertools.product(forces, ("m", "cm", "mm"), "23²")]
    return [*found, "MN/m", "(SLU)", "circa", "t/m al piede", "x", "1/m", "m/s2"]


NUMBERS = [name for name, column in columns().items() if column.entry.metadata["kind"] == "float"]
GIVEN = {"height_m": "5", "thickness_m": "0.5", "mechanism": "su due lati"}


@pytest.mark.shows("case.units")
@pytest.mark.parametrize("every", [11, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("place", ["head", "row"])
def test_that_every_key_with_every_unit_is_converted_or_refused(place, every):
    """Every so many-th unit, of one key at a time; whether the value is accepted is another matter: then the sentence
    is of the value."""
    units, read, refused = two_hundred_units(), 0, 0
    assert len(units) >= 200
    for key in NUMBERS:
        wanted = columns()[key].entry.metadata.get("unit", "")
        for unit in units[::every]:
            factor = factor_to(unit, wanted)
            given = {name: value for name, value in GIVEN.items() if name != key} | {key: "2"}
            heads = [f"{name} ({unit})" if name == key and place == "head" else name for name in given]
            metres = {name: "m" for name in ("height_m", "thickness_m") if name != key}
            below = [unit if name == key and place == "row" else metres.get(name, "") for name in given]
            try:
                (wall,) = parse_wall_rows([["nome", *heads], ["", *below], ["a", *given.values()]])
            except InputError as error:
                refused += error.code == "unknown_unit"
                assert error.code != "unknown_unit" or factor is None, (key, unit)
                continue
            assert factor is not None or unit in ("-", "–"), (key, unit)  # a unit left out
            value = getattr(wall, key, None)
            if value is not None:
                read += 1
                assert value == 2.0 * (factor or 1.0)
    assert read > 100 // every and refused > 5000 // every


def test_that_the_walls_of_a_table_in_tonnes_are_those_in_kilonewtons():
    heads = ["nome", "meccanismo", "altezza (m)", "spessore (m)", "carico 1", "carico 1 P ({})", "carico 1 h (m)"]
    heads += ["carico 1 d (m)", "carico 1 massa", "peso specifico"]
    found = []
    for unit, value in (("t/m", "2"), ("kN/m", "19.6133"), ("kg/m", "2000"), ("daN/m", "1961.33")):
        row = ["a", "su un lato", "5", "0,5", "verticale", value, "5", "0,25", "nessuna", "18"]
        (wall,) = parse_wall_rows([[head.format(unit) for head in heads], row])
        found.append(wall.load[0].kn_m)
    assert found == pytest.approx([19.6133] * 4, rel=1e-12)


@pytest.mark.parametrize("head", ["H (altezza)", "H [m", "H (m) (cm)", "H (m/s)", "H (kN)"])
def test_that_what_stands_where_a_unit_does_is_the_unit_of_the_key_or_refused(head):
    rows = [["nome", "meccanismo", head, "t"], ["", "", "", "m"], ["a", "su due lati", "5", "0.5"]]
    if head == "H [m":
        assert parse_wall_rows(rows)[0].height_m == 5.0
        return
    with pytest.raises(InputError) as caught:
        parse_wall_rows(rows)
    assert caught.value.code in ("unknown_unit", "two_units_of_column")


@pytest.mark.parametrize(
    ("head", "foreign"),
    [
        ("T_R (anni)  ag [g]  F0 [-]  TC* [s]", None),
        ("TR ag [m/s2] F0 TC*", "m/s2"),
        ("TR ag m/s^2 F0 TC*", "m/s^2"),
        ("TR [anni] ag [cm/s²]", "cm/s²"),
        ("T [ms] Sa [g]", "ms"),
        ("T (s) Sa (g) (suolo B) (5 %)", None),
        ("T Sa gal", "gal"),
        ("T [s] Sa [cms2]", "cms2"),
        ("spettro elastico, smorzamento 5%", None),
    ],
)
def test_that_the_head_of_a_hazard_or_a_spectrum_names_its_own_units(head, foreign):
    assert foreign_unit(head.lower() if foreign is None else head, ("anni", "s", "g", "-")) == foreign


def test_that_a_hazard_in_another_unit_is_refused_with_the_unit():
    rows = "30 0.5 2.4 0.28\n475 1.9 2.5 0.33\n"
    with pytest.raises(InputError, match="m/s2"):
        parse_hazard("TR [anni] ag [m/s2] F0 TC* [s]\n" + rows.replace("0.5", "0.05").replace("1.9", "0.19"))
    assert len(parse_hazard("TR [anni] ag [g] F0 [-] TC* [s]\n30 0.05 2.4 0.28\n475 0.19 2.5 0.33\n")) == 2


HEADS = (
    "time (s), acc ({unit})",
    "time [s]; a [{unit}]",
    "acceleration in {unit}, dt = 0.01 s",
    "dt = 0.01 s\nUNITS: {unit}",
)
"""How heads of records name their unit: of columns, in a sentence, on a line of its own."""


@pytest.mark.parametrize("every", [5, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("head", HEADS)
def test_that_a_unit_in_the_head_of_a_record_is_its_own_or_refused(head, every, tmp_path):
    """Heads of records are sentences and keep wordings of their own: none gives a third factor. every : so many-th unit
    but those of accelerations"""
    values, agreed = np.round(np.sin(0.3 * np.arange(200)), 4), 0
    path = tmp_path / "record.txt"
    for unit in (
        *two_hundred_units()[::every],
        "g",
        "cm/s2",
        "gal",
        "mm/s^2",
        "m/sec2",
        "cm/s/s",
        "mg",
        "%g",
        "km/s2",
        "m/s",
        "cm",
    ):
        mark = "; " if ";" in head else ", " if "time" in head else ""
        rows = [f"{0.01 * k:.2f}{mark}{a:.4f}" if mark else f"{a:.4f}" for k, a in enumerate(values)]
        path.write_text("\n".join([head.format(unit=unit), *rows, ""]), encoding="utf-8")
        try:
            found = records.read(path)
        except RecordError:
            continue
        factor = found.acceleration[5] / values[5]
        assert factor == pytest.approx(factor_to(unit, "m/s2"), rel=1e-9), unit
        agreed += 1
    assert agreed >= 5
