"""What the window works on: the case with its history, its file, its records and its result. No widget."""

import contextlib
import hashlib
import os
import secrets
import time
import tomllib
import weakref
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, BinaryIO

from app.work import recovery
from app.work.draft import make_savable
from app.work.site_demand import update_demand
from core import atomic_write
from core.case.drawn_solids import expand_drawings
from core.case.judge import IncrementalParser
from core.case.problems import find_problems
from core.case.reader import read_case, read_toml
from core.case.rules import parse_draft
from core.case.schema import Case, Record, Report
from core.case.wall import Wall
from core.case.writer import dumps, table_of
from core.errors import InputError, OutputError
from core.file_names import key_of, name_of
from core.known import require_value
from core.setting.demand_input import read_target_spectrum
from core.study.journal import lock_file
from core.study.results import StudyResult
from core.text.sentence import Sentence

UNDO_PAUSE = 1.0
"""A pause [s] that ends a step of undo."""

MAX_UNDO = 500
"""Steps kept for undo."""


class Session:
    """A case being edited. Every change is a new frozen Case; old ones are kept for undo.

    on_change : called after every change of case, file or result, without arguments.
    left_out : why the last file that was saved lacks some values
    """

    def __init__(self, recovery_folder: Path):
        self.recovery_folder = recovery_folder
        self.listeners: list[Callable[[], None]] = []
        self.base_dir = Path.cwd()
        self.path: Path | None = None
        self.result: StudyResult | None = None
        self.samples: set[str] | None = None
        """Hashes of the records as they are on disk, None while they are not read."""
        self.token = secrets.token_hex(8)
        self._lock_file: BinaryIO | None = None
        self._judge = IncrementalParser()
        self._known: tuple | None = None
        self._problems: tuple | None = None
        self.generation = 0
        self._start(Case())

    def _start(self, case: Case) -> None:
        """Another case: results on their way to the one before must not arrive here."""
        self.generation += 1
        self.case = self.saved = case
        self.past: list[Case] = []
        self.future: list[Case] = []
        self.last_place: object = None
        self.last_edit = 0.0
        self.content: bytes | None = None
        self.from_drawings: tuple[Sentence | InputError, ...] = ()
        self.left_out: list[InputError] = []
        self.result = None

    def changed(self) -> None:
        self._take_words()
        for listener in self.listeners:
            listener()

    # the case and its history

    def edit(self, case: Case, place: object = None) -> None:
        """A new case; edits of the same place without a pause are one step of undo."""
        case = replace(case, demand=update_demand(self.case, case))
        if case == self.case:
            return
        now = time.monotonic()
        if place is None or place != self.last_place or now - self.last_edit > UNDO_PAUSE:
            self.past = [*self.past[-MAX_UNDO:], self.case]
        self.future = []
        self.last_place, self.last_edit = place, now
        self.case = case
        self.changed()

    def edit_wall(self, index: int, place: object = None, **values) -> None:
        walls = list(self.case.wall)
        walls[index] = replace(walls[index], **values)
        self.edit(replace(self.case, wall=tuple(walls)), place)

    def edit_section(self, section: str, place: object = None, **values) -> None:
        """Change keys of report, analysis, demand or generate."""
        changed = replace(getattr(self.case, section), **values)
        self.edit(replace(self.case, **{section: changed}), place)

    def undo(self) -> None:
        if self.past:
            self.future.append(self.case)
            self.case = self.past.pop()
            self.last_place = None
            self.changed()

    def redo(self) -> None:
        if self.future:
            self.past.append(self.case)
            self.case = self.future.pop()
            self.last_place = None
            self.changed()

    def _take_words(self) -> None:
        """A result stays that of a case whose title or report alone has changed since: they decide no number."""
        result = self.result
        case = self.checked() if result is not None else None
        if result is None or case is None or case == result.case:
            return
        if replace(result.case, title=case.title, report=case.report) == case:
            self.result = replace(result, case=case)

    @property
    def dirty(self) -> bool:
        return self.case != self.saved

    @property
    def stale(self) -> bool:
        """Whether the result is of another case than the one shown, or of records that another program has
        changed since."""
        if self.result is None:
            return False
        if self.result.case != self.checked():
            return True
        demand = self.case.demand
        if demand and demand.spectrum_file and self.result.demand:
            with contextlib.suppress(InputError, TypeError):
                if read_target_spectrum(demand, self.base_dir) != self.result.demand.target:
                    return True
        used = {m.samples_sha256 for m in self.result.motions if m.format != "generated"}
        return self.samples is not None and not used <= self.samples

    def _judged(self) -> tuple[Case | None, InputError | None]:
        """(the case as the batch would read it, None) or (None, the first broken rule)."""
        if self._known is None or self._known[0] is not self.case:
            try:
                case = self._judge(self.case)
                if self.saved.sha256 and not self.dirty:  # what the batch says of the file
                    given = self.saved.given or case.given
                    read = {key: getattr(self.saved, key) for key in ("sha256", "table", "source", "files")}
                    case = replace(case, given=given, **read)
                judged = (case, None)
            except InputError as error:
                judged = (None, error)
            self._known = (self.case, judged)
        return self._known[1]

    def checked(self) -> Case | None:
        """The case as the batch would read it, None where a rule is broken."""
        return self._judged()[0]

    def problem(self) -> InputError | None:
        """The first broken rule; None if the case can run."""
        return self._judged()[1]

    def problems(self) -> list[InputError]:
        """All that keeps the case from running."""
        if self.problem() is None:
            return []
        if self._problems is None or self._problems[0] is not self.case:
            self._problems = (self.case, find_problems(self.case, self._judge) or [self.problem()])
        return self._problems[1]

    # walls and records

    def add_walls(self, walls: list[Wall]) -> None:
        names = {wall.title for wall in self.case.wall}
        added = []
        for wall in walls:
            name, k = wall.name, 2
            while replace(wall, name=name).title in names:
                name, k = f"{wall.name} {k}", k + 1
            added.append(replace(wall, name=name))
            names.add(added[-1].title)
        self.edit(replace(self.case, wall=(*self.case.wall, *added)))

    def remove_wall(self, index: int) -> None:
        walls = [wall for k, wall in enumerate(self.case.wall) if k != index]
        self.edit(replace(self.case, wall=tuple(walls)))

    def add_records(self, records: list[Record]) -> None:
        known = {record.file for record in self.case.record}
        new = [record for record in records if record.file not in known]
        self.edit(replace(self.case, record=(*self.case.record, *new)))

    def relative(self, path: Path) -> str:
        """A record's path as the case file will hold it."""
        if self.path is None:
            return key_of(str(path.resolve()))
        with contextlib.suppress(ValueError):  # another drive
            return key_of(Path(os.path.relpath(path, self.base_dir)).as_posix())
        return key_of(str(path.resolve()))

    # files

    def new(self, language: str = "en") -> None:
        """An empty case with its report in this language."""
        self.drop_recovery_file()
        self._start(Case(report=Report(language=language)))
        self.path, self.base_dir = None, Path.cwd()
        self.changed()

    def open(self, path: Path) -> None:
        """Open a case file, also one that is not complete yet; raises InputError and keeps what is open. The shapes of
        its drawings become solids; `from_drawings` says which, or why not."""
        try:
            case = read_case(path)
            from_drawings = case.drawings
        except InputError as error:
            try:
                table, _ = read_toml(path)
            except InputError:
                raise error from None
            if "walls" in table:
                raise  # its table cannot be merged into a draft
            try:
                table, drawings = expand_drawings(table, path.parent)
                from_drawings = tuple(drawing.notice for drawing in drawings)
            except InputError as wrong:
                from_drawings = (wrong,)
            case = parse_draft(table)
        self.drop_recovery_file()
        self._start(replace(case, drawings=()))
        self.from_drawings = from_drawings
        self.path, self.base_dir = path.resolve(), path.resolve().parent
        if path.suffix.lower() == ".pdf":  # its case was read from a note, which is not written into
            self.path = None
        self.content = self._on_disk()
        self.changed()

    def _on_disk(self) -> bytes | None:
        try:
            return self.path.read_bytes() if self.path else None
        except OSError:
            return None

    @property
    def is_changed_on_disk(self) -> bool:
        """Whether another program wrote the case's file since it was read or saved here."""
        return self.content is not None and self._on_disk() not in (None, self.content)

    def save(self, path: Path | None = None) -> None:
        """Write the case file, whole or not at all; record paths follow it to another folder. A value that no case file
        may hold is not written, `left_out` says why, and the case stays unsaved. Raises InputError."""
        target = require_value(path or self.path).resolve()
        old = self.base_dir

        def moved(case: Case) -> Case:
            return self._moved(case, old, target.parent)

        case = moved(self.case)
        before = (self.content or b"").decode("utf-8-sig", errors="replace")
        text, given, self.left_out = self._text(case, before)
        content = text.encode()
        atomic_write.write({target: content})
        self.content = content
        self.drop_recovery_file()
        self.path, self.base_dir = target, target.parent
        self.case = case
        digest = hashlib.sha256(content).hexdigest()
        written = make_savable(case)[0] if self.left_out else case
        self.saved = replace(written, sha256=digest, given=given, table="")
        self._known = None
        self.past, self.future = [moved(c) for c in self.past], [moved(c) for c in self.future]
        if self.result is not None:
            self.result = self.relocate_result(self.result, old)
        self.last_place = None
        self.changed()

    @staticmethod
    def _reads(text: str, case: Case) -> bool:
        """Whether the text of a file is read as this case."""
        try:
            return table_of(parse_draft(tomllib.loads(text))) == table_of(case)
        except InputError:
            return False

    @staticmethod
    def _text(case: Case, before: str = "") -> tuple[str, frozenset, list[InputError]]:
        """(the case as the text of a file, what it states, what was left out of it), complete or not. before : as of
        `dumps`. Raises InputError where it could not be opened again: what is there already is not given up for it."""
        left_out: list[InputError] = []
        text = dumps(case, before)
        if not Session._reads(text, case):
            case, left_out = make_savable(case)
            text = dumps(case, before)
        again = parse_draft(tomllib.loads(text))
        if table_of(again) != table_of(case):
            raise OutputError("case_reads_otherwise")
        return text, again.given, left_out

    def relocate_result(self, result: StudyResult, old: Path) -> StudyResult:
        """A result of the folder `old` as one of the case's folder now, and of its file."""
        case, known = self._moved(result.case, old, self.base_dir), self.checked()
        motions = tuple(
            motion
            if motion.format == "generated"
            else replace(motion, file=self._seen(motion.file, old, self.base_dir))
            for motion in result.motions
        )
        return replace(result, case=known if known == case else case, motions=motions)

    @staticmethod
    def _seen(name: str, old: Path, new: Path) -> str:
        """A path, as a case holds it, as seen from another folder."""
        if new == old and not Path(name).is_absolute():
            return name
        with contextlib.suppress(ValueError):  # another drive
            return key_of(Path(os.path.relpath(old / name_of(name), new)).as_posix())
        return name

    @staticmethod
    def _moved(case: Case, old: Path, new: Path) -> Case:
        """The case with its paths as seen from another folder."""
        seen = Session._seen
        records = tuple(replace(record, file=seen(record.file, old, new)) for record in case.record)
        demand, report, select = case.demand, case.report, case.select
        if select and select.folder:
            select = replace(select, folder=seen(select.folder, old, new))
        if report.logo:
            report = replace(report, logo=seen(report.logo, old, new))
        for key in ("spectrum_file", "hazard_file"):
            if demand and getattr(demand, key):
                file: dict[str, Any] = {key: seen(getattr(demand, key), old, new)}
                demand = replace(demand, **file)
        return replace(case, record=records, select=select, demand=demand, report=report)

    # the recovery file: what a kill -9 must not lose

    @property
    def recovery_file(self) -> Path:
        name = hashlib.sha256(os.fsencode(str(self.path))).hexdigest()[:16]
        return self.recovery_folder / f"{name}-{self.token}.swap"

    def _hold(self) -> None:
        """While this file is locked the recovery files of this session are in use, whatever runs elsewhere."""
        if self._lock_file is None:
            self.recovery_folder.mkdir(parents=True, exist_ok=True)
            self._lock_file = open(self.recovery_folder / f"{self.token}.lock", "ab")  # noqa: SIM115  (to the end)
            weakref.finalize(self, self._lock_file.close)
            lock_file(self._lock_file)

    def autosave(self) -> bool:
        """Keep the unsaved case in the recovery file, and return whether it is kept; a full disk must not disturb the
        work, and what could not be recovered takes the place of nothing."""
        if not self.dirty:
            self.drop_recovery_file()
            return False
        with contextlib.suppress(OSError, InputError):
            text = self._text(self.case)[0]
            self._hold()
            recovery.write_state(self.recovery_file, text, self.path, self.base_dir)
            return True
        return False

    def drop_recovery_file(self) -> None:
        recovery.delete_states(self.recovery_file)

    def close(self) -> None:
        """The session ends: its lock goes, and its recovery files are anybody's."""
        if self._lock_file is not None:
            if os.name == "nt":
                self._lock_file.close()
            with contextlib.suppress(OSError):
                (self.recovery_folder / f"{self.token}.lock").unlink(missing_ok=True)
            self._lock_file.close()
            self._lock_file = None

    def recoverable(self) -> list[Path]:
        """Recovery files whose session is gone, the newest first; each stands for its last states."""
        tokens = {file: file.stem.rsplit("-", 1)[-1] for file in recovery.files(self.recovery_folder)}
        return [file for file, token in tokens.items() if token != self.token and not self._in_use(token)]

    def _in_use(self, token: str) -> bool:
        """Whether the session of this token still holds its lock."""
        place = self.recovery_folder / f"{token}.lock"
        try:
            if not place.is_file():
                return False
            with open(place, "ab") as stream:
                lock_file(stream)
            place.unlink(missing_ok=True)
        except OSError:
            return True
        return False

    def recover(self, file: Path) -> None:
        """Take over the case of a recovery file, its newest state that reads; the file it belongs to is untouched, and
        what cannot be read stays where it is. Raises InputError."""
        draft, saved = recovery.newest(file), Case()
        with contextlib.suppress(InputError, OSError, ValueError):
            if draft.path and draft.path.exists():
                saved = read_case(draft.path)
        self._start(draft.case)
        self.saved, self.path, self.base_dir = saved, draft.path, draft.base_dir
        self.autosave()  # before the other goes: a kill in between loses nothing
        if self.recovery_file.is_file() or not self.dirty:
            recovery.delete_states(file)
        self.changed()
