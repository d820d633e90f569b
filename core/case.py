"""The case: what the user asks. Keys, ranges, defaults and names in one place, for form and file."""

import datetime
import difflib
import hashlib
import json
import math
import tomllib
from dataclasses import MISSING, asdict, dataclass, field, fields, replace
from pathlib import Path

from core.block import Block
from core.errors import InputError
from core.moment_rotation import LAWS, MomentLaw
from core.restitution import MODELS, Restitution, restitution
from core.rocking import METHODS

MAX_TEXT = 500

LEAST_ELASTIC = 0.001
"""Smallest D1 of a trilinear law: below it the branch is rigid in all but cost."""


def _number(low, high, default=None, unit="", exclusive=False, whole=False):
    """A number in [low, high] (low excluded if exclusive), NaN and infinity refused."""
    kind = "int" if whole else "float"
    rule = {"kind": kind, "low": low, "high": high, "unit": unit, "exclusive": exclusive}
    return field(default=default, metadata=rule)


def _text(default=""):
    return field(default=default, metadata={"kind": "text"})


def _choice(*names, default=MISSING):
    return field(default=default, metadata={"kind": "choice", "names": names})


@dataclass(frozen=True)
class Report:
    """[report]: what the title block of the workbook says."""

    client: str = _text()
    site: str = _text()
    project: str = _text()
    author: str = _text()
    revision: str = _text()
    date: str = _text()
    language: str = _choice("en", "it", default="en")


@dataclass(frozen=True)
class Wall:
    """[[wall]]: geometry, mechanism, restitution, moment law."""

    name: str = _text(MISSING)
    mechanism: str = _choice("one_sided", "two_sided", "both")
    height_m: float | None = _number(0.1, 60.0, unit="m")
    thickness_m: float | None = _number(0.005, 20.0, unit="m")
    slenderness_deg: float | None = _number(0.05, 60.0, unit="deg")
    height_over_thickness: float | None = _number(0.5, 1000.0)
    radius_m: float | None = _number(0.05, 60.0, unit="m")
    inertia_over_mass_m2: float | None = _number(0.0025, 20000.0, unit="m2")
    restitution: str | None = _choice(*MODELS, default=None)
    velocity_ratio: float | None = _number(0.0, 1.0)
    law: str | dict = field(default="rigid", metadata={"kind": "law"})

    def block(self) -> Block:
        """Raises InputError for a wall without exactly one geometry."""
        shape = ("thickness_m", "slenderness_deg", "height_over_thickness")
        given = [key for key in shape if getattr(self, key) is not None]
        if self.radius_m is not None or self.inertia_over_mass_m2 is not None:
            if self.height_m is not None or given != ["slenderness_deg"]:
                raise InputError(
                    f'wall "{self.name}": a general block takes radius_m, slenderness_deg and '
                    "inertia_over_mass_m2 and nothing else; a rectangular one takes height_m"
                )
            if self.radius_m is None or self.inertia_over_mass_m2 is None:
                raise InputError(
                    f'wall "{self.name}": a general block needs radius_m and inertia_over_mass_m2'
                )
            return Block(
                math.radians(self.slenderness_deg), self.radius_m, self.inertia_over_mass_m2
            )
        if self.height_m is None or len(given) != 1:
            found = ", ".join(given) or "none"
            raise InputError(
                f'wall "{self.name}": give height_m and exactly one of {", ".join(shape)} '
                f"(found: height_m {'given' if self.height_m else 'missing'}; {found})"
            )
        if self.thickness_m is not None:
            alpha = math.atan2(self.thickness_m, self.height_m)
        elif self.slenderness_deg is not None:
            alpha = math.radians(self.slenderness_deg)
        else:
            alpha = math.atan(1.0 / self.height_over_thickness)
        return Block.rectangle(self.height_m, alpha)

    def mechanisms(self) -> tuple[str, ...]:
        return ("two_sided", "one_sided") if self.mechanism == "both" else (self.mechanism,)

    def restitution_of(self, mechanism: str) -> Restitution:
        """Restitution for one mechanism: as asked, else the default that follows the mechanism."""
        model = self.restitution or ("user" if self.velocity_ratio is not None else None)
        if model is None:
            model = "one_sided_theoretical" if mechanism == "one_sided" else "housner"
        if model.startswith("one_sided") and mechanism == "two_sided":
            raise InputError(
                f'wall "{self.name}": restitution {model} is for one_sided walls; for mechanism '
                f"{self.mechanism} take housner, sorrentino_experimental, costa_upper or user, "
                "or write two walls"
            )
        if (model == "user") != (self.velocity_ratio is not None):
            raise InputError(
                f'wall "{self.name}": velocity_ratio goes with restitution "user" (or with none), '
                f"and restitution user needs it"
            )
        return restitution(self.block(), model, self.velocity_ratio)

    def moment_law(self) -> MomentLaw:
        if isinstance(self.law, str):
            return LAWS[self.law]
        return MomentLaw(self.law["elastic_limit"], self.law["plateau_end"])


