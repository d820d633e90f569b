"""Kinematic checks of a wall, Circolare 7/2019 C8.7.1.2.1.1 to .8, for a single block.

The clauses put the weight of each block at its centroid: for one wall turning about its base the sums of
C8.7.1.4 and C8.7.1.5 have one term and one for each load that pushes it, so that without such loads e* = 1 and
d = d_C at the centroid. (Summed over the height, as if each course were a block, e* would be 0.75 and a0* a third
higher than the acceleration that uplifts the wall.)

Above the ground the spectra are those of the floor, C7.2.3. Since they go to zero with the height, no demand of the
floor is taken below that of the ground, a_g S, S_e(T_0) and S_De: a rule of ours.
"""

import contextlib
import math
from dataclasses import dataclass, replace

from core.capacity.limit_states import LIMIT_FRACTION
from core.codes import target_spectrum
from core.codes.demand import SeismicDemand
from core.codes.floor_spectrum import FloorSpectrum
from core.codes.kinematic_chain import ChainSums, elastic_period_of_loads, sum_bending_chain, sum_chain
from core.codes.target_spectrum import GivenSpectrum
from core.codes.vertical_bending import Bending, governing_mechanism
from core.errors import InputError, place
from core.units import G
from core.wall.arch import MIN_THRUST
from core.wall.kinematics import kinematics
from core.wall.masonry import Masonry, period_share
from core.wall.wall_loads import without_ties

PERIOD_FACTOR = {"SLV": 1.68 * math.pi, "SLC": 1.56 * math.pi}
STATE_DAMPING = {"SLV": 0.08, "SLC": 0.10}
"""C8.7.1.10, C8.7.1.11 and the damping of C8.7.1.12."""

FREE_DAMPING = 0.05
"""Damping of an element before it moves (C8.7.1.9)."""

CANTILEVER_KAPPA = 6.2
"""kappa of C8.7.1.7 for a cantilever (beam theory: 6.190)."""

SLD_CLAUSE = "C8.7.1.2.1.5"
Q_CLAUSE = "C8.7.1.2.1.7"
DISPLACEMENT_CLAUSE = "C8.7.1.2.1.8"
HOLD_CLAUSE = "C8.7.1.2.1"
"""That the connections are effective is what the clauses of local mechanisms start from."""

ZETA_ROUNDING = 1e-12
"""What zeta may miss of the one required by rounding alone [-]."""


@dataclass(frozen=True)
class Check:
    """One row of the table of methods.

    name : dynamic, nonlinear, linear_q_slv, linear_q_code, hold; clause
    capacity, demand : in `unit`, None where the row has none
    zeta : of the check; passed iff zeta >= zeta_target
    q : of the row
    """

    name: str
    clause: str
    unit: str
    capacity: float | None
    demand: float | None
    zeta: float | None
    passed: bool | None
    q: float | None = None

    @property
    def label(self) -> str:
        """Key of its words: the check of SLD takes no q."""
        sld = self.clause == SLD_CLAUSE and self.name == "linear_q_code"
        return "linear_sld" if sld else self.name


@dataclass(frozen=True)
class Displacement:
    """One reading of the displacement check (C8.7.1.2.1.8).

    limit, capacity : d_SLV or d_SLC [m], and the capacity there [m/s2]
    period : T_SLV or T_SLC [s]; demand : largest S_De on [T_0, T_SLV] [m]
    """

    limit: float
    capacity: float
    period: float
    demand: float

    @property
    def ratio(self) -> float:
        """zeta, but for a_g,SLD [-]."""
        return self.limit / self.demand


