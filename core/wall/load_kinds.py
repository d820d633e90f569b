"""Kinds of loads of a wall, each with what it is: who needs to know asks it, and recognises none by its name."""

from dataclasses import dataclass


@dataclass(frozen=True)
class LoadKind:
    """A kind of load.

    name : as a case file has it
    is_weight : it acts downward; where not, across the wall, outward positive
    rests : its mass is held elsewhere, pushes the wall or moves with it: which, is stated
    is_carried : its mass moves with the wall
    """

    name: str
    is_weight: bool = False
    rests: bool = False
    is_carried: bool = False


LOAD_KINDS = {
    kind.name: kind
    for kind in (
        LoadKind("vertical", is_weight=True, rests=True),
        LoadKind("thrust"),
        LoadKind("carried_mass", is_weight=True, is_carried=True),
    )
}
"""Name -> kind, in the order in which a person is offered them."""


class OfLoadKind:
    """What a load is, by the name of its kind."""

    kind: str

    @property
    def is_weight(self) -> bool:
        """Whether it acts downward."""
        return self.kind in LOAD_KINDS and LOAD_KINDS[self.kind].is_weight

    @property
    def rests(self) -> bool:
        """Whether it is a weight of which is stated what its mass does."""
        return self.kind in LOAD_KINDS and LOAD_KINDS[self.kind].rests

    @property
    def is_carried(self) -> bool:
        """Whether it is a mass that moves with the wall."""
        return self.kind in LOAD_KINDS and LOAD_KINDS[self.kind].is_carried

    @property
    def is_thrust(self) -> bool:
        """Whether it acts across the wall, and is no tie."""
        return self.kind in LOAD_KINDS and not LOAD_KINDS[self.kind].is_weight
