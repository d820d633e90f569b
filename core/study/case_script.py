"""A case as a Python script: "Save as Python" of the window. It gives the numbers of the program."""

import re
from pathlib import Path

from core.case.schema import Case
from core.case.writer import dumps
from core.errors import InputError, place
from core.version import line

TEMPLATE = Path(__file__).resolve().parents[2] / "resources" / "templates" / "case_script.py"


def case_script(case: Case, base_dir: Path) -> str:
    """The script of a case whose paths start from a folder. Raises InputError for a wall whose solids come from a
    drawing, which only its file reads."""
    for wall in case.wall:
        if wall.drawing:
            raise InputError("script_of_drawing", place=(place("wall", name=wall.title),), key="drawing")
    content = dumps(case)
    text = repr(content) if '"""' in content or "\\" in content else f'"""\\\n{content.rstrip()}\n"""'
    title = " ".join(case.title.replace('"', "'").replace("\\", "/").split())
    script = TEMPLATE.read_text(encoding="utf-8")
    words = {'"{base_dir}"': repr(str(base_dir)), "{title}": title, "{line}": line(), '"{text}"': text}
    return re.sub("|".join(map(re.escape, words)), lambda found: words[found[0]], script)
