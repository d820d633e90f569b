"""What the forms of a wall have in common."""

from collections.abc import Callable

from PySide6.QtWidgets import QWidget

from app.work.session import Session
from core.case.wall import Wall


class WallEditor(QWidget):
    """Edits the wall at `index()`, or a part of it."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__()
        self.session, self.index = session, index

    @property
    def wall(self) -> Wall | None:
        walls = self.session.case.wall
        return walls[self.index()] if self.index() < len(walls) else None

    def edit(self, *place, **values) -> None:
        """Change keys of the wall, if there is one. place : key by key to what is typed, none for a choice"""
        if self.wall is not None:
            self.session.edit_wall(self.index(), ("wall", self.index(), *place) if place else None, **values)
