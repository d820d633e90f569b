"""A case as a Python script: "Save as Python" of the window. It gives the numbers of the program."""

from pathlib import Path

from core.case.schema import Case
from core.case.writer import dumps
from core.errors import InputError, place
from core.version import line

SCRIPT = '''"""{title}: the case and its run, as of {line}."""

import tomllib

try:
    import ribalta_rocking as ribalta
except ImportError:  # in the folder of the program
    import core.api as ribalta

CASE = {text}
result = ribalta.run(ribalta.case(tomllib.loads(CASE)), base_dir={base_dir!r})
for one in ribalta.verdicts(result):
    print(one["wall"], one["code"], "zeta", one["zeta_e"])
table = ribalta.table(result)  # a row for each mechanism: pandas.DataFrame(table)
for name, mechanism, q, zeta in zip(*(table[key] for key in ("name", "mechanism", "q_set", "zeta_e")), strict=True):
    print(name, mechanism, "q", q, "zeta", zeta)
'''


def case_script(case: Case, base_dir: Path) -> str:
    """The script of a case whose paths start from a folder. Raises InputError for a wall whose solids come from a
    drawing, which only its file reads."""
    for wall in case.wall:
        if wall.drawing:
            raise InputError("script_of_drawing", place=(place("wall", name=wall.title),), key="drawing")
    content = dumps(case)
    text = repr(content) if '"""' in content or "\\" in content else f'"""\\\n{content.rstrip()}\n"""'
    title = " ".join(case.title.replace('"', "'").replace("\\", "/").split())
    return SCRIPT.format(title=title, line=line(), text=text, base_dir=str(base_dir))
