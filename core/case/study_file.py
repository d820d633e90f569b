"""The file of a parametric study: grids of walls, shapes of spectra, records. Read and checked like a case."""

import hashlib
from dataclasses import MISSING, dataclass, field, replace
from itertools import product
from pathlib import Path

from core.case.keys import choice_key, flag_key, number_key, path_key, text_key
from core.case.reader import read_toml
from core.case.rules import check_code_keys, parse_wall
from core.case.schema import Record
from core.case.values import parse_section, refuse_unknown
from core.case.wall import Wall
from core.codes.spectrum_codes import CODES
from core.codes.target_spectrum import NTC_TOPOGRAPHY, SOILS
from core.errors import InputError, place
from core.rocking.methods import METHODS
from core.text.sentence import LANGUAGES
from core.wall.kinematics import Kinematics, kinematics
from core.wall.moment_rotation import LAWS
from core.wall.restitution import MODELS

DEFAULT_MODEL = "default"
"""The restitution that follows the mechanism: Eq. 4 or Eq. 6."""


def list_key(item, default):
    """One or more values of one kind."""
    return field(default=default, metadata={"kind": "list", "of": item})


def tables_key(cls):
    """One or more tables of a section."""
    return field(default=(), metadata={"kind": "tables", "of": cls})


@dataclass(frozen=True)
class Shape:
    """[[group.spectrum]]: the shape of a code's elastic spectrum and the first seed of its motions."""

    name: str = text_key(MISSING)
    code: str = choice_key(*CODES)
    soil: str = choice_key(*SOILS)
    seed: int = number_key(0, 1_000_000, MISSING, whole=True)
    f0: float | None = number_key(2.0, 4.0)
    tc_star_s: float | None = number_key(0.05, 1.0, unit="s")
    topography: str | None = choice_key(*NTC_TOPOGRAPHY, default=None)
    type: int | None = number_key(1, 2, whole=True)
    vs30_m_s: float | None = number_key(50.0, 3000.0, unit="m/s")
    contribution_k: float | None = number_key(0.5, 3.0)


@dataclass(frozen=True)
class Group:
    """[[group]]: spectra of one peak ground acceleration a_g S."""

    name: str = text_key(MISSING)
    pga_g: float = number_key(0.001, 5.0, MISSING, unit="g")
    spectrum: tuple[Shape, ...] = tables_key(Shape)


@dataclass(frozen=True)
class Grid:
    """[[grid]]: every combination of its lists is a cell of the study."""

    slenderness_deg: tuple[float, ...] = list_key(number_key(0.5, 45.0, unit="deg"), ())
    height_m: tuple[float, ...] = list_key(number_key(0.1, 60.0, unit="m"), ())
    mechanism: tuple[str, ...] = list_key(choice_key("two_sided", "one_sided"), ("two_sided",))
    restitution: tuple[str, ...] = list_key(choice_key(DEFAULT_MODEL, *MODELS), ())
    velocity_ratio: tuple[float, ...] = list_key(number_key(0.0, 1.0), ())
    law: tuple[str, ...] = list_key(choice_key(*LAWS), ("rigid",))
    method: tuple[str, ...] = list_key(choice_key(*METHODS), ("taylor",))
    q_step: tuple[float, ...] = list_key(number_key(1e-4, 0.1), (0.005,))
    motions: str = choice_key("generated", "records", "all", default="generated")
    quick: bool = flag_key(True)


@dataclass(frozen=True)
class Quick:
    """[quick]: what a short run keeps; height_m empty keeps all."""

    count: int = number_key(1, 50, 2, whole=True)
    height_m: tuple[float, ...] = list_key(number_key(0.1, 60.0, unit="m"), ())


@dataclass(frozen=True)
class Study:
    """A parametric study.

    count : motions generated for each spectrum
    natural : file of the named set of natural records (core/lab/research/natural_set.py) that is looked for in a folder
        of records; without it every record of the folder is taken
    """

    title: str = text_key("Ribalta")
    report: str = choice_key("grid", "paper", "law", default="grid")
    language: str = choice_key(*LANGUAGES, default="en")
    count: int = number_key(1, 50, 7, whole=True)
    group: tuple[Group, ...] = tables_key(Group)
    record: tuple[Record, ...] = tables_key(Record)
    natural: str | None = path_key(None)
    grid: tuple[Grid, ...] = tables_key(Grid)
    quick: Quick | None = field(default=None, metadata={"kind": "tables", "of": Quick})


