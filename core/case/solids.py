"""The shape of a wall that is no rectangle: solids, and short forms of what is common."""

import math
from dataclasses import MISSING, dataclass

from core.case.keys import choice_key, flag_key, key, number_key, path_key
from core.known import require_value

ROUND = 64
"""Sides of the polygon of a round opening, which has the area of the circle."""


@dataclass(frozen=True)
class Solid:
    """[[wall.solid]]: a polygon (s, z) in a vertical plane, extruded along its normal n.

    plane : elevation, s along the wall and n from the outer face inward; section, s from the outer face inward and n
        along the wall; oblique, angle_deg from the section in plan
    polygon_m : corners (s, z), z above the hinge; from_m, to_m : its ends along n
    opening : taken away; x0_m : from the outer face inward to s = n = 0; unit_weight_kn_m3 : that of the wall if
        none is given
    """

    plane: str = choice_key("elevation", "section", "oblique")
    polygon_m: tuple[tuple[float, float], ...] = key("polygon", MISSING)
    to_m: float = number_key(-200.0, 200.0, MISSING, unit="m")
    from_m: float = number_key(-200.0, 200.0, 0.0, unit="m")
    opening: bool = flag_key()
    x0_m: float = number_key(-20.0, 20.0, 0.0, unit="m")
    angle_deg: float | None = number_key(-90.0, 90.0, unit="deg")
    unit_weight_kn_m3: float | None = number_key(5.0, 40.0, unit="kN/m3")


@dataclass(frozen=True)
class Drawing:
    """[[wall.drawing]]: closed shapes of a DXF file, which become solids of the wall each time the case is read.

    file : relative to the case; layers : of the body; opening_layers : of what is taken away
    unit : of the drawing, in place of what its header says
    hinge_y_m : of the drawing at z = 0, else the lowest point of the body; what is below is cut off
    """

    file: str = path_key(MISSING)
    layers: tuple[str, ...] = key("texts", MISSING)
    plane: str = choice_key("elevation", "section")
    to_m: float = number_key(-200.0, 200.0, MISSING, unit="m")
    from_m: float = number_key(-200.0, 200.0, 0.0, unit="m")
    opening_layers: tuple[str, ...] = key("texts", ())
    unit: str | None = choice_key("m", "cm", "mm", "in", "ft", default=None)
    hinge_y_m: float | None = number_key(-1e7, 1e7, unit="m")


@dataclass(frozen=True)
class Opening:
    """[[wall.openings]]: a rectangle by its lower left corner, width and height, or a circle by its centre and its
    diameter.

    s_m : along the wall; z_m : above the hinge
    """

    s_m: float = number_key(0.0, 200.0, MISSING, unit="m")
    z_m: float = number_key(0.0, 60.0, MISSING, unit="m")
    width_m: float | None = number_key(0.05, 100.0, unit="m")
    height_m: float | None = number_key(0.05, 60.0, unit="m")
    diameter_m: float | None = number_key(0.05, 60.0, unit="m")

    @property
    def corners(self) -> list[tuple[float, float]]:
        """(s, z) of its outline [m]."""
        s, z = self.s_m, self.z_m
        if self.diameter_m is None:
            right, top = s + require_value(self.width_m), z + require_value(self.height_m)
            return [(s, z), (right, z), (right, top), (s, top)]
        turn = 2.0 * math.pi / ROUND
        radius = 0.5 * self.diameter_m * math.sqrt(turn / math.sin(turn))
        return [(s + radius * math.cos(turn * k), z + radius * math.sin(turn * k)) for k in range(ROUND)]


@dataclass(frozen=True)
class Wedges:
    """[wall.return_wedges]: what the wall drags along of the return walls behind it.

    number : of return walls; thickness_m : of each; length_at_top_m : of the wedge at the top of the wall
    from_z_m : where the crack begins, above the hinge
    """

    number: int = number_key(1, 20, MISSING, whole=True)
    thickness_m: float = number_key(0.05, 3.0, MISSING, unit="m", form_unit="cm")
    length_at_top_m: float = number_key(0.0, 30.0, MISSING, unit="m", exclusive=True)
    from_z_m: float = number_key(0.0, 60.0, 0.0, unit="m")


