"""The rotations a limit state allows."""

LIMIT_FRACTION = {"SLV": 0.40, "SLC": 0.60}
"""Share of the rotation at which nothing holds the wall, and of d_0, that a limit state allows without
ties or supports (Circolare 7/2019 C8.7.1.2.1.6)."""
