"""A drawing (DXF) read: its closed shapes and its open outlines by layer (resources/docs/case.md)."""

import hashlib
import io
import itertools
import logging
import math
import re
import struct
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from core.case.drawing_outlines import (
    MAX_CHORDS,
    MAX_POINTS,
    Gap,
    Point,
    drop_duplicates,
    expand_bulges,
    gaps_of,
    is_longer,
    join_lines,
    refuse_many,
    simple,
)
from core.errors import InputError
from core.packages import require
from core.regular_file import TooLarge, read_regular

DRAWING_UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
"""Unit of a drawing -> [m]."""

INSUNITS = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m"}
"""$INSUNITS of the header -> unit."""

DRAWING_TOLERANCE = 1e-3
"""What a chord may be off its arc, and the ends of two lines apart that are to meet [m]: a tenth of what a survey of
masonry is good for. Of a rose window of 4 m it leaves out 0.07 % of the area."""

MIN_CORNER_DISTANCE = 1e-6
"""Corners nearer than this are one [m]."""

MAX_DRAWING_BYTES = 20_000_000
"""Largest size of a file [bytes]: sheets of a building have a quarter; ezdxf takes a second and some 20 times the
memory for each MB."""

MAX_ENTITIES, INSERTED, IN_BLOCK = 100_000, 5, 20_000
"""Entities of a drawing with its blocks opened; for how many an inserted block counts, which takes as long to place;
corners of one line of a block, which ezdxf places in the square of their number."""

MAX_RADIUS = 1e7
"""Largest radius of a circle, in tolerances: 10 km."""

DEEPEST = 20
"""Blocks inside one another: one that holds itself has no end."""

MAX_WALL_SIZE, MIN_WALL_SIZE = 300.0, 0.05
"""Size of a wall beyond which the unit is another one, and below which [m]."""

USUAL_SIZE, MAX_SIZE_FACTOR = 8.0, 10.0
"""Size of a wall by which a unit is guessed [m], and the factor beyond which none is."""

BINARY = b"AutoCAD Binary DXF"


SPECK = "speck"
"""Kind of a stroke shorter than the tolerance that closes gaps, which is no outline."""

ANNOTATIONS = {
    *("TEXT", "MTEXT", "ATTRIB", "ATTDEF", "DIMENSION", "ARC_DIMENSION", "LARGE_RADIAL_DIMENSION", "LEADER"),
    *("MULTILEADER", "MLEADER", "TOLERANCE", "POINT", "VIEWPORT", "ACAD_TABLE", "RAY", "XLINE", "IMAGE", "OLE2FRAME"),
    *("SUN", "LIGHT", "GEODATA", "invisible", "hidden layer", "small CIRCLE", SPECK),
}
"""Entities that are no part of a body."""

READ = ("LINE", "CIRCLE", "ARC", "ELLIPSE", "SPLINE", "LWPOLYLINE", "HATCH", "MPOLYGON")
"""Entities that are read, besides flat polylines."""


class Tilted(Exception):
    """An entity that does not lie in the plane of the drawing."""


