"""Damaged copies of real records: is what a reader could see in the samples seen by the program?

`.venv/bin/python -m tests.core.ground.damage --records FOLDER` damages every record of a folder in each way below,
reads the copies as plain text and prints what was refused, named and silent. A silent one is harmless where neither
the peak nor the Housner intensity moved by 5 %, and visible where the damage shows: of damage to the whole record
always; of damage at one place where it makes a step three times as large as any within 64 samples (2.6 at most on the
shelf), or leaves a velocity above a quarter of the peak velocity; a wrong time step, a velocity or a displacement where
the mean frequency is that of no ground: others are motions that some ground could have, and only a head that states
peak or filter can tell. "Visible" is judged from the intact record, by other measures than those of the program.
"""

import argparse
from collections import Counter, defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.errors import RecordError
from core.ground import records
from core.ground.ground_motion import GroundMotion, _integral
from core.ground.record_folder import DOUBTED
from core.ground.records.grammar import Options
from core.ground.response_spectrum import housner_intensity
from core.units import G

HARMLESS = 0.05
"""Change of the peak and of the Housner intensity below which a damage does no harm."""


@dataclass(frozen=True)
class Damaged:
    """acceleration : [m/s2]; time_step [s]; places : samples the damage stands at; shows : whoever looks sees it"""

    acceleration: np.ndarray
    time_step: float
    places: tuple[int, ...] = ()
    shows: bool = False


def _strong(a: np.ndarray, rng, share: float = 0.1) -> int:
    """A sample within the strong part."""
    energy = np.cumsum(a**2) / np.sum(a**2)
    return int(np.searchsorted(energy, rng.uniform(share, 1.0 - share)))


def _spliced(a, first, last, piece):
    return np.concatenate([a[:first], piece, a[last:]])