@dataclass(frozen=True)
class KinematicAnalysis:
    """Quantities of the mechanism.

    alpha0 : multiplier that starts it (C8.7.1.1), with the friction of return walls [-]
    e_star : share of the mass that takes part (C8.7.1.5) [-]
    m_star : the mass that takes part, per metre of wall [kg/m]; None without a unit weight
    a0 : spectral acceleration that starts it, with FC (C8.7.1.3) [m/s2]
        these four of one body: the wall, or with the friction of return walls its upper part of `chain.friction_height`
    wall : as it is counted: at SLD without its ties, which pull only once it has moved
    chain : the sums these follow from, of the wall without the friction and of that part with it
    moved : the sums of the displacement check, of a wall held at its top with a hinge of its own, where its zeta is
        least; those of `chain` of others
    d0 : displacement of the centroid at which nothing holds the wall [m]
    free_element : free to vibrate, not restrained by transverse walls before it moves (clauses .3, .5, .7)
    period_0 : T_0 of a free element before it moves (C8.7.1.7) [s]; None where it is not known
    acceleration_demand : a_g S, of a free element S_e(T_0, 5 %) (clause .5); above the ground a_Z and S_eZ(T_0, 5 %)
        [m/s2]; None without T_0
    zeta_sld : a_g,SLD over a_g (C8.7.1.8, C8.7.1.9) [-]; None where acceleration_demand is
    zeta_floor : the same of the wall without its ties and without the friction of return walls, which is lost over a
        slip, where that is less: the displacement check is not below it
    missing : keys of the case without which a free element has no linear check; period_0 where its T_0 is so
        long that it would be elastic up to d_SLV
    d_limit, a_limit : d_SLV = 0.40 d_0 or d_SLC = 0.60 d_0 [m], and the capacity there [m/s2]
    period : T_SLV or T_SLC (C8.7.1.10, .11) [s]
    s_de : largest S_De on [T_0, T_SLV] (clause .8), above the ground not below S_DeZ(T_SLV) [m]; these four are None
        without a spectrum, at SLD
    floor : spectrum of the floor, None on the ground
    without_ties : the displacement check of the wall without the ties that these count; None without ties, and where a
        spectrum of a file ends before its period
    """

    alpha0: float
    e_star: float
    m_star: float | None
    a0: float
    wall: Masonry
    chain: ChainSums
    moved: ChainSums
    d0: float
    free_element: bool
    period_0: float | None
    acceleration_demand: float | None
    zeta_sld: float | None
    zeta_floor: float | None = None
    missing: tuple[str, ...] = ()
    d_limit: float | None = None
    a_limit: float | None = None
    period: float | None = None
    s_de: float | None = None
    floor: FloorSpectrum | None = None
    without_ties: Displacement | None = None

    @property
    def ends_at_break(self) -> bool:
        """Whether a tie that breaks ends d_SLV or d_SLC."""
        bare = self.without_ties
        return bare is not None and self.d_limit is not None and self.d_limit < bare.limit * (1.0 - 1e-12)

    @property
    def displacement(self) -> Displacement | None:
        """Displacement check of the wall. Of a wall with ties it is the one with larger zeta, that with ties or that of
        the bare wall: a tie that breaks ends d_SLV (C8.7.1.2.1.6), and no wall is weaker for a tie that it does not
        need."""
        if self.d_limit is None or self.a_limit is None or self.period is None or self.s_de is None:
            return None
        own = Displacement(self.d_limit, self.a_limit, self.period, self.s_de)
        bare = self.without_ties
        return bare if bare is not None and bare.ratio > own.ratio else own


def elastic_period(wall: Masonry) -> float | None:
    """T_0 = kappa lambda L sqrt(W / (E g)) [s], C8.7.1.7, of the wall as a cantilever of length L = H,
    lambda = L / t, W the unit weight, of a body by its base and `period_share`, and the masses that move with
    it (a rule of ours, `elastic_period_of_loads`); None where E, the unit weight or the rectangle is not given."""
    height, thickness = wall.top, wall.thickness
    if wall.modulus is None or wall.unit_weight is None or height is None or thickness is None:
        return None
    alone = CANTILEVER_KAPPA * height / thickness * height * math.sqrt(wall.unit_weight / (wall.modulus * G))
    if wall.parts:
        alone *= math.sqrt(period_share(wall))
    return math.sqrt(alone**2 + elastic_period_of_loads(wall)) if wall.loads else alone


