"""Unit conversions at the border of the program. Inside, everything is SI and radians."""

G = 9.80665
"""Standard gravity [m/s2]; the one value used everywhere (another g moves a history by a percent)."""

CM = 0.01
"""One centimetre [m]."""
