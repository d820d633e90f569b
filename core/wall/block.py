"""The rigid block (Coccia et al. 2016, Fig. 1, Eq. 2)."""

import math
from dataclasses import dataclass

from core.errors import require
from core.text.sentence import sentence
from core.units import G


@dataclass(frozen=True)
class Block:
    """A symmetric block on its base, seen from a pivot at an edge.

    slenderness : alpha [rad], larger = stockier
    radius : R, pivot to centre of mass [m]
    inertia_over_mass : I0 / m about the pivot [m2], 4/3 R^2 for a rectangle and above R^2 for any block
    Raises InputError outside 0 < alpha < pi/2, R > 0, I0/m > R^2.
    """

    slenderness: float
    radius: float
    inertia_over_mass: float

    def __post_init__(self):
        degrees = math.degrees(self.slenderness)
        require(0.0 < degrees < 90.0, "slenderness_deg", degrees, sentence("accepted", "degrees"))
        require(0.0 < self.radius < math.inf, "radius_m", self.radius, sentence("accepted", "positive"))
        require(
            self.radius**2 < self.inertia_over_mass < math.inf,
            "inertia_over_mass_m2",
            self.inertia_over_mass,
            sentence("accepted", "above_radius", square=self.radius**2),
        )

    @classmethod
    def rectangle(cls, height: float, slenderness: float) -> "Block":
        """Rectangular block of this height [m] and slenderness alpha = atan(t/H) [rad]."""
        require(0.0 < height < math.inf, "height_m", height, sentence("accepted", "positive"))
        require(0.0 < slenderness < 0.5 * math.pi, "slenderness", slenderness, sentence("accepted", "radians"))
        radius = height / (2.0 * math.cos(slenderness))
        return cls(slenderness, radius, 4.0 / 3.0 * radius * radius)

    @classmethod
    def with_setback(cls, height: float, thickness: float, setback: float) -> "Block":
        """Rectangular wall turning about a hinge `setback` u inside its edge [m]: tan(alpha) = (t - 2u) / H,
        R and I0 about that hinge."""
        slenderness = math.atan2(thickness - 2.0 * setback, height)
        if setback == 0.0:
            return cls.rectangle(height, slenderness)
        radius = 0.5 * math.hypot(height, thickness - 2.0 * setback)
        own = (height * height + thickness * thickness) / 12.0
        return cls(slenderness, radius, own + radius * radius)

    @property
    def is_rectangle(self) -> bool:
        return self.inertia_over_mass == 4.0 / 3.0 * self.radius * self.radius

    @property
    def centroid(self) -> tuple[float, float]:
        """Centroid of the block at rest, inward from the pivot and above it [m]."""
        return self.radius * math.sin(self.slenderness), self.radius * math.cos(self.slenderness)

    @property
    def p2(self) -> float:
        """Squared frequency parameter p^2 = m g R / I0 [1/s2]; 3 g / (4 R) for a rectangle."""
        return G * self.radius / self.inertia_over_mass

    @property
    def frequency_parameter(self) -> float:
        """p [rad/s]; the paper gives this name to p^2."""
        return math.sqrt(self.p2)

    @property
    def threshold_acceleration(self) -> float:
        """a_RM = g tan(alpha) [m/s2], Eq. 2."""
        return G * math.tan(self.slenderness)

    @property
    def height(self) -> float:
        """H [m] of the rectangle with the same p and alpha: 2 R_eq cos(alpha), R_eq = 3 g / (4 p^2)."""
        return 2.0 * (0.75 * G / self.p2) * math.cos(self.slenderness)

    @property
    def thickness(self) -> float:
        """t = H tan(alpha) [m]."""
        return self.height * math.tan(self.slenderness)
