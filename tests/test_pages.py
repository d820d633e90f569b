"""The documents as a site: it builds, and every link of it leads somewhere."""

import re
import subprocess
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

import pytest

import core.api
from tests.conftest import ROOT


class Links(HTMLParser):
    """The links of a page and the places within it."""

    def __init__(self, text):
        super().__init__()
        self.links, self.ids = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.links |= {given[key] for key in ("href", "src") if given.get(key)}
        self.ids |= {given[key] for key in ("id", "name") if given.get(key)}


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    pytest.importorskip("sphinx", reason="no wheel of sphinx here")
    output = tmp_path_factory.mktemp("pages")
    command = [sys.executable, "-P", ROOT / "packaging" / "pages.py", "--output", output]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split("\n")[-2] == f"the site: {(output / 'index.html').resolve()}"  # where to look
    return output


@pytest.mark.shows("doors.pages")
def test_that_every_link_of_the_site_leads_somewhere(site):
    pages = {path: Links(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
    documents = [*ROOT.glob("resources/docs/*.md"), *ROOT.glob("resources/docs/gui*/*.md")]
    for document in documents:
        assert (site / document.relative_to(ROOT)).with_suffix(".html") in pages
    checked = 0
    for path, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                assert parts.scheme in ("https", "http", "mailto"), link
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            assert target.exists(), f"{path.name}: {link}"
            if parts.fragment and target in pages and not parts.fragment.startswith("module-"):
                assert unquote(parts.fragment) in pages[target].ids, f"{path.name}: {link}"
            checked += 1
    assert checked > 1000


@pytest.mark.shows("doors.pages")
def test_that_each_name_of_the_package_has_its_place(site):
    text = (site / "names.html").read_text(encoding="utf-8")
    ids = Links(text).ids
    own = [name for name in core.api.__all__ if getattr(core.api, name).__module__ == "core.api"]
    assert {f"core.api.{name}" for name in own} <= ids and len(own) > 12
    assert re.search(r"Parameters", text) and "m/s2" in text