@dataclass(frozen=True)
class Record:
    """[[record]]: a file or a glob, and only what the file does not say."""

    file: str = _text(MISSING)
    unit: str | None = _choice("g", "m/s2", "cm/s2", "mm/s2", default=None)
    time_step_s: float | None = _number(1e-5, 0.5, unit="s")
    column: int | None = _number(1, 100, whole=True)
    skip_lines: int | None = _number(0, 1000, whole=True)
    scale: float = _number(-1000.0, 1000.0, 1.0)
    kind: str = _choice("natural", "artificial", "simulated", default="natural")


@dataclass(frozen=True)
class Analysis:
    """[analysis]: method and search."""

    method: str = _choice("auto", *METHODS, default="auto")
    q_step: float = _number(1e-4, 0.1, 0.005)
    q_limit: float = _number(1.5, 1000.0, 100.0)
    map_span: float = _number(1.0, 10.0, 2.0)
    robust_window: float = _number(0.01, 0.5, 0.10)
    polarity: str = _choice("both", "as_recorded", "reversed", default="both")


@dataclass(frozen=True)
class Demand:
    """[demand]: the motion asked of the wall; ag_g on rock, without soil_factor."""

    ag_g: float = _number(0.001, 5.0, MISSING, unit="g")
    limit_state: str = _choice("SLV", "SLC", "SLD", default="SLV")
    soil_factor: float = _number(0.5, 5.0, 1.0)
    housner_intensity_cm: float | None = _number(0.1, 5000.0, unit="cm")
    q_code: float = _number(1.0, 10.0, 2.0)


@dataclass(frozen=True)
class Case:
    """One study. sha256 : of the file it was read from, else of its content; given : places
    (section, index, key) the user wrote."""

    title: str = _text("Ribalta")
    report: Report = field(default_factory=Report)
    wall: tuple[Wall, ...] = ()
    record: tuple[Record, ...] = ()
    analysis: Analysis = field(default_factory=Analysis)
    demand: Demand | None = None
    sha256: str = field(default="", compare=False)
    given: frozenset = field(default=frozenset(), compare=False)

    def as_dict(self) -> dict:
        """Keys and values as in the file, defaults filled, None where nothing is given."""
        content = asdict(self)
        del content["sha256"], content["given"]
        return content

    def differing(self) -> set[tuple]:
        """Places (section, index, key) whose value differs from the default."""
        found = set()
        for section, items in (("wall", self.wall), ("record", self.record),
                               ("report", [self.report]), ("analysis", [self.analysis]),
                               ("demand", [self.demand] if self.demand else [])):  # fmt: skip
            for index, item in enumerate(items):
                for entry in fields(item):
                    if entry.default is MISSING or getattr(item, entry.name) != entry.default:
                        found.add((section, index, entry.name))
        return found


