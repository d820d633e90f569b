"""Journal of finished runs: one line each, on disk before the next, so that a killed batch resumes."""

import json
import os
import threading
from pathlib import Path

from core.errors import OutputError


class Journal:
    """Finished runs by key. key : of case, samples and version; another key starts it anew.

    set_aside : where the finished runs of an earlier start went that is not resumed, or None.
    """

    def __init__(self, path: Path, key: str, resume: bool):
        self.path, self.found, good = path, {}, 0
        self.set_aside: Path | None = None
        try:
            if path.is_symlink():
                path.unlink()
            if path.exists():
                good = self._read(path.read_bytes(), key)
            if self.found and not resume:
                self.set_aside = path.with_name(path.name + ".old")
                os.replace(path, self.set_aside)
                self.found, good = {}, 0
            self._stream = path.open("r+b" if good else "wb")
            # drop a line cut by a kill before writing on
            self._stream.seek(good)
            self._stream.truncate()
            if not good:
                self._write({"journal": key})
        except OSError as error:
            raise OutputError(f"{path}: the journal cannot be written: {error.strerror}") from None

    def _read(self, content: bytes, key: str) -> int:
        """Load whole lines; returns the bytes they take, 0 if the journal is of another study."""
        good = 0
        for k, line in enumerate(content.split(b"\n")[:-1]):
            try:
                entry = json.loads(line)
            except ValueError:
                break
            if k == 0 and entry != {"journal": key}:
                return 0
            if k > 0:
                if not isinstance(entry, dict) or "result" not in entry:
                    break
                self.found[entry["run"]] = entry["result"]
            good += len(line) + 1
        return good

    def _write(self, entry: dict) -> None:
        self._stream.write(json.dumps(entry).encode() + b"\n")
        self._stream.flush()
        os.fsync(self._stream.fileno())

    def get(self, run: str) -> dict | None:
        return self.found.get(run)

    def add(self, run: str, result: dict) -> None:
        try:
            self._write({"run": run, "result": result})
        except OSError as error:
            raise OutputError(
                f"{self.path}: the journal cannot be written: {error.strerror}"
            ) from None

    def close(self) -> None:
        self._stream.close()

    def remove(self) -> None:
        self.close()
        self.path.unlink(missing_ok=True)


class Memory:
    """Finished runs of one process by key, for the studies that follow; as a Journal, but not on disk.

    most : digits of survival maps kept, what takes the room; the oldest runs go first. analyses : made by
    all runs added so far. Several threads may add.
    """

    def __init__(self, most: int = 20_000_000):
        self.most, self.found = most, {}
        self.size = self.analyses = 0
        self._lock = threading.Lock()

    def get(self, run: str) -> dict | None:
        return self.found.get(run)

    def add(self, run: str, result: dict) -> None:
        with self._lock:
            self.found[run] = result
            self.analyses += result["analyses"]
            self.size += len(result["outcomes"])
            while self.size > self.most:
                oldest = self.found.pop(next(iter(self.found)))
                self.size -= len(oldest["outcomes"])

    def close(self) -> None:
        """Nothing is open."""
