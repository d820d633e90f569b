"""What the rules of a case hold to be there."""

from typing import TypeVar

Value = TypeVar("Value")


def known(value: Value | None) -> Value:
    """A value that cannot be missing here; where it is, that is a fault of the program."""
    assert value is not None
    return value