LATER = {
    "case": ("walls", "generate"),
    "wall": ("hinge_setback_m", "base_z_m", "length_m", "unit_weight_kn_m3", "back_restraint",
             "unloaded_confirmed"),
    "record": ("channel",),
    "analysis": ("accuracy",),
    "demand": ("spectrum", "spectrum_file", "confidence_factor", "demand_scaling", "zeta_target"),
    "report": (),
}  # fmt: skip
"""Keys of the contract whose work is not built yet: refused, never ignored."""


def read_case(path: Path) -> Case:
    """The case of a TOML file. Raises InputError naming file, place, value and what is accepted."""
    try:
        if path.exists() and not path.is_file():
            raise InputError(f"{path}: this is not a file and cannot be read: name a case (.toml)")
        content = path.read_bytes()
    except FileNotFoundError:
        raise InputError(f"{path}: there is no such case file") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    try:
        table = tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise InputError(f"{path}: not UTF-8 text: a case file is TOML, see the examples") from None
    except (ValueError, RecursionError) as error:
        reason = str(error).split("; use sys")[0]
        raise InputError(
            f"{path}: not TOML: {reason}; see the examples in resources/cases"
        ) from None
    try:
        return replace(parse_case(table), sha256=hashlib.sha256(content).hexdigest())
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def parse_case(table: dict) -> Case:
    """The case of a mapping with the keys of the file; every rule is checked here, once."""
    _known(Case, table, "case", "case")
    title = _value(_field(Case, "title"), table.get("title", "Ribalta"), "title")
    walls = [
        _section(Wall, entry, "wall", f'wall "{_name(entry, k)}"')
        for k, entry in enumerate(_tables(table, "wall"))
    ]
    if not walls:
        raise InputError("no [[wall]]: a case needs at least one wall")
    names = [wall.name for wall in walls]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f'two walls have the same name "{name}": names must differ')
    for wall in walls:
        try:
            for mechanism in wall.mechanisms():
                wall.restitution_of(mechanism)
            wall.moment_law()
        except InputError as error:
            place = f'wall "{wall.name}": '
            raise InputError(place + str(error).removeprefix(place)) from None
    analysis = _section(Analysis, table.get("analysis", {}), "analysis", "[analysis]")
    if round(analysis.robust_window / math.log1p(analysis.q_step)) < 1:
        raise InputError(
            f"[analysis]: robust_window = {analysis.robust_window:g} is narrower than one step of q_step = "
            f"{analysis.q_step:g}: widen the window or take a finer step"
        )
    for wall in walls:
        if analysis.method == "linearised" and not wall.moment_law().is_rigid:
            raise InputError(
                f'[analysis]: method linearised is for the rigid law; wall "{wall.name}" is '
                "trilinear: take method auto"
            )
    records = [
        _section(Record, entry, "record", f"record {k + 1}")
        for k, entry in enumerate(_tables(table, "record"))
    ]
    for k, record in enumerate(records):
        if record.scale == 0.0:
            raise InputError(f"record {k + 1}: scale = 0 is not accepted: other than 0")
    demand = table.get("demand")
    case = Case(
        title=title,
        report=_section(Report, table.get("report", {}), "report", "[report]"),
        wall=tuple(walls),
        record=tuple(records),
        analysis=analysis,
        demand=_section(Demand, demand, "demand", "[demand]") if demand is not None else None,
    )
    digest = hashlib.sha256(json.dumps(case.as_dict(), sort_keys=True).encode()).hexdigest()
    return replace(case, sha256=digest, given=frozenset(_written(table)))


def _written(table: dict):
    """Places (section, index, key) the user wrote."""
    for section in ("wall", "record", "report", "analysis", "demand"):
        items = table.get(section) or []
        for index, item in enumerate(items if isinstance(items, (list, tuple)) else [items]):
            for key in item:
                yield section, index, key


