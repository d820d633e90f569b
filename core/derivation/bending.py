"""A wall held at its top that bends (core/codes/vertical_bending.py): its hinge, alpha_0, d_0 and the capacity at the
limit of the displacement check. kN, m, s, degrees; per metre of wall; d of a load is from the outer face.

The height of the hinge is the lowest of alpha_0 = 2/W [(W + N) b/h1 + m/(H - h1)] in closed form, where the program
searches it.
"""

import math

from core.codes.vertical_bending import Bending, displaced_blocks, virtual, work_of_thrusts
from core.derivation import body, checks
from core.derivation.functions import arctan, cos, sin, sqrt
from core.derivation.line import FULL, INPUT, LIVE, RUN, SYMBOLS, VALUE, Columns, Line, Section, Word
from core.derivation.quantity import Given, quantity
from core.known import require_value
from core.study.results import WallResult
from core.units import G
from core.wall.bending import blocks_of

LOADS = {"load.n": "N", "load.d": "d"}
"""Columns of the loads on the top."""

THETA_0 = Given("theta_0", "θ_0", "°", 3, label="θ_0 of the lower block, where α = 0")

IMPACT_RATIO = Given(
    "velocity_ratio", "e", "–", 4, label="velocity ratio of an impact: momentum of both blocks, projected"
)

A_START = Given("a_rm_run", "a_RM", "g", 3, label="acceleration that starts the motion, outward or inward")


# the start of the motion


@quantity("b", "m", "", 3, "0.000", label="b = t − 2 u, between the hinges of the lower block")
def width(thickness, setback):
    return thickness - 2 * setback


@quantity("ΣN", "kN/m", "", 2, "0.000", name="on_top")
def on_top(loads):
    return sum(load.n for load in loads)


@quantity("m", "kN", "", 3, "0.000", label="m = ΣN (t − u − d)")
def top_moment(thickness, setback, loads):
    return sum(load.n * (thickness - setback - load.d) for load in loads)


@quantity("h_1", "m", "C8.7.1.1", 3, "0.000", name="h1", label="height h_1 of the hinge, of the lowest α0")
def h1_with_loads(height, thickness, w, on_top, width, top_moment):
    return min(
        height * sqrt((w + on_top) * width) / (sqrt((w + on_top) * width) + sqrt(max(top_moment, 0))),
        height - thickness,
    )


@quantity("h_1", "m", "C8.7.1.1", 3, "0.000", name="h1", label="height h_1 of the hinge, of the lowest α0")
def h1_alone(height, thickness):
    return height - thickness


@quantity("k", "–", "", 4, "0.0000")
def k(h1, height):
    return h1 / (height - h1)


@quantity("W_1", "kN/m", "", 2, "0.000")
def w1(w, h1, height):
    return w * h1 / height


@quantity("W_2", "kN/m", "", 2, "0.000")
def w2(w, w1):
    return w - w1


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_with_loads(w1, width, w2, k, loads, thickness, setback, h1):
    return (
        w1 * width / 2
        + w2 * (width + k * width / 2)
        + sum(load.n * (width + k * (thickness - setback - load.d)) for load in loads)
    ) / ((w1 + w2) * h1 / 2)


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_alone(w1, width, w2, k, h1):
    return (w1 * width / 2 + w2 * (width + k * width / 2)) / ((w1 + w2) * h1 / 2)


@quantity("R", "kN/m", "", 2, "0.000", name="top_force", label="R, of what holds the top as the mechanism starts")
def top_force_with_loads(alpha0, w, width, height, loads, setback):
    return alpha0 * w / 2 - (w * width / 2 + sum(load.n * (load.d - setback) for load in loads)) / height


@quantity("R", "kN/m", "", 2, "0.000", name="top_force", label="R, of what holds the top as the mechanism starts")
def top_force_alone(alpha0, w, width, height):
    return alpha0 * w / 2 - w * width / 2 / height


# of a wall with openings, steps or loads below its top: what the blocks weigh and where is summed by the program

WEIGHT = Given("w", "W", "kN/m", 2, "0.000", label="W of the wall, its openings left out")
H1 = Given("h1", "h_1", "m", 3, "0.000", label="height h_1 of the hinge, of the lowest α0")
HINGE_WIDTH = Given("width", "b", "m", 3, "0.000", label="b between the hinges of the lower block")
W1 = Given("w1", "W_1", "kN/m", 2, "0.000", label="W_1 of the lower block")
W2 = Given("w2", "W_2", "kN/m", 2, "0.000", label="W_2 of the upper block")
X1 = Given("x1", "x_1", "m", 4, label="x_1 of its centroid, from the outer face")
Z1 = Given("z1", "z_1", "m", 4, label="z_1 of its centroid, above the base")
X2 = Given("x2", "x_2", "m", 4, label="x_2 of its centroid, from the outer face")
Z2 = Given("z2", "z_2", "m", 4, label="z_2 of its centroid, above the base")
HOLDING = Given("holding", "ΣN v", "kN", 3, "0.000", label="ΣN v of the loads by a unit of θ")
PUSHING = Given("pushing", "ΣQ s", "kN", 3, "0.000", label="ΣQ s of the loads that move sideways by a unit of θ")
TOP_FORCE = Given("top_force", "R", "kN/m", 2, "0.000", label="R, of what holds the top as the mechanism starts")
D0 = Given("d0", "d_0", "m", 4)
E_STAR_D = Given("e_star_d", "e*_d", "–", 4, label="e* with the hinge of the displacement check")
ALPHA_D = Given("alpha_d", "α(d_{state})", "–", 4)


