"""What a finished parametric study shows: the paper's figures and claims, the scale-free law, or the plain grid."""

from core.lab.research import law_study, paper_claims, paper_figures, paper_tables
from core.lab.research.figures import LINE_POINTS, Figure, StudyReport, Table
from core.lab.research.paper_figures import curve, scatter
from core.lab.research.parametric import ParametricResult
from core.lab.research.set_means import MotionValue, SetMean, motion_values, set_means
from core.text.sentence import localized
from core.units import CM, G

MAX_NAMED = 12
"""Missing records that a note names; all are in the JSON."""


def report_of(result: ParametricResult) -> StudyReport:
    """Figures, tables and claims in the language of the study."""

    def say(english: str, /, **values) -> str:
        return localized("report", english, result.study.language, **values)

    values = motion_values(result)
    sets = set_means(result, values)
    notes = [say("Short run: fewer motions and heights, and without what takes long.")] if result.quick else []
    if result.restored:
        notes.append(
            say("{n} runs were finished by an earlier start; the time is that of this one.", n=result.restored)
        )
    if any(row.cell.kinematics.one_way for row in result.rows):
        notes.append(say("One-sided walls: the lower q of both signs of each motion, unless it says as recorded."))
    without = sum(row.q is None for row in result.rows)
    if without:
        notes.append(say("{n} of {of} runs have no number and are left out.", n=without, of=len(result.rows)))
    if result.refused:
        notes.append(
            say(
                "{n} files are left out: no accelerograms the program reads, or vertical components.",
                n=len(result.refused),
            )
        )
    if result.missing:
        notes.append(
            say(
                "{n} records of the named set are not in the folder: {names}.",
                n=len(result.missing),
                names="; ".join(result.missing[:MAX_NAMED]) + ("; …" if len(result.missing) > MAX_NAMED else ""),
            )
        )
    if result.study.report == "paper":
        notes.insert(
            0,
            say(
                "The paper's Table 1 and figures are lost: spectra, seeds and steps of H are a reconstruction. "
                "Signs and ranges are compared, not digits."
            ),
        )
        return StudyReport(
            result.study.title,
            tuple(notes),
            tuple(paper_figures.figures(result, values, sets, say)),
            tuple(paper_tables.tables(result, values, sets, say)),
            tuple(paper_claims.claims(sets, values, say)),
        )
    if result.study.report == "law":
        return law_study.report(result, values, notes, say)
    return StudyReport(
        result.study.title,
        tuple(notes),
        tuple(_grid_figures(values, sets, say)),
        tuple(table for table in (_grid_table(sets, say), _motion_table(values, say)) if table.rows),
    )


def _name(entry: MotionValue | SetMean) -> str:
    cell = entry.cell
    return f"{cell.mechanism}, {cell.restitution}, {cell.law}, {cell.method}"


def _grid_figures(values: list[MotionValue], sets: list[SetMean], say) -> list[Figure]:
    """q against H, against SI/PGA and against Pi, a chart for each kind of cell."""
    figures = []
    for k, kind in enumerate(dict.fromkeys(_name(entry) for entry in values), start=1):
        ours = [entry for entry in sets if _name(entry) == kind]
        series = []
        for color, alpha in enumerate(sorted({entry.cell.slenderness_deg for entry in ours})):
            for spectrum in dict.fromkeys(entry.spectrum.name for entry in ours):
                points = [
                    (entry.cell.height_m, entry.q)
                    for entry in ours
                    if entry.cell.slenderness_deg == alpha and entry.spectrum.name == spectrum
                ]
                series.append(curve(f"{alpha:g}°, {spectrum}", points, LINE_POINTS, color))
        if series:
            figures.append(Figure(f"q_height_{k}", say("q against H") + f": {kind}", "H [m]", "q [-]", tuple(series)))
        single = [(entry.pi, entry.q) for entry in values if _name(entry) == kind and entry.q is not None]
        if single:
            chart = (scatter(say("single motions"), single, 7),)
            if ours:
                chart += (scatter(say("means of sets"), [(entry.pi, entry.q) for entry in ours]),)
            figures.append(
                Figure(f"q_pi_{k}", say("q against Π = p² SI/PGA") + f": {kind}", "Π [-]", "q [-]", chart, True, True)
            )
    return figures


def _grid_table(sets: list[SetMean], say) -> Table:
    """Means of every cell and spectrum."""
    rows = tuple(
        (
            e.cell.slenderness_deg,
            e.cell.height_m,
            _name(e),
            e.spectrum.name,
            e.pga / G,
            e.intensity / CM,
            e.q,
            e.q_slv,
            e.q_slc,
            e.q_robust,
            e.scatter,
            e.q_eff,
            e.numbers,
        )
        for e in sets
    )
    head = (
        "α [°]",
        "H [m]",
        say("wall"),
        say("spectrum"),
        "PGA [g]",
        "SI [cm]",
        "q",
        "q SLV",
        "q SLC",
        say("q robust"),
        say("scatter"),
        "q_eff",
        "n",
    )
    return Table("sets", say("Means of the sets"), head, rows)


def _motion_table(values: list[MotionValue], say) -> Table:
    """Every natural record on every wall."""
    rows = tuple(
        (
            e.cell.slenderness_deg,
            e.cell.height_m,
            _name(e),
            e.entry.motion.name,
            e.entry.motion.pga / G,
            e.entry.motion.housner_intensity / CM,
            e.pi,
            e.q,
            e.q_slv,
            e.q_robust,
        )
        for e in values
        if e.entry.seed is None
    )
    head = ("α [°]", "H [m]", say("wall"), say("motion"), "PGA [g]", "SI [cm]", "Π", "q", "q SLV", say("q robust"))
    return Table("motions", say("Single motions"), head, rows)
