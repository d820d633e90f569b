"""Errors the user can mend, and the cancellation of a run."""


class InputError(ValueError):
    """Something in the input is wrong: one sentence with place, value, accepted range, next step."""


class RecordError(InputError):
    """A record cannot be read as an accelerogram."""


class OutputError(InputError):
    """A result cannot be written."""


class Cancelled(Exception):
    """The user asked to stop between two analyses; finished runs are in the journal."""


def require(condition: bool, name: str, value, accepted: str) -> None:
    """Raise InputError naming the field, its value and what is accepted, unless condition holds."""
    if not condition:
        raise InputError(f"{name} = {repr(value)[:100]} is not accepted: {accepted}")
