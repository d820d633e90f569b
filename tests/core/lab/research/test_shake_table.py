"""The model against tests on a shake table: an invented set in the layout, whose truth is known."""

import csv
import math
import shutil

import numpy as np
import pytest

from app.__main__ import main
from app.terminal import solved_cases
from core.errors import InputError
from core.lab.research.shake_table import (
    GRANITE,
    LOSSES,
    SETBACKS,
    Body,
    Computed,
    TableTests,
    best,
    compared,
    halves,
    read_tests,
    scored,
    with_setback,
)
from core.units import G
from core.wall.block import Block

TRUE = math.radians(8.0)
"""Slenderness of the invented body; it was measured as 10 degrees."""


def pulse(strength: float, period: float) -> np.ndarray:
    """A full sine [g], at rest before and after."""
    time = np.arange(0.0, 4.0, 0.005)
    return np.where((time > 0.5) & (time < 0.5 + period), strength * np.sin(2.0 * np.pi * (time - 0.5) / period), 0.0)


def invented(folder, truth=TRUE, wrong=()):
    """Eight events of nine strengths; a body that does what a block of this slenderness does. wrong : tests told so"""
    motions, rows = {}, []
    body = Block(truth, GRANITE[0].radius, GRANITE[0].inertia_over_mass)
    strengths = [(event, s) for event in range(8) for s in np.linspace(0.1, 0.5, 9)]
    sines = [pulse(s, 0.35 + 0.06 * event) for event, s in strengths]
    fell, _ = Computed([G * sine for sine in sines]).of(body)
    for k, ((event, s), motion, fallen) in enumerate(zip(strengths, sines, fell, strict=True)):
        name = f"{k + 1}"
        motions[f"t{name}"] = motion
        said = bool(fallen) != (name in wrong)
        period = 0.35 + 0.06 * event
        rows.append([name, f"E{event}", s, s * (1.5 if name == "3" else 1.0), period / math.pi, int(said)])
    with open(folder / "tests.csv", "w", newline="") as stream:
        head = ["test", "event", "stated_pga_g", "measured_pga_g", "pgv_over_pga_s", "overturned_1"]
        csv.writer(stream).writerows([head, *rows])
    np.savez(folder / "records.npz", **motions)
    return folder


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """What `invented` makes, once."""
    return invented(tmp_path_factory.mktemp("invented"))


@pytest.fixture
def copied(whole, tmp_path):
    """A copy of it that a test may damage."""
    return shutil.copytree(whole, tmp_path / "copied")


def test_that_a_body_that_does_what_the_model_says_is_found_with_its_slenderness(whole):
    tests = read_tests(whole)
    assert tests.left_out == ("3",) and tests.overturned.shape == (1, 71)  # its PGA was measured half as large again
    (found,) = compared(tests)
    scores = {score.method: score for score in found.scores}
    assert scores["slenderness"].right >= 0.97 and scores["slenderness"].fitted == pytest.approx((8.0, 8.0), abs=0.4)
    # a setback of 10 degrees to 8: tan(8)/tan(10) of the half width is left
    assert found.setback[0] == pytest.approx(0.5 * (1.0 - math.tan(TRUE) / math.tan(math.radians(10.0))), abs=0.02)
    assert found.setback[1] <= found.setback[0] <= found.setback[2]
    assert scores["measured"].right < scores["slenderness"].right and scores["measured"].missed > 0.0
    assert found.tried is None


@pytest.mark.shows("batch.validate")
def test_that_misses_and_false_alarms_are_of_what_fell_and_of_what_stood():
    events = np.array(["a", "a", "b", "b", "c"])
    fell = np.array([True, True, False, False, False])
    said = np.array([True, False, True, False, False])
    found = scored("measured", said, fell, events)
    assert (found.right, found.missed, found.false) == pytest.approx((0.6, 0.5, 1.0 / 3.0))
    assert found.interval[0] <= 0.6 <= found.interval[1]
    every = scored("measured", fell, fell, events)
    assert (every.right, every.missed, every.false, every.interval) == (1.0, 0.0, 0.0, (1.0, 1.0))


@pytest.mark.shows("batch.validate")
def test_that_no_event_is_in_both_halves_and_the_seed_decides():
    events = np.repeat([f"E{k}" for k in range(9)], 5)
    first, second = halves(events, 1)
    assert not set(events[first]) & set(events[second]) and (first ^ second).all()
    assert {len(set(events[first])), len(set(events[second]))} == {4, 5}
    assert (halves(events, 1)[0] == first).all() and any((halves(events, k)[0] != first).any() for k in range(2, 6))


def test_that_of_equal_fits_the_middle_one_is_taken():
    computed = np.array([[0, 0], [1, 0], [1, 0], [1, 0], [1, 1]], bool)
    overturned, mask = np.array([True, False]), np.array([True, True])
    assert best(computed, overturned, mask) == 2


def test_that_a_setback_leaves_the_height_of_the_centre_of_mass_and_its_own_inertia():
    body = GRANITE[0]
    whole, moved = with_setback(body, 0.0), with_setback(body, 0.2)
    assert (whole.slenderness, whole.radius) == pytest.approx((body.slenderness, body.radius), rel=1e-12)
    assert moved.centroid[1] == pytest.approx(whole.centroid[1]) and moved.centroid[0] == pytest.approx(
        0.6 * whole.centroid[0]
    )
    own = [one.inertia_over_mass - one.radius**2 for one in (whole, moved)]
    assert own[0] == pytest.approx(own[1]) == pytest.approx(0.088)
    assert SETBACKS[0] == 0.0 and LOSSES[-1] == pytest.approx(1.0)


