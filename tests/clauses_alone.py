"""Cases judged by the checks of the clauses alone."""

from core.case import rules
from core.case.schema import Case


def parse_case(table: dict) -> Case:
    """`core.case.rules.parse_case` of a table; where it has no records none are generated for want of them, and the
    reason is given."""
    demand = table.get("demand")
    if any(key in table for key in ("record", "generate", "select")) or not isinstance(demand, dict):
        return rules.parse_case(table)
    reasons = {"histories": "a test of the clauses alone"} | demand.get("justification", {})
    analysis = {"histories": False} | table.get("analysis", {})
    return rules.parse_case(table | {"analysis": analysis, "demand": demand | {"justification": reasons}})
