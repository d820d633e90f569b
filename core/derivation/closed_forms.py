"""Eq. 9 to 16: q of a record, and of the closed forms. SI in cm, alpha in degrees, H in m, accelerations in g."""

from core.capacity.closed_forms import COEFFICIENTS
from core.derivation.line import Line, Section
from core.derivation.quantity import Quantity, quantity
from core.study.results import WallResult


@quantity("q", "–", "Eq. 10", 2, "0.00")
def q(collapse_scale, pga, a_rm_run):
    return collapse_scale * pga / a_rm_run


@quantity("q_eff", "–", "Eq. 12", 2, "0.00")
def q_eff(q, pga):
    return q / pga


@quantity("q_eff", "–", "{form}", 2, "0.00", label="q_eff of the demand")
def q_eff_closed(a1, slenderness, a2, height, a3, demand_si, c2):
    return (a1 * slenderness + a2 * height + a3) * demand_si**c2


@quantity("q_eff", "–", "{form}", 2, "0.00", name="q_eff_closed", label="q_eff of the demand")
def q_eff_closed_of_block(a1, slenderness, a2, equivalent_height, a3, demand_si, c2):
    return (a1 * slenderness + a2 * equivalent_height + a3) * demand_si**c2


@quantity("q", "–", "{form}", 2, "0.00", label="q = q_eff S a_g / g of the demand")
def q_closed(q_eff_closed, demand_pga):
    return q_eff_closed * demand_pga


@quantity("S a_g/q", "g", "Eq. 9", 3, "0.000")
def demand_over_q(demand_pga, q):
    return demand_pga / q


@quantity("ratio", "–", "Eq. 9", 2, "0.00")
def capacity_over_demand(a_rm, demand_over_q):
    return a_rm / demand_over_q


def closed_q_eff(wall: WallResult) -> Quantity:
    """Formula of q_eff by Eq. 15 or 16 for a block of this kind."""
    return q_eff_closed if wall.block.is_rectangle else q_eff_closed_of_block


def constants(wall: WallResult) -> dict[str, float]:
    """Coefficients of Eq. 15, of a one-sided wall those of Eq. 16."""
    return dict(zip(("a1", "a2", "a3", "c2"), COEFFICIENTS[wall.kinematics.one_way], strict=True))


def closed(wall: WallResult) -> Section:
    """Lines of q by the closed form at the demand."""
    if wall.closed_form_q is None:
        return Section("", [])
    form = {"form": "Eq. 16" if wall.kinematics.one_way else "Eq. 15"}
    lines = [
        Line(closed_q_eff(wall), wall.closed_form_q_eff, words=form),
        Line(q_closed, wall.closed_form_q, words=form),
    ]
    return Section("", lines, constants(wall))
