"""The kinematic chain, the linear and the displacement check, and what the mechanism withstands.

kN, m, s, degrees, accelerations in g unless said; per metre of wall. A mode of the building is t, xi, part (gamma psi)
and se, the elastic spectrum at both [g].
"""

from core.codes.kinematic import CANTILEVER_KAPPA
from core.derivation.functions import arctan, kilo, pi, sin, sqrt, tan
from core.derivation.quantity import Given, quantity

ALPHA0_FRICTION = Given("alpha0_friction", "α0,f", "–", 4, label="α0 with friction, top {h:.2f} m", clause="C8.7.1.1")
E_STAR = Given("e_star", "e*", "–", 3, "0.00", clause="C8.7.1.5")
E_STAR_FRICTION = Given("e_star_friction", "e*", "–", 3, label="e* of that part", clause="C8.7.1.5")
MASS = Given("mass", "Σ(P + Q)/g", "kg/m", 0, "0")
MODULUS = Given("modulus", "E", "MPa", 0)
SE_T0_GIVEN = Given("se_t0", "S_e(T_0, 5 %)", "g", 3, clause="C8.7.1.9")
SEZ_T0_GIVEN = Given("se_t0", "S_eZ(T_0, 5 %)", "g", 3, clause="C8.7.1.9")
T0_GIVEN = Given("period_0", "T_0", "s", clause="C8.7.1.7")
Q_SLV = Given("q_slv", "q SLV", "–", 2)
Q_SLV_LOW = Given("q_slv_low", "q_SLV,min", "–", 3, label="lower end of the spread of q SLV")
Q_SLV_ROBUST = Given("q_slv_robust", "q_SLV,rob", "–", 3, label="around which 16 % of the points reach SLV")
Q_SLV_SAFE = Given("q_slv_safe", "q_SLV,s", "–", 3, label="q SLV of the linear check, of each record the lower")
D_BREAK = Given("d_limit", "d_{state}", "m", 4, label="d_{state}, where a tie breaks", clause="C8.7.1.2.1.6")
D0_WITH_TIES = Given("d0_with_ties", "d_0,T", "m", 4, label="d_0 were the ties at yield up to collapse, not taken")
D0_GIVEN = Given("d0", "d_0", "m", 4, clause="C8.7.1.4")
S_DE_BARE_GIVEN = Given("s_de_bare", "S_De,b max, [T_0, T_{state}], {damping} %", "m", 4, clause="C8.7.1.12")
S_DE_GIVEN = Given("s_de", "S_De max, [T_0, T_{state}], {damping} %", "m", 4, clause="C8.7.1.12")
S_DEZ_GIVEN = Given("s_de", "S_DeZ(T_{state}, {damping} %)", "m", 4, clause="C8.7.1.12")

PEAK = Given("peak", "θmax/θc", "–", 3, label="θmax/θc of the set (Dynamic check)", clause="C8.7.1.2.1.9")
LIMIT = Given("peak_limit", "θmax/θc", "–", 2, "0.00", "limit", "C8.7.1.2.1.9")
EXCEEDED = Given("exceeded", "n", "–", label="runs beyond θc")
DYNAMIC_ZETA = Given("dynamic_zeta", "ζ_E", "–", 3, clause="C8.7.1.2.1.9")
ZETA_16 = Given("zeta_16", "ζ_16", "–", 3)
ZETA_OTHER = Given("zeta_other", "ζ_E", "–", 3)

HOLD_ASKED = Given("hold_asked", "R_d", "kN/m", 2, "0.00", label="R_d, of the hold that gives way first")
HOLD_STANDS = Given("hold_stands", "R_u", "kN/m", 2, "0.00", label="R_u, what it stands")
HOLD_ZETA = Given("hold_zeta", "ζ_R", "–", 3, clause="C8.7.1.2.1")

MODES = {"mode.t": "T", "mode.xi": "ξ", "mode.part": "γψ", "mode.se": "S_e(T, ξ)"}
"""Columns of the table of modes, with their symbols."""


# the start of the motion


