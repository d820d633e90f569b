"""How far the making of a file is, and whether it is still wanted: asked at every part, told in hundredths."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TypeVar

T = TypeVar("T")


class Steps:
    """Goes through the parts of a work, parts within parts.

    check : called at every item, may raise to end the work
    tell(done, planned) : called when another hundredth is done
    planned : hundredths that are taken in all
    """

    def __init__(
        self,
        check: Callable[[], None] = lambda: None,
        tell: Callable[[int, int], None] = lambda done, planned: None,
        planned: int = 100,
    ):
        self.check, self._tell, self.planned = check, tell, planned
        self._told, self._span = -1, (0.0, 0.0)

    def take(self, hundredths: float) -> None:
        """The part that begins now is as much of the work as this."""
        end = self._span[1]
        self._span = (end, end + hundredths)
        self._at(end)

    def each(self, items: Iterable[T], weights: Sequence[float] | None = None) -> Iterator[T]:
        """The items one after the other, to which the present part belongs by their weights, or in equal shares."""
        known = list(items)
        shares = weights or [1.0] * len(known)
        low, high = self._span
        width, done = (high - low) / (sum(shares) or 1.0), low
        for item, share in zip(known, shares, strict=True):
            self._at(done)
            self._span = (done, done + width * share)
            yield item
            done += width * share
        self._span = (high, high)

    def _at(self, done: float) -> None:
        self.check()
        if int(done) > self._told:
            self._told = int(done)
            self._tell(self._told, self.planned)
