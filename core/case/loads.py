"""The loads of a wall in a case, its ties, and the walls across behind it."""

from dataclasses import MISSING, dataclass

from core.case.keys import choice_key, flag_key, key, number_key
from core.known import require_value
from core.wall import masonry, ties


@dataclass(frozen=True)
class Bars:
    """[wall.load.bar]: the steel bars of a tie, over the length of the wall.

    thread_mm : diameter of the thread at their ends, that of the bar if none is given
    fy_mpa, fu_mpa : 235 and 360 if none is given
    existing : of an existing building: f_y and f_u are given mean values, which FC divides
    anchorage_kn : least resistance of the anchorage of a bar (plate, bearing and punching of the masonry), found by the
        engineer; without it the elongation of the bars is not counted on
    """

    number: int = number_key(1, 500, MISSING, whole=True)
    diameter_mm: float = number_key(4.0, 100.0, MISSING, unit="mm")
    fy_mpa: float | None = number_key(100.0, 1500.0, unit="MPa")
    fu_mpa: float | None = number_key(100.0, 2000.0, unit="MPa")
    thread_mm: float | None = number_key(4.0, 100.0, unit="mm")
    existing: bool = flag_key()
    anchorage_kn: float | None = number_key(0.0, 10000.0, unit="kN", exclusive=True)

    @property
    def strength(self) -> float:
        """f_y [MPa]."""
        return self.fy_mpa or 1e-6 * ties.DEFAULT_STRENGTH

    @property
    def tensile(self) -> float:
        """f_u [MPa]."""
        return self.fu_mpa or 1e-6 * ties.DEFAULT_TENSILE

    def in_si(self) -> ties.Steel:
        """The bars in SI."""
        return ties.Steel(
            self.number,
            1e-3 * self.diameter_mm,
            1e6 * self.strength,
            1e6 * self.tensile,
            None if self.thread_mm is None else 1e-3 * self.thread_mm,
            self.existing,
            None if self.anchorage_kn is None else 1e3 * self.anchorage_kn,
        )


@dataclass(frozen=True)
class Load:
    """[[wall.load]]: a force of constant size and direction on a metre of wall, a mass that moves with it, or a tie.

    kn_m : its size [kN/m]: of a thrust positive outward, else positive; of a tie its force at yield, in place of `bar`
    g_kn_m, q_kn_m, psi_2 : of a weight in its place, permanent and variable, of which psi_2 counts (NTC 2018 2.5.3)
    d_m : from the outer face inward [m]; at the face where a thrust has none, always that of a tie
    h_m : above the hinge of the wall [m]
    mass : of a vertical load: held elsewhere, pushing the wall horizontally, or moving with it
    bar_length_m and what follows : of a tie only
    fy_mpa : with kn_m, gives the elongation at yield; 235 if none is given
    elongation_m : what it stands, in place of `elongation` times its length; without either it fails at yield
    slack_mm : before it pulls; prestress : share of the force at yield
    """

    kind: str = choice_key("vertical", "thrust", "tie", "carried_mass")
    kn_m: float | None = number_key(-10000.0, 10000.0, unit="kN/m")
    h_m: float = number_key(0.0, 120.0, unit="m", exclusive=True, required=True)
    d_m: float | None = number_key(0.0, 20.0, unit="m")
    mass: str | None = choice_key("none", "horizontal", "moving", default=None)
    bar_length_m: float | None = number_key(0.2, 100.0, unit="m")
    fy_mpa: float | None = number_key(100.0, 1500.0, unit="MPa")
    elongation_m: float | None = number_key(0.0, 10.0, unit="m")
    elongation: float | None = number_key(0.0, 0.3)
    slack_mm: float | None = number_key(0.0, 500.0, unit="mm")
    prestress: float | None = number_key(0.0, 0.9)
    bar: Bars | None = key("section", of=Bars, columns="load{n}_bar_")
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
    def is_weight(self) -> bool:
        return self.kind in ("vertical", "carried_mass")

    @property
    def is_tie(self) -> bool:
        return self.kind == "tie"

    @property
    def stated_elongation(self) -> float | None:
        """What the bar of a tie stands before it breaks, as stated [m]; None where nothing is."""
        if self.elongation_m is not None or self.elongation is None:
            return self.elongation_m
        return self.elongation * require_value(self.bar_length_m)

    def tie(self, wall_length: float | None) -> ties.Tie:
        """The tie of a load that is one, for a metre of a wall of this length [m]."""
        length, slack, prestress = (
            require_value(self.bar_length_m),
            1e-3 * (self.slack_mm or 0.0),
            self.prestress or 0.0,
        )
        stands = self.stated_elongation or 0.0
        if self.bar is not None:
            return ties.tie_of_bars(
                self.h_m, self.bar.in_si(), length, require_value(wall_length), stands, slack, prestress
            )
        strength = ties.DEFAULT_STRENGTH if self.fy_mpa is None else 1e6 * self.fy_mpa
        at_yield = ties.elongation_at_yield(length, strength)
        return ties.tie_of_force(self.h_m, 1e3 * require_value(self.kn_m), at_yield, stands, slack, prestress)

    def in_si(self, wall_length: float | None) -> masonry.Load:
        """The load in SI, on a wall of this length [m]. Raises TypeError where it has no size yet."""
        tie = self.tie(wall_length) if self.is_tie else None
        force = 1e3 * require_value(self.kn_m) if tie is None else tie.bar.strength
        return masonry.Load(self.kind, force, self.d_m or 0.0, self.h_m, self.pushes, tie)

    @property
    def pushes(self) -> bool:
        """Whether its mass is moved by the wall: Q of C8.7.1.1, and part of the moving block."""
        return self.kind == "carried_mass" or self.mass in ("horizontal", "moving")


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
