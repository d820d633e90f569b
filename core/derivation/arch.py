"""A wall that spans between transverse walls (core/wall/arch.py): the thrust of its ends, its hinges, alpha_0 and d_0.
kN, m, s; per metre of height."""

import math
from dataclasses import replace

from core.derivation import bending, body, checks
from core.derivation.functions import kilo, sqrt
from core.derivation.line import FULL, INPUT, LIVE, RUN, VALUE, Columns, Line, Section
from core.derivation.quantity import Given, quantity
from core.known import require_value
from core.study.results import WallResult
from core.units import G
from core.wall.arch import ALONG, parted_flat, thrust_of_shoulder
from core.wall.bending import spread_over

SPACING = Given("spacing", "L", "m", 2, "0.00", "L between the transverse walls")
STRENGTH = Given("strength", "f", "MPa", 2, "0.00", "f of the masonry")
TIE_FORCE = Given("tie_yield", "H_y", "kN/m", 2, "0.000", "H_y, yield of the ties along the wall")
AT_YIELD = Given("tie_at_yield", "v_y", "m", 4, label="v_y, elongation of a bar at yield")
STANDS = Given("tie_stands", "v_u", "m", 4, label="v_u, elongation a bar stands")
DEVELOPED = Given("tie_force", "H_t", "kN/m", 2, "0.000", "H_t, what those ties pull at 0.40 d_0")
SHOULDER_LENGTH = Given("shoulder_length", "b_s", "m", 2, "0.00", "b_s of the masonry beyond, along the wall")
SHOULDER_THICKNESS = Given("shoulder_thickness", "s_s", "m", 3, "0.000", "s_s of the masonry beyond, across the wall")
PUSHED = Given("pushed", "α_d", "–", 4, label="α_d, largest push across the wall, 0.3 of which acts along it")
MORE = Given("more_weight", "Q", "kN/m", 2, "0.000", "Q of masses that push the wall, spread over a metre of height")
PRESSED = Given("pressed", "P", "kN/m", 2, "0.000", "P that presses the wall outward, spread over a metre of height")


ALPHA0_BARE = Given("alpha0_bare", "α0,b", "–", 4)
THRUST = Given("thrust", "H_e", "kN/m", 2, "0.000", "thrust H_e of the ends")


@quantity("v_0", "m", "", 4, label="v_0, by which the ends have parted with all hinges in line", name="parted")
def parted(spacing, thickness):
    return sqrt(spacing**2 + 4 * thickness**2) - spacing


@quantity("H_s,0", "kN/m", "", 2, "0.000", label="H_s,0, overturning or sliding of the masonry beyond", name="shoulder")
def shoulder(weight, shoulder_thickness, shoulder_length, height, parted):
    return (
        weight
        * shoulder_thickness
        * shoulder_length
        * min(shoulder_length / height * max(1 - 2 * parted / shoulder_length, 0), 0.4)
    )


@quantity("H_s", "kN/m", "NTC 7.3.5", 2, "0.000", label="H_s, less the inertia of that masonry", name="by_shoulder")
def by_shoulder(shoulder, pushed, weight, shoulder_thickness, shoulder_length):
    return max(shoulder - 0.3 * pushed * weight * shoulder_thickness * shoulder_length, 0)


@quantity("H_c", "kN/m", "", 2, "0.000", label="H_c, crushing of the hinges", name="by_crushing")
def by_crushing(strength, thickness):
    return 0.375 * kilo(strength) * thickness


@quantity("H_e", "kN/m", "", 2, "0.000", label="thrust H_e of the ends", name="thrust")
def thrust_of_both(tie_force, by_shoulder, by_crushing):
    return min(max(tie_force, by_shoulder), by_crushing)


@quantity("H_e", "kN/m", "", 2, "0.000", label="thrust H_e of the ends", name="thrust")
def thrust_of_tie(tie_force, by_crushing):
    return min(tie_force, by_crushing)


@quantity("H_e", "kN/m", "", 2, "0.000", label="thrust H_e of the ends", name="thrust")
def thrust_by_shoulder(by_shoulder, by_crushing):
    return min(by_shoulder, by_crushing)


@quantity("u", "m", "", 4, label="hinge setback u, of a triangle of stress", name="setback")
def setback(thrust, strength):
    return 2 * thrust / (3 * kilo(strength))


@quantity("W", "kN/m", "", 2, "0.000", label="W of the wall between the transverse walls", name="w")
def weight_of_span(weight, thickness, spacing):
    return weight * thickness * spacing


@quantity("W", "kN/m", "", 2, "0.000", label="W of the wall between the transverse walls", name="w")
def weight_of_span_with_masses(weight, thickness, spacing, more_weight):
    return weight * thickness * spacing + more_weight


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0(thrust, width, w, spacing):
    return 8 * thrust * width / (w * spacing)


@quantity("α0", "–", "C8.7.1.1", 4, name="alpha0")
def alpha0_pressed(thrust, width, w, spacing, pressed):
    return 8 * thrust * width / (w * spacing) - pressed / w


@quantity("d_0", "m", "C8.7.1.4", 4, name="d0")
def d0(width):
    return width / 2