@quantity("W x", "kN", "C8.7.1.1", 2, "0.00")
def wx(w, x):
    return w * x


@quantity("ΣN d", "kN", "C8.7.1.1", 2, "0.00")
def nd(loads):
    return sum(load.n * load.d for load in loads)


@quantity("ΣF h", "kN", "C8.7.1.1", 2, "0.00")
def fh(loads):
    return sum(load.f * load.h for load in loads)


@quantity("W y", "kN", "C8.7.1.1", 2, "0.00")
def wy(w, y):
    return w * y


@quantity("ΣQ h", "kN", "C8.7.1.1", 2, "0.00")
def qh(loads):
    return sum(load.q * load.h for load in loads)


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_with_loads(wx, nd, fh, wy, qh):
    return (wx + nd + fh) / (wy + qh)


@quantity("ΣT h", "kN", "C8.7.1.1", 2, "0.00")
def th(loads):
    return sum(load.t * load.h for load in loads)


@quantity("α0,b", "–", "C8.7.1.1", 4, label="α0 without its ties")
def alpha0_bare(wx, nd, fh, wy, qh):
    return (wx + nd + fh) / (wy + qh)


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_with_ties(alpha0_bare, th, wy, qh):
    return alpha0_bare + th / (wy + qh)


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_of_sizes(thickness, height):
    return thickness / height


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_with_setback(thickness, setback, height):
    return (thickness - 2 * setback) / height


@quantity("α0", "–", "C8.7.1.1", 4)
def alpha0(slenderness):
    return tan(slenderness)


@quantity("e*", "–", "C8.7.1.5", 3, name="e_star")
def e_star_with_loads(w, y, loads, wy, qh):
    return (wy + qh) ** 2 / (
        (w + sum(load.q for load in loads)) * (w * y**2 + sum(load.q * load.h**2 for load in loads))
    )


@quantity("M*", "kg/m", "C8.7.1.4", 0, "0", label="M* per metre")
def m_star(e_star, mass):
    return e_star * mass


@quantity("M*", "kg/m", "C8.7.1.4", 0, "0", name="m_star", label="M* per metre of that part")
def m_star_with_friction(e_star_friction, mass):
    return e_star_friction * mass


@quantity("a_0*", "g", "C8.7.1.3", 4)
def a0_star(alpha0, e_star, demand_fc):
    return alpha0 / (e_star * demand_fc)


@quantity("a_0*", "g", "C8.7.1.3", 4, name="a0_star")
def a0_star_with_friction(alpha0_friction, e_star_friction, demand_fc):
    return alpha0_friction / (e_star_friction * demand_fc)


# the linear check


@quantity("a_Z", "g", "C7.2.8", 3)
def a_z(modes):
    return sqrt(sum((mode.se * mode.part) ** 2 * (1 + 4 * mode.xi**2) for mode in modes))


@quantity("T_0", "s", "C8.7.1.7")
def period_0(height, thickness, weight, modulus, gravity):
    return CANTILEVER_KAPPA * (height / thickness) * height * sqrt(weight / (kilo(modulus) * gravity))


@quantity("T_0", "s", "C8.7.1.7", name="period_0")
def period_0_of_slenderness(height, slenderness, weight, modulus, gravity):
    return CANTILEVER_KAPPA / tan(slenderness) * height * sqrt(weight / (kilo(modulus) * gravity))


@quantity("T_0", "s", "C8.7.1.7", name="period_0")
def period_0_with_loads(height, thickness, weight, modulus, gravity, loads):
    return sqrt(
        (CANTILEVER_KAPPA * (height / thickness) * height) ** 2 * weight / (kilo(modulus) * gravity)
        + 16 * pi**2 * sum(load.q * load.h**3 for load in loads) / (kilo(modulus) * gravity * thickness**3)
    )


def shape(t, damping, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td):
    return max(sqrt(10 / (5 + damping)), 0.55) * spectrum_f0 * branch(t, spectrum_tb, spectrum_tc, spectrum_td) + below(
        t, spectrum_tb
    )