def _tables(table: dict, key: str) -> list:
    entries = table.get(key, [])
    if not isinstance(entries, (list, tuple)):
        raise InputError(f"{key} must be written [[{key}]], once for each")
    return list(entries)


def _name(entry, index: int):
    return entry.get("name", index + 1) if isinstance(entry, dict) else index + 1


def _field(cls, key: str):
    return next(entry for entry in fields(cls) if entry.name == key)


def _known(cls, table: dict, section: str, place: str) -> None:
    keys = [entry.name for entry in fields(cls) if entry.name not in ("sha256", "given")]
    for key in table:
        if key in LATER[section]:
            raise InputError(f"{place}: {key} is not built yet in this version: leave it out")
        if key not in keys:
            near = difflib.get_close_matches(key, keys + list(LATER[section]), 1)
            hint = f"; did you mean {near[0]}?" if near else f"; known: {', '.join(keys)}"
            raise InputError(f"{place}: unknown key {key!r}{hint}")


def _section(cls, table, section: str, place: str):
    if not isinstance(table, dict):
        raise InputError(f"{place} must be a table of keys, not {table!r}")
    _known(cls, table, section, place)
    values = {}
    for entry in fields(cls):
        if entry.name in table:
            values[entry.name] = _value(entry, table[entry.name], f"{place}: {entry.name}")
        elif entry.default is MISSING:
            rule = _accepted(entry)
            raise InputError(f"{place}: {entry.name} is missing: it is required ({rule})")
    return cls(**values)


def _accepted(entry) -> str:
    rule = entry.metadata
    if rule["kind"] == "choice":
        return "one of " + ", ".join(rule["names"])
    if rule["kind"] in ("float", "int"):
        bracket = "above" if rule["exclusive"] else "from"
        unit = f" {rule['unit']}" if rule["unit"] else ""
        whole = "a whole number " if rule["kind"] == "int" else ""
        return f"{whole}{bracket} {rule['low']:g} to {rule['high']:g}{unit}"
    if rule["kind"] == "law":
        return f"one of {', '.join(LAWS)}, or {{ elastic_limit = ..., plateau_end = ... }}"
    return f"text in quotes, up to {MAX_TEXT} characters, without control characters"


def _value(entry, value, place: str):
    """One value checked against its field; raises InputError with place, value, accepted."""
    rule = entry.metadata
    kind = rule["kind"]
    if kind in ("float", "int"):
        fits = isinstance(value, (int, float) if kind == "float" else int)
        if fits and not isinstance(value, bool):
            above = value > rule["low"] if rule["exclusive"] else value >= rule["low"]
            if above and value <= rule["high"]:  # NaN is neither
                return float(value) if kind == "float" else value
    elif kind == "choice":
        if isinstance(value, str) and value in rule["names"]:
            return value
    elif kind == "text":
        if isinstance(value, datetime.date):
            value = value.isoformat()
        printable = isinstance(value, str) and all(letter.isprintable() for letter in value)
        if printable and len(value) <= MAX_TEXT and (value or entry.default is not MISSING):
            return value
    elif kind == "law":
        if isinstance(value, str) and value in LAWS:
            return value
        if isinstance(value, dict) and sorted(value) == ["elastic_limit", "plateau_end"]:
            ends = list(value.values())
            if all(isinstance(end, (int, float)) and not isinstance(end, bool) for end in ends):
                first, last = value["elastic_limit"], value["plateau_end"]
                if LEAST_ELASTIC <= first <= last < 1.0:
                    return {"elastic_limit": float(first), "plateau_end": float(last)}
                raise InputError(
                    f"{place} = {value!r} is not accepted: {LEAST_ELASTIC:g} <= elastic_limit <= "
                    "plateau_end < 1"
                )
    raise InputError(f"{place} = {value!r} is not accepted: {_accepted(entry)}")
