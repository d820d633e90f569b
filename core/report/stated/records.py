"""Quantities of the demand, of the records and of their selection."""

from operator import itemgetter

from core.codes.limits import EXCEEDANCE
from core.codes.national_hazard import RETURN_PERIODS, USE_CLASSES
from core.codes.spectrum_codes import CODES
from core.file_names import shown
from core.ground.provenance import provenance
from core.report.stated.quantity import (
    flag,
    list_quantity,
    mapping_quantity,
    number,
    numbers,
    object_quantity,
    rebase_group,
    scaled_reader,
    text,
    texts,
    whole,
)
from core.units import CM, G

PROVENANCE = (
    text("event", "event, as the file names it; empty where it says nothing, as the keys below"),
    text("station", "station with its network"),
    text("date", "date of the event"),
    text("magnitude", "magnitude"),
    text("distance_km", "distance, as written [km]"),
    text("site_class", "class of the soil at the station"),
    text("filter", "corner frequencies, as written"),
    text("processing", "processing, as the file names it"),
)

MEASURES = (
    text("file", "file the motion was read from", lambda motion: shown(motion.file)),
    text("file_sha256", "SHA-256 of the file"),
    text("samples_sha256", "SHA-256 of the samples in m/s2"),
    text("format", "format of the file"),
    number("time_step_s", "s", "time between samples", "time_step"),
    whole("samples", "number of samples", lambda motion: int(motion.acceleration.size)),
    text("unit", "unit of the samples in the file"),
    number("pga_g", "g", "largest acceleration", scaled_reader(G, "pga")),
    number("pgv_cm_s", "cm/s", "largest velocity, without baseline step", scaled_reader(CM, "pgv")),
    number("pgd_cm", "cm", "largest displacement, without baseline step", scaled_reader(CM, "pgd")),
    number("arias_m_s", "m/s", "Arias intensity", "arias"),
    number("duration_5_95_s", "s", "time between 5 and 95 % of the Arias intensity", "duration_5_95"),
    object_quantity("provenance", "what the file says of its motion", PROVENANCE, provenance),
    number("housner_intensity_cm", "cm", "SI, Eq. 11, not divided by 2.4", scaled_reader(CM, "housner_intensity")),
    object_quantity(
        "lines",
        "lines of the file; null of a file without lines",
        (
            whole("head", "lines of the head", lambda lines: lines[0]),
            whole("samples", "lines of samples", lambda lines: lines[1]),
            whole("others", "lines of neither", lambda lines: lines[2]),
        ),
        lambda motion: motion.lines or None,
    ),
    texts("warnings", "remarks on the reading", lambda motion: [warning.text() for warning in motion.warnings]),
)
"""Quantities read from GroundMotion."""

RECORD = (
    text("name", "name for people", lambda pair: pair[0].name),
    text("kind", "natural, artificial or simulated", lambda pair: pair[1]),
    number("scale", "-", "factor of the case", lambda pair: pair[0].scale),
    *rebase_group(itemgetter(0), MEASURES),
)
"""Quantities read from (GroundMotion, kind)."""

RULE = (
    text("code", "NTC, EN, or shown"),
    text("clause", "clause"),
    text("name", "what is compared"),
    number("value", "see unit", "value of the set"),
    number("limit", "see unit", "limit of the rule, null where it is only shown"),
    text("unit", "of value and limit: %, g, s or empty"),
    flag("passed", "whether the rule is kept, null where it is only shown"),
)

COMPLIANCE = (
    flag("compatible", "whether the set keeps the rules of the code of its spectrum"),
    numbers("period_range_s", "s", "periods over which the mean spectrum is compared", "period_range"),
    whole("stations", "number of stations"),
    list_quantity("rules", "each rule", RULE),
)

HAZARD_ROW = (
    number("return_period_years", "years", "return period", lambda row: row[0]),
    number("ag_g", "g", "a_g on rock", lambda row: row[1]),
    number("f0", "-", "F0", lambda row: row[2]),
    number("tc_star_s", "s", "T_C*", lambda row: row[3]),
)

SITE = (
    text("municipality", "municipality, empty where coordinates are given"),
    text("province", "province"),
    number("latitude", "deg", "latitude", "hazard.latitude"),
    number("longitude", "deg", "longitude", "hazard.longitude"),
    texts("nodes", "nodes of the grid around it", "hazard.nodes"),
    numbers("distances_km", "km", "their distances", "hazard.distances"),
    text("island", "island of Annex B Table 2, empty elsewhere", "hazard.island"),
    text("use_class", "class of use"),
    number("use_class_factor", "-", "C_U", lambda site: USE_CLASSES[site.use_class]),
    number("reference_life_years", "years", "V_R", "reference_life"),
    list_quantity(
        "hazard",
        "a_g, F0, T_C* at the return periods of the grid",
        HAZARD_ROW,
        lambda site: [(years, *values) for years, values in zip(RETURN_PERIODS, site.hazard.rows, strict=True)],
    ),
    mapping_quantity(
        "states",
        "the same at the limit states",
        HAZARD_ROW,
        lambda site: {state: (years := site.return_period(state), *site.hazard.at(years)) for state in EXCEEDANCE},
    ),
)

