"""Words of a PDF that no ink shows: under a drawing, or cut off."""

import re
import shutil
import subprocess
from html import unescape
from pathlib import Path

import numpy as np
import pytest

DOTS = 72
"""Dots per inch: a dot is a point of the PDF."""

FAINT = 40
"""Grey levels between the darkest and the lightest dot of a word that can be read."""

_PAGE = re.compile(r"<page .*?</page>", re.DOTALL)
_WORD = re.compile(r'<word xMin="([\d.-]+)" yMin="([\d.-]+)" xMax="([\d.-]+)" yMax="([\d.-]+)">(.*?)</word>')


def words_of(pdf: Path) -> list[list[tuple[str, tuple[float, ...]]]]:
    """(word, left, top, right, bottom [points]) of each page."""
    found = subprocess.run(["pdftotext", "-bbox", pdf, "-"], check=True, capture_output=True, timeout=120)
    return [
        [(unescape(word), tuple(map(float, box))) for *box, word in _WORD.findall(page)]
        for page in _PAGE.findall(found.stdout.decode())
    ]


def words_without_ink(pdf: Path) -> list[tuple[int, str]]:
    """(page, word) of what stands in the PDF and is not seen. A drawing at the end of a page is written on the next one
    too, at the same place of the line: what is seen there is not hidden."""
    from PIL import Image

    if not shutil.which("pdftotext") or not shutil.which("pdftoppm"):
        pytest.skip("poppler is not installed: the PDF was not looked at")
    stem = pdf.with_suffix("")
    subprocess.run(["pdftoppm", "-r", str(DOTS), "-gray", pdf, stem], check=True, timeout=300)
    pages = sorted(stem.parent.glob(f"{stem.name}-*.pgm"))
    hidden, shown = [], set()
    for number, (words, page) in enumerate(zip(words_of(pdf), pages, strict=True), start=1):
        seen = np.asarray(Image.open(page)).astype(int)
        for word, (left, top, right, bottom) in words:
            box = seen[int(top) : int(bottom) + 1, int(left) : int(right) + 1]
            if box.size and np.ptp(box) >= FAINT:
                shown.add((number, word, round(left)))
            elif re.search(r"\w{3}", word):
                hidden.append((number, word, round(left)))
    return [
        (number, word)
        for number, word, left in hidden
        if not any((number + page, word, left + k) in shown for page in (-1, 1) for k in (-1, 0, 1))
    ]
