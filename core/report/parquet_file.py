"""Rows of groups of walls -> one Parquet file, by row groups: no more of it is held than one of these."""

from collections.abc import Iterable
from typing import Any, BinaryIO

from core.report.columns import COLUMNS

GROUP_ROWS = 2048
"""Rows of a row group: the file keeps some hundred bytes of each column of each of them until its end."""


def schema(pyarrow: Any, metadata: dict[str, str]) -> Any:
    """The schema of the file: each column with its unit. metadata : of the whole"""
    kinds = {"text": pyarrow.string(), "whole": pyarrow.int64(), "number": pyarrow.float64(), "flag": pyarrow.bool_()}
    kinds |= {f"{kind}s": pyarrow.list_(kinds[kind]) for kind in ("text", "whole", "number")}
    fields = []
    for column in COLUMNS:
        field = pyarrow.field(column.key, kinds[column.kind])
        fields.append(field.with_metadata({"unit": column.unit}) if column.unit else field)
    return pyarrow.schema(fields, metadata)


def write(stream: BinaryIO, groups: Iterable[dict[str, list]], metadata: dict[str, str]) -> None:
    """Write the file into a stream.

    groups : rows of each group, by column
    metadata : of the whole file
    """
    import pyarrow
    import pyarrow.parquet

    layout = schema(pyarrow, metadata)
    held: dict[str, list] = {column.key: [] for column in COLUMNS}
    with pyarrow.parquet.ParquetWriter(stream, layout, compression="zstd") as writer:

        def put(count: int) -> None:
            writer.write_table(pyarrow.table({name: held[name][:count] for name in held}, layout))
            for name in held:
                del held[name][:count]

        for rows in groups:
            for name, values in held.items():
                values += rows[name]
            while len(held["wall"]) >= GROUP_ROWS:
                put(GROUP_ROWS)
        if held["wall"]:
            put(GROUP_ROWS)
