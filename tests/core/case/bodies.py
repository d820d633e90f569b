"""Random bodies, each written in as many ways as there are."""

import itertools
from pathlib import Path

import numpy as np

HEIGHT = 9.0
BASE = {"name": "w", "mechanism": "one_sided", "base_z_m": 0.0, "height_m": HEIGHT, "unit_weight_kn_m3": 18.0}
BASE |= {"hold": [{"kind": "cross_walls", "evidence": {"kind": "drawing"}}], "unloaded_confirmed": True}


def _cm(value) -> float:
    return round(float(value), 2)


def random_body(rng: np.random.Generator) -> dict:
    """Storeys (low, high, outer, inner), rectangles of openings through the whole thickness (s0, s1, z0, z1), a length
    and a gable on the last storey, or 0 [m]."""
    count = int(rng.integers(1, 4))
    cuts = sorted({_cm(z) for z in rng.uniform(0.8, HEIGHT - 0.8, count - 1)})
    heights = [0.0, *cuts, HEIGHT]
    length, outer, inner = _cm(rng.uniform(2.0, 12.0)), 0.0, _cm(rng.uniform(0.4, 1.2))
    storeys = []
    for low, high in itertools.pairwise(heights):
        storeys.append((low, high, outer, inner))
        which = rng.integers(4)
        thinner = inner - outer - 0.02 if inner - outer < 0.3 else rng.uniform(0.2, inner - outer - 0.02)
        less = _cm(inner - outer - thinner)
        outer, inner = (_cm(outer + (less if which == 0 else 0.0)), _cm(inner - (less if which == 1 else 0.0)))
        if which == 2:
            outer, inner = _cm(outer + round(less / 4, 2)), _cm(inner - round(less / 4, 2))
        if which == 3 and rng.random() < 0.5:  # it overhangs
            outer = _cm(outer - 0.1)
    gable = _cm(rng.uniform(0.5, 0.9 * (HEIGHT - heights[-2]))) if rng.random() < 0.3 else 0.0
    openings = []
    for column in range(int(rng.integers(0, 3))):
        left = _cm(0.3 + column * 0.5 * length)
        width = _cm(rng.uniform(0.2, 0.5 * length - 0.5))
        for z in np.arange(rng.uniform(0.0, 1.5), HEIGHT - gable - 1.5, rng.uniform(2.5, 4.0)):
            bottom = _cm(z) if rng.random() < 0.8 or openings else 0.0
            openings.append((left, _cm(left + width), bottom, _cm(bottom + rng.uniform(0.4, 1.4))))
    return {"storeys": storeys, "openings": openings, "length": length, "gable": gable}


def _box(s0: float, s1: float, z0: float, z1: float) -> list[list[float]]:
    return [[s0, z0], [s1, z0], [s1, z1], [s0, z1]]


def _inside(opening, low: float, high: float):
    s0, s1, z0, z1 = opening
    return (s0, s1, max(z0, low), min(z1, high)) if min(z1, high) > max(z0, low) else None


def as_steps(body: dict) -> dict | None:
    """Short forms: where each storey is flush with a face of the base, or in its middle."""
    (_, _, _, base), *upper = body["storeys"]
    steps, below = [], base
    for low, _, outer, inner in upper:
        flush = {(0.0, inner): "outer", (_cm(base - inner + outer), base): "inner"}.get((outer, inner))
        if flush is None or inner - outer > below + 1e-9:
            return None
        below = inner - outer
        flush = "outer" if outer == 0.0 else "inner" if inner == base else None
        if flush is None:
            return None
        steps.append({"from_z_m": low, "thickness_m": _cm(inner - outer), "flush": flush})
    openings = [{"s_m": a, "z_m": c, "width_m": _cm(b - a), "height_m": _cm(d - c)} for a, b, c, d in body["openings"]]
    found = {"steps": steps, "openings": openings, "gable_m": body["gable"] or None}
    return {key: value for key, value in found.items() if value}


def as_elevations(body: dict, mirrored: bool = False) -> dict:
    """An elevation for each storey, with its openings."""
    length = body["length"]
    solids = []
    for low, high, outer, inner in body["storeys"]:
        more = {"plane": "elevation", "from_m": outer, "to_m": inner}
        outline = _box(0.0, length, low, high)
        if high == HEIGHT and body["gable"]:
            eaves = _cm(HEIGHT - body["gable"])
            outline[2:] = [[length, eaves], [0.5 * length, HEIGHT], [0.0, eaves]]
        solids.append(more | {"polygon_m": outline})
        for opening in body["openings"]:
            part = _inside(opening, low, high)
            if part is not None:
                s0, s1, z0, z1 = part
                s0, s1 = (_cm(length - s1), _cm(length - s0)) if mirrored else (s0, s1)
                solids.append(more | {"polygon_m": _box(s0, s1, z0, z1), "opening": True})
    return {"solid": solids}


