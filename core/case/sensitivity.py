"""[sensitivity]: by how much each input of a wall is moved, to show what that does to zeta."""

from dataclasses import dataclass

from core.case.keys import flag_key, key


def factors_key(low: float, high: float):
    """Two factors of a value, the lower first."""
    return key("factors", (low, high))


MIN_FACTOR, MAX_FACTOR = 0.1, 10.0
"""Factors accepted."""

MAX_ADDED = 0.3
"""Largest length added to a hinge setback [m]."""


@dataclass(frozen=True)
class Ranges:
    """[sensitivity]: the moves of each input; the reasons of the defaults are in resources/docs/sure.md.

    thickness_factor : and of the distances of its loads from its outer face
    load_factor : of all loads
    setback_m : added to the hinge setback [m]
    out_of_plumb_m : added outward for each storey of the height of a wall of rectangular outline [m]
    velocity_ratio_factor : of the theoretical velocity ratio, of Eq. 4 or 6
    modulus_factor : of the modulus that T_0 follows from
    building_period_factor, building_damping_factor : of the building that carries the wall
    ag_factor : of a_g, and of records that are used as given
    restraint_lost : a wall restrained behind it, or at its top, no longer is
    record_left_out : each record in turn, under the rule of the whole set
    """

    thickness_factor: tuple[float, float] = factors_key(0.95, 1.0)
    unit_weight_factor: tuple[float, float] = factors_key(0.9, 1.1)
    load_factor: tuple[float, float] = factors_key(0.8, 1.2)
    setback_m: tuple[float, float] = key("setbacks", (0.0, 0.03))
    out_of_plumb_m: tuple[float, float] = key("setbacks", (0.0, 0.02))
    velocity_ratio_factor: tuple[float, float] = factors_key(0.9, 1.0)
    modulus_factor: tuple[float, float] = factors_key(0.5, 2.0)
    building_period_factor: tuple[float, float] = factors_key(0.8, 1.2)
    building_damping_factor: tuple[float, float] = factors_key(0.5, 2.0)
    ag_factor: tuple[float, float] = factors_key(0.9, 1.1)
    restraint_lost: bool = flag_key(True)
    record_left_out: bool = flag_key(True)
