"""Cases judged by the checks of the clauses alone."""

from core.case import rules
from core.case.schema import Case


def parse_case(table: dict) -> Case:
    """`core.case.rules.parse_case` of a table; where it has no records none are generated for want of them."""
    if any(key in table for key in ("record", "generate", "select")) or not isinstance(table.get("demand"), dict):
        return rules.parse_case(table)
    return rules.parse_case(table | {"analysis": {"histories": False} | table.get("analysis", {})})
