"""Walls as they are beside walls as they are designed, compared line by line."""

from collections.abc import Container
from dataclasses import dataclass, fields, replace

from core.case.variant_names import AS_IS, DESIGNED
from core.case.wall import Wall
from core.study.results import WallResult, WallVerdict
from core.text.sentence import notice


@dataclass(frozen=True)
class Comparison:
    """One wall and mechanism before and after.

    changed : keys of the case whose values differ
    """

    name: str
    before: WallResult
    after: WallResult
    changed: tuple[str, ...]


def changed_keys(before: Wall, after: Wall) -> tuple[str, ...]:
    """Keys whose values differ between two walls, names and notes apart."""
    return tuple(
        entry.name
        for entry in fields(Wall)
        if entry.name not in ("name", "variant", "notes", "unloaded_confirmed")
        and getattr(before.without_sought(), entry.name) != getattr(after.without_sought(), entry.name)
    )


def compare_results(walls: tuple[WallResult, ...]) -> tuple[Comparison, ...]:
    """The pairs of a study, in its order."""
    after = {w.pair: w for w in walls if w.wall.variant == DESIGNED}
    pairs = []
    for wall in walls:
        other = after.get(wall.pair)
        if wall.wall.variant == AS_IS and other is not None:
            changed = changed_keys(wall.wall, other.wall)
            pairs.append(Comparison(wall.part.own_name, wall, other, changed))
    return tuple(pairs)


@dataclass(frozen=True)
class WallComparison:
    """One wall of the case before and after, each with its outcome. changed : keys of the case whose values differ"""

    name: str
    before: WallVerdict
    after: WallVerdict
    changed: tuple[str, ...]


def compare_walls(verdicts: tuple[WallVerdict, ...]) -> tuple[WallComparison, ...]:
    """The walls of a study as they are beside as they are designed, in its order; empty without a demand."""
    after = {verdict.wall.name: verdict for verdict in verdicts if verdict.wall.variant == DESIGNED}
    before = [verdict for verdict in verdicts if verdict.wall.variant == AS_IS and verdict.wall.name in after]
    pairs = [(one, after[one.wall.name]) for one in before]
    return tuple(WallComparison(a.wall.name, a, b, changed_keys(a.wall, b.wall)) for a, b in pairs)


OTHER_VARIANT = {AS_IS: DESIGNED, DESIGNED: AS_IS}


def flag_missing_variant(wall: WallResult, known: Container) -> WallResult:
    """A result; with a notice where it is a variant whose counterpart is missing. known : of `Plan.variants`"""
    variant = wall.wall.variant
    if variant is None or (wall.pair, OTHER_VARIANT[variant]) in known:
        return wall
    return replace(wall, warnings=(notice("variant_alone"), *wall.warnings))
