"""What may be imported of Ribalta: rocking of masonry walls, from a record to a verdict, by a dozen stable names.

Quantities are in SI (m, s, N, kg, rad) wherever a name has no unit in it; keys of a case have their units in their
names. What is not named here may change from version to version; results do not without a word in CHANGELOG.md.
Wrong input raises `InputError`, whose text is the sentence that the program prints.
"""

import io
import math
import os
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from core import atomic_write
from core.capacity import ida
from core.capacity.closed_forms import closed_form_q, range_notices
from core.case import reader
from core.case.floor_loads import add_corner_thrust
from core.case.rules import parse_case
from core.case.schema import Case, Record
from core.case.study_file import quick_study, read_study
from core.case.values import parse_section
from core.case.wall import Wall
from core.errors import InputError
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.report import parquet_file
from core.report.columns import columns_of
from core.report.json_report import results
from core.rocking import history as rocking
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, OUTCOME_WORDS, STABLE
from core.setting.check_input import make_rocking_model
from core.setting.plan import select_case_records
from core.setting.record_input import record_options
from core.study import run as study_run
from core.study.results import StudyResult
from core.study.wall_result import model_notices
from core.text.sentence import Key
from core.version import NAME, VERSION
from core.wall.kinematics import kinematics
from core.wall.rocking_model import RockingModel

__all__ = [
    "GroundMotion",
    "History",
    "InputError",
    "case",
    "eq15_16",
    "history",
    "motion",
    "read_case",
    "read_record",
    "run",
    "save_parquet",
    "search",
    "select",
    "spectrum",
    "study",
    "table",
    "verdicts",
    "wall",
]

Kind = TypeVar("Kind")

OF_FILE = "unit", "time_step_s", "column", "skip_lines", "channel"
"""Keys of [[record]] that say what a file does not."""

PAPER = Path(__file__).resolve().parents[1] / "resources" / "studies" / "paper.toml"
"""The study of the paper."""


def wall(**keys: Any) -> Wall:
    """A wall by the keys of `[[wall]]`.

    Parameters
    ----------
    **keys
        As in a case file: ``name``, ``height_m``, ``thickness_m``, ``mechanism`` ("one_sided" or "two_sided"), ...

    Returns
    -------
    Wall
        ``wall.in_si.block`` has its slenderness [rad], R [m] and p [rad/s].

    Raises
    ------
    InputError
        Where a key is unknown, missing or out of its range.
    """
    table = {"name": "wall", **_plain(keys)}
    if "demand" in keys or "record" in keys:
        raise InputError("api_case", key="demand" if "demand" in keys else "record")
    return parse_case({"wall": [table]}).wall[0]


def read_case(path: str | os.PathLike) -> Case:
    """The case of a file.

    Raises
    ------
    InputError
        Naming file, place and way out.
    """
    return reader.read_case(_path(path))


def case(keys: dict[str, Any]) -> Case:
    """A case by the mapping its file holds: ``{"wall": [{...}], "demand": {...}, "generate": {...}}``.

    Raises
    ------
    InputError
        Where the file with this content would be refused.
    """
    made = parse_case(_plain(_of(dict, "keys", keys)))
    if made.walls is not None:
        raise InputError("api_table", key="walls", found=made.walls)
    return made


def motion(acceleration: Sequence[float] | np.ndarray, time_step: float, name: str = "motion") -> GroundMotion:
    """A ground motion by its samples.

    Parameters
    ----------
    acceleration
        [m/s2], shape (n,), linear between samples.
    time_step
        [s].

    Raises
    ------
    InputError
        For fewer than 10 samples, samples that are not finite, or zeros alone.
    """
    step = _number("time_step", time_step, "> 0 s", lambda one: one > 0.0)
    return GroundMotion(_of(str, "name", name), _row("acceleration", acceleration), step)


def read_record(path: str | os.PathLike, scale: float = 1.0, **said: Any) -> GroundMotion:
    """The accelerogram of a file of any format the program knows.

    Parameters
    ----------
    path
        PEER .AT2, ESM, ITACA, CSMIP, K-NET, tables, ...: recognised by its content.
    scale
        Factor of the samples [-].
    **said
        What the file does not say, by the keys of ``[[record]]``: ``unit``, ``time_step_s``, ``column``,
        ``skip_lines``, ``channel``.

    Raises
    ------
    InputError
        Naming file, place and way out.
    """
    place = _path(path)
    if more := set(said) - set(OF_FILE):
        raise InputError("api_number", key=min(more), accepted=", ".join(OF_FILE))
    entry = parse_section(Record, _plain({"file": str(place), "scale": scale, **said}), "record", "record")
    return records.read(place, record_options(entry), entry.scale)