def _missing(wall: Masonry, demand: SeismicDemand) -> tuple[str, ...]:
    """Keys that a free element lacks for S_e(T_0)."""
    of_wall = {"elastic_modulus_mpa": wall.modulus, "unit_weight_kn_m3": wall.unit_weight, "height_m": wall.height}
    return tuple(name for name, value in (of_wall | {"spectrum": demand.target}).items() if value is None)


def _covers(target, period: float, name: str, wall: Masonry) -> None:
    """Raise InputError where the spectrum of a file ends before a period [s] it is read at."""
    if isinstance(target, GivenSpectrum) and target.periods[-1] < period:
        raise InputError(
            "spectrum_ends",
            name=target.name,
            end=target.periods[-1],
            period_name=name,
            period=period,
            place=(place("wall", name=wall.name),),
        )


def _without_what_stretches(wall: Masonry) -> Masonry:
    """A wall without its ties, which pull only once it has moved: across it, and along one between transverse walls."""
    wall = replace(without_ties(wall) if wall.ties else wall, yielded=())
    return replace(wall, arch=wall.arch.without_tie) if wall.arch is not None and wall.arch.tied else wall


def _pushed_along(wall: Masonry, demand: SeismicDemand, floor: FloorSpectrum | None) -> Masonry:
    """A wall between transverse walls while the demand pushes the masonry beyond its ends along the wall."""
    if wall.arch is None:
        return wall
    largest = demand.pga if floor is None else max(floor.a_z, demand.pga)
    return replace(wall, arch=wall.arch.under(largest / G))


def analyse_mechanism(
    wall: Masonry, mechanism: str, demand: SeismicDemand, floor: FloorSpectrum | None = None
) -> KinematicAnalysis:
    """The mechanism of a wall.

    floor : above the ground the spectrum of its floor; None there means that the demand has none
    Raises InputError where the spectrum of a file ends before T_SLV, T_SLC or T_0.
    """
    wall = _pushed_along(wall, demand, floor)
    wall = _without_what_stretches(wall) if demand.limit_state == "SLD" else wall
    free, sums = wall.is_free(mechanism), sum_chain(wall, kinematics(mechanism).both_ways)
    alpha0, e_star, mass = sums.start
    a0 = alpha0 * G / (e_star * demand.confidence_factor)
    # nothing of a_g,SLD counts for SLV that a tie has to stretch for, and no friction, which is lost over a slip
    without_friction = sums.alpha0_bare * G / (sums.e_star * demand.confidence_factor)
    mass = None if mass is None else e_star * mass
    period_0, acceleration = None, acceleration_at_rest(wall, demand, floor)
    missing: tuple[str, ...] = () if acceleration is not None or free else ("spectrum",)
    if free:
        period_0, missing = elastic_period(wall), _missing(wall, demand)
        if period_0 is not None and not missing:
            # elastic up to d_SLV: no rocking wall
            elastic = max(a0, without_friction) * (period_0 / (2.0 * math.pi)) ** 2
            missing = ("period_0",) if elastic >= LIMIT_FRACTION["SLV"] * sums.d0 else ()
        acceleration = None
        if period_0 is not None and demand.target is not None and not missing:
            spectra = [demand.target, *([] if floor is None else [floor])]
            acceleration = max(float(s.acceleration([period_0], FREE_DAMPING)[0]) for s in spectra)
            _covers(demand.target, period_0, "T_0", wall)
    zeta_sld = zeta_floor = None
    if acceleration is not None:
        zeta_sld, zeta_floor = a0 / acceleration, min(a0, without_friction) / acceleration
    start, moved = 0.0 if missing or period_0 is None else period_0, sums
    held = wall.arch is None or wall.arch.thrust > MIN_THRUST  # of what nothing holds the period has no end
    with_displacement = held and demand.target is not None and demand.limit_state in LIMIT_FRACTION
    if with_displacement and sums.bending is not None:
        moved = _weakest(sums, demand, floor, wall)
    of_both = (alpha0, e_star, mass, a0, wall, sums, moved, moved.d0)
    quantities = (*of_both, free, period_0, acceleration, zeta_sld, zeta_floor, missing)
    if not with_displacement:
        return KinematicAnalysis(*quantities, floor=floor)
    own = _displacement(moved, demand, floor, start, wall)
    bare = None
    if sums.ties:
        with contextlib.suppress(InputError):
            bare = _displacement(replace(sums, ties=()), demand, floor, start, wall)
    return KinematicAnalysis(*quantities, own.limit, own.capacity, own.period, own.demand, floor, bare)


