"""The version of the program that a picture was made by: its PNG says it, and a test compares it."""

import io
from pathlib import Path
from typing import TYPE_CHECKING

from core.version import NAME, VERSION

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from PIL.Image import Image

KEY = "Software"
"""The keyword of PNG for what made a picture."""

MADE_BY = f"{NAME} {VERSION}"


def save_picture(image: "Image", path: Path) -> None:
    """Write an image as PNG, in its 256 most frequent colours: means of colours would take the red of a bar away."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    image = image.convert("RGB")
    by_count = sorted(image.getcolors(image.width * image.height) or [], reverse=True)
    palette = Image.new("P", (1, 1))
    palette.putpalette([part for _, colour in by_count[:256] for part in tuple(colour)])  # type: ignore
    words = PngInfo()
    words.add_text(KEY, MADE_BY)
    image.quantize(palette=palette, dither=Image.Dither.NONE).save(path, optimize=True, pnginfo=words)


def save_chart(figure: "Figure", path: Path) -> None:
    """Write a chart in the same way."""
    from PIL import Image

    content = io.BytesIO()
    figure.savefig(content, dpi=90)
    save_picture(Image.open(content), path)