@dataclass(frozen=True)
class Corner:
    """[wall.corner]: two walls that meet and turn together over the edge where they do, dragged along their cracks. The
    first is the wall itself, of thickness t.

    length_1_m, length_2_m : of each at the top, to its crack, which begins at the base; thickness_2_m : of the second
    angle_deg : in plan, between the first wall and the direction in which the corner turns
    thrust_1_kn_m, thrust_2_kn_m : with which what spans in each wall beyond its crack pushes the corner outward, along
        that wall, per metre of its height; across_1_kn_m, across_2_kn_m : across it
    """

    length_1_m: float = number_key(0.1, 30.0, MISSING, unit="m")
    length_2_m: float = number_key(0.1, 30.0, MISSING, unit="m")
    thickness_2_m: float = number_key(0.05, 3.0, MISSING, unit="m", form_unit="cm")
    angle_deg: float = number_key(10.0, 80.0, 45.0, unit="deg")
    thrust_1_kn_m: float = number_key(0.0, 10000.0, 0.0, unit="kN/m")
    thrust_2_kn_m: float = number_key(0.0, 10000.0, 0.0, unit="kN/m")
    across_1_kn_m: float = number_key(0.0, 10000.0, 0.0, unit="kN/m")
    across_2_kn_m: float = number_key(0.0, 10000.0, 0.0, unit="kN/m")

    @property
    def pushes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """(along, across) [kN/m] with which what spans in its first and in its second wall pushes it."""
        return (self.thrust_1_kn_m, self.across_1_kn_m), (self.thrust_2_kn_m, self.across_2_kn_m)

    @property
    def is_pushed(self) -> bool:
        """Whether something that spans to it pushes it."""
        return any(max(push) > 0.0 for push in self.pushes)

    @property
    def outward_push(self) -> float:
        """What pushes it in the direction in which it turns, per metre of its height [kN/m]: the second wall stands at
        a right angle to the first."""
        angle, ((along_1, across_1), (along_2, across_2)) = math.radians(self.angle_deg), self.pushes
        return (along_1 + across_2) * math.cos(angle) + (across_1 + along_2) * math.sin(angle)


@dataclass(frozen=True)
class InPlan:
    """[wall.plan]: where a wall stands in the key plan of its building, from one end to the other, along its outer
    face."""

    x1_m: float = number_key(-1e4, 1e4, MISSING, unit="m")
    y1_m: float = number_key(-1e4, 1e4, MISSING, unit="m")
    x2_m: float = number_key(-1e4, 1e4, MISSING, unit="m")
    y2_m: float = number_key(-1e4, 1e4, MISSING, unit="m")

    @property
    def length(self) -> float:
        """From one end to the other [m]."""
        return math.hypot(self.x2_m - self.x1_m, self.y2_m - self.y1_m)


@dataclass(frozen=True)
class Leaf:
    """[wall.leaf]: the outer leaf of a wall of several, looked at as it comes off and turns alone.

    thickness_m : of it; connector_kn_m : what a row of connectors holds when it is pulled out, per metre of wall
    row_spacing_m : between their rows, the first at that height; slip_mm : of the leaf when a connector is pulled out
    """

    thickness_m: float = number_key(0.05, 3.0, MISSING, unit="m", form_unit="cm")
    connector_kn_m: float | None = number_key(0.0, 1000.0, unit="kN/m", exclusive=True)
    row_spacing_m: float | None = number_key(0.3, 20.0, unit="m")
    slip_mm: float | None = number_key(0.3, 100.0, unit="mm")


@dataclass(frozen=True)
class Step:
    """[[wall.steps]]: the thickness from a height on. flush : the face that goes on"""

    from_z_m: float = number_key(0.0, 60.0, MISSING, unit="m", exclusive=True)
    thickness_m: float = number_key(0.05, 20.0, MISSING, unit="m", form_unit="cm")
    flush: str = choice_key("outer", "inner", "middle", default="outer")