def spectrum(ground: GroundMotion, periods: Sequence[float] | np.ndarray, damping: float = 0.05) -> np.ndarray:
    """Pseudo-acceleration response spectrum [m/s2], shape (n,) of `periods` [s]; damping a share of critical.

    Raises
    ------
    InputError
        For periods that are not above 0, or a damping that is not from 0.001 to 0.5.
    """
    _of(GroundMotion, "ground", ground)
    asked = _row("periods", periods)
    if not np.isfinite(asked).all() or (asked <= 0.0).any():
        raise InputError("api_number", key="periods", accepted="> 0 s")
    share = _number("damping", damping, "0.001 – 0.5", lambda one: 0.001 <= one <= 0.5)
    return pseudo_acceleration_spectrum(ground.acceleration, ground.time_step, asked, share)


@dataclass(frozen=True)
class History:
    """A rocking history.

    Attributes
    ----------
    time, rotation, velocity
        [s], [rad], [rad/s] at the samples, up to the end.
    impact_time
        [s].
    peak
        Largest rotation [rad], the free motion after the record included.
    overturned
        Whether the wall falls.
    """

    time: np.ndarray
    rotation: np.ndarray
    velocity: np.ndarray
    impact_time: np.ndarray
    peak: float
    overturned: bool


def history(wall: Wall, ground: GroundMotion, scale: float = 1.0, mechanism: str | None = None) -> History:
    """Rocking history of a wall under a scaled record (Eq. 1), by the Taylor series with located events.

    A one-sided wall that stands under a record may fall under the same one reversed: try both signs.

    Parameters
    ----------
    ground
        The motion under the wall.
    scale
        Multiplier of the record [-]; negative reverses it.
    mechanism
        Of a wall of "both" the one that is meant.

    Raises
    ------
    InputError
        For a mechanism the wall has not, a wall above the ground, whose motion is that of its floor, a scale or a
        motion that is no earthquake (10^5 g), and a motion after too many impacts.
    """
    model = _model(wall, _of(GroundMotion, "ground", ground), mechanism)
    factor = _number("scale", scale, "-1e6 – 1e6", lambda one: abs(one) <= 1e6)
    found = rocking.integrate_history(ground.acceleration, ground.time_step, factor, model)
    if found.outcome not in (STABLE, COLLAPSED):
        raise InputError("api_no_outcome", wall=wall.title, outcome=OUTCOME_WORDS[found.outcome])
    time = ground.time_step * np.arange(found.rotation.size)
    overturned = found.outcome == COLLAPSED
    return History(time, found.rotation, found.velocity, found.impact_time, found.peak, overturned)


def search(
    wall: Wall, ground: GroundMotion, mechanism: str | None = None, q_step: float = 0.005, reverse: bool | None = None
) -> ida.Ida:
    """The search of q of a wall under a record: incremental dynamic analysis to collapse (Eq. 10).

    Parameters
    ----------
    q_step
        Step of ln q [-].
    reverse
        None, as in the program: of a wall whose sides are unlike, as a one-sided one, both signs of the record, of
        each quantity the lower one; False as recorded, True with the other sign.

    Returns
    -------
    Ida
        ``q``, ``q_slv``, ``q_slc``, ``q_robust`` [-], None where there is none, and ``analyses`` made.

    Raises
    ------
    InputError
        For a mechanism the wall has not, and a wall above the ground, whose motion is that of its floor.
    """
    model = _model(wall, _of(GroundMotion, "ground", ground), mechanism)
    if not (reverse is None or isinstance(reverse, bool | np.bool_)):
        raise InputError("api_kind", key="reverse", kind="bool", found=type(reverse).__name__)
    settings = ida.Search(q_step=_number("q_step", q_step, "0.0001 – 0.1", lambda one: 1e-4 <= one <= 0.1))
    signs = ([1] if model.both_signs_alike else [1, -1]) if reverse is None else [-1 if reverse else 1]
    made = [
        ida.incremental_dynamic_analysis(
            ground.acceleration, ground.time_step, ground.pga, sign, model, METHODS["taylor"], settings
        )
        for sign in signs
    ]
    worst = min(made, key=lambda one: math.inf if one.q is None else one.q)
    lower: dict[str, Any] = {name: _lower(getattr(one, name) for one in made) for name in OF_BOTH}
    return replace(worst, analyses=sum(one.analyses for one in made), **lower)