@quantity("ΣW v_0", "kN", "", 3, "0.000", label="ΣW v of both blocks by a unit of θ, at the start")
def rise_of_blocks(w1, x1, setback, w2, width, k, x2):
    return w1 * (x1 - setback) + w2 * (width + k * (width + setback - x2))


@quantity("ΣW s_0", "kN", "", 3, "0.000", label="ΣW s of both blocks by a unit of θ, at the start")
def way_of_blocks(w1, z1, w2, h1, k, z2):
    return w1 * z1 + w2 * (h1 - k * (z2 - h1))


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_of_blocks(rise_of_blocks, holding, way_of_blocks, pushing):
    return (rise_of_blocks + holding) / (way_of_blocks + pushing)


# where nothing holds it, and the limit of the displacement check


H1_D = Given(
    "h1_d", "h_1,d", "m", 3, "0.000", label="height h_1,d of the hinge, where ζ of the displacement check is least"
)


@quantity("W_1,d", "kN/m", "", 2, "0.000")
def w1_d(w, h1_d, height):
    return w * h1_d / height


@quantity("W_2,d", "kN/m", "", 2, "0.000")
def w2_d(w, w1_d):
    return w - w1_d


@quantity("d_C,0", "m", "C8.7.1.4", 4, label="d_C,0, of the hinge where α = 0")
def d_c0(width, theta_0, h1_d):
    return width * (1 - cos(theta_0)) + h1_d * sin(theta_0)


@quantity("d_0", "m", "C8.7.1.4", 4, name="d0")
def d0(d_c0):
    return d_c0 / 2


@quantity("θ_d", "°", "", 3, label="θ_d of the lower block at d_{state}")
def theta_d(width, h1_d, d_limit):
    return arctan(width / h1_d) + arctan((2 * d_limit - width) / sqrt(width**2 + h1_d**2 - (2 * d_limit - width) ** 2))


@quantity("x_C", "m", "", 4, label="x_C of the hinge at d_{state}")
def x_c(setback, width, theta_d, h1_d):
    return setback + width * cos(theta_d) - h1_d * sin(theta_d)


@quantity("φ_d", "°", "", 3, label="φ_d of the upper block at d_{state}")
def phi_d(thickness, setback, height, h1_d, x_c):
    return arctan((thickness - setback) / (height - h1_d)) - arctan(
        x_c / sqrt((thickness - setback) ** 2 + (height - h1_d) ** 2 - x_c**2)
    )


@quantity("v_C", "m", "", 4, label="v_C, rise of the hinge by a unit of θ")
def v_c(width, theta_d, h1_d):
    return width * cos(theta_d) - h1_d * sin(theta_d)


@quantity("s_C", "m", "", 4, label="s_C, way of the hinge outward by a unit of θ")
def s_c(width, theta_d, h1_d):
    return width * sin(theta_d) + h1_d * cos(theta_d)


@quantity("μ", "–", "", 4, label="μ = φ'/θ' at d_{state}")
def mu(s_c, thickness, setback, phi_d, height, h1_d):
    return s_c / ((thickness - setback) * sin(phi_d) + (height - h1_d) * cos(phi_d))


@quantity("ΣW v", "kN m", "", 3, "0.000", label="ΣW v of both blocks by a unit of θ")
def rise_of_wall(w1_d, w2_d, v_c, mu, width, phi_d, height, h1_d):
    return w1_d * v_c / 2 + w2_d * (v_c + mu * (width * cos(phi_d) - (height - h1_d) * sin(phi_d)) / 2)


@quantity("ΣW s", "kN m", "", 3, "0.000", label="ΣW s of both blocks by a unit of θ")
def way_of_wall(w1_d, w2_d, s_c, mu, width, phi_d, height, h1_d):
    return w1_d * s_c / 2 + w2_d * (s_c - mu * (width * sin(phi_d) + (height - h1_d) * cos(phi_d)) / 2)


