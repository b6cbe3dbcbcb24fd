"""Columns of numbers from Python: arrays, sequences, mappings of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def numbers(values: Any, what: str, width: int = 1) -> bytes:
    """The numbers of an array as bytes of ``float64``: strided, of any kind of numbers, read-only or not.

    Raises ``TypeError`` for what is not a number, ``ValueError`` for another shape; both name ``what``.
    """
    import numpy

    if isinstance(values, numpy.ma.MaskedArray):
        values = numpy.ma.filled(values.astype(float), numpy.nan)
    try:
        array = numpy.asarray(values)
    except ValueError as error:
        raise ValueError(f"{what} is not an array: {error}") from None
    if array.size == 0 and array.ndim == 1 and not isinstance(values, numpy.ndarray):
        array = array.reshape((0, 2) if width == 2 else (0,)).astype(float)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{what} takes numbers, but has {array.dtype}")
    if array.ndim != width or (width == 2 and array.shape[1] != 2):
        wanted = "one number per row" if width == 1 else "two numbers per row"
        raise ValueError(f"{what} takes {wanted}, but has the shape {array.shape}")
    return numpy.ascontiguousarray(array, dtype="=f8").tobytes()


def names(values: Any) -> list[str | None] | None:
    """The names in a column of texts; ``None`` if it has other values."""
    items = values.tolist() if hasattr(values, "tolist") else list(values)
    texts = [item for item in items if item is not None]
    if texts and all(isinstance(item, str) for item in texts):
        return items
    return None


def is_arrow(table: Any) -> bool:
    """Whether an object has the C interface of Arrow."""
    return hasattr(table, "__arrow_c_stream__") or hasattr(table, "__arrow_c_array__")


def of_mapping(table: Mapping[str, Any]) -> list[tuple[str, Any]]:
    """Columns of a mapping: bytes of numbers, or lists of names."""
    columns = []
    for name, values in table.items():
        if not isinstance(name, str):
            raise TypeError(f"a column is called {name!r}, which is not a text")
        if isinstance(values, (str, bytes)) or not hasattr(values, "__len__"):
            raise TypeError(f"column `{name}` takes an array, but is {type(values).__name__}")
        columns.append((name, names(values) or numbers(values, f"column `{name}`")))
    return columns
