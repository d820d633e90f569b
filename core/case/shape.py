"""The body of a wall from the keys that give it: solids, or the short forms of what is common."""

import math
from functools import cached_property

from core.case.solids import Corner, Opening, Solid, Step, Wedges
from core.errors import InputError, place
from core.known import require_value
from core.wall.body import clipped_above
from core.wall.solids import Part, top_of

ANGLES = {"elevation": 0.5 * math.pi, "section": 0.0}
"""Angles of the planes of solids from the direction of motion [rad]."""

SHORT_FORMS = ("gable_m", "openings", "steps", "out_of_plumb_m")
"""Keys that make a wall another shape, in place of solids."""

FLUSH = {"outer": 0.0, "inner": 1.0, "middle": 0.5}
"""Face of a step that goes on -> share of what it is thinner that lies before it."""


class Shaped:
    """The keys of a wall that give its body, see `Wall`."""

    height_m: float | None
    thickness_m: float | None
    slenderness_deg: float | None
    height_over_thickness: float | None
    length_m: float | None
    unit_weight_kn_m3: float | None
    solid: tuple[Solid, ...]
    gable_m: float | None
    openings: tuple[Opening, ...]
    steps: tuple[Step, ...]
    out_of_plumb_m: float | None
    return_wedges: Wedges | None
    corner: Corner | None

    @property
    def title(self) -> str:
        raise NotImplementedError

    @property
    def thickness(self) -> float | None:
        """t [m] of a rectangular wall, None of a general block."""
        if self.thickness_m is not None or self.height_m is None:
            return self.thickness_m
        if self.slenderness_deg is not None:
            return self.height_m * math.tan(math.radians(self.slenderness_deg))
        return None if self.height_over_thickness is None else self.height_m / self.height_over_thickness

    @property
    def has_shape(self) -> bool:
        """Whether it gives more than a rectangle."""
        return bool(self.solid or self.return_wedges or self.corner or any(getattr(self, key) for key in SHORT_FORMS))

    @property
    def shoulder(self) -> float:
        """Height of the wall below its gable [m]."""
        return require_value(self.height_m) - (self.gable_m or 0.0)

    @property
    def top(self) -> float | None:
        """Height of the body [m]."""
        return top_of(self.parts) if self.parts else self.height_m

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """Solids of the wall; none of a rectangle, however it is written. Raises InputError where a size is missing."""
        if not self.has_shape:
            return ()
        _, face, weight, length = self.complete_sizes()
        if (corner := self.corner) is not None:
            return _of_corner(corner, require_value(self.height_m), face, weight)
        made = tuple(_given(solid, weight) for solid in self.solid) or tuple(self._layers(face, length, weight))
        if (wedges := self.return_wedges) is not None:
            top = self.shoulder
            corners = ((face, wedges.from_z_m), (face + wedges.length_at_top_m, top), (face, top))
            ends = (0.0, wedges.number * wedges.thickness_m)
            made += (Part(corners, ends, 0.0, 0.0, weight, "section", wedge=True),)
        return () if self._is_rectangle(made, weight) else made

    def complete_sizes(self) -> tuple[float, float, float, float]:
        """Height, thickness [m], unit weight [N/m3] and length [m] of a wall with a shape. Raises InputError where one
        is missing."""
        height, thickness, weight, length = self.height_m, self.thickness, self.unit_weight_kn_m3, self.length_m
        if height is not None and thickness is not None and weight is not None and length is not None:
            return height, thickness, 1e3 * weight, length
        given = {"height_m": height, "thickness_m": thickness, "unit_weight_kn_m3": weight, "length_m": length}
        missing = next(key for key, value in given.items() if value is None)
        raise InputError("solids_need", place=(place("wall", name=self.title),), key=missing)

    def _layers(self, base: float, length: float, weight: float) -> list[Part]:
        """Solids of the wall between its steps, with its gable, and of its openings through each. base : thickness at
        the base [m]"""
        top, eaves = require_value(self.height_m), self.shoulder
        outline = [(0.0, 0.0), (length, 0.0), (length, eaves), (0.0, eaves)]
        if self.gable_m:
            outline.insert(3, (0.5 * length, top))
        steps = [(0.0, base, "outer"), *((s.from_z_m, s.thickness_m, s.flush) for s in self.steps)]
        layers = []
        for k, (low, thickness, flush) in enumerate(steps):
            high = steps[k + 1][0] if k + 1 < len(steps) else top
            start = FLUSH[flush] * (base - thickness)
            if self.out_of_plumb_m:
                corners = self._leaning(start, thickness, low, high)
                layers.append(Part(corners, (0.0, length), 0.0, 0.0, weight, "section"))
                continue
            for corners, sign in [(outline, 1.0), *((opening.corners, -1.0) for opening in self.openings)]:
                if polygon := cut_between(corners, low, high):
                    angle = ANGLES["elevation"]
                    layers.append(Part(polygon, (0.0, thickness), angle, start, sign * weight, "elevation"))
        return layers

    def _leaning(self, start: float, thickness: float, low: float, high: float) -> tuple[tuple[float, float], ...]:
        """Section between two heights of a wall whose top is out of plumb, outward [m]."""
        lean = require_value(self.out_of_plumb_m) / require_value(self.height_m)
        corners = ((start, low), (start + thickness, low), (start + thickness, high), (start, high))
        return tuple((x - lean * z, z) for x, z in corners)

    def _is_rectangle(self, parts: tuple[Part, ...], weight: float) -> bool:
        if len(parts) != 1 or parts[0].weight != weight or len(parts[0].polygon) != 4:
            return False
        (part,) = parts
        corners, (first, last) = set(part.polygon), part.ends
        height, thickness, length = self.height_m, self.thickness, self.length_m
        if part.plane == "section":
            return corners == _box(thickness, height) and part.start == 0.0 and last - first == length
        seen = {(s - min(s for s, _ in corners), z) for s, z in corners}
        return (
            part.plane == "elevation"
            and seen == _box(length, height)
            and (part.start + first == 0.0 and part.start + last == thickness)
        )