def _pull(wall: WallResult) -> float:
    """What the ties along the wall pull at d_SLV [N/m]."""
    asked, given = wall.wall, require_value(wall.wall.arch)
    own = replace(given, shoulder_length_m=None, shoulder_thickness_m=None)
    alone = replace(asked, hold=(own,), compressive_strength_mpa=asked.compressive_strength_mpa).in_si.arch
    return require_value(alone).thrust


def geometry(wall: WallResult) -> Section:
    """Sizes, what the ends push against, the thrust and the hinges."""
    asked, given = wall.wall, require_value(wall.wall.arch)
    own, height, thickness = (
        require_value(asked.in_si.arch),
        require_value(asked.height_m),
        require_value(asked.thickness),
    )
    found = require_value(wall.mechanics.wall.arch) if wall.assessment and wall.assessment.kinematic else own
    with_tie = given.with_tie and found == own.under(found.pushed)  # at SLD no tie counts
    weight, strength = require_value(asked.unit_weight_kn_m3), require_value(asked.compressive_strength_mpa)
    lines: list[Line | Columns] = [
        Line(SPACING, given.spacing_m, INPUT, VALUE),
        Line(body.HEIGHT, height, INPUT),
        Line(body.THICKNESS, thickness, INPUT),
        Line(body.UNIT_WEIGHT, weight, INPUT),
        Line(STRENGTH, strength, INPUT, VALUE),
    ]
    if with_tie:
        lines += [Line(TIE_FORCE, given.tie_kn_m, INPUT, VALUE), Line(STANDS, given.tie_elongation_m, INPUT, VALUE)]
        lines += [Line(AT_YIELD, given.at_yield, RUN, VALUE), Line(DEVELOPED, 1e-3 * _pull(wall), RUN, VALUE)]
    if given.with_shoulder:
        sizes = require_value(given.shoulder_length_m), require_value(given.shoulder_thickness_m)
        apart = parted_flat(require_value(given.spacing_m), thickness)
        lines += [Line(SHOULDER_LENGTH, sizes[0], INPUT, VALUE), Line(SHOULDER_THICKNESS, sizes[1], INPUT, VALUE)]
        lines.append(Line(parted, apart, note=FULL))
        resting = thrust_of_shoulder(*sizes, height, weight, apart)
        lines.append(Line(shoulder, resting, note=FULL))
        lines.append(Line(PUSHED, found.pushed, RUN, VALUE))
        left = max(0.0, resting - ALONG * found.pushed * weight * sizes[0] * sizes[1])
        lines.append(Line(by_shoulder, left, note=FULL))
    lines.append(Line(by_crushing, by_crushing.function(strength, thickness), note=FULL))
    by = thrust_of_both if with_tie and given.with_shoulder else thrust_by_shoulder
    if given.with_shoulder or with_tie:
        lines.append(Line(by if given.with_shoulder else thrust_of_tie, 1e-3 * found.thrust, note=FULL))
    else:
        lines.append(Line(THRUST, 1e-3 * found.thrust, RUN, VALUE))
    lines.append(Line(setback, found.setback, note=FULL))
    lines.append(Line(bending.A_START, wall.threshold / G, RUN, VALUE))
    return Section("The wall between its transverse walls", lines)


def chain(wall: WallResult) -> list[Line]:
    """Lines of alpha_0 and e*: the hinge between is in the middle, where alpha_0 is least."""
    mechanism = require_value(wall.mechanics.chain.bending)
    strip, asked = mechanism.strip, wall.mechanics.wall
    per_height = 1e-3 * strip.height / spread_over(require_value(asked.height))
    more = per_height * sum(load.force for load in asked.loads if load.pushes)
    pressed = 1e-3 * strip.pressed * strip.weight
    lines = [Line(bending.width, strip.width, note=FULL)]
    if more:
        lines.append(Line(MORE, more, RUN, VALUE))
    lines.append(Line(weight_of_span_with_masses if more else weight_of_span, 1e-3 * strip.weight, note=FULL))
    if pressed:
        lines.append(Line(PRESSED, pressed, RUN, VALUE))
    of = alpha0_pressed if pressed else alpha0
    return [
        *lines,
        Line(of, mechanism.alpha0, LIVE, FULL, "two blocks, three hinges, the middle one at L/2"),
        Line(checks.E_STAR, mechanism.e_star, RUN, VALUE, "both centroids move alike"),
    ]


def collapse(wall: WallResult) -> list[Line]:
    """Lines of d_0: alpha is zero where the three hinges lie in one line, d_C then b; earlier where something presses
    the wall outward."""
    mechanism = require_value(wall.mechanics.moved.bending)
    lines = [Line(bending.THETA_0, math.degrees(mechanism.theta0), RUN, VALUE, "finite geometry")]
    if mechanism.strip.pressed or mechanism.strip != require_value(wall.mechanics.chain.bending).strip:
        return [*lines, Line(bending.D0, mechanism.d0, RUN, VALUE, "finite geometry")]
    return [*lines, Line(d0, mechanism.d0, LIVE, FULL, "all hinges in line; both centroids move half as far")]