@quantity("ΣN v", "kN m", "", 3, "0.000", label="ΣN v of the loads by a unit of θ")
def rise_of_loads(v_c, mu, phi_d, height, h1_d, loads, thickness, setback):
    return sum(
        load.n * (v_c + mu * ((thickness - setback - load.d) * cos(phi_d) - (height - h1_d) * sin(phi_d)))
        for load in loads
    )


@quantity("α(d_{state})", "–", "C8.7.1.1", 4, name="alpha_d")
def alpha_d_with_loads(rise_of_wall, rise_of_loads, way_of_wall):
    return (rise_of_wall + rise_of_loads) / way_of_wall


@quantity("α(d_{state})", "–", "C8.7.1.1", 4, name="alpha_d")
def alpha_d_alone(rise_of_wall, way_of_wall):
    return rise_of_wall / way_of_wall


@quantity("a(d_{state})", "m/s²", "C8.7.1.3", name="a_limit")
def a_limit(alpha_d, gravity, e_star, demand_fc):
    return alpha_d * gravity / (e_star * demand_fc)


@quantity("a(d_{state})", "m/s²", "C8.7.1.3", name="a_limit")
def a_limit_of_blocks(alpha_d, gravity, e_star_d, demand_fc):
    return alpha_d * gravity / (e_star_d * demand_fc)


def geometry(wall: WallResult) -> Section:
    """Sizes, weight and what stands on the top."""
    asked = wall.wall
    lines: list[Line | Columns] = [
        Line(body.HEIGHT, wall.height, INPUT),
        Line(body.THICKNESS, wall.thickness, INPUT),
        Line(body.SETBACK, asked.setback, RUN if asked.compressive_strength_mpa else INPUT),
        Line(body.UNIT_WEIGHT, asked.unit_weight_kn_m3, INPUT),
    ]
    weight = 1e-3 * asked.in_si.weight
    shaped = bool(asked.parts)
    lines.append(Line(WEIGHT, weight, RUN, VALUE) if shaped else Line(body.w, weight, note=FULL))
    kinematic = wall.assessment.kinematic if wall.assessment else None
    if loads := (kinematic.wall if kinematic else asked.in_si).loads:
        rows = [(Word(f"choice_{load.kind}"), (1e-3 * load.force, load.depth)) for load in loads]
        faces = "Loads, from the face about which its base turns"
        lines.append(Columns(faces, LOADS, ("kN/m", "m"), rows, INPUT))
    lines.append(Line(A_START, wall.model.threshold / G, RUN, VALUE))
    lines.append(Line(IMPACT_RATIO, wall.model.ratio_at_rest, RUN, VALUE))
    return Section("The wall, held at its top", lines)


def chain(wall: WallResult) -> list[Line]:
    """Lines of alpha_0 and e* of a wall held at its top."""
    mechanism = require_value(wall.mechanics.chain.bending)
    strip, h1 = mechanism.strip, mechanism.h1
    if not strip.is_plain:
        return _of_blocks(mechanism)
    lower = 1e-3 * strip.weight * h1 / strip.height
    edge, lines = strip.thickness - strip.setback, [Line(width, strip.width)]
    hinge, alpha0, top = h1_alone, alpha0_alone, top_force_alone
    if strip.loads:
        hinge, alpha0, top = h1_with_loads, alpha0_with_loads, top_force_with_loads
        lines.append(Line(on_top, 1e-3 * sum(n for n, _ in strip.loads)))
        lines.append(Line(top_moment, 1e-3 * sum(n * (edge - d) for n, d in strip.loads), note=SYMBOLS))
    label = "as high as it may be: both blocks at least as high as thick" if mechanism.highest else "where α0 is lowest"
    return [
        *lines,
        Line(hinge, h1, LIVE, SYMBOLS, label),
        Line(k, h1 / (strip.height - h1), note=FULL),
        Line(w1, lower, note=FULL),
        Line(w2, 1e-3 * strip.weight - lower, note=FULL),
        Line(alpha0, mechanism.alpha0, LIVE, SYMBOLS, "two blocks, three hinges"),
        Line(top, 1e-3 * mechanism.top_force, LIVE, SYMBOLS, "on what holds the top, of the wall alone"),
        Line(checks.E_STAR, mechanism.e_star, RUN, VALUE, "both centroids move alike, the top does not"),
    ]


