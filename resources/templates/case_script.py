"""{title}: the case and its run, as of {line}."""

import tomllib

try:
    import ribalta_rocking as ribalta
except ImportError:  # in the folder of the program
    import core.api as ribalta

CASE = "{text}"
result = ribalta.run(ribalta.case(tomllib.loads(CASE)), base_dir="{base_dir}")
for one in ribalta.verdicts(result):
    print(one["wall"], one["code"], "zeta", one["zeta_e"])
table = ribalta.table(result)  # a row for each mechanism: pandas.DataFrame(table)
for name, mechanism, q, zeta in zip(*(table[key] for key in ("name", "mechanism", "q_set", "zeta_e")), strict=True):
    print(name, mechanism, "q", q, "zeta", zeta)
