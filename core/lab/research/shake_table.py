"""The rocking model against tests on a shake table: which bodies overturned, and what the misses say about their base.

A folder holds what was tested (resources/docs/validation.md, "Against shake-table tests"): tests.csv, records.npz and,
where the bodies are not the granite ones, bodies.csv. What is fitted is fitted on one half of the events and scored on
the other; intervals are of the bootstrap over events, since strengths of one motion are not independent.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.case.number import parse_number
from core.case.wall_table import text_cells
from core.child import Refused, bounded
from core.decoding import decode_text
from core.errors import InputError
from core.lab.research.motion_archive import NO_MOTION, unpacked
from core.regular_file import read_regular
from core.rocking.grounds import Grounds
from core.rocking.history import scan_records
from core.rocking.methods import METHODS
from core.rocking.outcome import STABLE
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import RIGID
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

MAX_FILE_BYTES = {"tests.csv": 20_000_000, "records.npz": 1_000_000_000, "bodies.csv": 100_000}
SECONDS, MEGABYTES = 60.0, 4000
"""That unpacking the motions may take."""

MAX_PGA_FACTOR = 1.5
"""Factor by which the PGA of a motion may differ from the measured one: beyond it the unit or the motion is another."""

RADII = 0.05, 60.0
"""Least and greatest R of a body [m], as of a wall that is given by its radius."""

MIN_EVENTS = 4
"""Events that halves and intervals need."""

TIME_STEP = 0.005
"""Time between two samples of the motions [s]."""

AGREE = 0.30
"""Share by which a measured PGA may differ from the stated one: beyond it the channel was at fault."""

SLENDERNESSES = np.radians(np.arange(3.0, 20.01, 0.1))
SETBACKS = np.arange(0.0, 0.4501, 0.005)
"""Shares of the width of the base by which each hinge is set back."""

LOSSES = np.arange(0.3, 1.0001, 0.01)
"""Velocity ratios over Housner's."""

EVENT_DRAWS, INTERVAL_SHARE = 2000, 0.90
"""Sets of events that are drawn, and the share of them an interval holds."""

COUNTED_PEAKS = (0.1, 0.4)
"""Computed peaks over theta_c that are counted: below the limit of C8.7.1.2.1.9, and not at rest."""


@dataclass(frozen=True)
class Body:
    """A body of the tests as it was measured, before any test was looked at.

    radius : R [m]; inertia_over_mass : I0/m [m2]; slenderness : alpha [rad]
    """

    name: str
    radius: float
    inertia_over_mass: float
    slenderness: float


GRANITE = tuple(Body(name, 0.39, 0.39**2 + 0.088, math.radians(10.0)) for name in ("1", "2"))
"""The boulders of Chen et al.: R 0.36 to 0.42 m from their meshes, I0/m about R^2 + 0.088 m2, weak side 10 degrees in
the pose of the meshes."""


@dataclass(frozen=True)
class TableTests:
    """What was tested and is of use.

    names, events : of each test; motions : [m/s2]; velocity : PGV [m/s]
    overturned : of each body, whether it did, shape (bodies, tests)
    others : of each body, what other programs computed, by their names
    left_out : tests whose measured PGA is not the stated one
    """

    bodies: tuple[Body, ...]
    names: tuple[str, ...]
    events: np.ndarray
    motions: list[np.ndarray]
    velocity: np.ndarray
    overturned: np.ndarray
    others: tuple[dict[str, np.ndarray], ...]
    left_out: tuple[str, ...]


@dataclass(frozen=True)
class Score:
    """How often a method tells the outcome.

    method : measured, slenderness, setback, restitution, pgv or distinct_elements
    right : share of the tests; missed : of the tests that overturned, computed standing; false : of those that stood,
        computed overturned
    interval : of right
    fitted : on each half of the events, for the other; empty where nothing is
    """

    method: str
    right: float
    missed: float
    false: float
    interval: tuple[float, float]
    fitted: tuple[float | str, ...] = ()


@dataclass(frozen=True)
class Found:
    """What was found of a body.

    below_rule : (tests, overturned) whose computed peak lies in COUNTED_PEAKS
    setback : share of the width fitted on all its tests, and its interval
    tried : with the setback of the first body; None of that one
    """

    body: Body
    tests: int
    scores: tuple[Score, ...]
    below_rule: tuple[int, int]
    setback: tuple[float, float, float]
    tried: Score | None