def branch(t, spectrum_tb, spectrum_tc, spectrum_td):
    return (
        t / spectrum_tb
        if t < spectrum_tb
        else (1 if t < spectrum_tc else (spectrum_tc / t if t < spectrum_td else spectrum_tc * spectrum_td / t**2))
    )


def below(t, spectrum_tb):
    return max(1 - t / spectrum_tb, 0)


@quantity("S_e(T_0, 5 %)", "g", "C8.7.1.9", 3)
def se_t0(demand_pga, period_0, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td):
    return demand_pga * shape(period_0, 5, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td)


@quantity("S_e(T_0, 5 %)", "g", "3.2.2", 3, name="se_t0")
def se_rising(demand_pga, period_0, spectrum_f0, spectrum_tb):
    return demand_pga * (spectrum_f0 * period_0 / spectrum_tb + 1 - period_0 / spectrum_tb)


@quantity("S_e(T_0, 5 %)", "g", "3.2.2", 3, name="se_t0")
def se_plateau(demand_pga, spectrum_f0):
    return demand_pga * spectrum_f0


@quantity("S_e(T_0, 5 %)", "g", "3.2.2", 3, name="se_t0")
def se_falling(demand_pga, period_0, spectrum_f0, spectrum_tc):
    return demand_pga * spectrum_f0 * spectrum_tc / period_0


@quantity("S_e(T_0, 5 %)", "g", "3.2.2", 3, name="se_t0")
def se_last(demand_pga, period_0, spectrum_f0, spectrum_tc, spectrum_td):
    return demand_pga * spectrum_f0 * spectrum_tc * spectrum_td / period_0**2


SE_BRANCHES = se_rising, se_plateau, se_falling, se_last
"""S_e(T_0) on each branch of the spectrum of a code (NTC 2018 Eq. 3.2.2, EN 1998-1 Eq. 3.2 to 3.5)."""


@quantity("a_g,SLD/a_g", "–", "C8.7.1.8")
def zeta_sld(a0_star, demand_pga):
    return a0_star / demand_pga


@quantity("a_g,SLD/a_g", "–", "C8.7.1.8", name="zeta_sld")
def zeta_sld_on_floor(a0_star, a_z, demand_pga):
    return a0_star / max(a_z, demand_pga)


@quantity("a_g,SLD/a_g", "–", "C8.7.1.9", name="zeta_sld")
def zeta_sld_of_free_element(a0_star, se_t0):
    return a0_star / se_t0


@quantity("q", "–", "C8.7.1.2.1.7", 2)
def linear_q_code(code_q):
    return code_q


@quantity("q", "–", "C8.7.1.5")
def linear_q_slv(q_slv_safe, e_star):
    return q_slv_safe * e_star


@quantity("q", "–", "C8.7.1.5", name="linear_q_slv")
def linear_q_slv_with_friction(q_slv_safe, e_star_friction, alpha0, alpha0_friction):
    return q_slv_safe * e_star_friction * min(1, alpha0 / alpha0_friction)


@quantity("q", "–", "C8.7.1.5", name="linear_q_slv")
def linear_q_slv_with_ties(q_slv_safe, e_star, alpha0, alpha0_bare):
    return q_slv_safe * e_star * alpha0_bare / alpha0


@quantity("q", "–", "C8.7.1.5", name="linear_q_slv")
def linear_q_slv_with_ties_and_friction(q_slv_safe, e_star_friction, alpha0_bare, alpha0_friction):
    return q_slv_safe * e_star_friction * min(1, alpha0_bare / alpha0_friction)


@quantity("ζ", "–", "C8.7.1.2.1.7")
def linear_q_code_zeta(linear_q_code, zeta_sld):
    return linear_q_code * zeta_sld


@quantity("ζ", "–", "C8.7.1.2.1.7")
def linear_q_slv_zeta(linear_q_slv, zeta_sld):
    return linear_q_slv * zeta_sld


# the displacement check; share and factor are of the limit state


@quantity("d_0", "m", "C8.7.1.4", 4)
def d0(radius, slenderness):
    return radius * sin(slenderness)


