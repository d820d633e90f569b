"""The one door by which a file that the user names is read: a regular file, not more of it than is meant."""

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO

FILE_CHUNK = 1 << 20
"""Bytes read at a time of a file that has more than it says."""


class TooLarge(OSError):
    """A file above its bound. size : [bytes], at least"""

    def __init__(self, size: int):
        super().__init__(errno.EFBIG, os.strerror(errno.EFBIG))
        self.size = size


def refuse_irregular(stream: BinaryIO) -> os.stat_result:
    """Return what the system says of an open file. Raises OSError for a device, a pipe, a socket: they have no end."""
    status = os.fstat(stream.fileno())
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "not a regular file")
    return status


def read_regular(path: Path, most: int) -> bytes:
    """Read the bytes of a file. most : bytes it may have

    Raises OSError as `open` does and for what is no regular file, TooLarge above the bound: also of one that grows, or
    says that it is empty.
    """
    with open_regular(path) as stream:
        size = os.fstat(stream.fileno()).st_size
        if size > most:
            raise TooLarge(size)
        content = stream.read(size + 1)
        while size < len(content) <= most and (more := stream.read(FILE_CHUNK)):  # it grows, or says that it is empty
            content += more
    if len(content) > most:
        raise TooLarge(len(content))
    return content


def open_regular(path: Path, buffering: int = -1) -> BinaryIO:
    """Open a regular file to be read. Raises OSError as `open` does and for a device, a pipe, a socket."""
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
    stream = os.fdopen(os.open(path, flags), "rb", buffering)  # a pipe without a writer does not hold it up
    try:
        refuse_irregular(stream)
    except OSError:
        stream.close()
        raise
    return stream


def first_bytes(path: Path, count: int) -> bytes:
    """Read so many bytes of the beginning of a regular file. Raises OSError."""
    with open_regular(path) as stream:
        return stream.read(count)
