"""The page of the two studies, resources/docs/paper.md: a template whose every number is a cell, and their results.

    .venv/bin/python -m core.lab.research.page PAPER.json LAW.json

keeps what the page needs of the JSON that `--study paper` and `--study law` wrote, in resources/studies, and writes the
page. Without files it writes the page of what was kept.
"""

import json
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from core.capacity.closed_forms import FITTED_PGA
from core.capacity.scale_free_law import BANDS
from core.lab.research.paper_sets import words

ROOT = Path(__file__).resolve().parents[3]
STUDIES = ROOT / "resources" / "studies"
TEMPLATE, PAGE = STUDIES / "paper_page.txt", ROOT / "resources" / "docs" / "paper.md"

KEPT = ("program", "elapsed_s", "study", "missing", "runs", "notes", "tables", "claims", "fits")
"""What the page needs of the JSON of a study, beside the counts of its natural records and of their earthquakes."""

NOT_SHOWN = {"law": (7, 13, 14, 15), "table2": (0,)}
"""Table -> columns the page leaves out."""


SHOWN = ("q", "q at SLV")
"""Quantities of the law that the page, and the program, have."""


def kept(name: str) -> Path:
    """Where the results of a study are kept."""
    return STUDIES / f"{name}.results.json"


def written(value: Any) -> str:
    """A value of a cell of a table."""
    if value is None:
        return "–"
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def table_text(head: list[str], rows: list[list]) -> str:
    """A table of Markdown."""
    lines = [head, ["---"] * len(head), *([written(one) for one in row] for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


class Results:
    """What a study found. content : of its JSON"""

    def __init__(self, content: dict):
        self.content = content
        self.tables = {table["key"]: table for table in content["tables"]}

    def table(self, key: str, keep: Callable[[list], bool] = lambda row: True) -> str:
        """A table of the study, its rows that are to be kept."""
        table, hidden = self.tables[key], NOT_SHOWN.get(key, ())
        shown = [k for k in range(len(table["head"])) if k not in hidden]
        rows = [[row[k] for k in shown] for row in table["rows"] if keep(row)]
        return table_text([table["head"][k] for k in shown], rows)

    def rows(self, key: str, **where: object) -> list[list]:
        """Rows of a table by the values of columns, by number: c0="two-sided"."""
        return [row for row in self.tables[key]["rows"] if all(row[int(k[1:])] == v for k, v in where.items())]

    def claim(self, source: str, *parts: str) -> dict:
        """The claim of a source that holds these words. Raises ValueError unless there is one."""
        (found,) = (
            c for c in self.content["claims"] if c["source"] == source and all(part in c["claim"] for part in parts)
        )
        return found


def cells(paper: Results, law: Results) -> dict[str, str]:
    """Name of a cell of the template -> what stands there."""
    made = _of_paper(paper) | _of_law(law)
    for name, study in (("paper", paper), ("law", law)):
        content = study.content
        made |= {
            f"{name}_version": content["program"]["version"],
            f"{name}_runs": f"{content['runs']['count']}",
            f"{name}_analyses": f"{content['runs']['analyses'] / 1e6:.1f} million",
            f"{name}_seconds": f"{content['elapsed_s']:.0f}",
            f"{name}_records": f"{content['natural']['records']}",
            f"{name}_events": f"{content['natural']['events']}",
        }
    return made


def _of_paper(paper: Results) -> dict[str, str]:
    claims = [[c["source"], c["claim"], f"{c['held']} of {c['tried']}", c["found"]] for c in paper.content["claims"]]
    exponents = [row[10] for row in paper.tables["eq13"]["rows"] if row[10] is not None]
    eq13 = max(paper.tables["eq13"]["rows"], key=lambda row: row[7])
    made = {
        "table1": paper.table("table1"),
        "claims": table_text(["where", "claim of the paper", "holds in", "found"], claims),
        "distance": paper.table("distance", lambda row: "spectrum" not in row[1]),
        "eq14": paper.table("eq14"),
        "table2": paper.table("table2"),
        "exponents": f"{min(exponents):.2f} to {max(exponents):.2f}",
        "furthest": f"{eq13[7]:.0%} at {eq13[1]:g} degrees and {eq13[2]:g} m ({eq13[0]})",
        "rank": re.sub(r".*equation|.*Rank", "Rank", paper.tables["table2"]["note"]),
        "missing": f"{len(paper.content['missing']) or 'none'}",
    }
    for mechanism, figure in (("two", "Fig. 21"), ("one", "Fig. 22")):
        words = f"{mechanism}-sided"
        single = [row[2] for row in paper.tables["distance"]["rows"] if row[0] == words and "spectrum" in row[1]]
        by = {row[1]: row[2] for row in paper.rows("distance", c0=words)}
        near, mean = paper.claim(figure, "natural records"), paper.claim(figure, "earthquakes")
        meets = paper.claim("5", "the interval", words)
        made |= {
            f"{mechanism}_single": f"{min(single):.2f} to {max(single):.2f}",
            f"{mechanism}_near": f"{near['held']} of {near['tried']}",
            f"{mechanism}_earthquakes": f"{mean['held']} of {mean['tried']}",
            f"{mechanism}_meets": f"{meets['held']} of {meets['tried']}",
            f"{mechanism}_exact": f"{by['exact, step 0.5 %']:.2f}",
        }
        if mechanism == "two":
            made |= {
                "finest": f"{by['exact, step 0.1 %']:.2f}",
                "coarsest": f"{by['exact, step 5 %']:.2f}",
                "newmark": f"{by['Newmark of the paper']:.2f}",
            }
    return made


def _ends(record: dict[str, Any]) -> str:
    """The factors of q at the ends of the interval of one record, the lowest and the highest of all places."""
    low, sixth, high = zip(*np.exp([*record["by_scaled"], *record["by_loss"]]), strict=True)
    return f"{min(low):.2f} to {max(low):.2f}, {min(sixth):.2f} to {max(sixth):.2f}, {min(high):.2f} to {max(high):.2f}"


def _held_table(fits: dict[str, Any]) -> str:
    """What the intervals hold of shapes and events left out: in all, and at worst in a part of Lambda or of s."""
    rows: list[list] = []
    for name, fit in fits.items():
        mechanism, moment, quantity = name.split()
        if quantity not in ("q", "q_slv"):
            continue
        of_wall = [mechanism.replace("_", "-"), words(str)[moment], SHOWN[quantity == "q_slv"]]
        for kind, held in (("mean of a set", fit["set_held"]), ("one record", fit["record_held"])):
            if held is None:
                continue
            parts = [*held["scaled"], *held["loss"]]
            shares = [f"{held['all'][0][k]:.0%} ({(min, max)[k > 0](part[k] for part in parts):.0%})" for k in range(2)]
            sixth = f"{held['all'][0][2]:.0%} ({max(part[2] for part in parts):.0%})" if kind == "one record" else "–"
            rows.append([*of_wall, kind, *shares, sixth])
    head = ["mechanism", "law", "quantity", "interval of", "inside (least)", "below (most)", "below one in six (most)"]
    return table_text(head, rows)


def _of_law(law: Results) -> dict[str, str]:
    study, fits = law.content["study"], law.content["fits"]
    grids = study["grid"]
    heights = [h for grid in grids for h in grid["height_m"]]
    alphas = [a for grid in grids for a in grid["slenderness_deg"]]
    losses = [s for fit in fits.values() for s in fit["loss_range"]]
    slopes = [
        fit["coefficients"][2] + fit["coefficients"][3] * s
        for name, fit in fits.items()
        if name.endswith((" rigid q", " rigid q_slv"))
        for s in fit["loss_range"]
    ]
    low, high = FITTED_PGA
    made = {
        "held": _held_table(fits),
        "eq16_pga": f"{(high / low) ** 0.1 - 1.0:.0%}",
        "law": law.table("law", lambda row: row[2] in SHOWN),
        "rivals": law.table("rivals", lambda row: row[1] in SHOWN),
        "q_code": law.table("q_code"),
        "design": law.table("design"),
        "restitution": law.table("restitution"),
        "shapes": f"{sum(len(group['spectrum']) for group in study['group'])}",
        "motions": f"{study['count']}",
        "law_heights": f"{min(heights):g}–{max(heights):g} m",
        "law_alphas": f"{min(alphas):g}–{max(alphas):g} degrees",
        "law_ratios": f"{1.0 - max(losses) ** 2:.1f}–{1.0 - min(losses) ** 2:.1f}",
        "slopes": f"{min(slopes):.1f} and {max(slopes):.1f}",
        "least_scaled": f"{min(fit['scaled_range'][0] for fit in fits.values()):.2g}",
        "band_two": "({:g}, {:g})".format(*BANDS["two_sided"]),
        "band_one": "({:g}, {:g})".format(*BANDS["one_sided"]),
        "code_count": f"{sum(row[5] for row in law.tables['q_code']['rows'])}",
        "sentences": "\n".join(
            f"- {note}" for note in law.content["notes"] if re.search("q at SLV|below 2|q = 2", note)
        ),
    }
    for mechanism in ("two_sided", "one_sided"):
        short = mechanism[:3]
        for quantity in ("q", "q_slv"):
            fit = fits[f"{mechanism} rigid {quantity}"]
            inside, below = fit["set_of_records"]
            made |= {
                f"{short}_{quantity}_record": _ends(fit["record"]),
                f"{short}_{quantity}_records": f"{inside:.0%} inside, {below:.0%} below",
            }
            for variable, key in (("Λ", "scaled"), ("Π", "pi"), ("p PGV/PGA", "velocity")):
                words = {"c0": f"{short}-sided", "c1": SHOWN[quantity == "q_slv"]}
                (row,) = law.rows("rivals", **words, c2=f"{variable}, natural records")
                made[f"{short}_{quantity}_{key}"] = f"{row[4]:.2f}"
    for short, number in (("two", 15), ("one", 16)):
        refitted = law.rows("rivals", c0=f"{short}-sided", c2=f"Eq. {number} refitted on these walls, shape left out")
        own = law.rows("rivals", c0=f"{short}-sided", c1="q", c2="Λ on these walls, shape left out")
        made |= {f"{short}_refitted": f"{refitted[0][4]:.0%}", f"{short}_own": f"{own[0][4]:.0%}"}
    trilinear = [row[9] for row in law.tables["law"]["rows"] if row[0] == "two-sided" and "trilinear" in row[1]]
    return made | {"trilinear": f"{max(trilinear):.2f}"}


def rendered(template: str, values: dict[str, str]) -> str:
    """The page: each {{name}} of the template replaced. Raises KeyError for a cell without a value."""
    return re.sub(r"\{\{(\w+)\}\}", lambda cell: re.sub(r"(\d)%", r"\1 %", values[cell[1]]), template)


def page() -> str:
    """The page of the results that are kept."""
    found = [Results(json.loads(kept(name).read_text(encoding="utf-8"))) for name in ("paper", "law")]
    return rendered(TEMPLATE.read_text(encoding="utf-8"), cells(*found))


def main(files: list[str]) -> None:
    for name, file in zip(("paper", "law"), files, strict=False):
        content = json.loads(Path(file).read_text(encoding="utf-8"))
        events = [motion["event"] for motion in content["motions"] if motion["seed"] is None]
        counts = {"natural": {"records": len(events), "events": len(set(events))}}
        text = json.dumps({key: content[key] for key in KEPT} | counts, ensure_ascii=False)
        kept(name).write_text(text + "\n", encoding="utf-8")
    PAGE.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
