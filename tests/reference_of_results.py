"""The keys of the results JSON as a page and a JSON Schema: `.venv/bin/python -m tests.reference_of_results` writes
resources/docs/results.md and results.schema.json, or into the folder it is given."""

import json
import sys
from pathlib import Path

from core.derivation import arch, bending, body, checks, closed_forms, demand, geometry
from core.derivation.quantity import Given
from core.report.columns import COLUMNS
from core.report.stated.quantity import Quantity, schema, walk_quantities
from core.report.stated.study import RESULTS
from tests.conftest import ROOT

FOLDER = ROOT / "resources" / "docs"
HEAD = """# The results

`--batch` writes beside the workbook `<case>.json`, with every number exact. Its keys and units are below; the same as a
[JSON Schema](results.schema.json), against which the results of every shipped case are tested. A key may be null where
there is no such number, and is left out where it says so. `[]` marks the items of a list, `.*` the values of a mapping.
A case of more than 10 000 walls has a table `<case>.parquet` with the columns of the second table, and in its JSON a
summary of its own ([scale.md](scale.md)), which is not of this schema. The sheet Check and the note derive the numbers
that have a symbol in the last column, line by line.

```
python3 run.py --batch resources/cases/verdict.toml --output results
```
```
>>> import json
>>> results = json.load(open("results/verdict.json", encoding="utf-8"))
>>> [(one["wall"], one["code"], one["zeta_e"]) for one in results["verdicts"]]
```
"""
KINDS = {
    "text": "text",
    "whole": "whole number",
    "number": "number",
    "flag": "true or false",
    "free": "object",
    "one": "object",
    "named": "object",
    "many": "list",
    "frees": "list of objects",
    "any": "number or text",
    "pairs": "list of pairs",
    "rows": "list of lists of texts",
}


def kind_of(quantity: Quantity) -> str:
    return KINDS.get(quantity.kind) or f"list of {KINDS[quantity.kind[:-1]]}s"


SYMBOLS = {
    value.name: value.symbol.format(state="LS", damping="ξ", years="years")
    for module in (arch, bending, body, checks, closed_forms, demand, geometry)
    for value in vars(module).values()
    if isinstance(value, Given)
}
"""Name of a line of the sheet Check -> its symbol."""


def row(path: str, quantity: Quantity) -> str:
    words = quantity.meaning + ("; left out where there is none" if quantity.left_out else "")
    derived = SYMBOLS[quantity.line] if quantity.line else ""
    return f"| `{path}` | {kind_of(quantity)} | {quantity.unit if quantity.unit != '-' else ''} | {words} | {derived} |"


def page() -> str:
    """The page, with every key."""
    head = ["| key | kind | unit | what it is | in Check |", "|---|---|---|---|---|"]
    keys = [row(path, quantity) for path, quantity in walk_quantities(RESULTS)]
    columns = [row(column.key, column) for column in COLUMNS]
    return "\n".join([HEAD, "## Every key", *head, *keys, "", "## Columns of many walls", *head, *columns]) + "\n"


def json_schema() -> str:
    """The schema of the file."""
    title = {"$schema": "http://json-schema.org/draft-07/schema#", "title": "Results of Ribalta"}
    return json.dumps(title | schema(RESULTS), indent=1, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if sys.argv[1:] else FOLDER
    (folder / "results.md").write_text(page(), encoding="utf-8")
    (folder / "results.schema.json").write_text(json_schema(), encoding="utf-8")
