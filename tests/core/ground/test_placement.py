"""Where a sensor stood, by the words of its head."""

import numpy as np
import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.record_folder import Limits, read_file
from core.ground.records.grammar import Options
from core.ground.records.placement import structure_words

PLACES = [
    ("Chan  3: Roof - East", True),
    ("Location: 5th Floor, Center", True),
    ("STATION: HOTEL, FLOOR 4", True),
    ("Sensor at the basement", True),
    ("Bridge Deck, midspan", True),
    ("Dam crest, center", True),
    ("Left abutment", True),
    ("Edificio comunale, 2° piano", True),
    ("Torre civica, copertura", True),
    ("Piano di Sorrento", False),
    ("Monte Piano", False),
    ("PROCESSING LEVEL 2", False),
    ("Rooftop Canyon Road", True),
    ("Crest Drive, free field", False),
    ("Deckerville", False),
    ("BASELINE CORRECTED", False),
    ("STATION: AQV, L'Aquila - V. Aterno - Centro Valle", False),
]


@pytest.mark.parametrize(("line", "inside"), PLACES)
def test_that_the_words_of_a_place_in_a_structure_are_known(line, inside):
    assert bool(structure_words(["# head", line, "0.1 0.2"], "")) == inside
    assert bool(structure_words(["# head"], line)) == inside


@pytest.mark.parametrize(("place", "taken"), [("roof, 12 storeys", False), ("free field, garden", True)])
def test_that_a_selection_takes_free_field_alone(place, taken, tmp_path):
    rng = np.random.default_rng(1)
    values = np.convolve(rng.normal(size=900), np.ones(5) / 5.0, "same") * np.hanning(900)
    values -= values.sum() * np.hanning(900) / np.hanning(900).sum()  # no velocity is left
    head = f"Station: X, {place}; acceleration in m/s2, dt = 0.01 s"
    path = tmp_path / "x.txt"
    path.write_text(head + "\n" + "\n".join(f"{a:.6f}" for a in values) + "\n")
    (found,) = read_file(path, np.geomspace(0.1, 2.0, 10), Limits())
    assert hasattr(found, "spectrum") == taken
    if not taken:
        assert found.reason.code == "structure_component" and "roof" in found.reason.text("en")


@pytest.mark.parametrize(
    ("column", "said"),
    [("acc_base", ""), ("acc_top", "acc_top"), ("L3_X", "L3_X"), ("storey2", "storey2"), ("AccTop", "AccTop")],
)
def test_that_the_name_of_a_column_places_its_sensor_alone(tmp_path, column, said):
    """What stands above the other columns says nothing of this one."""
    rows = [f"{0.01 * k:.2f};{0.1 * np.sin(k / 5.0):.4f};{0.2 * np.sin(k / 5.0):.4f}" for k in range(400)]
    path = tmp_path / "building.csv"
    path.write_text("\n".join([f"t [s];{column} [g];acc_base [g]", *rows, ""]))
    found = records.read(path, Options(column=2))
    assert [dict(note.values)["words"] for note in found.warnings if note.code == "in_structure"] == (
        [f"'{said}'"] if said else []
    )
    other = records.read(path, Options(column=3))
    assert "in_structure" not in {note.code for note in other.warnings}


@pytest.mark.parametrize("name", ["drift", "theta", "rot_x", "gyro_z", "F_base", "ux"])
def test_that_a_column_that_is_no_acceleration_is_refused_by_its_name(tmp_path, name):
    path = tmp_path / "others.csv"
    rows = [f"{0.01 * k:.2f};{0.1 * np.sin(k / 5.0):.4f};{0.2 * np.sin(k / 5.0):.4f}" for k in range(400)]
    path.write_text("\n".join([f"t [s];{name};acc [g]", *rows, ""]))
    with pytest.raises(RecordError, match=name):
        records.read(path, Options("g", column=2))
