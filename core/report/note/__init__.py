"""The calculation note: what an engineer signs, once as data, then as sheets of the workbook or as a document."""