def _of_corner(corner: Corner, height: float, thickness: float, weight: float) -> tuple[Part, ...]:
    """Both walls of a corner above their cracks, what they share once. thickness : of the first [m]"""
    first, second = corner.length_1_m, corner.length_2_m
    angle, begins = math.radians(corner.angle_deg), height * thickness / second
    own = ((0.0, 0.0), (first, height), (0.0, height))
    other = ((thickness, begins), (second, height), (thickness, height))
    parts = (Part(own, (0.0, thickness), angle, 0.0, weight, "oblique"),)
    if second <= thickness:  # it does not reach beyond what both share
        return parts
    ends = (-corner.thickness_2_m, 0.0)
    return (*parts, Part(other, ends, angle - 0.5 * math.pi, 0.0, weight, "oblique"))


def _given(solid: Solid, weight: float) -> Part:
    if len(solid.polygon_m) < 3:  # of a draft
        raise InputError("polygon_empty", key="polygon_m")
    angle = ANGLES[solid.plane] if solid.plane in ANGLES else math.radians(require_value(solid.angle_deg))
    weight = weight if solid.unit_weight_kn_m3 is None else 1e3 * solid.unit_weight_kn_m3
    ends = (solid.from_m, solid.to_m)
    return Part(solid.polygon_m, ends, angle, solid.x0_m, -weight if solid.opening else weight, solid.plane)


def _box(width, height) -> set[tuple[float, float]]:
    return {(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)}


def cut_between(polygon, low: float, high: float) -> tuple[tuple[float, float], ...]:
    """The part of a polygon between two heights, where it is."""
    if low > 0.0:
        polygon = clipped_above(polygon, low)
    if max((z for _, z in polygon), default=0.0) > high:
        polygon = [(s, -z) for s, z in clipped_above([(s, -z) for s, z in polygon], -high)]
    return tuple(polygon)