def acceleration_at_rest(wall: Masonry, demand: SeismicDemand, floor: FloorSpectrum | None) -> float | None:
    """a_g S, above the ground not below a_Z, of what does not vibrate before it moves [m/s2]; None of a wall above the
    ground without the spectrum of its floor."""
    if floor is None:
        return None if wall.above_ground else demand.pga
    return max(floor.a_z, demand.pga)


def _weakest(sums: ChainSums, demand: SeismicDemand, floor: FloorSpectrum | None, wall: Masonry) -> ChainSums:
    """The sums of a wall held at its top whose displacement check has the least zeta. Raises InputError where the
    spectrum of a file ends before a period."""
    assert sums.bending is not None

    def zeta(mechanism: Bending) -> float:
        return _displacement(sum_bending_chain(wall, mechanism), demand, floor, 0.0, wall).ratio

    own, arch = sum_bending_chain(wall, governing_mechanism(sums.bending.strip, zeta)), wall.arch
    if wall.yielded:  # a bar that breaks early takes nothing from what the wall stands alone
        with contextlib.suppress(ValueError):
            alone = sum_bending_chain(wall, governing_mechanism(sums.bending.strip._replace(bars=()), zeta))
            return max(own, alone, key=lambda one: _displacement(one, demand, floor, 0.0, wall).ratio)
    if arch is None or not arch.tied or arch.shoulder <= MIN_THRUST:
        return own
    # a tie that breaks early takes nothing from what the masonry beyond holds alone
    alone = sum_chain(replace(wall, arch=arch.without_tie), False)
    return max(own, alone, key=lambda one: _displacement(one, demand, floor, 0.0, wall).ratio)


def _displacement(
    sums: ChainSums, demand: SeismicDemand, floor: FloorSpectrum | None, period_0: float, wall: Masonry
) -> Displacement:
    """Displacement check by the sums of a chain. period_0 : T_0 [s]. Raises InputError where the spectrum of a file
    ends before the period."""
    state, target = demand.limit_state, demand.target
    assert target is not None
    d_limit = sums.limit_of_ties(LIMIT_FRACTION[state] * sums.d0)
    a_limit = capacity_acceleration(sums, d_limit, demand.confidence_factor)
    period = PERIOD_FACTOR[state] * math.sqrt(d_limit / a_limit)
    _covers(target, period, f"T_{state}", wall)
    damping = STATE_DAMPING[state]
    s_de = target_spectrum.largest_displacement(target, min(period_0, period), period, damping)
    if floor is not None:
        s_de = max(s_de, floor.displacement(period, damping))
    return Displacement(d_limit, a_limit, period, s_de)


def capacity_acceleration(sums: ChainSums, d: float, confidence: float) -> float:
    """a(d) (C8.7.1.3) [m/s2]: that of the wall falls to zero at d_0, its ties add what they give at d. None of the
    friction of return walls."""
    return sums.alpha(d) * G / (sums.e_star * confidence)


def _passed(zeta: float, demand: SeismicDemand) -> bool:
    return zeta >= demand.zeta_target - ZETA_ROUNDING


