"""Functions of a calculation by hand: angles in degrees, as an engineer writes them."""

import math
from math import atan, pi, radians, sqrt

__all__ = ["arctan", "atan", "cos", "kilo", "log", "pi", "radians", "sin", "sqrt", "tan"]

log = math.log


def arctan(ratio: float) -> float:
    """Angle [degrees]."""
    return math.degrees(math.atan(ratio))


def sin(angle: float) -> float:
    """angle : [degrees]"""
    return math.sin(math.radians(angle))


def cos(angle: float) -> float:
    """angle : [degrees]"""
    return math.cos(math.radians(angle))


def tan(angle: float) -> float:
    """angle : [degrees]"""
    return math.tan(math.radians(angle))


def kilo(value: float) -> float:
    """The value in a unit a thousand times smaller: MPa in kN/m2."""
    return 1000.0 * value
