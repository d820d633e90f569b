"""The summary of a case of more walls than a workbook holds: what was asked, counts, the worst walls, the columns."""

import json
from collections import Counter
from dataclasses import replace

from core.answer.answer import Worst
from core.case.schema import Case
from core.report.columns import COLUMNS
from core.report.stated.quantity import serialize
from core.report.stated.study import OF_STUDY
from core.study.results import StudyResult
from core.version import NAME, VERSION, commit

WORST = 100
"""Walls that are named, the worst first."""

NAMED = ("wall", "name", "variant", "hinge_m", "mechanism", "verdict", "check", "zeta_e", "zeta_target", "q_set")


class Tally:
    """Counts of the rows of a case as they go by."""

    def __init__(self) -> None:
        self.rows = self.walls = self.analyses = self.without_q = self.errors = 0
        self.verdicts: Counter[str] = Counter()
        self._worst = Worst(WORST)

    def add(self, rows: dict[str, list]) -> None:
        """Count the rows of a group. rows : by column"""
        self.rows += len(rows["wall"])
        self.walls += len(set(rows["wall"]))
        self.analyses += sum(rows["analyses"])
        self.without_q += sum(rows["runs_without_q"])
        self.errors += sum("wall_error" in (codes or ()) for codes in rows["warnings"])
        decide = [k for k, decides in enumerate(rows["decides"]) if decides is None or decides]
        self.verdicts.update(rows["verdict"][k] for k in decide if rows["decides"][k])
        self._worst.add({name: rows[name][k] for name in NAMED} for k in decide)

    @property
    def worst(self) -> list[dict]:
        """The worst walls, the worst first, by their keys NAMED."""
        return self._worst.rows


def summary(case: Case, result: StudyResult, tally: Tally, file: str) -> dict:
    """The summary as a mapping.

    case : with all its walls, which it does not list
    result : of one group, for what is of all
    file : name of the table
    """
    return {
        "program": {"name": NAME, "version": VERSION, "commit": commit()},
        "case": {**replace(case, wall=()).as_dict(), "walls": case.table or None},
        "case_sha256": case.sha256,
        **serialize([one for one in OF_STUDY if one.key in ("demand", "records", "selection")], result),
        "table": {
            "file": file,
            "rows": tally.rows,
            "columns": [{"name": column.key, "kind": column.kind, "unit": column.unit or None} for column in COLUMNS],
        },
        "walls": tally.walls,
        "verdicts": dict(sorted(tally.verdicts.items())),
        "analyses": tally.analyses,
        "runs_without_q": tally.without_q,
        "worst": tally.worst,
    }


def dumps(content: dict) -> str:
    """The summary as JSON text."""
    return json.dumps(content, indent=1, allow_nan=False, ensure_ascii=False) + "\n"
