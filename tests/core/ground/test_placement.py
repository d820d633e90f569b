"""Where a sensor stood, by the words of its head."""

import numpy as np
import pytest

from core.ground.record_folder import Limits, read_file
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