@quantity("d_C", "m", "C8.7.1.4", 4)
def d_c(x, y, theta_c_degrees):
    return x - sqrt(x**2 + y**2) * sin(arctan(x / y) - theta_c_degrees)


@quantity("d_0", "m", "C8.7.1.4", 4, name="d0")
def d0_with_loads(d_c, w, y, wy, qh, loads):
    return d_c * (w * y**2 + sum(load.q * load.h**2 for load in loads)) / (y * (wy + qh))


@quantity("d_{state}", "m", "C8.7.1.2.1.6", 4)
def d_limit(share, d0):
    return share * d0


@quantity("a(d_{state})", "m/s²", "C8.7.1.3")
def a_limit(share, alpha0, gravity, e_star, demand_fc):
    return (1 - share) * alpha0 * gravity / (e_star * demand_fc)


@quantity("ΣT_d h", "kN", "C8.7.1.2.1.6", 2, "0.00", label="ΣT h of the ties at d_{state}")
def th_limit(loads):
    return sum(load.l * load.h for load in loads)


@quantity("a(d_{state})", "m/s²", "C8.7.1.3", name="a_limit")
def a_limit_with_ties(d_limit, d0, alpha0_bare, th_limit, wy, qh, gravity, e_star, demand_fc):
    return ((1 - d_limit / d0) * alpha0_bare + th_limit / (wy + qh)) * gravity / (e_star * demand_fc)


@quantity("T_{state}", "s", "{period_clause}")
def period(factor, d_limit, a_limit):
    return factor * pi * sqrt(d_limit / a_limit)


@quantity("S_De({damping} %)", "m", "C8.7.1.12", 4)
def s_de(demand_pga, gravity, period, damping, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td):
    return (
        demand_pga
        * gravity
        * shape(period, damping, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td)
        * (period / (2 * pi)) ** 2
    )


@quantity("S_De({damping} %)", "m", "3.2.11", 4, name="s_de")
def s_de_rising(demand_pga, gravity, period, damping, spectrum_f0, spectrum_tb):
    return (
        demand_pga
        * gravity
        * (sqrt(10 / (5 + damping)) * spectrum_f0 * period / spectrum_tb + 1 - period / spectrum_tb)
        * (period / (2 * pi)) ** 2
    )


@quantity("S_De({damping} %)", "m", "3.2.11", 4, name="s_de")
def s_de_plateau(demand_pga, gravity, period, damping, spectrum_f0):
    return demand_pga * gravity * sqrt(10 / (5 + damping)) * spectrum_f0 * (period / (2 * pi)) ** 2


@quantity("S_De({damping} %)", "m", "3.2.11", 4, name="s_de")
def s_de_falling(demand_pga, gravity, period, damping, spectrum_f0, spectrum_tc):
    return demand_pga * gravity * sqrt(10 / (5 + damping)) * spectrum_f0 * spectrum_tc * period / (2 * pi) ** 2


@quantity("S_De({damping} %)", "m", "3.2.11", 4, name="s_de")
def s_de_last(demand_pga, gravity, damping, spectrum_f0, spectrum_tc, spectrum_td):
    return demand_pga * gravity * sqrt(10 / (5 + damping)) * spectrum_f0 * spectrum_tc * spectrum_td / (2 * pi) ** 2


S_DE_BRANCHES = s_de_rising, s_de_plateau, s_de_falling, s_de_last
"""S_De on each branch; eta = sqrt(10/(5 + xi)) of NTC 2018 Eq. 3.2.4 is above 0.55 at the damping of the clauses."""


@quantity("ζ", "–", "C8.7.1.2.1.8")
def nonlinear_zeta(d_limit, s_de):
    return d_limit / s_de


@quantity("d_{state}/S_De", "–", "C8.7.1.12")
def displacement_ratio(d_limit, s_de):
    return d_limit / s_de


# the same without the ties


@quantity("d_{state},b", "m", "C8.7.1.2.1.6", 4, label="d_{state} without its ties")
def d_limit_bare(share, d0):
    return share * d0


