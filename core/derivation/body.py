"""The body: sizes, loads, block, impact, uplift. kN, m, s, degrees; per metre of wall.

A load is n and f, the vertical and the outward force [kN/m], at d inward of the hinge and h above it [m], and q, the
weight of the mass that moves with it [kN/m]. A tie is t, its force in alpha_0, and l, its force at the limit of the
displacement check [kN/m], at h.
"""

from core.derivation.functions import arctan, cos, pi, sin, sqrt, tan
from core.derivation.quantity import Given, quantity
from core.wall.restitution import EQ5_FACTOR, EQ7_FACTOR

GRAVITY = Given("gravity", "g", "m/s²", 2, "0.00000")
HEIGHT = Given("height", "H", "m", 2, "0.00")
THICKNESS = Given("thickness", "t", "m", 3, "0.000")
SETBACK = Given("setback", "u", "m", 4, label="hinge setback u")
UNIT_WEIGHT = Given("weight", "w", "kN/m³", 1, "0.00", "unit weight")
SLENDERNESS = Given("slenderness", "α", "°", 2)
RADIUS = Given("radius", "R", "m")
INERTIA = Given("inertia", "I0/m", "m²")
VELOCITY_RATIO = Given("velocity_ratio", "e", "–", 3, label="velocity ratio e ({model})")

LOADS = {"load.n": "N", "load.f": "F", "load.d": "d", "load.h": "h", "load.q": "Q"}
"""Columns of the table of loads, with their symbols."""

SOLIDS = {"solid.m": "M", "solid.x": "x", "solid.z": "z", "solid.i": "I"}
"""Columns of the table of solids: mass, centroid from the outer face of the base, moment of inertia about it."""

LENGTH = Given("length", "L", "m", 2, "0.00")

TIES = {"load.t": "T", "load.l": "T_d"}
"""Columns added to LOADS for a wall with ties: their force in alpha_0, and at the limit of the displacement check."""


# a rectangle, with or without a setback of its hinge


@quantity("α", "°", "Fig. 1", 2, name="slenderness")
def slenderness_of_sizes(thickness, height):
    return arctan(thickness / height)


@quantity("α", "°", "Fig. 1", 2, name="slenderness")
def slenderness_with_setback(thickness, setback, height):
    return arctan((thickness - 2 * setback) / height)


@quantity("R", "m", "Fig. 1", name="radius")
def radius_of_rectangle(height, slenderness):
    return height / (2 * cos(slenderness))


@quantity("R", "m", "Fig. 1", name="radius")
def radius_with_setback(height, thickness, setback):
    return sqrt(height**2 + (thickness - 2 * setback) ** 2) / 2


@quantity("I0/m", "m²", "Fig. 1", name="inertia")
def inertia_with_setback(height, thickness, radius):
    return (height**2 + thickness**2) / 12 + radius**2


# a body of solids; x from the hinge the formulas are about


@quantity("M", "kg", "", 1, "0.0")
def body_mass(solids):
    return sum(solid.m for solid in solids)


@quantity("x_G", "m", "", 4)
def x_g(solids, body_mass):
    return sum(solid.m * solid.x for solid in solids) / body_mass


@quantity("z_G", "m", "", 4)
def z_g(solids, body_mass):
    return sum(solid.m * solid.z for solid in solids) / body_mass


@quantity("I_O", "kg m²", "", 1, "0.0")
def i_o(solids):
    return sum(solid.i for solid in solids)


@quantity("I_G/M", "m²", "", 4)
def i_g(i_o, body_mass, x_g, z_g):
    return i_o / body_mass - x_g**2 - z_g**2


@quantity("x", "m", "", 4, name="x")
def x_of_body(x_g, setback):
    return x_g - setback


@quantity("x", "m", "", 4, name="x")
def x_of_body_inward(thickness, setback, x_g):
    return thickness - setback - x_g


@quantity("y", "m", "", 4, name="y")
def y_of_body(z_g):
    return z_g


@quantity("α", "°", "Fig. 1", 2, name="slenderness")
def slenderness_of_body(x, y):
    return arctan(x / y)


@quantity("R", "m", "Fig. 1", name="radius")
def radius_of_body(x, y):
    return sqrt(x**2 + y**2)


@quantity("I0/m", "m²", "Fig. 1", name="inertia")
def inertia_of_body(i_g, radius):
    return i_g + radius**2


@quantity("W", "kN/m", "", 2, "0.000", name="w")
def w_of_body(gravity, body_mass, length):
    return gravity * body_mass / (1000 * length)


@quantity("I0/m", "m²", "Fig. 1", name="inertia")
def inertia_of_body_with_loads(w, i_g, x, y, loads):
    return (w * (i_g + x**2 + y**2) + sum(load.q * (load.d**2 + load.h**2) for load in loads)) / (
        w + sum(load.q for load in loads)
    )


# with loads


@quantity("W", "kN/m", "", 2, "0.000")
def w(weight, thickness, height):
    return weight * thickness * height


@quantity("x", "m", "", 3, "0.000")
def x(thickness, setback):
    return thickness / 2 - setback


@quantity("y", "m", "", 3, "0.000")
def y(height):
    return height / 2


@quantity("α", "°", "Fig. 1", 2, name="slenderness")
def slenderness_with_loads(w, x, y, loads):
    return arctan((w * x + sum(load.q * load.d for load in loads)) / (w * y + sum(load.q * load.h for load in loads)))