@dataclass(frozen=True)
class Cell:
    """One wall of a study, its restitution (a name, or a velocity ratio as text) and how it is integrated."""

    slenderness_deg: float
    height_m: float
    mechanism: str
    restitution: str
    law: str
    method: str
    q_step: float

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

    @property
    def wall(self) -> Wall:
        """The cell as a wall of a case, whose rules it obeys. Raises InputError."""
        chosen: dict[str, object]
        if self.restitution[0].isdigit():
            chosen = {"velocity_ratio": float(self.restitution)}
        else:
            chosen = {"restitution": self.restitution}
        return parse_wall(
            {
                "name": f"{self.slenderness_deg:g} deg, {self.height_m:g} m",
                "law": self.law,
                **chosen,
                "slenderness_deg": self.slenderness_deg,
                "height_m": self.height_m,
                "mechanism": self.mechanism,
            }
        )


def cells_of(study: Study) -> dict[Cell, frozenset[str]]:
    """The cells of all grids, each once, and the motions it is put under: generated, records or both.

    Raises InputError for a cell that is no wall.
    """
    cells: dict[Cell, frozenset[str]] = {}
    for k, grid in enumerate(study.grid, start=1):
        here = place("grid", n=k)
        ratios = tuple(repr(ratio) for ratio in grid.velocity_ratio)
        models = grid.restitution + ratios or (DEFAULT_MODEL,)
        kinds = frozenset(("generated", "records") if grid.motions == "all" else (grid.motions,))
        lists = (grid.slenderness_deg, grid.height_m, grid.mechanism, models, grid.law, grid.method)
        for alpha, height, mechanism, model, law, method in product(*lists):
            if model == DEFAULT_MODEL:
                model = "one_sided_theoretical" if kinematics(mechanism).one_way else "housner"
            named = [Cell(alpha, height, mechanism, model, law, method, step) for step in grid.q_step]
            try:
                named[0].wall.restitution_of(mechanism)
            except InputError as error:
                raise error.at(here) from None
            if method == "linearised" and law != "rigid":
                name = named[0].wall.name
                raise InputError("linearised_is_rigid", place=(here,), key="method", wall=name)
            for cell in named:
                cells[cell] = cells.get(cell, frozenset()) | kinds
    return cells


def parse_study(table: dict) -> Study:
    """The study of a mapping with the keys of the file; every rule is checked here. Raises InputError."""
    refuse_unknown(Study, table, "study")
    quick = table.get("quick")
    study = parse_section(Study, {key: table[key] for key in table if key != "quick"}, "study", "study")
    if quick is not None:
        study = replace(study, quick=parse_section(Quick, quick, "quick", "[quick]"))
    if not study.grid:
        raise InputError("study_without", key="grid")
    for k, grid in enumerate(study.grid, start=1):
        for key in ("slenderness_deg", "height_m"):
            if not getattr(grid, key):
                raise InputError("study_without", place=(place("grid", n=k),), key=key)
        if grid.motions == "generated" and not study.group:
            raise InputError("study_without", place=(place("grid", n=k),), key="group")
    names: set[tuple[str, str]] = set()
    seeds: set[int] = set()
    for group in study.group:
        here = place("group", name=group.name)
        if not group.spectrum:
            raise InputError("study_without", place=(here,), key="spectrum")
        for entry in [("group", group.name), *(("spectrum", shape.name) for shape in group.spectrum)]:
            if entry in names:
                raise InputError("study_same_name", place=(here,), kind=entry[0], name=entry[1])
            names.add(entry)
        for shape in group.spectrum:
            check_code_keys(shape, here)
            own = set(range(shape.seed, shape.seed + study.count))
            if own & seeds:
                raise InputError("study_same_seed", place=(here,), name=shape.name, seed=min(own & seeds))
            seeds |= own
    cells_of(study)
    return study


@dataclass(frozen=True)
class RecordList:
    """A file of [[record]] tables alone."""

    record: tuple[Record, ...] = tables_key(Record)


def read_record_list(path: Path) -> RecordList:
    """The [[record]] tables of a TOML file, as those of a case. Raises InputError."""
    if not path.exists():
        raise InputError("study_no_records", place=(path,))
    table, _ = read_toml(path)
    try:
        record_list = parse_section(RecordList, table, "records", "records")
        if not record_list.record:
            raise InputError("study_without", key="record")
        return record_list
    except InputError as error:
        raise error.at(path) from None


def read_study(path: Path) -> tuple[Study, str]:
    """The study of a TOML file and the hash of its content. Raises InputError with the file's name."""
    if not path.exists():
        raise InputError("no_study_file", place=(path,))
    table, content = read_toml(path)
    try:
        return parse_study(table), hashlib.sha256(content).hexdigest()
    except InputError as error:
        raise error.at(path) from None


def quick_study(study: Study) -> Study:
    """The study as `--quick` makes it: fewer motions and heights, without the grids marked quick = false."""
    quick = study.quick or Quick()

    def fewer(grid: Grid) -> Grid:
        kept = tuple(height for height in grid.height_m if height in quick.height_m)
        return replace(grid, height_m=kept or grid.height_m)

    grids = tuple(fewer(grid) for grid in study.grid if grid.quick)
    return replace(study, count=min(study.count, quick.count), grid=grids)
