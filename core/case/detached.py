"""The outer leaf of a wall that comes off and turns alone, its connectors as ties that are pulled out."""

from dataclasses import replace

from core.case.document import Document, document_of
from core.case.hold import TIE, Hold
from core.case.solids import Leaf
from core.case.wall import Wall
from core.errors import InputError, place
from core.known import require_value
from core.text.sentence import Key
from core.wall.ties import DEFAULT_STRENGTH, elongation_at_yield

BELOW_TOP = 0.05
"""Distance of the highest row of connectors from the top of a wall, at least [m]."""

OF_CONNECTORS = "connector_kn_m", "row_spacing_m", "slip_mm"
"""Keys of the connectors: all or none."""


def make_leaf_wall(wall: Wall) -> Wall:
    """The outer leaf of a wall as a wall: what rests within it stays on it, thrusts and ties act on it as on the wall,
    and what drags the wall along behind is not its own. It leans on what is behind it, which shows nothing of it."""
    leaf = require_value(wall.leaf)
    loads = [load for load in wall.load if not load.is_weight or require_value(load.d_m) <= leaf.thickness_m]
    loads = [replace(load, d_m=None) if load.is_thrust else load for load in loads]
    rows = _connectors(leaf, require_value(wall.height_m), document_of(wall.evidence, "leaf"))
    return replace(
        wall,
        name=f"{wall.name} ({leaf_label(leaf)})",
        mechanism="one_sided",
        thickness_m=leaf.thickness_m,
        slenderness_deg=None,
        height_over_thickness=None,
        steps=(),
        return_wedges=None,
        return_walls=None,
        leaf=None,
        set_aside=(),
        load=tuple(loads),
        hold=(*(_behind_leaf(hold, wall) for hold in wall.restraints), *wall.ties, *rows),
    )


def _behind_leaf(hold: Hold, wall: Wall) -> Hold:
    """What holds a wall as it stands behind its leaf: shown where the engineer says why the leaf does."""
    shown = document_of(wall.evidence, "leaf")
    return replace(hold.alone, evidence=hold.evidence if shown else None)


def leaf_label(leaf: Leaf) -> str:
    """What tells a leaf from its wall, in every language."""
    return f"t {leaf.thickness_m:.4g} m"


def _connectors(leaf: Leaf, height: float, shown: Document | None) -> list[Hold]:
    """The rows of connectors of a leaf: ties that hold up to their slip, and break there. shown : by"""
    if leaf.connector_kn_m is None:
        return []
    step = require_value(leaf.row_spacing_m)
    strain = elongation_at_yield(1.0, DEFAULT_STRENGTH)
    length = 1e-3 * require_value(leaf.slip_mm) / strain
    row = Hold(TIE, h_m=step, out_kn_m=leaf.connector_kn_m, bar_length_m=length, evidence=shown)
    rows = int((height - BELOW_TOP) / step + 1e-9)
    return [replace(row, h_m=step * k) for k in range(1, rows + 1)]


def check_leaf(wall: Wall) -> None:
    """Raise InputError for a leaf that is not complete, or of a wall that has none."""
    if (leaf := wall.leaf) is None:
        return
    here = (place("wall", name=wall.name), place("leaf"))
    if not wall.leans:
        raise InputError("leaf_mechanism", place=here, found=wall.mechanism)
    if wall.solid or wall.corner or any(step.flush != "outer" for step in wall.steps):
        raise InputError("leaf_shape", place=here)
    if wall.thickness is None or wall.height_m is None or wall.unit_weight_kn_m3 is None:
        given = {"thickness_m": wall.thickness, "height_m": wall.height_m, "unit_weight_kn_m3": wall.unit_weight_kn_m3}
        key = next(key for key, value in given.items() if value is None)
        raise InputError("leaf_needs", place=(here[0],), key=key)
    thinnest = min([wall.thickness, *(step.thickness_m for step in wall.steps)])
    if leaf.thickness_m >= thinnest:
        raise InputError("leaf_thickness", place=here, key="thickness_m", found=leaf.thickness_m, most=thinnest)
    missing = [key for key in OF_CONNECTORS if getattr(leaf, key) is None]
    if missing and len(missing) < len(OF_CONNECTORS):
        raise InputError("leaf_connectors", place=here, key=missing[0], others=tuple(map(Key, OF_CONNECTORS)))
    if leaf.connector_kn_m is not None and not wall.moment_law().is_rigid:
        raise InputError("tie_needs_rigid_law", place=(here[0],), key="law")
    if leaf.row_spacing_m is not None and leaf.row_spacing_m > wall.height_m - BELOW_TOP:
        most = wall.height_m - BELOW_TOP
        raise InputError("leaf_rows", place=here, key="row_spacing_m", found=leaf.row_spacing_m, most=most)