@quantity("R", "m", "Fig. 1", name="radius")
def radius_with_loads(w, x, y, loads):
    return sqrt(
        (w * x + sum(load.q * load.d for load in loads)) ** 2 + (w * y + sum(load.q * load.h for load in loads)) ** 2
    ) / (w + sum(load.q for load in loads))


@quantity("I0/m", "m²", "Fig. 1", name="inertia")
def inertia_with_loads(w, height, thickness, x, y, loads):
    return (
        w * ((height**2 + thickness**2) / 12 + x**2 + y**2) + sum(load.q * (load.d**2 + load.h**2) for load in loads)
    ) / (w + sum(load.q for load in loads))


@quantity("a", "–", "Eq. 1")
def a(w, radius, slenderness, loads):
    return 1 + sum(
        (load.n - load.q) * (load.h * cos(slenderness) + load.d * sin(slenderness))
        - load.f * (load.d * cos(slenderness) - load.h * sin(slenderness))
        for load in loads
    ) / ((w + sum(load.q for load in loads)) * radius)


@quantity("c", "–", "Eq. 1")
def c(w, radius, slenderness, loads):
    return sum(
        (load.n - load.q) * (load.d * cos(slenderness) - load.h * sin(slenderness))
        + load.f * (load.h * cos(slenderness) + load.d * sin(slenderness))
        for load in loads
    ) / ((w + sum(load.q for load in loads)) * radius)


@quantity("θ_c,°", "°", "Eq. 1", 4)
def theta_c_degrees(slenderness, c, a):
    return slenderness + arctan(c / a)


@quantity("θ_c", "rad", "Eq. 1")
def theta_c(theta_c_degrees):
    return pi * theta_c_degrees / 180


# any block


@quantity("H", "m", "Eq. 15, 16", label="H = 2 R_eq cos α (equivalent)")
def equivalent_height(inertia, radius, slenderness):
    return 1.5 * inertia / radius * cos(slenderness)


@quantity("p", "rad/s", "Eq. 1", name="p")
def p_of_rectangle(gravity, radius):
    return sqrt(3 * gravity / (4 * radius))


@quantity("p", "rad/s", "Eq. 1")
def p(gravity, radius, inertia):
    return sqrt(gravity * radius / inertia)


@quantity("a_RM", "g", "Eq. 2", 3, "0.000")
def a_rm(slenderness):
    return tan(slenderness)


@quantity("a_RM", "g", "Eq. 2", 3, "0.000", name="a_rm")
def a_rm_with_loads(a, slenderness, c):
    return a * tan(slenderness) + c


# impacts: from the outer to the inner hinge, and from there to the top of the inner face


@quantity("e_b", "–", "Eq. 4", name="e_base")
def e_base_of_rectangle(slenderness):
    return 1 - 1.5 * sin(slenderness) ** 2


@quantity("e_b", "–", "Eq. 4", name="e_base")
def e_base_of_block(radius, inertia, slenderness):
    return 1 - 2 * radius**2 / inertia * sin(slenderness) ** 2


def inward(thickness, setback, radius, slenderness):
    return thickness - 2 * setback - radius * sin(slenderness)


def above(height, radius, slenderness):
    return height - radius * cos(slenderness)


@quantity("e_b", "–", "Eq. 4", name="e_base")
def e_base_with_loads(inertia, radius, slenderness, thickness, setback):
    return (
        inertia
        - radius**2
        - radius * sin(slenderness) * inward(thickness, setback, radius, slenderness)
        + (radius * cos(slenderness)) ** 2
    ) / (inertia - radius**2 + inward(thickness, setback, radius, slenderness) ** 2 + (radius * cos(slenderness)) ** 2)


@quantity("e_t", "–", "Eq. 6", name="e_top")
def e_top_of_rectangle(slenderness):
    return abs(1 - 1.5 * cos(slenderness) ** 2)


@quantity("e_t", "–", "Eq. 6", name="e_top")
def e_top_of_block(radius, inertia, slenderness):
    return abs(1 - 2 * radius**2 / inertia * cos(slenderness) ** 2)


@quantity("e_t", "–", "Eq. 6", name="e_top")
def e_top_with_loads(inertia, radius, slenderness, thickness, setback, height):
    return abs(
        (
            inertia
            - radius**2
            + inward(thickness, setback, radius, slenderness) ** 2
            - radius * cos(slenderness) * above(height, radius, slenderness)
        )
        / (
            inertia
            - radius**2
            + inward(thickness, setback, radius, slenderness) ** 2
            + above(height, radius, slenderness) ** 2
        )
    )


@quantity("e", "–", "Eq. 4", name="velocity_ratio")
def housner(e_base):
    return e_base


@quantity("e", "–", "Eq. 5", name="velocity_ratio")
def sorrentino_experimental(e_base):
    return EQ5_FACTOR * e_base


@quantity("e", "–", "Eq. 6", name="velocity_ratio")
def one_sided_theoretical(e_base, e_top):
    return min(e_base**2 * e_top, 1)


@quantity("e", "–", "Eq. 7, v = 0", name="velocity_ratio")
def one_sided_experimental(e_base, e_top):
    return EQ7_FACTOR * e_base**2 * e_top


RATIOS = {
    "housner": housner,
    "sorrentino_experimental": sorrentino_experimental,
    "one_sided_theoretical": one_sided_theoretical,
    "one_sided_experimental": one_sided_experimental,
}
"""Restitution models that have a formula."""