def _lines(a, rng):
    """The beginning of a line of eight samples in the strong part that has lines around it."""
    return int(min(max(_strong(a, rng) // 8 * 8, 16), (a.size // 8 - 4) * 8))


def turned_halfway(a, dt, rng):
    k = _strong(a, rng)
    return Damaged(np.concatenate([a[:k], -a[k:]]), dt, (k,))


def turned_piece(a, dt, rng):
    k, n = _strong(a, rng), int(rng.integers(20, 400))
    last = min(k + n, a.size)
    return Damaged(_spliced(a, k, last, -a[k:last]), dt, (k, last))


def lines_swapped(a, dt, rng):
    k = _lines(a, rng)
    return Damaged(np.concatenate([a[:k], a[k + 8 : k + 16], a[k : k + 8], a[k + 16 :]]), dt, (k, k + 8, k + 16))


def line_lost(a, dt, rng):
    k, n = _lines(a, rng), int(rng.choice([8, 8, 40, 200]))
    return Damaged(np.concatenate([a[:k], a[k + n :]]), dt, (k,))


def line_twice(a, dt, rng):
    k = _lines(a, rng)
    return Damaged(np.concatenate([a[: k + 8], a[k:]]), dt, (k + 8,))


def piece_twice(a, dt, rng):
    k, n = _strong(a, rng, 0.2), 300
    return Damaged(np.concatenate([a[: k + n], a[k:]]), dt, (min(k + n, a.size - 1),), True)


def whole_twice(a, dt, rng):
    return Damaged(np.concatenate([a, a]), dt, shows=True)


def ascending(a, dt, rng):
    return Damaged(np.sort(a), dt, shows=True)


def lines_sorted(a, dt, rng):
    """Lines of eight sorted by their first number, as an editor sorts lines."""
    rows = a[: a.size // 8 * 8].reshape(-1, 8)
    return Damaged(rows[np.argsort(rows[:, 0], kind="stable")].ravel(), dt, shows=True)


def shuffled(a, dt, rng):
    return Damaged(rng.permutation(a), dt, shows=True)


def held(a, dt, rng):
    k = _strong(a, rng, 0.2)
    return Damaged(np.concatenate([a[:k], np.full(min(300, a.size - k), a[k]), a[k + 300 :]]), dt, (k,), True)


def zeros_filled(a, dt, rng):
    k = _strong(a, rng, 0.2)
    n = min(200, a.size - k)
    return Damaged(_spliced(a, k, k + n, np.zeros(n)), dt, (k, k + n), True)


def clipped(a, dt, rng):
    top = np.abs(a).max() * rng.uniform(0.3, 0.7)
    return Damaged(np.clip(a, -top, top), dt, shows=True)


def signs_lost(a, dt, rng):
    return Damaged(np.abs(a), dt, shows=True)


def some_signs_lost(a, dt, rng):
    return Damaged(np.where(rng.random(a.size) < 0.2, np.abs(a), a), dt, shows=True)


def rounded(a, dt, rng):
    step = np.abs(a).max() / rng.uniform(3, 12)
    return Damaged(np.round(a / step) * step, dt, shows=True)


def point_lost(a, dt, rng):
    """The decimal point of one number slips by a digit or two."""
    k = _strong(a, rng)
    b = a.copy()
    b[k] *= 10.0 ** int(rng.integers(1, 3))
    return Damaged(b, dt, (k, k + 1))


def sign_lost(a, dt, rng):
    k = _strong(a, rng)
    b = a.copy()
    b[k] = -b[k]
    return Damaged(b, dt, (k, k + 1))


def offset(a, dt, rng):
    return Damaged(a + np.abs(a).max() * rng.uniform(0.05, 0.5) * rng.choice([-1, 1]), dt, shows=True)


def backwards(a, dt, rng):
    """It shows where little of the record is left after half of the motion."""
    return Damaged(a[::-1], dt, shows=bool(np.sum(a[: a.size // 5] ** 2) > 0.5 * np.sum(a**2)))


def interleaved(a, dt, rng):
    """Two components one after the other in one column, as a table of two read along its lines."""
    other = np.roll(a, int(rng.integers(5, 60))) * rng.uniform(0.5, 1.0) * rng.choice([-1, 1])
    return Damaged(np.column_stack([a, other]).ravel()[: a.size], dt, shows=True)


def no_acceleration(a: np.ndarray, dt: float) -> bool:
    """Whether the mean frequency of the samples, by their squares and those of their steps, is that of no ground."""
    mean = float(np.sqrt(np.sum((np.diff(a) / dt) ** 2) / np.sum(a**2)) / (2.0 * np.pi))
    return not 0.3 <= mean <= 40.0


def step_tenfold(a, dt, rng):
    return Damaged(a, dt * 10.0, shows=no_acceleration(a, dt * 10.0))


def step_tenth(a, dt, rng):
    return Damaged(a, dt / 10.0, shows=no_acceleration(a, dt / 10.0))


def velocity_for_acceleration(a, dt, rng):
    v = _integral(a, dt)
    return Damaged(v, dt, shows=no_acceleration(v, dt))


def displacement_for_acceleration(a, dt, rng):
    d = _integral(_integral(a, dt), dt)
    return Damaged(d, dt, shows=no_acceleration(d, dt))


def a_trend(a, dt, rng):
    return Damaged(a + np.linspace(0.0, 1.0, a.size) * np.abs(a).max() * rng.uniform(0.1, 0.5), dt, shows=True)


def cut_before_its_end(a, dt, rng):
    k = int(np.abs(a).argmax()) + 1
    return Damaged(a[: max(k, 200)], dt, shows=k >= 200)


KINDS = (
    turned_halfway,
    turned_piece,
    lines_swapped,
    line_lost,
    line_twice,
    piece_twice,
    whole_twice,
    ascending,
    lines_sorted,
    shuffled,
    held,
    zeros_filled,
    clipped,
    signs_lost,
    some_signs_lost,
    rounded,
    point_lost,
    sign_lost,
    offset,
    backwards,
    interleaved,
    step_tenfold,
    step_tenth,
    velocity_for_acceleration,
    displacement_for_acceleration,
    a_trend,
    cut_before_its_end,
)


def read(a: np.ndarray, dt: float) -> GroundMotion:
    """The motion of a plain text of two columns. Raises RecordError."""
    rows = [f"{dt * k:.7g} {value:.7e}" for k, value in enumerate((a / G).tolist())]
    content = "\n".join(["time (s)  acceleration (g)", *rows, ""]).encode()
    return records._motion(content, Path("record.txt"), Options(), 1.0, "record")


def visible(intact: np.ndarray, damaged: Damaged) -> bool:
    """Whether whoever looks at the damaged samples sees that no ground moved so."""
    if damaged.shows:
        return True
    a, steps = damaged.acceleration, np.abs(np.diff(damaged.acceleration))
    for k in damaged.places:
        if not 0 < k < a.size:
            continue
        around = steps[max(k - 65, 0) : k + 64].copy()
        for place in damaged.places:
            j = place - 1 - max(k - 65, 0)
            if 0 <= j < around.size:
                around[j] = 0.0
        if steps[k - 1] > 3.0 * around.max(initial=0.0) and steps[k - 1] > 0.05 * np.abs(a).max():
            return True
    dt = damaged.time_step
    v, before = _integral(a, dt), _integral(intact, dt)
    return abs(v[-1]) > 0.25 * np.abs(v).max() and abs(before[-1]) < 0.1 * np.abs(before).max()


def harmless(intact: np.ndarray, dt: float, damaged: Damaged) -> bool:
    """Whether neither peak nor Housner intensity moved by more than HARMLESS."""
    if damaged.time_step != dt:
        return False
    peaks = np.abs(damaged.acceleration).max() / np.abs(intact).max()
    if not damaged.acceleration.any() or abs(peaks - 1.0) > HARMLESS:
        return False
    changed = housner_intensity(damaged.acceleration, dt) / housner_intensity(intact, dt)
    return bool(abs(changed - 1.0) <= HARMLESS)


def outcome(intact: np.ndarray, dt: float, damaged: Damaged, known: frozenset[str]) -> str:
    """ "refused", "named", "harmless", "visible" or "hidden". known : codes that say nothing of the samples"""
    try:
        motion = read(damaged.acceleration, damaged.time_step)
    except RecordError:
        return "refused"
    if {warning.code for warning in motion.warnings} - known:
        return "named"
    if harmless(intact, dt, damaged):
        return "harmless"
    return "visible" if visible(intact, damaged) else "hidden"


def motions(folder: Path, every: int = 1) -> list[GroundMotion]:
    """The motions of every so many-th file of a folder of records, read without an option or with g for their unit."""
    found = []
    for path in sorted(entry for entry in folder.rglob("*") if entry.is_file())[::every]:
        for channel in records.channels(path) or (None,):
            for unit in (None, "g"):
                try:
                    found.append(records.read(path, Options(channel=channel, unit=unit)))
                    break
                except RecordError:
                    continue
    return found


def damage_all(found: list[GroundMotion], rounds: int = 1) -> tuple[dict[str, Counter], list[str], list[str]]:
    """(outcomes of each kind of damage, the visible ones that stay silent, intact motions refused as plain text)"""
    told: dict[str, Counter] = defaultdict(Counter)
    silent, false = [], []
    for number, motion in enumerate(found):
        a, dt = np.asarray(motion.acceleration), motion.time_step
        try:
            known = frozenset(warning.code for warning in read(a, dt).warnings) - DOUBTED
        except RecordError as error:
            false.append(f"{motion.name}: {error.code}")
            continue
        for place, kind in enumerate(KINDS):
            for turn in range(rounds):
                rng = np.random.default_rng((number, place, turn))
                damaged = kind(a, dt, rng)
                what = outcome(a, dt, damaged, known)
                told[kind.__name__][what] += 1
                if what == "visible":
                    silent.append(f"{kind.__name__}: {motion.name} ({number}, {place}, {turn})")
    return told, silent, false


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--records", type=Path, required=True, help="folder of real records")
    parser.add_argument("--rounds", type=int, default=1, help="copies of each record and kind")
    given = parser.parse_args()
    found = motions(given.records)
    told, silent, false = damage_all(found, given.rounds)
    columns = ("refused", "named", "harmless", "hidden", "visible")
    print(f"{len(found)} motions, {sum(sum(one.values()) for one in told.values())} damaged copies")
    print(f"{'damage':32}" + "".join(f"{name:>10}" for name in columns))
    for kind, counts in told.items():
        print(f"{kind:32}" + "".join(f"{counts[name]:10}" for name in columns))
    print("silent though visible:", *silent or ["none"], sep="\n  ")
    print("intact, but refused:", *false or ["none"], sep="\n  ")


if __name__ == "__main__":
    main()
