"""Metadata of the wheel that follow from the README: its text as the description, and where the project is.

RIBALTA_ADDRESS, when the wheel is built, is the address below which the files of the sources are served as they are:
links and pictures of the description then lead there. Without it the description has no pictures, and its links are
plain words: an address that does not exist would be worse.
"""

import os
import re
from pathlib import Path

from hatchling.metadata.plugin.interface import MetadataHookInterface

PICTURE = re.compile(r"!\[([^]]*)\]\((?!https?:)([^)]+)\)\n*")
LINK = re.compile(r"(?<!!)\[([^]]*)\]\((?!https?:)([^)]+)\)")


def description(text: str, address: str) -> str:
    """A text in Markdown without links to files that are not beside it."""
    if address:
        text = PICTURE.sub(rf"![\1]({address}/\2)\n\n", text)
        return LINK.sub(rf"[\1]({address}/\2)", text)
    return LINK.sub(r"\1", PICTURE.sub("", text))


class Metadata(MetadataHookInterface):
    """What hatchling asks."""

    def update(self, metadata: dict) -> None:
        """Fill in what pyproject.toml names as dynamic."""
        address = os.environ.get("RIBALTA_ADDRESS", "").rstrip("/")
        text = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": description(text, address)}
        metadata["urls"] = {}
        if address:
            metadata["urls"] = {
                "Source": address,
                "Changelog": f"{address}/CHANGELOG.md",
                "Documentation": f"{address}/resources/docs/guide/1_install.md",
            }
