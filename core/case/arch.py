"""What a case says of a wall between its transverse walls, and the part of the wall that spans there."""

from dataclasses import MISSING, dataclass

from core.case.keys import number_key, text_key
from core.known import require_value
from core.wall import arch
from core.wall.ties import elongation_at_yield


@dataclass(frozen=True)
class Between:
    """[wall.arch]: the transverse walls between which a wall spans, and what its ends push against.

    spacing_m : clear distance L between two of them
    tie_kn_m : yield force of the ties along the wall, per metre of its height
    tie_bar_length_m, tie_elongation_m : length of a bar, and the elongation it stands
    shoulder_length_m, shoulder_thickness_m : of the masonry beyond the last transverse wall, along it and across
    out_kn_m : what holds each end across the wall beside the friction of its thrust, per metre of height
    corner_wall : wall of the case with a [wall.corner] that stands there, and takes that thrust; corner_side : which of
        its two walls the one that spans goes on from, 1 or 2
    """

    spacing_m: float = number_key(0.3, 50.0, MISSING, unit="m")
    tie_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m", exclusive=True)
    tie_bar_length_m: float | None = number_key(0.2, 300.0, unit="m")
    tie_elongation_m: float | None = number_key(0.0, 10.0, unit="m")
    shoulder_length_m: float | None = number_key(0.05, 50.0, unit="m")
    shoulder_thickness_m: float | None = number_key(0.05, 20.0, unit="m", form_unit="cm")
    out_kn_m: float | None = number_key(0.0, 10000.0, unit="kN/m", exclusive=True)
    corner_wall: str = text_key()
    corner_side: int | None = number_key(1, 2, whole=True)

    @property
    def with_tie(self) -> bool:
        """Whether ties along the wall are said to hold it."""
        return self.tie_kn_m is not None

    @property
    def with_shoulder(self) -> bool:
        """Whether masonry beyond its ends is."""
        return self.shoulder_length_m is not None

    @property
    def at_yield(self) -> float:
        """Elongation of a bar of the ties at yield [m]."""
        return elongation_at_yield(require_value(self.tie_bar_length_m))

    def in_si(self, height: float, thickness: float, unit_weight: float, strength: float, presses: float) -> arch.Arch:
        """The arch of a wall. height, thickness : [m]; unit_weight : w [N/m3]; strength : f [Pa]; presses : what
        presses the wall outward between its transverse walls [N/m]"""
        tie = shoulder = None
        if self.tie_kn_m is not None and self.tie_bar_length_m is not None and self.tie_elongation_m is not None:
            bays = max(1.0, self.tie_bar_length_m / self.spacing_m)
            tie = arch.Along(1e3 * self.tie_kn_m, self.at_yield, self.tie_elongation_m, bays)
        if self.shoulder_length_m is not None and self.shoulder_thickness_m is not None:
            sizes = self.shoulder_length_m, self.shoulder_thickness_m
            parted = arch.parted_flat(self.spacing_m, thickness)
            shoulder = arch.thrust_of_shoulder(*sizes, height, unit_weight, parted)
        by_ends = arch.arch_of(self.spacing_m, thickness, strength, tie, shoulder, presses)
        return by_ends._replace(across=1e3 * (self.out_kn_m or 0.0))
