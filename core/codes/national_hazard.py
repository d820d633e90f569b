"""Seismic hazard of Italy by place (NTC 2018 3.2; Annexes A and B of D.M. 14/01/2008, which it keeps)."""

import bisect
import math
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.errors import InputError, place

RETURN_PERIODS = (30.0, 50.0, 72.0, 101.0, 140.0, 201.0, 475.0, 975.0, 2475.0)
"""Return periods of the table of Annex B [years]."""

USE_CLASSES = {"I": 0.7, "II": 1.0, "III": 1.5, "IV": 2.0}
"""C_U (NTC 2018 Tab. 2.4.II)."""

MIN_REFERENCE_PERIOD = 35.0
"""V_R is at least 35 years (NTC 2008 2.4.3; NTC 2018 lets it go lower: the safe side is kept)."""

EARTH_RADIUS = 6371.0088
"""Mean radius [km]."""

MILLION = 1_000_000
HAZARD_FILE = Path(__file__).resolve().parents[2] / "resources" / "hazard" / "italy.npz"

MAX_NODE_DISTANCE = 0.2
"""Degrees within which nodes of the cell of a point are looked for; cells are about 0.05 by 0.07."""


class HazardValues(NamedTuple):
    """a_g [g], F_0 [-], T_C* [s]."""

    ag_g: float
    f0: float
    tc_star_s: float


class Island(NamedTuple):
    """A group of Table 2. boxes : (south, north, west, east) [degrees]; ag in g/10, f0, tc at RETURN_PERIODS"""

    name: str
    boxes: Sequence[tuple[float, float, float, float]]
    ag: Sequence[float]
    f0: Sequence[float]
    tc: Sequence[float]


ISLANDS = (
    Island(
        "Arcipelago Toscano, Isole Egadi, Pantelleria, Sardegna, Lampedusa, Linosa, Ponza, Palmarola, Zannone",
        (
            (38.80, 41.35, 8.00, 9.90),
            (42.20, 42.45, 10.80, 11.15),
            (42.25, 43.50, 9.75, 10.48),
            (37.88, 38.06, 11.98, 12.40),
            (36.70, 36.88, 11.90, 12.08),
            (35.45, 35.58, 12.28, 12.68),
            (35.83, 35.90, 12.82, 12.92),
            (40.86, 41.00, 12.82, 13.10),
        ),
        (0.186, 0.235, 0.274, 0.314, 0.351, 0.393, 0.500, 0.603, 0.747),
        (2.61, 2.67, 2.70, 2.73, 2.78, 2.82, 2.88, 2.98, 3.09),
        (0.273, 0.296, 0.303, 0.307, 0.313, 0.322, 0.340, 0.372, 0.401),
    ),
    Island(
        "Ventotene, Santo Stefano",
        ((40.77, 40.82, 13.38, 13.48),),
        (0.239, 0.303, 0.347, 0.389, 0.430, 0.481, 0.600, 0.707, 0.852),
        (2.61, 2.61, 2.61, 2.66, 2.69, 2.71, 2.92, 3.07, 3.27),
        (0.245, 0.272, 0.298, 0.326, 0.366, 0.401, 0.476, 0.517, 0.564),
    ),
    Island(
        "Ustica, Tremiti",
        ((38.67, 38.74, 13.13, 13.22), (42.09, 42.24, 15.46, 15.78)),
        (0.429, 0.554, 0.661, 0.776, 0.901, 1.056, 1.500, 1.967, 2.725),
        (2.50,) * 9,
        (0.400,) * 9,
    ),
    Island(
        "Alicudi, Filicudi",
        ((38.52, 38.60, 14.32, 14.61),),
        (0.350, 0.558, 0.807, 1.020, 1.214, 1.460, 2.471, 3.212, 4.077),
        (2.70,) * 9,
        (0.400,) * 9,
    ),
    Island(
        "Panarea, Stromboli, Lipari, Vulcano, Salina",
        ((38.36, 38.60, 14.78, 15.01), (38.61, 38.68, 15.03, 15.13), (38.76, 38.83, 15.18, 15.26)),
        (0.618, 0.817, 0.983, 1.166, 1.354, 1.580, 2.200, 2.823, 3.746),
        (2.45, 2.48, 2.51, 2.52, 2.56, 2.56, 2.58, 2.65, 2.76),
        (0.287, 0.290, 0.294, 0.290, 0.290, 0.292, 0.306, 0.316, 0.324),
    ),
)
"""Islands off the grid (Annex A, Table 2); of those outside it, each by a rectangle that holds it."""


class Grid(NamedTuple):
    """ids : of the nodes, shape (n,); nodes : latitude, longitude [degrees], shape (n, 2); values : a_g [g/10], F_0,
    T_C* [s], shape (n, 9, 3); row_of : id -> row"""

    ids: np.ndarray
    nodes: np.ndarray
    values: np.ndarray
    row_of: dict[int, int]