@quantity("a(d_{state},b)", "m/s²", "C8.7.1.3", label="a(d_{state}) without its ties")
def a_limit_bare(share, alpha0_bare, gravity, e_star, demand_fc):
    return (1 - share) * alpha0_bare * gravity / (e_star * demand_fc)


@quantity("T_{state},b", "s", "{period_clause}", label="T_{state} without its ties")
def period_bare(factor, d_limit_bare, a_limit_bare):
    return factor * pi * sqrt(d_limit_bare / a_limit_bare)


@quantity("S_De,b({damping} %)", "m", "C8.7.1.12", 4, label="S_De({damping} %) without its ties")
def s_de_bare(demand_pga, gravity, period_bare, damping, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td):
    return (
        demand_pga
        * gravity
        * shape(period_bare, damping, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td)
        * (period_bare / (2 * pi)) ** 2
    )


@quantity("d_{state},b/S_De,b", "–", "C8.7.1.12", label="d_{state}/S_De without its ties")
def displacement_ratio_bare(d_limit_bare, s_de_bare):
    return d_limit_bare / s_de_bare


@quantity("ζ", "–", "C8.7.1.2.1.8", name="nonlinear_zeta")
def nonlinear_zeta_of_ties(displacement_ratio, displacement_ratio_bare):
    return max(displacement_ratio, displacement_ratio_bare)


@quantity("ζ", "–", "C8.7.1.2.1.8", name="nonlinear_zeta")
def nonlinear_zeta_of_ties_at_slv(displacement_ratio, displacement_ratio_bare, zeta_floor):
    return max(displacement_ratio, displacement_ratio_bare, zeta_floor)


@quantity("a_g,SLD,d/a_g", "–", "C8.7.1.2.1.8", name="zeta_floor", label="not below a_g,SLD,d / a_g")
def zeta_floor(zeta_sld):
    return zeta_sld


@quantity("a_g,SLD,d/a_g", "–", "C8.7.1.2.1.8", name="zeta_floor", label="not below a_g,SLD,d / a_g")
def zeta_floor_with_friction(zeta_sld, alpha0, e_star, alpha0_friction, e_star_friction):
    return min(zeta_sld, zeta_sld * (alpha0 / e_star) / (alpha0_friction / e_star_friction))


@quantity("a_g,SLD,d/a_g", "–", "C8.7.1.2.1.8", name="zeta_floor", label="not below a_g,SLD,d / a_g")
def zeta_floor_with_ties(zeta_sld, alpha0, alpha0_bare):
    return zeta_sld * min(1, alpha0_bare / alpha0)


@quantity("a_g,SLD,d/a_g", "–", "C8.7.1.2.1.8", name="zeta_floor", label="not below a_g,SLD,d / a_g")
def zeta_floor_with_ties_and_friction(zeta_sld, alpha0_bare, e_star, alpha0_friction, e_star_friction):
    return min(zeta_sld, zeta_sld * (alpha0_bare / e_star) / (alpha0_friction / e_star_friction))


@quantity("ζ", "–", "C8.7.1.2.1.8", name="nonlinear_zeta")
def nonlinear_zeta_at_slv(displacement_ratio, zeta_floor):
    return max(displacement_ratio, zeta_floor)


# what the mechanism withstands; zeta is that of the check that decides


@quantity("PGA_C", "g", "", 3)
def pga_c(zeta, demand_pga):
    return zeta * demand_pga


@quantity("T_R,C", "{years}", "", 0, "0.00", label="T_R,C = T_R,D ζ^η, min")
def tr_c(tr_d, zeta, eta_italy, eta_site):
    return min(tr_d * zeta**eta_italy, tr_d * zeta**eta_site)


@quantity("T_R,C", "{years}", "", 0, "0.00", label="T_R,C, max")
def tr_c_longer(tr_d, zeta, eta_italy, eta_site):
    return max(tr_d * zeta**eta_italy, tr_d * zeta**eta_site)


@quantity("IS-V", "–", "D.M. 65/2017", 2, "0.00", label="IS-V of this mechanism, class {letter}")
def is_v(pga_c, demand_pga):
    return pga_c / demand_pga
