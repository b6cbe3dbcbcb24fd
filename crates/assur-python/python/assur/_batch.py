"""Answers to rows of variants, batch by batch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from . import _assur
from ._columns import is_arrow, of_mapping

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray


class Answers:
    """A batch of answers: one line per row and position, in the units of the file.

    ``answers[name]`` is a view of a column of numbers, or a list of texts. Its columns are those of ``assur batch``: ``row``,
    ``variant``, the values of the row, ``pose``, the answers, ``error`` with the reason why a line has none.
    It has the PyCapsule interface of Arrow.
    """

    def __init__(self, batch: _assur.Batch) -> None:
        self._batch = batch

    def __getitem__(self, name: str) -> NDArray[numpy.float64] | list[Any]:
        import numpy

        try:
            return numpy.asarray(self._batch.numbers(name))
        except TypeError:
            return self._batch.cells(name)

    def __len__(self) -> int:
        """How many lines there are."""
        return len(self._batch)

    def __iter__(self) -> Iterator[str]:
        return iter(self._batch.names)

    def keys(self) -> list[str]:
        """The names of the columns."""
        return self._batch.names

    @property
    def units(self) -> dict[str, str]:
        """The units of the columns that have one."""
        return dict(self._batch.units)

    def __arrow_c_schema__(self) -> object:
        return self._batch.__arrow_c_schema__()

    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]:
        return self._batch.__arrow_c_array__(requested_schema)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._batch.__arrow_c_stream__(requested_schema)


class AnswerStream:
    """Answers that are solved while they are read, once: by iteration, or by the PyCapsule interface of Arrow."""

    def __init__(self, batches: _assur.Batches) -> None:
        self._batches = batches

    def __iter__(self) -> Iterator[Answers]:
        return map(Answers, self._batches)

    def read(self) -> Answers:
        """All answers as one batch."""
        return Answers(self._batches.read())

    def __arrow_c_schema__(self) -> object:
        return self._batches.__arrow_c_schema__()

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._batches.__arrow_c_stream__(requested_schema)


def batch(problem: _assur.Problem, table: Any, form: tuple[bool, bool, int | None]) -> AnswerStream:
    """The answers to the rows of a table; ``form`` is whether they are a key, whether rows have numbers, and how many threads."""
    if is_arrow(table):
        return AnswerStream(problem.batch_arrow(table, form))
    if isinstance(table, Mapping):
        return AnswerStream(problem.batch_columns(of_mapping(table), form))
    raise TypeError(f"rows are a table of Arrow or a mapping of arrays, not {type(table).__name__}")
