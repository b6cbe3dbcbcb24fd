"""What needs no problem: format, explain, grade."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from . import _assur
from ._columns import is_arrow


def format(text: str) -> str:
    """Puts a text in the one style, as ``assur fmt`` does. Raises :class:`ProblemError` for a text that cannot be read."""
    return _assur.format(text)


def explain(code: str) -> str:
    """The page that explains a diagnostic, in Markdown. Raises ``KeyError`` for an unknown code, with the nearest."""
    return _assur.explain(code)


def grade(
    key: Any,
    answers: Any,
    *,
    within: float | None = None,
    only_answered: bool = False,
    points: Mapping[str, float] | None = None,
    credit: Mapping[str, float] | None = None,
) -> dict[str, Any]:
    """Marks answers by a key: the document of ``assur grade --format json``.

    Each is a path, a text of comma-separated values, a table of Arrow, or a mapping of columns whose names have units in brackets.
    ``within`` is the greatest relative difference allowed, 0.03 without a word; ``points`` of quantities, ``credit`` for slips, as
    ``{"sign": 0.5}``.
    """
    import json

    pairs = [",".join(f"{name}={part}" for name, part in rules.items()) if rules else None for rules in (points, credit)]
    graded: dict[str, Any] = json.loads(
        _assur.grade(text_of(key), text_of(answers), within, only_answered, *pairs)
    )
    return graded


def text_of(table: Any) -> str:
    """A table as comma-separated values."""
    if isinstance(table, os.PathLike):
        return read(table)
    if isinstance(table, str):
        return table if "\n" in table else read(table)
    if is_arrow(table):
        return "".join(written(batch, i == 0) for i, batch in enumerate(_assur.batches(table)))
    if isinstance(table, Mapping):
        columns = [list(values) for values in table.values()]
        if len({len(column) for column in columns}) > 1:
            raise ValueError("the columns of a table have the same number of rows")
        return rows_of([list(table), *zip(*columns)])
    raise TypeError(f"a table is a path, a text, a table of Arrow or a mapping, not {type(table).__name__}")


def read(path: str | os.PathLike[str]) -> str:
    """The text of a file."""
    with open(path, encoding="utf-8", newline="") as file:
        return file.read()


def written(batch: _assur.Batch, headed: bool) -> str:
    """A batch of Arrow, below its header where it is the first."""
    units = dict(batch.units)
    heads = [f"{name} [{units[name]}]" if name in units and "[" not in name else name for name in batch.names]
    columns = [batch.cells(name) for name in batch.names]
    return rows_of([heads] * headed + [list(row) for row in zip(*columns)])


def rows_of(rows: list[Any]) -> str:
    """Rows as comma-separated values; a missing one is empty."""
    import csv
    import io

    out = io.StringIO()
    filled = [["" if x is None or x != x else x for x in row] for row in rows]
    csv.writer(out, lineterminator="\n").writerows(filled)
    return out.getvalue()