def eq15_16(wall: Wall, ground: GroundMotion, mechanism: str | None = None) -> float:
    """q [-] of the paper's Eq. 15 (two-sided) or 16 (one-sided) for a wall and the intensity of a record.

    Warns
    -----
    UserWarning
        Where wall or record lie outside the ranges the equations were fitted on, or the wall has another velocity
        ratio or law than they: q by `search` may then be half of theirs.

    Raises
    ------
    InputError
        For a wall above the ground, with loads or that bends, where they do not hold.
    """
    _of(GroundMotion, "ground", ground)
    if not add_corner_thrust(_of(Wall, "wall", wall)).has_closed_forms:
        raise InputError("api_closed_forms", wall=wall.title)
    block, asked = wall.in_si.block, _mechanism(wall, mechanism)
    one_sided = kinematics(asked).one_way
    outside = range_notices(block.slenderness, block.height, [(ground.name, ground.pga)])
    outside += model_notices(asked, wall.restitution_of(asked), wall.moment_law())
    for one in outside:
        warnings.warn(one.text("en"), stacklevel=2)
    return closed_form_q(block.slenderness, block.height, ground.housner_intensity, ground.pga, one_sided)


def run(case: Case, base_dir: str | os.PathLike = ".", jobs: int | None = None) -> StudyResult:
    """Run a case: histories, checks and verdicts of each wall, as the window and the batch do.

    Parameters
    ----------
    base_dir
        Folder the paths of its records start from.
    jobs
        Threads, which change no result; all processors without it.
    """
    return study_run.run(_of(Case, "case", case), base_dir=_path(base_dir), jobs=_threads(jobs))


def verdicts(result: StudyResult) -> list[dict[str, Any]]:
    """The verdict of each wall with its checks, assumptions and hinges, by the keys of the results
    (resources/docs/results.md)."""
    return results(_of(StudyResult, "result", result))["verdicts"]


def table(result: StudyResult) -> dict[str, list]:
    """The rows of a study by column, a row for each wall, hinge and mechanism: ``pandas.DataFrame(table(result))``."""
    return columns_of(_of(StudyResult, "result", result), range(len(result.case.wall)))


def save_parquet(result: StudyResult, path: str | os.PathLike) -> None:
    """Write `table` as a Parquet file, with the unit of each column. It takes the package pyarrow."""
    rows, place = table(result), _path(path)
    metadata = {"program": f"{NAME} {VERSION}", "case_sha256": result.case.sha256}
    stream = io.BytesIO()
    parquet_file.write(stream, [rows], metadata)
    atomic_write.write({place: stream.getvalue()})


def study(path: str | os.PathLike = PAPER, quick: bool = False, jobs: int | None = None) -> list[dict[str, Any]]:
    """The runs of a parametric study, a row for each wall, motion and sign: ``pandas.DataFrame(study())``.

    Parameters
    ----------
    path
        A study file; the study of the paper (sections 4 and 5) without it.
    quick
        The short study its file describes.

    Returns
    -------
    list of dict
        ``mechanism``, ``slenderness_deg``, ``height_m``, ``restitution``, ``law``, ``spectrum`` ("" of a natural
        record), ``motion``, ``polarity``, ``intensity_m``, ``pga_m_s2``, ``q``, ``q_slv``, None where there is none.
    """
    from core.lab.research import parametric

    place = _path(path)
    asked, digest = read_study(place)
    asked = quick_study(asked) if _of(bool, "quick", quick) else asked
    made = parametric.run(asked, digest, base_dir=place.parent, quick=quick, jobs=_threads(jobs))
    return [
        {
            "mechanism": row.cell.mechanism,
            "slenderness_deg": row.cell.slenderness_deg,
            "height_m": row.cell.height_m,
            "restitution": row.cell.restitution,
            "law": row.cell.law,
            "spectrum": made.motions[row.motion].spectrum,
            "motion": made.motions[row.motion].motion.name,
            "polarity": row.polarity,
            "intensity_m": made.motions[row.motion].motion.housner_intensity,
            "pga_m_s2": made.motions[row.motion].motion.pga,
            "q": row.q,
            "q_slv": row.q_slv,
        }
        for row in made.rows
    ]