def read_tests(folder: Path) -> TableTests:
    """The tests of a folder. Raises InputError for a file that is missing, damaged, or does not say what it should."""
    place = folder / "tests.csv"
    table = _rows(folder, "tests.csv", ("test", "event", "stated_pga_g", "measured_pga_g", "pgv_over_pga_s"))
    bodies = _bodies(folder, table[0])
    names = [row["test"] for row in table]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise InputError("validation_twice", test=twice, place=(place,))
    kept = [row for row in table if _agrees(row, place)]
    if len({row["event"] for row in kept}) < MIN_EVENTS:
        raise InputError("validation_events", least=MIN_EVENTS, place=(place,))
    motions = _motions(folder, [row["test"] for row in kept])
    for row, motion in zip(kept, motions, strict=True):
        peak, measured = float(np.abs(motion).max()), _number(row, "measured_pga_g", place)
        if not measured / MAX_PGA_FACTOR < peak < measured * MAX_PGA_FACTOR:
            raise InputError("validation_unit", test=row["test"], found=peak, stated=measured, place=(place,))
    others = tuple(
        {
            key.removeprefix("dem: "): np.array([_outcome(row, key, place) for row in kept])
            for key in table[0]
            if key.startswith("dem: ") and f"Specimen {body.name}-" in key
        }
        for body in bodies
    )
    velocity = [_number(row, "pgv_over_pga_s", place) * _number(row, "measured_pga_g", place) for row in kept]
    return TableTests(
        bodies,
        tuple(row["test"] for row in kept),
        np.array([row["event"] for row in kept]),
        [G * motion for motion in motions],
        G * np.array(velocity),
        np.array([[_outcome(row, f"overturned_{body.name}", place) for row in kept] for body in bodies]),
        others,
        tuple(name for name in names if name not in {row["test"] for row in kept}),
    )


def _agrees(row: dict[str, str], place: Path) -> bool:
    """Whether the measured PGA of a test is the stated one."""
    stated, measured = (_number(row, key, place) for key in ("stated_pga_g", "measured_pga_g"))
    return abs(measured / stated - 1.0) <= AGREE


def _rows(folder: Path, name: str, needed: tuple[str, ...]) -> list[dict[str, str]]:
    """The rows of a table that has these columns, each as long as its head."""
    path = folder / name
    try:
        head, *rows = [row for row in text_cells(decode_text(read_regular(path, MAX_FILE_BYTES[name]))) if any(row)]
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except (InputError, ValueError):
        raise InputError("validation_table", place=(path,)) from None
    if missing := next((key for key in needed if key not in head), None):
        raise InputError("validation_column", column=missing, place=(path,))
    ragged = next((n for n, row in enumerate(rows, start=2) if len(row) != len(head)), None)
    if ragged is not None or not rows or len(set(head)) < len(head):
        raise InputError("validation_row", row=ragged or 1, place=(path,))
    return [dict(zip(head, (cell.strip() for cell in row), strict=True)) for row in rows]


def _number(row: dict[str, str], key: str, place: Path) -> float:
    try:
        value = parse_number(row[key])
    except InputError:
        value = math.nan
    if not 1e-6 <= value <= 1e6:
        raise InputError("validation_number", column=key, test=row.get("test") or row["name"], place=(place,))
    return value


def _outcome(row: dict[str, str], key: str, place: Path) -> bool:
    """Whether a body overturned: 1, and 0 where it stood."""
    if row[key] not in ("0", "1"):
        raise InputError("validation_outcome", column=key, test=row["test"], place=(place,))
    return row[key] == "1"


def _bodies(folder: Path, row: dict[str, str]) -> tuple[Body, ...]:
    """The bodies that tests.csv names, of bodies.csv where it is there."""
    names = [key.removeprefix("overturned_") for key in row if key.startswith("overturned_")]
    if not names:
        raise InputError("validation_column", column="overturned_1", place=(folder / "tests.csv",))
    known, place = {body.name: body for body in GRANITE}, folder / "bodies.csv"
    if place.exists():
        keys = ("radius_m", "inertia_over_mass_m2", "slenderness_deg")
        known = {}
        for one in _rows(folder, "bodies.csv", ("name", *keys)):
            radius, inertia, degrees = (_number(one, key, place) for key in keys)
            if not RADII[0] <= radius <= RADII[1]:
                raise InputError("validation_number", column="radius_m", test=one["name"], place=(place,))
            body = Body(one["name"], radius, inertia, math.radians(degrees))
            try:
                restitution(with_setback(body, 0.0), "housner")
            except InputError as error:
                raise error.at(place) from None
            known[body.name] = body
    if missing := next((name for name in names if name not in known), None):
        raise InputError("validation_body", name=missing, place=(place,))
    return tuple(known[name] for name in names)