class Municipality(NamedTuple):
    """name; province : its letters; province_name; latitude, longitude : of its seat [degrees]"""

    name: str
    province: str
    province_name: str
    latitude: float
    longitude: float


@cache
def grid() -> Grid:
    """The nodes of Annex B, read when first asked for."""
    with np.load(HAZARD_FILE) as data:
        ids = data["ids"]
        row_of = {int(node): k for k, node in enumerate(ids)}
        return Grid(ids, data["nodes"] / MILLION, data["values"] / MILLION, row_of)


@cache
def municipalities() -> tuple[Municipality, ...]:
    """All that are known, by name."""
    with np.load(HAZARD_FILE) as data:
        lines = data["names"].tobytes().decode().split("\n")
        seats = (data["seats"] / MILLION).tolist()
    return tuple(Municipality(*line.split("\t"), *seat) for line, seat in zip(lines, seats, strict=True))


def normalise_name(name: str) -> str:
    """A name without accents, apostrophes and case."""
    plain = "".join(c for c in unicodedata.normalize("NFKD", name) if not unicodedata.combining(c))
    return " ".join("".join(c if c.isalnum() else " " for c in plain.casefold()).split())


@cache
def _by_name() -> dict[str, list[Municipality]]:
    by_name: dict[str, list[Municipality]] = {}
    for one in municipalities():
        by_name.setdefault(normalise_name(one.name), []).append(one)
    return by_name


def _joined(name: str) -> str:
    """A folded name without spaces: "Laquila" is meant where L'Aquila is."""
    return name.replace(" ", "")


@cache
def _by_letters() -> dict[str, list[Municipality]]:
    by_letters: dict[str, list[Municipality]] = {}
    for name, ones in _by_name().items():
        by_letters.setdefault(_joined(name), []).extend(ones)
    return by_letters


@cache
def _in_order() -> tuple[list[list[Municipality]], str, str]:
    """Who is called by each name, by name; the names without spaces and with them as lines, folded once and not at
    every key typed."""
    names = sorted(_by_name())
    letters, lines = ("\n" + "\n".join(each) for each in (map(_joined, names), names))
    return [_by_name()[name] for name in names], letters, lines


@cache
def _begins_of(lines: str) -> list[int]:
    """Where each line begins, after the break before it."""
    return [at for at, letter in enumerate(lines) if letter == "\n"]


def _lines_with(lines: str, wanted: str, most: int) -> list[int]:
    """Numbers of the first lines that hold a text, which may begin with the break before the line."""
    line_numbers: list[int] = []
    begins, at = _begins_of(lines), lines.find(wanted)
    while at >= 0 and len(line_numbers) < most:
        line_numbers.append(bisect.bisect_right(begins, at) - 1)
        at = lines.find(wanted, begins[line_numbers[-1] + 1]) if line_numbers[-1] + 1 < len(begins) else -1
    return line_numbers


def search_municipalities(text: str, most: int = 20) -> list[Municipality]:
    """Municipalities whose name begins with a text, then those that hold it."""
    wanted = normalise_name(text)
    joined = _joined(wanted)
    if not wanted:
        return []
    order, letters, names = _in_order()
    first = _lines_with(letters, "\n" + joined, most)
    rows = first if len(first) >= most else [*first, *_lines_with(names, wanted, most + len(first))]
    matches = [one for row in dict.fromkeys(rows) for one in order[row]]
    return matches[:most]


def municipality(name: str, province: str = "") -> Municipality:
    """The one of a name, and of a province where it is not unique. Raises InputError."""
    namesakes = _by_name().get(normalise_name(name)) or _by_letters().get(_joined(normalise_name(name)), [])
    letters = province.strip().upper()
    kept = [
        namesake
        for namesake in namesakes
        if not letters or letters in (namesake.province, namesake.province_name.upper())
    ]
    if len(kept) == 1:
        return kept[0]
    if kept:
        provinces = ", ".join(one.province for one in kept)
        raise InputError("municipality_of_two", key="municipality", name=name, provinces=provinces)
    if namesakes:
        provinces = ", ".join(namesake.province for namesake in namesakes)
        raise InputError("municipality_elsewhere", key="province", name=name, found=province, provinces=provinces)
    if near := ", ".join(one.name for one in search_municipalities(name[:4], 3)):
        raise InputError("municipality_near", key="municipality", name=name, near=near)
    raise InputError("municipality_unknown", key="municipality", name=name)


def distance(one: Sequence[float], other: Sequence[float]) -> float:
    """Great circle between two points (latitude, longitude) [km]."""
    (a, b), (c, d) = (map(math.radians, point) for point in (one, other))
    h = math.sin(0.5 * (c - a)) ** 2 + math.cos(a) * math.cos(c) * math.sin(0.5 * (d - b)) ** 2
    return 2.0 * EARTH_RADIUS * math.asin(min(1.0, math.sqrt(h)))


