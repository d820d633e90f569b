"""The icon of the program, a wall that rocks on its toe: resources/icons/ribalta.png, and for build.py .ico and .icns.

python3 packaging/icon.py
"""

import math
from pathlib import Path

from PIL import Image, ImageDraw

PNG = Path(__file__).resolve().parents[1] / "resources" / "icons" / "ribalta.png"
SIZE, FINE = 256, 4
ANGLE = math.radians(14.0)
TOE, WIDTH, HEIGHT, COURSES = (166.0, 214.0), 68.0, 168.0, 7
WALL, JOINT, GROUND, TRACE = "#c8693c", "#f4e3d3", "#2f3e4e", "#7d93a8"


def _place(along: float, up: float, angle: float = ANGLE) -> tuple[float, float]:
    """A point of the wall, leftwards from its toe and up, after it has rotated about the toe; in pixels."""
    x = -along * math.cos(angle) + up * math.sin(angle)
    y = along * math.sin(angle) + up * math.cos(angle)
    return (TOE[0] + x) * FINE, (TOE[1] - y) * FINE


def drawn() -> Image.Image:
    image = Image.new("RGBA", (SIZE * FINE, SIZE * FINE), (0, 0, 0, 0))
    draw = ImageDraw.Draw(image)
    draw.rounded_rectangle(((0, 0), (SIZE * FINE - 1, SIZE * FINE - 1)), 48 * FINE, "#eef2f6")
    draw.rectangle(((24 * FINE, 214 * FINE), (232 * FINE, 226 * FINE)), GROUND)
    corners = ((0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT))
    draw.line([_place(x, y, 0.0) for x, y in (*corners, corners[0])], TRACE, 4 * FINE, "curve")
    draw.polygon([_place(*corner) for corner in corners], WALL)
    step = HEIGHT / COURSES
    for k in range(COURSES):
        if k:
            draw.line([_place(0, k * step), _place(WIDTH, k * step)], JOINT, 4 * FINE)
        at = WIDTH * (0.35 if k % 2 else 0.65)
        draw.line([_place(at, k * step), _place(at, (k + 1) * step)], JOINT, 4 * FINE)
    return image.resize((SIZE, SIZE), Image.Resampling.LANCZOS)


def write(folder: Path) -> None:
    """Icons of Windows and macOS."""
    image = Image.open(PNG)
    image.save(folder / "ribalta.ico", sizes=[(n, n) for n in (16, 24, 32, 48, 64, 128, 256)])
    image.save(folder / "ribalta.icns")


if __name__ == "__main__":
    PNG.parent.mkdir(exist_ok=True)
    drawn().save(PNG, optimize=True)
