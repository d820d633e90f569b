"""A parametric study as files: CSV of every run, JSON, PNG and SVG of the figures."""

import csv
import io
import json
import math
from dataclasses import asdict

from core.lab.research.figures import DASHED, LINE, LINE_POINTS, POINTS, Figure, StudyReport, marker_of
from core.lab.research.parametric import ParametricResult
from core.report.drawing import style
from core.report.plain_cell import plain_cell
from core.report.stated.quantity import serialize
from core.report.stated.records import MEASURES
from core.report.xml_text import escape_for_xml
from core.units import CM, G
from core.version import NAME, VERSION, commit

PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#666666", "#1F2D3D")
"""Colours of the series, told apart in print and by the colour-blind."""

CSV_COLUMNS = {
    "group": ("", "of the spectrum; empty of a natural record"),
    "spectrum": ("", "target of a generated motion"),
    "motion": ("", "its name; of a natural record event, station, component"),
    "seed": ("", "of a generated motion"),
    "pga_g": ("g", "peak ground acceleration"),
    "pgv_cm_s": ("cm/s", "peak ground velocity"),
    "housner_intensity_cm": ("cm", "SI, of the pseudo-velocity at 5 % from 0.1 to 2.5 s"),
    "slenderness_deg": ("deg", "alpha of the wall"),
    "height_m": ("m", "H of the wall"),
    "mechanism": ("", "two_sided or one_sided"),
    "restitution": ("", "model, or the velocity ratio itself"),
    "law": ("", "moment and rotation: rigid, doherty, al_shawa"),
    "method": ("", "how the motion is integrated"),
    "q_step": ("-", "step of the search"),
    "polarity": ("", "1 as recorded, -1 reversed"),
    "status": ("", "of the search"),
    "q": ("-", "a_g S / a_RM at the first overturning"),
    "q_low": ("-", "the largest multiplier survived below it, as q"),
    "q_slv": ("-", "at the first rotation of 0.40 theta_c"),
    "q_slc": ("-", "at the first rotation of 0.60 theta_c"),
    "q_robust": ("-", "smallest q around which 16 % of a window overturn"),
    "q_eff": ("-", "q g / PGA, Eq. 12"),
    "survived_fraction": ("-", "share of the multipliers above q that the wall survives"),
    "pi": ("-", "p2 SI / PGA"),
    "analyses": ("", "integrations of the search"),
}
"""Columns of the CSV of runs -> unit, what it is."""

DPI = 150
MARKERS = ("o", "s", "^", "D")


