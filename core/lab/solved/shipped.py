"""The cases that come with the program."""

from pathlib import Path

SHIPPED = Path(__file__).resolve().parents[3] / "resources" / "cases"
