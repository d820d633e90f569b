"""The demand: ground, branches of the spectrum of NTC 2018, SI of a code's spectrum. g, s, cm."""

from core.codes.target_spectrum import SI_FROM, SI_TO
from core.derivation.functions import log
from core.derivation.quantity import Given, quantity

AG = Given("demand_ag", "a_g", "g", 3, "0.000", "a_g on rock")
S = Given("demand_s", "S", "–", 3, "0.00")
FC = Given("demand_fc", "FC", "–", 2, "0.00")
ZETA = Given("zeta_target", "ζ", "–", 2, "0.00", "ζ required")
F0 = Given("spectrum_f0", "F0", "–", 3, "0.000")
TC_STAR = Given("spectrum_tc_star", "T_C*", "s", 3, "0.000")
T_B = Given("spectrum_tb", "T_B", "s", 3, "0.000")
T_C = Given("spectrum_tc", "T_C", "s", 3, "0.000")
T_D = Given("spectrum_td", "T_D", "s", 3, "0.000")
SI = Given("demand_si", "SI", "cm", 1, "0.00", "SI of the demand")
Q = Given("code_q", "q", "–", 2, "0.00", "q of the code")


@quantity("S a_g", "g", "", 3, "0.000")
def demand_pga(demand_s, demand_ag):
    return demand_s * demand_ag


# NTC 2018, Tab. 3.2.IV and .V: soil_* and topography are of the site


@quantity("S", "–", "3.2.3", 3, "0.00", label="S = S_S S_T ({soil}, {topography})")
def demand_s(soil_a, soil_b, spectrum_f0, demand_ag, soil_low, soil_high, topography):
    return min(max(soil_a - soil_b * spectrum_f0 * demand_ag, soil_low), soil_high) * topography


@quantity("T_C", "s", "3.2.5")
def spectrum_tc(soil_c, spectrum_tc_star, soil_d):
    return soil_c * spectrum_tc_star**soil_d * spectrum_tc_star


@quantity("T_B", "s", "3.2.6")
def spectrum_tb(spectrum_tc):
    return spectrum_tc / 3


@quantity("T_D", "s", "3.2.7")
def spectrum_td(demand_ag):
    return 4 * demand_ag + 1.6


# Eq. 11: what SI of the run becomes


def area(f0, tb, tc, td):
    return (
        (tb**2 - min(SI_FROM, tb) ** 2) / 2
        + (f0 - 1) * (tb**3 - min(SI_FROM, tb) ** 3) / (3 * tb)
        + f0 * (tc**2 - max(tb, SI_FROM) ** 2) / 2
        + f0 * tc * (min(td, SI_TO) - tc)
        + f0 * tc * td * log(SI_TO / min(td, SI_TO))
    )


@quantity("SI", "cm", "Eq. 11", 1, "0.00", name="demand_si", label="SI of the demand")
def intensity_of_spectrum(si_run, area_run, demand_pga, pga_run, spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td):
    return si_run * demand_pga / pga_run * area(spectrum_f0, spectrum_tb, spectrum_tc, spectrum_td) / area_run


@quantity("SI", "cm", "Eq. 11", 1, "0.00", name="demand_si", label="SI of the demand")
def intensity_of_records(si_run, demand_pga, pga_run):
    return si_run * demand_pga / pga_run
