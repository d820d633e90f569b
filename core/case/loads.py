"""The loads of a wall in a case, and the walls across behind it."""

from dataclasses import MISSING, dataclass

from core.case.keys import choice_key, key, number_key
from core.known import require_value
from core.wall import masonry
from core.wall.load_kinds import LOAD_KINDS, OfLoadKind


@dataclass(frozen=True)
class Load(OfLoadKind):
    """[[wall.load]]: a force of constant size and direction on a metre of wall, or a mass that moves with it.

    kn_m : its size [kN/m]: of a thrust positive outward, else positive
    g_kn_m, q_kn_m, psi_2 : of a weight in its place, permanent and variable, of which psi_2 counts (NTC 2018 2.5.3)
    d_m : from the outer face inward [m]; at the face where a thrust has none
    h_m : above the hinge of the wall [m]
    mass : of a vertical load: held elsewhere, pushing the wall horizontally, or moving with it
    """

    kind: str = key("choice", MISSING, names=LOAD_KINDS)
    kn_m: float | None = number_key(-10000.0, 10000.0, unit="kN/m")
    h_m: float = number_key(0.0, 120.0, unit="m", exclusive=True, required=True)
    d_m: float | None = number_key(0.0, 20.0, unit="m")
    mass: str | None = choice_key("none", "horizontal", "moving", default=None)
    g_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m")
    q_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m")
    psi_2: float | None = number_key(0.0, 1.0)

    def __post_init__(self):
        if self.kn_m is None and self.combined is not None:
            object.__setattr__(self, "kn_m", self.combined)

    @property
    def combined(self) -> float | None:
        """G + psi_2 Q [kN/m] of the seismic combination (NTC 2018 Eq. 2.5.5), None where it is not given so."""
        g, q, share = self.g_kn_m, self.q_kn_m, self.psi_2
        if isinstance(g, str) or isinstance(q, str) or isinstance(share, str):  # of a draft
            return None
        if g is None and (q is None or share is None):
            return None
        return (g or 0.0) + (q or 0.0) * (share or 0.0)

    @property
    def in_si(self) -> masonry.Load:
        """The load in SI. Raises TypeError where it has no size yet."""
        return masonry.Load(self.kind, 1e3 * require_value(self.kn_m), self.d_m or 0.0, self.h_m, self.pushes)

    @property
    def pushes(self) -> bool:
        """Whether its mass is moved by the wall: Q of C8.7.1.1, and part of the moving block."""
        return self.is_carried or self.mass in ("horizontal", "moving")

    @property
    def pushes_outward(self) -> bool:
        """Whether it is a thrust outward."""
        return self.is_thrust and (self.kn_m or 0.0) > 0.0


@dataclass(frozen=True)
class OwnWeight(Load):
    """The wall above a stretch of it, which stands on that: no load of the case, and nobody asks where its mass is."""


@dataclass(frozen=True)
class ReturnWalls:
    """[wall.return_walls]: the walls across behind a facade, whose courses it drags out (friction).

    number : of them along the wall; brick_height_m, brick_length_m : of a course h_b and of a unit l
    thickness_m : t_s; friction : coefficient mu
    """

    number: int = number_key(1, 20, MISSING, whole=True)
    thickness_m: float = number_key(0.05, 3.0, MISSING, unit="m", form_unit="cm")
    brick_height_m: float = number_key(0.02, 1.0, MISSING, unit="m", form_unit="cm")
    brick_length_m: float = number_key(0.05, 2.0, MISSING, unit="m", form_unit="cm")
    friction: float = number_key(0.1, 1.0, 0.577)

    def in_si(self) -> masonry.ReturnWalls:
        return masonry.ReturnWalls(
            self.number, self.thickness_m, self.brick_height_m, self.brick_length_m, self.friction
        )