@dataclass(frozen=True)
class SiteHazard:
    """The hazard of a point.

    latitude, longitude : [degrees]
    nodes : ids of the vertices of its cell, in order round it; none on an island of Table 2
    distances : to them [km]
    island : the group of Table 2, "" on the grid
    table : a_g [g/10], F_0, T_C* of each node, or of the group, at RETURN_PERIODS, shape (nodes, 9, 3)
    """

    latitude: float
    longitude: float
    nodes: tuple[int, ...]
    distances: tuple[float, ...]
    island: str
    table: np.ndarray

    def at(self, years: float) -> HazardValues:
        """Values at a return period: between those of the table by logarithms (Eq. 2), then between the nodes by the
        inverse of their distances (Eq. 3); below 30 years those of 30, above 2475 those of 2475 (NTC 2018)."""
        years = min(max(years, RETURN_PERIODS[0]), RETURN_PERIODS[-1])
        k = min(int(np.searchsorted(RETURN_PERIODS, years, side="right")) - 1, len(RETURN_PERIODS) - 2)
        share = math.log(years / RETURN_PERIODS[k]) / math.log(RETURN_PERIODS[k + 1] / RETURN_PERIODS[k])
        low, high = self.table[:, k], self.table[:, k + 1]
        of_nodes = low * (high / low) ** share
        if share in (0.0, 1.0):
            of_nodes = high if share else low
        ag, f0, tc = (of_nodes * self._weights()[:, None]).sum(axis=0).tolist()
        return HazardValues(0.1 * ag, f0, tc)

    def _weights(self) -> np.ndarray:
        if 0.0 in self.distances:
            return np.array([1.0 if d == 0.0 else 0.0 for d in self.distances])
        inverse = 1.0 / np.array(self.distances or (1.0,))
        return inverse / inverse.sum()

    @property
    def rows(self) -> list[HazardValues]:
        """Rows of the hazard at each of RETURN_PERIODS."""
        return [self.at(years) for years in RETURN_PERIODS]


def _inside(corners: np.ndarray, point: tuple[float, float]) -> bool:
    """Whether a point is in a convex quadrilateral or on its edge. corners : in order, shape (4, 2)"""
    ends = np.roll(corners, -1, axis=0)
    turns = (ends[:, 0] - corners[:, 0]) * (point[1] - corners[:, 1]) - (ends[:, 1] - corners[:, 1]) * (
        point[0] - corners[:, 0]
    )
    turns[np.abs(turns) < 1e-12] = 0.0
    return bool((turns >= 0.0).all() or (turns <= 0.0).all())


def hazard_at(latitude: float, longitude: float) -> SiteHazard:
    """The hazard of a point of Italy. Raises InputError outside the grid and its islands, with the nearest node."""
    known, point = grid(), (latitude, longitude)
    near = np.nonzero(np.abs(known.nodes - point).max(axis=1) < MAX_NODE_DISTANCE)[0]
    for k in near:
        node = int(known.ids[k])
        around = (node, node + 1, node + 223, node + 222)
        if all(one in known.row_of for one in around):
            rows = [known.row_of[one] for one in around]
            if _inside(known.nodes[rows], point):
                lengths = tuple(distance(point, known.nodes[row]) for row in rows)
                return SiteHazard(latitude, longitude, around, lengths, "", known.values[rows])
    for group in ISLANDS:
        if any(s <= latitude <= n and w <= longitude <= e for s, n, w, e in group.boxes):
            table = np.array([np.column_stack([group.ag, group.f0, group.tc])])
            return SiteHazard(latitude, longitude, (), (), group.name, table)
    lengths = [distance(point, node) for node in known.nodes]
    least = int(np.argmin(lengths))
    raise InputError(
        "outside_the_grid",
        place=(place("section", name="[site]"),),
        latitude=latitude,
        longitude=longitude,
        node=int(known.ids[least]),
        km=lengths[least],
    )


@cache
def national_range() -> tuple[tuple[float, float], tuple[float, float]]:
    """Least and largest F_0, and T_C* [s], of Annexes A and B, the islands of Table 2 among them."""
    f0, tc_star = (
        np.concatenate([grid().values[..., k].ravel(), island])
        for k, island in ((1, _islands("f0")), (2, _islands("tc")))
    )
    return (float(f0.min()), float(f0.max())), (float(tc_star.min()), float(tc_star.max()))


def _islands(name: str) -> np.ndarray:
    return np.array([getattr(island, name) for island in ISLANDS]).ravel()


def reference_life(nominal_life: float, use_class: str) -> float:
    """V_R [years] = V_N C_U (NTC 2018 2.4.3), at least MIN_REFERENCE_PERIOD."""
    return max(nominal_life * USE_CLASSES[use_class], MIN_REFERENCE_PERIOD)