DEMAND = (
    text("limit_state", "SLO, SLD, SLV or SLC", "demand_required.limit_state"),
    number("ag_g", "g", "a_g on rock", scaled_reader(G, "demand_required.ag")),
    number("soil_factor", "-", "S", "demand_required.soil_factor"),
    number("pga_g", "g", "a_g S", scaled_reader(G, "demand_required.pga")),
    number(
        "housner_intensity_cm",
        "cm",
        "SI of the demand, null without a spectrum",
        lambda result: result.demand_required.intensity / CM if result.demand_required.intensity else None,
    ),
    text("intensity_source", "what SI is of", "demand_required.intensity_source"),
    text(
        "spectrum",
        "spectrum",
        lambda result: result.demand_required.target.name if result.demand_required.target else None,
    ),
    text(
        "annex_sha256",
        "SHA-256 of the file of EN 1998-1 or of its annex that the spectrum is of",
        lambda result: (
            CODES[result.demand_required.spectrum_code].digest or None if result.demand_required.spectrum_code else None
        ),
    ),
    number("confidence_factor", "-", "FC", "demand_required.confidence_factor"),
    number("zeta_target", "-", "zeta_E that is required", "demand_required.zeta_target"),
    text("confidence_on", "where FC acts: capacity or demand", "demand_required.confidence_on"),
    number("return_period_years", "years", "return period of the demand", "demand_required.return_period"),
    list_quantity(
        "hazard",
        "a_g at return periods, as given",
        HAZARD_ROW[:2],
        lambda result: [(years, ag / G) for years, ag in result.demand_required.hazard],
    ),
    text("demand_scaling", "how records are scaled: as_given, pga or si", "demand_required.record_scaling"),
    object_quantity(
        "compliance", "the records against the spectrum", COMPLIANCE, lambda result: result.compliance or None
    ),
    texts(
        "warnings",
        "remarks on the demand",
        lambda result: [warning.text() for warning in result.demand_required.warnings],
    ),
    object_quantity("site", "the place", SITE, lambda result: result.case.site).optional(),
)
"""Quantities read from StudyResult with a demand."""

AT_PERIOD = (
    number("period_s", "s", "period", lambda of: of[0]),
    number("ratio", "-", "mean spectrum over the target there", lambda of: of[1]),
)

CHOSEN_SET = (
    number("deviation", "-", "root mean square of mean spectrum over target, less 1"),
    object_quantity("lowest", "where the mean lies lowest", AT_PERIOD),
    object_quantity("highest", "where it lies highest", AT_PERIOD),
    number("pga_ratio", "-", "mean ordinate at T = 0 over the target"),
    number("miss", "-", "worst ordinate beyond its bound, 0 where none is"),
    list_quantity(
        "records",
        "its records",
        (
            text("file", "file", lambda record: shown(record.file)),
            text("channel", "channel"),
            number("scale", "-", "factor"),
        ),
    ),
)

SELECTION = (
    text("folder", "folder of the records", lambda of: shown(of.folder)),
    whole("files", "files read"),
    whole("candidates", "motions that may be chosen"),
    flag("every_combination", "whether every set was looked at", "every"),
    numbers("period_range_s", "s", "periods of the comparison", "period_range"),
    object_quantity(
        "bounds",
        "of the mean spectrum over the target",
        (
            number("mean_lower", "-", "lowest", lambda bounds: bounds[0]),
            number("mean_upper", "-", "highest, null without one", lambda b: b[1] if b[1] < float("inf") else None),
            number("mean_pga", "-", "lowest at T = 0, null without one", lambda bounds: bounds[2] or None),
        ),
    ),
    flag("fits", "whether the chosen set keeps the rule", "chosen.fits"),
    list_quantity("sets", "the sets found, the chosen one first", CHOSEN_SET),
    list_quantity(
        "left_out",
        "motions that cannot be chosen",
        (
            text("file", "file", lambda one: shown(str(one.file.name))),
            text("channel", "channel"),
            text("reason", "why", lambda one: one.reason.text()),
        ),
    ),
)
"""Quantities read from Selection."""
