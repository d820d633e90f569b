"""The documents as a site: python3 run.py docs [--output DIR]

Sphinx with myst-parser: the pages of resources/docs, both guides, README and CHANGELOG as they are, and the names of
the package from their docstrings. It builds without a network; a link that leads nowhere ends it.
"""

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from core.version import NAME, VERSION  # noqa: E402

PROGRAM = [
    *("README", "CHANGELOG", "CONTRIBUTING", "THIRD_PARTY", "names"),
    *("packaging/README", "resources/benchmark/README", "resources/reference/README"),
]
PARTS = (
    ("Guide", "resources/docs/guide/*.md"),
    ("Guida", "resources/docs/guida/*.md"),
    ("Reference", "resources/docs/*.md"),
)
CONF = """
import sys
sys.path.insert(0, {root!r})
project, version, release, author = {name!r}, {version!r}, {version!r}, "The Ribalta authors"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {{".md": "markdown"}}
myst_heading_anchors = 4
napoleon_google_docstring = False
autodoc_typehints = "description"
html_theme = "alabaster"
html_theme_options = {{"description": "Out-of-plane overturning of masonry walls", "page_width": "1100px"}}
html_copy_source = False
exclude_patterns = ["packaging/joss"]
"""
API = """# Names of the package
```{eval-rst}
.. automodule:: core.api
   :members:
   :member-order: bysource
```
"""


def pages_of(pattern: str) -> list[str]:
    """Names of the documents of a part, without their ending."""
    return [path.relative_to(ROOT).with_suffix("").as_posix() for path in sorted(ROOT.glob(pattern))]


def tree_of(title: str, names: list[str]) -> str:
    """Table of contents of a part."""
    listed = "\n".join(names)
    return f"```{{toctree}}\n:caption: {title}\n:maxdepth: 1\n\n{listed}\n```\n\n"


def written(source: Path) -> None:
    """Lay out what Sphinx reads: the documents in their places, an index, the names of the package."""
    for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "THIRD_PARTY.md"):
        shutil.copy(ROOT / name, source / name)
    shutil.copytree(ROOT / "resources", source / "resources", ignore=shutil.ignore_patterns("*.npz", "__pycache__"))
    shutil.copytree(ROOT / "packaging", source / "packaging", ignore=shutil.ignore_patterns("__pycache__"))
    tables = [("Program", PROGRAM)]
    tables += [(title, pages_of(pattern)) for title, pattern in PARTS]
    trees = "".join(
        f"```{{toctree}}\n:caption: {title}\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n\n"
        for title, names in tables
    )
    (source / "index.md").write_text(f"# {NAME} {VERSION}\n\n{trees}", encoding="utf-8")
    (source / "names.md").write_text(API, encoding="utf-8")
    conf = CONF.format(root=str(ROOT), name=NAME, version=VERSION)
    (source / "conf.py").write_text(conf, encoding="utf-8")


def build(output: Path) -> int:
    """Write the site into a folder; returns the exit code of Sphinx, not 0 where a link leads nowhere."""
    from sphinx.cmd.build import main as sphinx

    with tempfile.TemporaryDirectory(prefix="ribalta-pages-") as folder:
        source = Path(folder)
        written(source)
        return sphinx(["-q", "-W", "--keep-going", "-d", str(source / ".doctrees"), str(source), str(output)])


def main() -> int:
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("--output", type=Path, default=ROOT / "dist" / "pages")
    output = words.parse_args().output
    if code := build(output):
        return code
    print(f"the site: {(output / 'index.html').resolve()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
