"""Text in tables that spreadsheets read: CSV and what is copied."""

import re

FORMULA_MARKS = ("=", "+", "-", "@", "＝", "＋", "－", "＠")
"""Marks a formula begins with, of full width too."""


def plain_cell(text: str) -> str:
    """Text that no spreadsheet takes for a formula; a number stays one."""
    if re.fullmatch(r"[+-]?[0-9]+([.,][0-9]+)?([eE][+-]?[0-9]+)?", text):
        return text
    return f"'{text}" if text.strip()[:1] in FORMULA_MARKS else text