def select(case: Case, base_dir: str | os.PathLike = ".") -> Case:
    """The case with the records that its ``[select]`` finds in a folder, by the spectrum of its demand.

    Raises
    ------
    InputError
        Where there is no set that fits.
    """
    return select_case_records(_of(Case, "case", case), _path(base_dir))[0]


OF_BOTH = "q_slv", "q_slc", "q_slv_low", "q_slv_robust", "q_robust"
"""Quantities of a search of which the lower of both signs counts; what else it tells is of the sign with the lower
q."""


def _lower(values: Iterable[float | None]) -> float | None:
    return min((value for value in values if value is not None), default=None)


def _of(kind: type[Kind], key: str, value: Any) -> Kind:
    """An argument of its kind. Raises InputError for another."""
    if not isinstance(value, kind):
        raise InputError("api_kind", key=key, kind=kind.__name__, found=type(value).__name__)
    return value


def _path(path: Any) -> Path:
    place = Path(path if isinstance(path, os.PathLike) else _of(str, "path", path))
    if "\0" in str(place) or any(len(os.fsencode(part)) > MAX_NAME for part in place.parts):
        raise InputError("api_number", key="path", accepted="a path")
    return place


MAX_NAME = 255
"""Bytes of a name that a system takes."""


NO_NUMBERS = str, bytes, bool, np.bool_, complex, np.complexfloating


def _number(key: str, value: Any, accepted: str, holds: Callable[[float], bool]) -> float:
    """A number in its range. Raises InputError for another, and for a text."""
    try:
        number = math.nan if isinstance(value, NO_NUMBERS) else float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not holds(number):
        raise InputError("api_number", key=key, accepted=accepted)
    return number


def _row(key: str, values: Any) -> np.ndarray:
    """Numbers one after the other. Raises InputError for anything else."""
    try:
        row = np.atleast_1d(np.asarray(values))
        if row.ndim != 1 or row.dtype.kind not in "iuf" or np.ma.is_masked(values):
            raise ValueError
        return row.astype(float)
    except (TypeError, ValueError, OverflowError):
        raise InputError("api_samples", key=key) from None


def _threads(jobs: Any) -> int:
    if jobs is None:
        return os.cpu_count() or 1
    return int(_number("jobs", jobs, "1 – 1000", lambda one: 1 <= one <= 1000 and one == int(one)))


def _plain(value: Any) -> Any:
    """What numpy made as what a case file holds, throughout a mapping."""
    if isinstance(value, dict):
        if not all(isinstance(key, str) for key in value):
            raise InputError("api_number", key="keys", accepted="dict[str, …]")
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, np.ma.MaskedArray):
        raise InputError("api_number", key="keys", accepted="1, 2.5, …")
    if isinstance(value, list | tuple) or (isinstance(value, np.ndarray) and value.ndim > 0):
        return [_plain(one) for one in value]
    if isinstance(value, np.ndarray):
        return _plain(value[()])
    if isinstance(value, np.float32 | np.float16):  # 4.1 in single precision is meant as 4.1
        return float(str(value))
    return value.tolist() if isinstance(value, np.generic) else value


def _model(wall: Wall, ground: GroundMotion, asked: str | None) -> RockingModel:
    """The model of a wall with all that acts on it. Raises InputError for one above the ground: it is moved by its
    floor."""
    if _of(Wall, "wall", wall).above_ground:
        said = {"wall": wall.title, "z": wall.demand_height_m, "ground": ground.name, "building": Key("[building]")}
        raise InputError("api_above_ground", key="base_z_m", **said)
    return make_rocking_model(add_corner_thrust(wall), _mechanism(wall, asked))


def _mechanism(wall: Wall, asked: str | None) -> str:
    """The mechanism that is asked for, or the only one of a wall."""
    known = wall.mechanisms()
    asked = asked if asked is None else _of(str, "mechanism", asked)
    if asked is None and len(known) == 1:
        return known[0]
    if asked not in known:
        raise InputError("api_mechanism", wall=wall.title, found=str(asked), known=tuple(known))
    return asked