def _of_blocks(mechanism: Bending) -> list[Line]:
    """Lines of alpha_0 and e* of a wall with openings, steps or loads below its top."""
    h1, (lower, upper) = mechanism.h1, blocks_of(mechanism.strip, mechanism.h1)
    own = ((W1, X1, Z1, lower[0]), (W2, X2, Z2, upper[0]))
    of_loads = [one for one in virtual(mechanism.strip, h1) if one[0] not in (lower[0], upper[0])]
    lines = [Line(H1, h1, RUN, VALUE, "where α0 is lowest"), Line(HINGE_WIDTH, mechanism.width, RUN, VALUE)]
    lines.append(Line(k, h1 / (mechanism.strip.height - h1), note=FULL))
    for weight, x, z, one in own:
        lines += [Line(weight, 1e-3 * one.force, RUN, VALUE), Line(x, one.x, RUN, VALUE), Line(z, one.z, RUN, VALUE)]
    thrusts = work_of_thrusts(mechanism.strip, h1, mechanism.theta0)
    holding = 1e-3 * (math.fsum(one.force * rise for one, rise, _ in of_loads) - thrusts)
    pushing = 1e-3 * math.fsum(one.force * way for one, _, way in of_loads if one.pushed)
    of_own = [one for one in virtual(mechanism.strip, h1) if one[0] in (lower[0], upper[0])]
    return [
        *lines,
        Line(rise_of_blocks, 1e-3 * math.fsum(one.force * rise for one, rise, _ in of_own)),
        Line(way_of_blocks, 1e-3 * math.fsum(one.force * way for one, _, way in of_own)),
        Line(HOLDING, holding, RUN, VALUE),
        Line(PUSHING, pushing, RUN, VALUE),
        Line(alpha0_of_blocks, mechanism.alpha0, LIVE, FULL, "two blocks, three hinges"),
        Line(TOP_FORCE, 1e-3 * mechanism.top_force, RUN, VALUE, "on what holds the top, of the wall alone"),
        Line(checks.E_STAR, mechanism.e_star, RUN, VALUE, "over the virtual displacements of both blocks"),
    ]


def collapse(wall: WallResult) -> list[Line]:
    """Lines of d_0 by the finite geometry, with the hinge of the displacement check."""
    mechanism = require_value(wall.mechanics.moved.bending)
    if not mechanism.strip.is_plain:
        return [
            Line(H1_D, mechanism.h1, RUN, VALUE, "sought; the linear check has its own"),
            Line(THETA_0, math.degrees(mechanism.theta0), RUN, VALUE, "finite geometry"),
            Line(D0, mechanism.d0, RUN, VALUE, "finite geometry"),
        ]
    lower = 1e-3 * mechanism.strip.weight * mechanism.h1 / mechanism.strip.height
    return [
        Line(H1_D, mechanism.h1, RUN, VALUE, "sought; the linear check has its own"),
        Line(w1_d, lower, note=VALUE),
        Line(w2_d, 1e-3 * mechanism.strip.weight - lower, note=VALUE),
        Line(THETA_0, math.degrees(mechanism.theta0), RUN, VALUE, "finite geometry"),
        Line(d_c0, mechanism.d_c0, note=FULL),
        Line(d0, mechanism.d0, LIVE, FULL, "both centroids move half as far as the hinge"),
    ]


def at_limit(wall: WallResult) -> list[Line]:
    """Lines of alpha at the limit of the displacement check, by the finite geometry: it lies below the straight line to
    d_0."""
    kinematic = wall.mechanics
    mechanism, limit = require_value(kinematic.moved.bending), require_value(kinematic.d_limit)
    if not mechanism.strip.is_plain:
        alpha = mechanism.alpha(limit)
        return [
            Line(ALPHA_D, alpha, RUN, VALUE, "finite geometry, below the straight line to d_0"),
            Line(E_STAR_D, mechanism.e_star, RUN, VALUE),
        ]
    strip, h1, theta = mechanism.strip, mechanism.h1, mechanism.rotation(limit)
    at = displaced_blocks(strip, h1, theta)
    degrees = math.degrees(theta)
    rise, way = strip.width * cos(degrees) - h1 * sin(degrees), strip.width * sin(degrees) + h1 * cos(degrees)
    phi = math.degrees(at.phi)
    rate = way / ((strip.thickness - strip.setback) * sin(phi) + (strip.height - h1) * cos(phi))
    lower, angles = 1e-3 * strip.weight * h1 / strip.height, (phi, strip.height, h1)
    of_wall = (lower, 1e-3 * strip.weight - lower)
    risen = rise_of_wall.function(*of_wall, rise, rate, strip.width, *angles)
    lines = [
        Line(theta_d, degrees, note=VALUE),
        Line(x_c, at.hinge[0], note=FULL),
        Line(phi_d, phi, note=VALUE),
        Line(v_c, rise),
        Line(s_c, way),
        Line(mu, rate, note=VALUE),
        Line(rise_of_wall, risen, note=VALUE),
    ]
    if strip.loads:
        lines.append(Line(rise_of_loads, 1e-3 * at.risen - risen, note=VALUE))
    alpha = alpha_d_with_loads if strip.loads else alpha_d_alone
    return [
        *lines,
        Line(way_of_wall, 1e-3 * at.moved, note=VALUE),
        Line(alpha, at.risen / at.moved, LIVE, FULL, "finite geometry, below the straight line to d_0"),
    ]
