"""The sheet of the floors: what moves the walls above the ground, the code beside the records."""

from core.report.cells import ACCENT, BAD, QUIET, Book, paragraph, text, title
from core.report.plots import DATA_COLUMN, add_series, new_chart, rows_below
from core.report.sheet_table import write_table
from core.report.wall_tables import modes_of_floor, motions_of_floor, numbered_modes
from core.setting.floors import CHART_PERIODS, Floor
from core.study.results import StudyResult
from core.units import G


def floors_of(result: StudyResult) -> dict[float, Floor]:
    """The floors of a study by their height [m]."""
    return {wall.floor.z: wall.floor for wall in result.walls if wall.floor is not None}


def floors(book: Book, result: StudyResult) -> None:
    """A table of the modes and the floor motions, and a chart of the spectra, for each height."""
    say, by_height = book.say, floors_of(result)
    sheet = book.sheet("Floors", [22, 12, 12, 12, 12, 12, 12, 12])
    title(sheet, 1, say("Motion of the floors"))
    row = paragraph(
        sheet,
        2,
        say(
            "The floor moves with the modes of the linear building; what they leave out moves with the ground. "
            "C multiplies the record of the ground. Code and records are compared at the damping of the mechanism; "
            "nothing is rescaled."
        ),
        8,
        105,
        color=QUIET,
    )
    for index, (z, floor) in enumerate(sorted(by_height.items())):
        row = _floor(book, sheet, floor, z, index, row + 1)


def _floor(book: Book, sheet, floor: Floor, z: float, index: int, row: int) -> int:
    say = book.say
    title(sheet, row, say("z = {z:g} m", z=z), 12)
    row = write_table(book, sheet, row + 1, modes_of_floor(book), numbered_modes(floor)) + 1
    if floor.motions:
        row = write_table(book, sheet, row, motions_of_floor(book), floor.motions) + 1
    curves = []
    if floor.code_spectrum is not None:
        curves.append((say("code, C7.2.5"), floor.code_spectrum, BAD))
    if floor.motions:
        curves.append((say("mean of the floor motions"), floor.mean_spectrum, ACCENT))
    if not curves:
        return row
    first = DATA_COLUMN + 4 * index
    text(sheet, 2, first, "T [s]", size=8)
    label = say("Floor spectra, z = {z:g} m, ξ = {damping:.0f} %", z=z, damping=100.0 * floor.damping)
    chart = new_chart(label, "T [s]", "S_a [g]", 17.5, 8.5)
    for k, (name, values, color) in enumerate(curves, start=1):
        text(sheet, 2, first + k, name, size=8)
        for n, (period, value) in enumerate(zip(CHART_PERIODS, values, strict=True)):
            sheet.cell(3 + n, first, float(period))
            sheet.cell(3 + n, first + k, float(value) / G)
        add_series(chart, sheet, (first, first + k), (2, 2 + CHART_PERIODS.size), color)
    chart.x_axis.scaling.min = chart.y_axis.scaling.min = 0
    sheet.add_chart(chart, f"A{row + 1}")
    return row + 1 + rows_below(chart.height)