def check_sld(mechanism: KinematicAnalysis, demand: SeismicDemand) -> Check | None:
    """C8.7.1.2.1.5: a0* against the largest acceleration of the ground a_g S (C8.7.1.8), of an element free
    to vibrate against S_e(T_0, 5 %) (C8.7.1.9). None where T_0 of a free element is not known."""
    if mechanism.zeta_sld is None or mechanism.acceleration_demand is None:
        return None
    return Check(
        "linear_q_code",
        SLD_CLAUSE,
        "g",
        mechanism.a0 / G,
        mechanism.acceleration_demand / G,
        mechanism.zeta_sld,
        _passed(mechanism.zeta_sld, demand),
        1.0,
    )


def check_linear(name: str, mechanism: KinematicAnalysis, demand: SeismicDemand, q: float) -> Check | None:
    """C8.7.1.2.1.7, at SLV only: a_g,SLV = q a_g,SLD >= a_g, a_g,SLD obtained by C8.7.1.8, for an element
    free to vibrate by C8.7.1.9 (T_0). None where its T_0 is not known."""
    if mechanism.zeta_sld is None:
        return None
    zeta = q * mechanism.zeta_sld
    return Check(name, Q_CLAUSE, "g", zeta * demand.ag / G, demand.ag / G, zeta, _passed(zeta, demand), q)


def check_displacement(mechanism: KinematicAnalysis, demand: SeismicDemand) -> Check | None:
    """C8.7.1.2.1.8: d_SLV against the largest S_De on [T_0, T_SLV] (T_0 = 0 for restrained walls; for the
    spectrum of a code that is S_De(T_SLV)). Where the a_g,SLV of this check is below a_g,SLD, a_g,SLD counts
    for SLV too. None without a spectrum."""
    compared = mechanism.displacement
    if compared is None:
        return None
    zeta = _not_below_sld(compared.ratio, mechanism, demand)
    return Check("nonlinear", DISPLACEMENT_CLAUSE, "m", compared.limit, compared.demand, zeta, _passed(zeta, demand))


def _not_below_sld(zeta: float, mechanism: KinematicAnalysis, demand: SeismicDemand) -> float:
    """zeta of a displacement check, at SLV not below a_g,SLD over a_g (C8.7.1.2.1.8)."""
    floor = mechanism.zeta_floor if demand.limit_state == "SLV" else None
    return zeta if floor is None else max(zeta, floor)


def zeta_with_and_without_ties(mechanism: KinematicAnalysis, demand: SeismicDemand) -> tuple[float, float] | None:
    """zeta of the displacement check of a wall with its ties and of the same wall without them; None of a wall whose
    ties this check does not count."""
    bare = mechanism.without_ties
    if bare is None or mechanism.d_limit is None or mechanism.s_de is None:
        return None
    own = mechanism.d_limit / mechanism.s_de
    return _not_below_sld(own, mechanism, demand), _not_below_sld(bare.ratio, mechanism, demand)


CHECKS = ("dynamic", "nonlinear", "linear_q_slv", "linear_q_code", "hold")
"""Names of the checks, the most refined first; the time histories are made by dynamic_check, and what holds a wall is
beside them all."""


def make_kinematic_checks(
    mechanism: KinematicAnalysis, demand: SeismicDemand, q_slv: float | None = None
) -> tuple[Check, ...]:
    """The kinematic checks that can be made at a demand, the most refined first.

    q_slv : of time histories, counted from a0*; None without it [-]
    """
    made = [check_displacement(mechanism, demand)]
    if demand.limit_state == "SLD":
        made.append(check_sld(mechanism, demand))
    elif demand.limit_state == "SLV":
        made.append(None if q_slv is None else check_linear("linear_q_slv", mechanism, demand, q_slv))
        made.append(check_linear("linear_q_code", mechanism, demand, demand.q_code))
    return tuple(check for check in made if check is not None)
