"""What acts on each horizontal section of a wall: the push above it, and the moments of the weights about its edges.

Per metre of wall; x inward from the outer face of the base, z above the base.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from core.known import require_value
from core.units import G
from core.wall.body import cut_above, sum_bodies
from core.wall.masonry import Load, Masonry
from core.wall.solids import changes, contact_at

PIECES = 4
"""Pieces between two heights at which a wall changes: of a wall of one thickness there one is exact."""


@dataclass(frozen=True)
class Section:
    """A section of a wall at a height.

    push : S, sum of the pushed weights times their height above it [N]
    outer, inner : M_o and M_i, moments of all weights above it about its outer and its inner hinge [N]
    pressing : moment about it of the thrusts above it, positive outward [N]
    weight, pushed : of what is above it, and of what of it is pushed [N/m]
    """

    push: float
    outer: float
    inner: float
    pressing: float
    weight: float
    pushed: float

    def least_moment(self, alpha: float) -> float:
        """Moment [N] that the holds above have to give under an outward push: alpha S - M_o, with the thrusts."""
        return alpha * self.push + self.pressing - self.outer

    def greatest_moment(self, alpha: float) -> float:
        """Moment [N] of the holds beyond which the wall is pulled in over its inner edge: alpha S + M_i."""
        return alpha * self.push + self.pressing + self.inner


@dataclass(frozen=True)
class Sections:
    """The sections of a wall.

    wall : with a unit weight; its ties and its holds act on none of its sections
    """

    wall: Masonry

    @cached_property
    def height(self) -> float:
        """Give the height of the wall [m]."""
        return require_value(self.wall.top)

    @cached_property
    def weights(self) -> tuple[Load, ...]:
        """The weights on the wall."""
        return tuple(load for load in self.wall.loads if load.is_weight)

    @cached_property
    def levels(self) -> tuple[float, ...]:
        """Heights at which the wall changes, or carries something [m], from its base to its top."""
        inside = [load.height for load in self.wall.loads if load.tie is None]
        if self.wall.parts:
            inside += changes(self.wall.parts)
        return tuple(sorted({0.0, self.height, *(z for z in inside if 0.0 < z < self.height)}))

    @cached_property
    def pieces(self) -> np.ndarray:
        """Stretches over which S, M_i with the thrusts and the thrusts less M_o are quadratic functions of z, as an
        array of rows (from, to, three coefficients of each), those of the power 0 first [m, N]."""
        rows = []
        for low, high in pairwise(self.levels):
            for n in range(PIECES):
                ends = low + (high - low) * n / PIECES, low + (high - low) * (n + 1) / PIECES
                places = ends[0], 0.5 * sum(ends), ends[1]
                cut = self.at(places[0]), self.at(places[1]), self.at_below(places[2])
                powers = np.vander(places, increasing=True)
                values = np.array([(s.push, s.pressing + s.inner, s.pressing - s.outer) for s in cut])
                rows.append([*ends, *np.linalg.solve(powers, values).T.ravel()])
        return np.array(rows)

    @cached_property
    def thrusts(self) -> float:
        """Sum of the thrusts, positive outward [N/m]."""
        return math.fsum(load.force for load in self.wall.loads if load.is_thrust)

    def at(self, z: float) -> Section:
        """The section just above a height [m]: a load at that very height is below it."""
        if z not in self._known:
            self._known[z] = self._section(z, lambda height: height > z)
        return self._known[z]

    def at_below(self, z: float) -> Section:
        """The section just below a height [m]: a load at that very height is above it."""
        return self._section(z, lambda height: height >= z)

    @cached_property
    def _known(self) -> dict[float, Section]:
        return {}

    def _section(self, z: float, is_above: Callable[[float], bool]) -> Section:
        wall, setback, thickness = self.wall, self.wall.setback, require_value(self.wall.thickness)
        faces = (0.0, thickness)
        if wall.parts:
            faces = contact_at(wall.parts, z) or faces
            weight, x, above = self._body_above(z)
        else:
            weight = wall.weight * (1.0 - z / self.height)
            x, above = 0.5 * thickness, 0.5 * (self.height - z)
        outer, inner = faces[0] + setback, faces[1] - setback
        push, pushed = weight * above, weight
        moments, total = [(weight, x)], weight
        for load in self.weights:
            if is_above(load.height):
                moments.append((load.force, load.depth))
                total += load.force
                if load.pushes:
                    push += load.force * (load.height - z)
                    pushed += load.force
        pressing = math.fsum(
            load.force * (load.height - z) for load in wall.loads if load.is_thrust and is_above(load.height)
        )
        about_outer = math.fsum(force * (place - outer) for force, place in moments)
        about_inner = math.fsum(force * (inner - place) for force, place in moments)
        return Section(push, about_outer, about_inner, pressing, total, pushed)

    def _body_above(self, z: float) -> tuple[float, float, float]:
        """Weight [N/m] of the solids above a height, and x and height above it of their centroid [m]."""
        cut = ((part, cut_above(part.polygon, z)) for part in self.wall.parts)
        bodies = [part._replace(polygon=tuple(polygon)).body for part, polygon in cut if polygon]
        body = sum_bodies(bodies) if bodies else None
        if body is None or body.mass <= 0.0:
            return 0.0, 0.0, 0.0
        x, above = body.centroid
        return body.mass * G / require_value(self.wall.length), x, above
