"""What a clause asks about, and what none does, as tables for resources/docs/verdict.md:
`.venv/bin/python -m tests.reference_of_asked` writes them there."""

from core.case.asked import ASKED, DEMAND, HOLD, NOT_ASKED, WALL
from core.case.document import kinds_that_show
from tests.conftest import ROOT

PAGE = ROOT / "resources" / "docs" / "verdict.md"
BEGIN, END = "<!-- asked -->\n", "<!-- end of asked -->\n"
PLACES = {WALL: "[[wall.evidence]]", DEMAND: "[[demand.evidence]]", HOLD: "evidence of the ties", "": "permitted"}


def tables() -> str:
    """Both tables: of a value its row in the results, the clause, where its document stands, and the kinds of it."""
    lines = ["| looked at | value | clause | document | kinds |", "|---|---|---|---|---|"]
    for code, row in ASKED.items():
        keys = ", ".join(f"`{key}`" for key in row.keys)
        kinds = ", ".join(kinds_that_show(row.section, row.shown_by)) if row.section else "–"
        place = f"`{PLACES[row.section]}`" if row.section in (WALL, DEMAND) else PLACES[row.section]
        lines.append(f"| `{code}` | {keys} | {row.clause} | {place} | {kinds} |")
    lines += ["", "| moved, and never in the way | why |", "|---|---|"]
    lines += [f"| `{code}` | {why} |" for code, why in NOT_ASKED.items()]
    return "\n".join(lines) + "\n"


def with_tables(page: str) -> str:
    """The page with the tables as they are to be."""
    before, _, rest = page.partition(BEGIN)
    return before + BEGIN + "\n" + tables() + "\n" + END + rest.partition(END)[2]


if __name__ == "__main__":
    PAGE.write_text(with_tables(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
