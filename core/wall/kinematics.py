"""The mechanisms out of plane, each with what it does: who needs to know asks it, and recognises none by its name."""

from dataclasses import dataclass

BENDS, ARCHES = "vertical_bending", "horizontal_bending"
"""Names of the mechanisms of a wall held at its top and of one between transverse walls."""


@dataclass(frozen=True)
class Kinematics:
    """What a mechanism does.

    name : as a case file, the results and the reports have it
    one_way : it turns about its outer edge alone, and comes back to what stands behind it
    both_ways : it rocks about either edge
    bends_up : it opens a hinge between its base and what holds its top
    arches : it opens hinges between transverse walls
    demand_at : height of its body at which its demand is taken, of its height [-]
    restitution : model of restitution by default
    stands_for : names of those looked at in its place, each with a result of its own
    """

    name: str
    one_way: bool = False
    both_ways: bool = False
    bends_up: bool = False
    arches: bool = False
    demand_at: float = 0.0
    restitution: str = "housner"
    stands_for: tuple[str, ...] = ()

    @property
    def bends(self) -> bool:
        """Whether it is held at its top or at both ends, and opens a hinge between."""
        return self.bends_up or self.arches

    @property
    def members(self) -> tuple["Kinematics", ...]:
        """Those it stands for, or itself."""
        return tuple(map(kinematics, self.stands_for)) or (self,)

    @property
    def turns_one_way(self) -> bool:
        """Whether one of those it stands for turns one way."""
        return any(member.one_way for member in self.members)

    @property
    def rocks_both_ways(self) -> bool:
        """Whether one of those it stands for rocks both ways."""
        return any(member.both_ways for member in self.members)


NOT_CHOSEN = Kinematics("")
"""The mechanism of a draft that has none yet."""

MECHANISMS = {
    kind.name: kind
    for kind in (
        Kinematics("one_sided", one_way=True, restitution="one_sided_theoretical"),
        Kinematics("two_sided", both_ways=True),
        Kinematics("both", stands_for=("two_sided", "one_sided")),
        Kinematics(BENDS, bends_up=True, demand_at=0.5),
        Kinematics(ARCHES, arches=True, demand_at=1.0),
    )
}
"""Name -> mechanism, in the order in which a person is offered them."""


def kinematics(name: str) -> Kinematics:
    """The mechanism of this name; of a name that is none the one that does nothing."""
    return MECHANISMS.get(name, NOT_CHOSEN)