def _motions(folder: Path, names: list[str]) -> list[np.ndarray]:
    """Motions of these tests [g]; they are unpacked in a process of their own."""
    path = folder / "records.npz"
    try:
        content = read_regular(path, MAX_FILE_BYTES["records.npz"])
        return bounded(unpacked, content, tuple(names), seconds=SECONDS, megabytes=MEGABYTES)
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except Refused as error:
        if error.reason.startswith(NO_MOTION):
            test = error.reason.removeprefix(NO_MOTION)
            raise InputError("validation_motion", test=test, place=(path,)) from None
        raise InputError("validation_table", place=(path,)) from None


def halves(events: np.ndarray, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Masks of the tests of two halves of the events, drawn by a seed."""
    names = np.unique(events)
    first = np.random.default_rng(seed).permutation(names)[: names.size // 2]
    mask = np.isin(events, first)
    return mask, ~mask


class Computed:
    """Outcomes of a body under all motions. share : of its peaks over theta_c"""

    def __init__(self, motions: list[np.ndarray]):
        self.grounds, self.count = Grounds.of(motions, TIME_STEP), len(motions)

    def of(self, block: Block, loss: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
        """(whether it overturns, its peak over theta_c) of each test. loss : velocity ratio over Housner's"""
        ratio = restitution(block, "housner").ratio_at_rest
        model = rocking_model(block, False, restitution(block, "user", min(loss * ratio, 1.0)), RIGID)
        outcomes, peaks = np.zeros(self.count, np.int64), np.zeros(self.count)
        which, scales = np.arange(self.count), np.ones(self.count)
        scan_records(METHODS["taylor"], self.grounds, which, scales, model, outcomes, peaks)
        return outcomes != STABLE, peaks / model.collapse_rotation


def with_setback(body: Body, share: float) -> Block:
    """The body about hinges set back by a share of its width."""
    x, z = body.radius * math.sin(body.slenderness), body.radius * math.cos(body.slenderness)
    left = x * (1.0 - 2.0 * share)
    radius = math.hypot(left, z)
    own = body.inertia_over_mass - body.radius**2
    return Block(math.atan2(left, z), radius, own + radius**2)


def best(computed: np.ndarray, overturned: np.ndarray, mask: np.ndarray) -> int:
    """Row of the outcomes that are right most often on some tests, shape (rows, tests); of equals the middle one."""
    right = (computed[:, mask] == overturned[mask]).sum(axis=1)
    equal = np.flatnonzero(right == right.max())
    return int(equal[equal.size // 2])


def scored(
    method: str, said: np.ndarray, overturned: np.ndarray, events: np.ndarray, fitted: Sequence[float | str] = ()
) -> Score:
    """The score of what a method says, with its interval by the bootstrap over events."""
    right = said == overturned
    names, place = np.unique(events, return_inverse=True)
    count, good = np.bincount(place), np.bincount(place, right)
    drawn = np.random.default_rng(1).integers(names.size, size=(EVENT_DRAWS, names.size))
    low, high = np.quantile(
        good[drawn].sum(axis=1) / count[drawn].sum(axis=1), (0.5 - INTERVAL_SHARE / 2, 0.5 + INTERVAL_SHARE / 2)
    )
    return Score(
        method,
        float(right.mean()),
        float((~said[overturned]).mean()) if overturned.any() else 0.0,
        float(said[~overturned].mean()) if not overturned.all() else 0.0,
        (float(low), float(high)),
        tuple(fitted),
    )


def _fitted(method: str, computed: np.ndarray, values: Sequence[float | str], overturned, events, parts) -> Score:
    """The score of a family of outcomes of which each half of the events chooses one for the other half."""
    said, chosen = np.zeros(overturned.size, bool), []
    for own, other in (parts, parts[::-1]):
        k = best(computed, overturned, own)
        said[other] = computed[k, other]
        chosen.append(values[k])
    return scored(method, said, overturned, events, chosen)


def compared(tests: TableTests, seed: int = 1, told: Callable[[float], None] = lambda share: None) -> list[Found]:
    """What the model and others tell of each body. seed : of the halves; told : share of the work that is done"""
    computed, parts, results = Computed(tests.motions), halves(tests.events, seed), []
    first_setback = 0.0
    for k, (body, overturned) in enumerate(zip(tests.bodies, tests.overturned, strict=True)):
        inertia = body.inertia_over_mass - body.radius**2
        measured = Block(body.slenderness, body.radius, body.inertia_over_mass)

        def block_of(alpha: float, body: Body = body, inertia: float = inertia) -> Block:
            return Block(alpha, body.radius, inertia + body.radius**2)

        by_slenderness = [computed.of(block_of(alpha)) for alpha in SLENDERNESSES]
        leaning = np.array([said for said, _ in by_slenderness])
        set_back = np.array([computed.of(with_setback(body, share))[0] for share in SETBACKS])
        losing = np.array([computed.of(measured, loss)[0] for loss in LOSSES])
        thresholds = np.quantile(tests.velocity, np.linspace(0.01, 0.99, 99))
        by_velocity = tests.velocity > thresholds[:, None]
        alike = (overturned, tests.events, parts)
        scores = [
            scored("measured", computed.of(measured)[0], overturned, tests.events),
            _fitted("slenderness", leaning, np.degrees(SLENDERNESSES).round(1).tolist(), *alike),
            _fitted("setback", set_back, SETBACKS.round(3).tolist(), *alike),
            _fitted("restitution", losing, LOSSES.round(2).tolist(), *alike),
            _fitted("pgv", by_velocity, thresholds.round(3).tolist(), *alike),
        ]
        if tests.others[k]:
            names, said = list(tests.others[k]), np.array(list(tests.others[k].values()))
            scores.append(_fitted("distinct_elements", said, names, *alike))
        whole = np.ones(overturned.size, bool)
        peaks = by_slenderness[best(leaning, overturned, whole)][1]
        inside = (peaks >= COUNTED_PEAKS[0]) & (peaks < COUNTED_PEAKS[1])
        own = float(SETBACKS[best(set_back, overturned, whole)])
        ends = _interval_of_fit(set_back, SETBACKS, overturned, tests.events)
        tried = None
        if k == 0:
            first_setback = own
        else:
            said = computed.of(with_setback(body, first_setback))[0]
            tried = scored("setback", said, overturned, tests.events, (round(first_setback, 3),))
        below = int(inside.sum()), int((inside & overturned).sum())
        results.append(Found(body, overturned.size, tuple(scores), below, (own, *ends), tried))
        told((k + 1) / len(tests.bodies))
    return results


def _interval_of_fit(computed: np.ndarray, values: np.ndarray, overturned, events) -> tuple[float, float]:
    """Between what values a fit lies for INTERVAL_SHARE of the drawn sets of events."""
    names, place = np.unique(events, return_inverse=True)
    right = (computed == overturned).astype(float)
    by_event = np.stack([np.bincount(place, row) for row in right])
    drawn = np.random.default_rng(2).integers(names.size, size=(EVENT_DRAWS, names.size))
    fitted = []
    for one in drawn:
        total = by_event[:, one].sum(axis=1)
        equal = np.flatnonzero(total == total.max())
        fitted.append(values[equal[equal.size // 2]])
    low, high = np.quantile(fitted, (0.5 - INTERVAL_SHARE / 2, 0.5 + INTERVAL_SHARE / 2))
    return float(low), float(high)


def as_json(tests: TableTests, results: list[Found], seed: int) -> dict:
    """The content of validation.json."""

    def score(one: Score) -> dict:
        values = {"method": one.method, "right": one.right, "missed": one.missed, "false": one.false}
        return values | {"interval": list(one.interval), "fitted": list(one.fitted)}

    bodies = []
    for one in results:
        main = next(score for score in one.scores if score.method == "slenderness")
        bodies.append(
            {
                "name": one.body.name,
                "tests": one.tests,
                **{key: value for key, value in score(main).items() if key != "method"},
                "methods": [score(other) for other in one.scores],
                "peaks_0_1_to_0_4": {"tests": one.below_rule[0], "overturned": one.below_rule[1]},
                "setback_share": {"fitted": one.setback[0], "interval": list(one.setback[1:])},
                "with_setback_of_first_body": score(one.tried) if one.tried else None,
            }
        )
    events = int(np.unique(tests.events).size)
    return {"seed": seed, "events": events, "left_out": list(tests.left_out), "bodies": bodies}