class Shape(NamedTuple):
    """A closed outline. corners : each once, in the unit of the drawing"""

    layer: str
    corners: tuple[Point, ...]

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Smallest x and y, largest x and y."""
        xs, ys = zip(*self.corners, strict=True)
        return min(xs), min(ys), max(xs), max(ys)


class Unread(NamedTuple):
    """Entities of a layer that are not read. kind : their type in DXF, or why: XREF, XCLIP, tilted, hidden"""

    layer: str
    kind: str
    n: int

    @property
    def is_ground(self) -> bool:
        """Whether they may be a part of a body: no text, mark or dimension."""
        return self.kind not in ANNOTATIONS

    def __str__(self) -> str:
        return f"{self.layer}: {self.n} {self.kind}"


class Sheet(NamedTuple):
    """What a drawing holds.

    shapes, gaps, unread : by layer, in the order of the drawing
    layers : names of all
    stated : unit of its header, None where it says none; unit : by which it was read, a guess where none is known
    lines : (layer, points) of all that is read
    """

    shapes: tuple[Shape, ...]
    gaps: tuple[Gap, ...]
    unread: tuple[Unread, ...]
    layers: tuple[str, ...]
    stated: str | None
    unit: str
    lines: tuple[tuple[str, tuple[Point, ...]], ...] = ()


class DxfFile:
    """A drawing in memory. Raises InputError for what is none, OutputError without ezdxf."""

    def __init__(self, path: Path):
        content = _content(path)
        self.sha256 = hashlib.sha256(content).hexdigest()
        if content.startswith(b"AC10"):
            raise InputError("drawing_dwg", place=(path,))
        require("dxf")
        import ezdxf

        logging.getLogger("ezdxf").addHandler(logging.NullHandler())  # else it writes to the terminal
        try:
            if not content.startswith(BINARY) and not content.rstrip(b"\0\r\n\t \x1a").endswith(b"EOF"):
                raise ValueError  # ezdxf reads what was cut off at the end of a tag
            self.document, self._unread = _read_whole(path, content)
            hidden = [layer for layer in self.document.layers if layer.is_off() or layer.is_frozen()]
            self._hidden = {layer.dxf.name.casefold() for layer in hidden}
            self._frozen = {layer.dxf.name.casefold() for layer in hidden if layer.is_frozen()}
            self._entities = tuple(self._opened(self.document.modelspace()))
            said = int(self.document.header.get("$INSUNITS", 0)) if b"$INSUNITS" in content else 0  # ezdxf says m
            self.stated = INSUNITS.get(said)
            self.layers = tuple(sorted({layer.dxf.name for layer in self.document.layers} | self._used()))
        except InputError as error:
            raise error.at(path) from None
        except DAMAGED + (ezdxf.DXFError,) as error:
            reason = str(error).strip().splitlines() or [type(error).__name__]
            raise InputError("drawing_damaged", reason=reason[0][:120], place=(path,)) from None
        self.path = path

    def _used(self) -> set[str]:
        return {layer for layer, _ in self._entities} | {layer for layer, _ in self._unread}

    def _opened(self, entities: Iterable) -> Iterator[tuple[str, Any]]:
        """(layer, entity), blocks opened: what is on layer 0 of a block is on that of the block."""
        entities_seen, corners_seen, placed = 0, 0, set[str]()

        def counted(entity: Any) -> None:
            nonlocal entities_seen, corners_seen
            entities_seen += INSERTED if entity.dxftype() == "INSERT" else 1
            if entities_seen > MAX_ENTITIES:
                raise InputError("drawing_too_much", most=MAX_ENTITIES)
            corners_seen += _corners(entity)
            refuse_many(corners_seen)
            if entity.dxftype() == "INSERT" and (block := entity.block()) is not None and block.name not in placed:
                if max(map(_corners, block), default=0) > IN_BLOCK:
                    raise InputError("drawing_too_many_points", most=IN_BLOCK)
                placed.add(block.name)

        def within(entities: Iterable, layer: str | None, depth: int) -> Iterator[tuple[str, Any]]:
            for entity in entities:
                counted(entity)
                own = entity.dxf.get("layer", "0")
                own = layer if own == "0" and layer is not None else own
                why = self._left_out(entity, own)
                if entity.dxftype() != "INSERT":
                    if why:
                        self._unread[own, why] += 1
                    else:
                        yield own, entity
                elif depth < DEEPEST and why != "XREF":
                    if entity.mcount > MAX_ENTITIES:
                        raise InputError("drawing_too_much", most=MAX_ENTITIES)
                    if entity.dxf.get("zscale", 1.0) == 0.0:
                        entity.dxf.zscale = 1.0  # flattened to the plane of the drawing
                    for one in entity.multi_insert() if entity.mcount > 1 else (entity,):
                        inner = within(one.virtual_entities(), own, depth + 1)
                        if why:
                            self._unread.update((place, why) for place, _ in inner)
                        else:
                            yield from inner
                else:
                    self._unread[own, why or "INSERT"] += 1

        return within(entities, None, 0)

    def _left_out(self, entity: Any, layer: str) -> str:
        """Why an entity is not read; "" where it is."""
        kind = entity.dxftype()
        if entity.dxf.get("invisible", 0):
            return "invisible"
        hidden = self._frozen if kind == "INSERT" else self._hidden  # a block on a layer that is off is shown
        if layer.casefold() in hidden:
            return "hidden layer"
        if kind == "INSERT":
            block = entity.block()
            if block is None or block.block.is_xref or block.block.is_xref_overlay:
                return "XREF"
            from ezdxf.xclip import XClip

            clip = XClip(entity)
            return "XCLIP" if clip.has_clipping_path and clip.is_clipping_enabled else ""
        if kind == "POLYLINE" and entity.get_mode() in ("AcDb2dPolyline", "AcDb3dPolyline"):
            return ""
        if kind == "POLYLINE":
            return "MESH"
        return "" if kind in READ else kind

    def sheet(self, unit: str | None = None) -> Sheet:
        """Read the sheet in this unit, else in that of its header, else in the likely one. Raises InputError."""
        unit = unit or self.stated
        if unit is None:
            shapes = self._shapes(0.1)[0]  # of any unit good enough for its size
            unit = likely_unit(largest(shapes)) or "m"
        shapes, gaps, unread, lines = self._shapes(DRAWING_TOLERANCE / DRAWING_UNITS[unit])
        ledger = tuple(Unread(layer, kind, unread[layer, kind]) for layer, kind in sorted(unread))
        return Sheet(tuple(shapes), tuple(gaps), ledger, self.layers, self.stated, unit, lines)

    def _shapes(self, tolerance: float) -> tuple[list[Shape], list[Gap], Counter, tuple]:
        import ezdxf

        unread = self._unread.copy()
        pieces: dict[str, list[list[Point]]] = {}
        points = 0
        try:
            for layer, entity in self._entities:
                try:
                    lines = list(_lines(entity, tolerance))
                except Tilted:
                    unread[layer, f"tilted {entity.dxftype()}"] += 1
                    continue
                except (*DAMAGED, ezdxf.DXFError):
                    unread[layer, f"damaged {entity.dxftype()}"] += 1
                    continue
                if not lines:
                    unread[layer, f"small {entity.dxftype()}"] += 1
                for line in lines:
                    points += len(line)
                    refuse_many(points)
                    if not all(math.isfinite(number) and abs(number) < 1e12 for point in line for number in point):
                        raise ValueError("coordinates")
                    if len(line) > 1:
                        pieces.setdefault(layer, []).append(line)
        except InputError as error:
            raise error.at(self.path) from None
        except (*DAMAGED, ezdxf.DXFError) as error:
            raise InputError("drawing_damaged", reason=str(error)[:120], place=(self.path,)) from None
        shapes, gaps, least = [], [], tolerance * MIN_CORNER_DISTANCE / DRAWING_TOLERANCE
        for layer, lines in pieces.items():
            closed, loose = join_lines(drop_duplicates(lines), tolerance)
            seen = set()
            for outline in closed:
                corners = tuple(simple(outline, least))
                known = frozenset((round(x / tolerance), round(y / tolerance)) for x, y in corners)
                if len(corners) > 2 and known not in seen:  # a hatch and its border are one
                    seen.add(known)
                    shapes.append(Shape(layer, corners))
            outlines = [line for line in loose if is_longer(line, tolerance)]
            if len(outlines) < len(loose):
                unread[layer, SPECK] += len(loose) - len(outlines)
            gaps += gaps_of(layer, outlines)
        drawn = tuple((layer, tuple(line)) for layer, lines in pieces.items() for line in lines)
        return shapes, gaps, unread, drawn


DAMAGED = (
    ValueError,
    LookupError,
    TypeError,
    AttributeError,
    ArithmeticError,
    RecursionError,
    StopIteration,
    AssertionError,
    OSError,
    struct.error,
)
"""Errors that a reader of damaged files raises."""


_NO_SUBCLASS = re.compile(r"missing '(?P<subclass>\w+)' subclass in (?P<kind>\w+)")

MAX_BROKEN_KINDS = 8
"""Kinds of entities without their subclass of which a drawing is freed."""


def _read_whole(path: Path, content: bytes) -> tuple[Any, Counter]:
    """The document of a drawing, and what of it was left out to read the rest: entities that do not say what they are,
    (layer, kind) with their number. Raises DXFError and those of DAMAGED."""
    import ezdxf
    from ezdxf.filemanagement import dxf_file_info

    left: Counter[tuple[str, str]] = Counter()
    text = ""
    for _ in range(MAX_BROKEN_KINDS):
        try:
            return (ezdxf.read(io.StringIO(text)) if text else ezdxf.readfile(path)), left
        except ezdxf.DXFStructureError as error:
            broken = _NO_SUBCLASS.search(str(error))
            if broken is None or content.startswith(BINARY):
                raise
            text = text or content.decode(dxf_file_info(path).encoding, errors="surrogateescape")
            text, without = _drop_broken(text, broken["kind"], broken["subclass"])
            if not without:
                raise
            left += without
    raise ValueError("subclass")


def _drop_broken(text: str, kind: str, subclass: str) -> tuple[str, Counter]:
    """A drawing without the entities of a kind that lack a subclass; how many there were, by layer and kind."""
    lines = text.splitlines()
    starts = [k for k in range(0, len(lines) - 1, 2) if lines[k].strip() == "0"]
    kept, left = lines[: starts[0]] if starts else lines, Counter[tuple[str, str]]()
    for start, end in itertools.pairwise([*starts, len(lines)]):
        tags = [(lines[k].strip(), lines[k + 1].strip()) for k in range(start, end - 1, 2)]
        if tags[:1] == [("0", kind)] and ("100", subclass) not in tags:
            layer = next((value for code, value in tags if code == "8"), "0")
            left[layer, f"damaged {kind}"] += 1
        else:
            kept += lines[start:end]
    return "\n".join([*kept, ""]), left


def _content(path: Path) -> bytes:
    try:
        if not path.is_file():
            raise InputError("no_drawing", place=(path,))
        return read_regular(path, MAX_DRAWING_BYTES)
    except TooLarge as error:
        raise InputError(
            "drawing_too_large", mb=error.size / 1e6, most=MAX_DRAWING_BYTES / 1e6, place=(path,)
        ) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None


def _lines(entity: Any, tolerance: float) -> Iterator[list[Point]]:
    """The lines of an entity: a closed one ends where it begins."""
    kind = entity.dxftype()
    if kind == "LINE":
        yield _flat((entity.dxf.start, entity.dxf.end), tolerance)
    elif kind in ("CIRCLE", "ARC"):
        if not tolerance < entity.dxf.radius < MAX_RADIUS * tolerance:  # a mark, or nothing of a wall
            return
        yield _flat(entity.flattening(tolerance), tolerance)
    elif kind == "ELLIPSE":
        yield _flat(_few(entity.flattening(tolerance)), tolerance)
    elif kind == "SPLINE":
        yield _flat(_spline(entity, tolerance), tolerance)
    elif kind == "LWPOLYLINE":
        yield _in_world(entity, expand_bulges(entity.get_points("xyb"), entity.closed, tolerance), tolerance)
    elif kind == "POLYLINE" and entity.get_mode() in ("AcDb2dPolyline", "AcDb3dPolyline"):
        corners = [
            (vertex.dxf.location.x, vertex.dxf.location.y, vertex.dxf.get("bulge", 0.0))
            for vertex in entity.vertices
            if not vertex.dxf.get("flags", 0) & 16  # a control point of the curve through the others
        ]
        line = expand_bulges(corners, entity.is_closed, tolerance)
        if not entity.is_2d_polyline:
            _flat((vertex.dxf.location for vertex in entity.vertices), tolerance)
        yield _in_world(entity, line, tolerance) if entity.is_2d_polyline else line
    elif kind in ("HATCH", "MPOLYGON"):
        for path in entity.paths:
            for line in _border(path, tolerance):
                yield _in_world(entity, line, tolerance)


def _spline(entity: Any, tolerance: float) -> list:
    """Points of a spline: of a periodic one, whose ends are no control points, within the knots on which it is
    defined, divided until no chord is farther from it than a tolerance."""
    curve = entity.construction_tool()
    if curve.is_clamped:
        return _few(entity.flattening(tolerance))
    knots, degree = curve.knots(), curve.degree
    start, end, parts = knots[degree], knots[-degree - 1], 32
    while True:
        points = list(curve.points(start + (end - start) * k / (2 * parts) for k in range(2 * parts + 1)))
        off = max(a.lerp(b).distance(m) for a, m, b in zip(points[::2], points[1::2], points[2::2], strict=False))
        if off <= tolerance:
            return points
        if parts > MAX_CHORDS:
            raise ValueError("spline")
        parts *= 2


def _few(points: Iterable) -> list:
    """Points of a curve, no more of them than a drawing may have."""
    few = list(itertools.islice(points, MAX_POINTS + 1))
    refuse_many(len(few))
    return few


def _corners(entity: Any) -> int:
    """How many corners an entity has before its curves are divided."""
    kind = entity.dxftype()
    if kind == "LWPOLYLINE":
        return len(entity)
    if kind == "POLYLINE":
        return len(entity.vertices)
    if kind == "SPLINE":
        return len(entity.control_points) + len(entity.fit_points)
    if kind in ("HATCH", "MPOLYGON"):
        return sum(len(getattr(path, "vertices", None) or path.edges) for path in entity.paths)
    return 1


def _border(path: Any, tolerance: float) -> Iterator[list[Point]]:
    """The lines of a border of a hatch."""
    if hasattr(path, "vertices"):
        yield expand_bulges(path.vertices, True, tolerance)
        return
    lines = []
    for edge in path.edges:
        if edge.EDGE_TYPE == "LineEdge":
            lines.append(_flat((edge.start, edge.end)))
        else:
            lines.append(_flat(_few(edge.construction_tool().flattening(tolerance))))
        refuse_many(sum(map(len, lines)))
    closed, loose = join_lines(drop_duplicates(lines), tolerance)
    yield from ([*outline, outline[0]] for outline in closed)
    yield from loose


def _flat(points: Iterable, tolerance: float | None = None) -> list[Point]:
    """Points in the plane of the drawing. Raises Tilted where their heights differ by more than a tolerance."""
    corners = [(float(point[0]), float(point[1]), float(point[2]) if len(point) > 2 else 0.0) for point in points]
    if tolerance is not None and corners:
        heights = [z for _, _, z in corners]
        if max(heights) - min(heights) > tolerance:
            raise Tilted
    return [(x, y) for x, y, _ in corners]


def _in_world(entity: Any, points: list[Point], tolerance: float) -> list[Point]:
    """Points of the plane of an entity in that of the drawing: a mirrored one looks from behind."""
    ocs = entity.ocs()
    return _flat(ocs.points_to_wcs((x, y, 0.0) for x, y in points), tolerance) if ocs.transform else points


def largest(shapes: Iterable[Shape]) -> float:
    """Width or height of all shapes together, the larger one; 0 without any."""
    extents = [shape.extent for shape in shapes]
    if not extents:
        return 0.0
    low_x, low_y, high_x, high_y = zip(*extents, strict=True)
    return max(max(high_x) - min(low_x), max(high_y) - min(low_y))


def likely_unit(size: float) -> str | None:
    """The metric unit by which a size [of the drawing] is nearest to that of a wall; None where none is near."""
    off = (
        {unit: abs(math.log(size * DRAWING_UNITS[unit] / USUAL_SIZE)) for unit in ("m", "cm", "mm")}
        if size > 0.0
        else {}
    )
    best = min(off, key=lambda unit: off[unit], default=None)
    return best if best and off[best] <= math.log(MAX_SIZE_FACTOR) else None
