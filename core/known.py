"""What the rules of a case hold to be there."""

from typing import TypeVar

Value = TypeVar("Value")


def require_value(value: Value | None) -> Value:
    """A value that cannot be missing in a case whose rules hold. Raises TypeError where it is, as arithmetic on ""
    does: the forms of a draft wait for it, anywhere else that is a fault of the program."""
    if value is None:
        raise TypeError(value)
    return value
