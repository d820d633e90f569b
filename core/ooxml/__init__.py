"""Office Open XML (ECMA-376): the one way in for every workbook that is read, whoever wrote it."""
