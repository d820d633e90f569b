"""Names of the variants of a wall. Standard library alone: run.py needs them before anything is installed."""

AS_IS, DESIGNED = "stato di fatto", "progetto"
"""Two walls of one name are compared if each is one of these variants."""