def csv_text(result: ParametricResult) -> str:
    """Write one line a run, numbers exact, empty where there is none; no text begins as a formula."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(CSV_COLUMNS)
    measures = [(e.motion.pga / G, e.motion.pgv / CM, e.motion.housner_intensity / CM) for e in result.motions]
    p2 = {cell: cell.wall.block().p2 for cell in dict.fromkeys(row.cell for row in result.rows)}
    for row in result.rows:
        entry, cell = result.motions[row.motion], row.cell
        pga, pgv, si = measures[row.motion]
        cells = (
            entry.group,
            entry.spectrum,
            entry.motion.name,
            "" if entry.seed is None else entry.seed,
            pga,
            pgv,
            si,
            cell.slenderness_deg,
            cell.height_m,
            cell.mechanism,
            cell.restitution,
            cell.law,
            cell.method,
            cell.q_step,
            row.polarity,
            row.status,
            row.q,
            row.low,
            row.q_slv,
            row.q_slc,
            row.q_robust,
            None if row.q is None else row.q / pga,
            row.survived_fraction,
            p2[cell] * (si * CM) / (pga * G),
            row.analyses,
        )
        writer.writerow([plain_cell(one) if isinstance(one, str) else one for one in cells])
    return stream.getvalue()


def json_text(result: ParametricResult, report: StudyReport, runs: str, runs_sha256: str) -> str:
    """The study as JSON. runs, runs_sha256 : name of the CSV and its hash."""
    content = {
        "program": {"name": NAME, "version": VERSION, "commit": commit()},
        "started_utc": result.started,
        "elapsed_s": result.elapsed,
        "quick": result.quick,
        "study": asdict(result.study),
        "study_sha256": result.sha256,
        "spectra": [
            {
                "name": s.name,
                "group": s.group,
                "shape": s.target.name,
                "ag_g": s.target.ag / G,
                "soil_factor": s.target.soil,
                "pga_g": s.target.pga / G,
                "housner_intensity_cm": s.intensity / CM,
            }
            for s in result.spectra
        ],
        "motions": [
            {
                "name": e.motion.name,
                "spectrum": e.spectrum,
                "group": e.group,
                "seed": e.seed,
                "event": e.event,
                **serialize(MEASURES, e.motion),
            }
            for e in result.motions
        ],
        "missing": result.missing,
        "refused": [{"file": file, "reason": error.text("en")} for file, error in result.refused],
        "runs": {
            "file": runs,
            "sha256": runs_sha256,
            "count": len(result.rows),
            "analyses": sum(row.analyses for row in result.rows),
        },
        "notes": report.notes,
        "tables": [
            {"key": t.key, "title": t.title, "note": t.note, "head": t.head, "rows": [_finite(row) for row in t.rows]}
            for t in report.tables
        ],
        "claims": [asdict(claim) for claim in report.claims],
        "fits": report.fits,
    }
    return json.dumps(content, indent=1, allow_nan=False, ensure_ascii=False) + "\n"


def _finite(row: tuple) -> list:
    return [None if isinstance(v, float) and not math.isfinite(v) else v for v in row]


def figure_files(figure: Figure) -> dict[str, bytes]:
    """PNG and SVG of a figure, by the name of the file."""
    from matplotlib.figure import Figure as Canvas

    figure = escape_for_xml(figure)
    look: dict = {
        "font.size": 9,
        "font.family": "DejaVu Sans",
        "svg.hashsalt": "ribalta",
        "svg.fonttype": "none",
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#E3E8EC",
        "text.parse_math": False,
    }
    files = {}
    with style(look):
        drawn = Canvas(figsize=(7.2, 4.6), layout="constrained")
        axes = drawn.subplots()
        for k, series in enumerate(figure.series):
            color = PALETTE[series.color % len(PALETTE)]
            marker = MARKERS[marker_of(figure, k) % len(MARKERS)]
            looks: dict[str, dict] = {
                POINTS: {"linestyle": "", "marker": marker, "markersize": 3.5, "alpha": 0.8},
                LINE: {"linewidth": 1.4},
                DASHED: {"linewidth": 1.1, "linestyle": "--"},
                LINE_POINTS: {"linewidth": 1.1, "marker": marker, "markersize": 4},
            }
            axes.plot(series.x, series.y, color=color, label=series.name or "_", **looks[series.look])
        axes.set_title(figure.title, loc="left", fontsize=10, fontweight="bold")
        axes.set_xlabel(figure.x)
        axes.set_ylabel(figure.y)
        for axis, logarithmic in ((axes.xaxis, figure.log_x), (axes.yaxis, figure.log_y)):
            if logarithmic:
                getattr(axes, f"set_{axis.axis_name}scale")("log")
                _plain_labels(axis)
        if any(series.name for series in figure.series):
            columns = 1 + sum(bool(series.name) for series in figure.series) // 13
            axes.legend(fontsize=7, frameon=False, ncols=columns, loc="center left", bbox_to_anchor=(1.0, 0.5))
        if figure.note:
            drawn.supxlabel(figure.note, fontsize=7.5, x=0.01, ha="left")
        for end in ("png", "svg"):
            stream = io.BytesIO()
            drawn.savefig(stream, format=end, dpi=DPI, metadata={"Date": None} if end == "svg" else None)
            files[f"{figure.key}.{end}"] = stream.getvalue()
    return files


def _plain_labels(axis) -> None:
    """Labels of a logarithmic axis as plain numbers, at 1, 2 and 5 of each decade."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    axis.set_major_locator(LogLocator(10, subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