def test_that_a_second_body_is_tried_with_the_setback_of_the_first(whole):
    tests = read_tests(whole)
    bodies = (GRANITE[0], Body("2", 0.39, 0.39**2 + 0.088, math.radians(9.5)))
    twice = TableTests(
        bodies,
        tests.names,
        tests.events,
        tests.motions,
        tests.velocity,
        np.vstack([tests.overturned, tests.overturned]),
        ({}, {}),
        (),
    )
    first, second = compared(twice)
    assert second.tried.fitted == (round(first.setback[0], 3),) and second.tried.right > 0.9


@pytest.mark.parametrize(
    ("damage", "code"),
    [
        (lambda folder: (folder / "records.npz").unlink(), "unreadable"),
        (lambda folder: (folder / "records.npz").write_bytes(b"PK\x03\x04"), "validation_table"),
        (lambda folder: (folder / "tests.csv").write_bytes(b"\xff\xfe\x00"), "validation_column"),
        (lambda folder: (folder / "tests.csv").write_text("test,event\n1,E1\n"), "validation_column"),
        (lambda folder: _replaced(folder, "overturned_1", "overturned_9"), "validation_body"),
        (lambda folder: _replaced(folder, "\n5,E0,", "\n5,E0,x"), "validation_number"),
        (lambda folder: _replaced(folder, "\n5,E0,", "\n500,E0,"), "validation_motion"),
        (lambda folder: _replaced(folder, "\n5,E0,", "\n4,E0,"), "validation_twice"),
        (lambda folder: _outcome(folder, "TRUE"), "validation_outcome"),
        (lambda folder: _outcome(folder, "1.0"), "validation_outcome"),
        (lambda folder: _outcome(folder, ""), "validation_outcome"),
        (lambda folder: _replaced(folder, "\n5,E0,", "\n5,E0,1,"), "validation_row"),
        (lambda folder: _replaced(folder, "\n5,E0,", "\n5,"), "validation_row"),
        (lambda folder: _replaced(folder, "test,event", "test,test"), "validation_column"),
        (lambda folder: _events(folder), "validation_events"),
        (lambda folder: _motions(folder, lambda one: 9.81 * one), "validation_unit"),
        (lambda folder: _motions(folder, lambda one: one + 0j), "validation_motion"),
        (lambda folder: _motions(folder, lambda one: one.astype(object)), "validation_table"),
        (lambda folder: _motions(folder, lambda one: one[None]), "validation_motion"),
        (lambda folder: (folder / "records.npz").write_bytes(b""), "validation_table"),
        (lambda folder: np.save(folder / "records.npy", np.ones(3)) or _renamed(folder), "validation_table"),
        (lambda folder: (folder / "bodies.csv").write_text("name,radius_m\n1,2\n"), "validation_column"),
        (lambda folder: _body(folder, "1,400,160000.1,9"), "validation_number"),
        (lambda folder: _body(folder, "9,2.0,5.5,9"), "validation_body"),
        (lambda folder: _body(folder, "1,2.0,4.0,9"), "not_accepted"),
    ],
)
def test_that_a_folder_that_is_none_is_refused_in_a_sentence(copied, damage, code, capsys, monkeypatch):
    refused = []

    def read(folder):
        try:
            return read_tests(folder)
        except InputError as error:
            refused.append(error.code)
            raise

    monkeypatch.setattr(solved_cases, "read_tests", read)
    damage(copied)
    assert main(["--validate", "--data", str(copied)]) == 1 and refused == [code]
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1 and str(copied) in said.err


def _outcome(folder, word):
    """An outcome that is no 0 and no 1, of the last test."""
    path = folder / "tests.csv"
    content = path.read_text().rstrip()
    path.write_text(content[:-1] + word + "\n")


def _events(folder):
    path = folder / "tests.csv"
    head, *rows = path.read_text().splitlines()
    path.write_text("\n".join([head, *rows[:18], ""]))


def _motions(folder, changed):
    with np.load(folder / "records.npz") as archive:
        motions = {name: changed(archive[name]) for name in archive}
    np.savez_compressed(folder / "records.npz", **motions)


def _renamed(folder):
    (folder / "records.npy").replace(folder / "records.npz")


def _body(folder, row):
    (folder / "bodies.csv").write_text(f"name,radius_m,inertia_over_mass_m2,slenderness_deg\n{row}\n")


def _replaced(folder, old, new):
    path = folder / "tests.csv"
    content = path.read_text()
    assert old in content
    path.write_text(content.replace(old, new, 1))


def test_that_the_bodies_of_a_folder_take_the_place_of_the_granite_ones(copied):
    (copied / "bodies.csv").write_text("name,radius_m,inertia_over_mass_m2,slenderness_deg\n1,2.0,5.5,9\n")
    (body,) = read_tests(copied).bodies
    assert body == Body("1", 2.0, 5.5, math.radians(9.0))