def as_bricks(body: dict, rng: np.random.Generator, plane: str) -> dict | None:
    """Boxes alone, cut at every edge and at one more, in any order and either way round; of a body without a gable."""
    if body["gable"]:
        return None
    s = sorted({0.0, body["length"], *(x for one in body["openings"] for x in one[:2]), _cm(rng.uniform(0.5, 1.5))})
    solids = []
    for low, high, outer, inner in body["storeys"]:
        ends = {low, high, *(x for one in body["openings"] for x in one[2:] if low < x < high)}
        levels = sorted(ends)
        for z0, z1 in itertools.pairwise(levels):
            for s0, s1 in itertools.pairwise(s):
                middle = 0.5 * (s0 + s1), 0.5 * (z0 + z1)
                if any(a < middle[0] < b and c < middle[1] < d for a, b, c, d in body["openings"]):
                    continue
                elevation = plane == "elevation"
                corners = _box(s0, s1, z0, z1) if elevation else _box(outer, inner, z0, z1)
                ends = (outer, inner) if elevation else (s0, s1)
                corners = corners[::-1] if rng.random() < 0.5 else corners
                solids.append({"plane": plane, "polygon_m": corners, "from_m": ends[0], "to_m": ends[1]})
    return {"solid": [solids[k] for k in rng.permutation(len(solids))]}


def as_outline(body: dict) -> dict | None:
    """One section, of a body without openings."""
    if body["openings"] or body["gable"]:
        return None
    outer = [[x, z] for low, high, x, _ in body["storeys"] for z in (low, high)]
    inner = [[x, z] for low, high, _, x in body["storeys"] for z in (low, high)]
    corners = [*inner, *outer[::-1]]
    corners = [corner for k, corner in enumerate(corners) if corner != corners[k - 1]]
    return {"solid": [{"plane": "section", "polygon_m": corners, "to_m": body["length"]}]}


def as_niches(body: dict) -> dict | None:
    """An elevation as thick as the thickest storey, less openings over the whole length in front and behind."""
    outer, inner = min(one[2] for one in body["storeys"]), max(one[3] for one in body["storeys"])
    if body["openings"] or body["gable"]:
        return None
    length = body["length"]
    solids = [{"plane": "elevation", "polygon_m": _box(0.0, length, 0.0, HEIGHT), "from_m": outer, "to_m": inner}]
    for low, high, first, last in body["storeys"]:
        for ends in ((outer, first), (last, inner)):
            if ends[1] > ends[0]:
                more = {"plane": "elevation", "from_m": ends[0], "to_m": ends[1], "opening": True}
                solids.append(more | {"polygon_m": _box(0.0, length, low, high)})
    return {"solid": solids}


def as_drawing(body: dict, folder: Path) -> dict | None:
    """A DXF file with a layer for each storey and one for its openings, a drawing of the wall for each."""
    try:
        import ezdxf
    except ImportError:
        return None
    document = ezdxf.new("R2010", units=6)
    drawings, at = [], (103.7, -12.4)
    for k, storey in enumerate(body["storeys"]):
        one = as_elevations(body | {"storeys": [storey]})["solid"]
        for solid in one:
            layer = {"layer": f"O{k}" if "opening" in solid else f"S{k}"}
            corners = [(at[0] + s, at[1] + z) for s, z in solid["polygon_m"]]
            document.modelspace().add_lwpolyline(corners, close=True, dxfattribs=layer)
        view = {"file": "body.dxf", "layers": f"S{k}", "plane": "elevation", "from_m": storey[2], "to_m": storey[3]}
        drawings.append(view | ({"opening_layers": f"O{k}"} if len(one) > 1 else {}))
    document.saveas(folder / "body.dxf")
    return {"drawing": drawings}


def ways(body: dict, rng: np.random.Generator, folder: Path | None = None) -> dict[str, dict]:
    """Name -> the wall of a case, of each way in which a body can be written. folder : for a drawing, None for none"""
    written = {
        "steps": as_steps(body),
        "elevations": as_elevations(body),
        "mirrored": as_elevations(body, mirrored=True),
        "bricks": as_bricks(body, rng, "elevation"),
        "bricks in section": as_bricks(body, rng, "section"),
        "outline": as_outline(body),
        "niches": as_niches(body),
        "drawing": as_drawing(body, folder) if folder else None,
    }
    base = BASE | {"thickness_m": body["storeys"][0][3], "length_m": body["length"]}
    return {name: base | more for name, more in written.items() if more is not None}
