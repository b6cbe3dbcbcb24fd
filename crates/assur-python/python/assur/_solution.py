"""The solution of a problem: columns of numbers."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _assur
from ._errors import Diagnostics

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Array = NDArray[numpy.float64]

SHOWN = 20


class Failure(NamedTuple):
    """A position without a solution."""

    position: int
    """Its index, from 0."""
    code: str | None
    """The code of the reason: ``assur.explain(code)``."""
    message: str
    """The reason."""


class Solution:
    """The answers of all positions, column by column, in SI units, angles in radians.

    ``solution[name]`` is a read-only view of a column: no number is copied. A vector has two columns, ``name.x`` and
    ``name.y``; ``solution[name]`` gives both. A position without an answer is NaN, and null in Arrow. A condition is 1 or 0.

    It has the PyCapsule interface of Arrow: ``pyarrow.table(solution)``, ``polars.DataFrame(solution)``.
    """

    def __init__(self, columns: _assur.Columns, si: Solution | None = None) -> None:
        self._columns = columns
        # none where it is this one: an object that holds itself, and its memory with it, goes late
        self._si = si

    def __getitem__(self, name: str) -> Array | tuple[Array, Array]:
        if f"{name}.x" in self.units and name not in self.units:
            return self._view(f"{name}.x"), self._view(f"{name}.y")
        return self._view(name)

    def _view(self, name: str) -> Array:
        import numpy

        return numpy.asarray(self._columns.numbers(name))

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns.names)

    def __contains__(self, name: object) -> bool:
        return name in self.units or f"{name}.x" in self.units

    def __len__(self) -> int:
        """How many positions there are."""
        return len(self._columns)

    def keys(self) -> list[str]:
        """The names of the columns: drives, what is asked for, reactions."""
        return self._columns.names

    @cached_property
    def units(self) -> dict[str, str]:
        """The units by the names of the columns; empty for plain numbers: ``N*m``, ``rad``, ``m/s``."""
        return dict(self._columns.units)

    @property
    def residuals(self) -> dict[str, Array]:
        """How well equations hold that were not used: ``closure``, ``equilibrium``, ``power``, all relative; NaN without forces."""
        return {name: self._view(f"residual({name})") for name in ("closure", "equilibrium", "power")}

    @property
    def condition(self) -> Array:
        """The condition figure of every position, in (0, 1]: 1 is best."""
        return self._view("condition")

    @property
    def poses(self) -> list[str]:
        """The names of the positions."""
        return self._columns.poses

    @property
    def failures(self) -> list[Failure]:
        """The positions without a solution, with the reasons."""
        return [Failure(*failure) for failure in self._columns.failures]

    @property
    def expectations(self) -> list[tuple[str, str | None, bool]]:
        """The expectations of the text: its left side, the pose, whether it is met."""
        return self._columns.expectations

    @property
    def diagnostics(self) -> Diagnostics:
        """Warnings about the text and its positions."""
        return Diagnostics(*self._columns.diagnostics)

    def to(self, units: str = "file") -> Solution:
        """The same in the units of the file (``"file"``), which copies it, or in SI units (``"si"``)."""
        if units == "file":
            si = self._si or self
            return Solution(si._columns.in_file_units(), si)
        if units == "si":
            return self._si or self
        raise ValueError(f'units are "file" or "si", not {units!r}')

    def to_pandas(self) -> Any:
        """A data frame with the columns and their names."""
        import pandas  # type: ignore[import-untyped]

        return pandas.DataFrame({name: self._view(name) for name in self})

    def __arrow_c_schema__(self) -> object:
        return self._columns.batch.__arrow_c_schema__()

    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]:
        return self._columns.batch.__arrow_c_array__(requested_schema)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._columns.batch.__arrow_c_stream__(requested_schema)

    def __repr__(self) -> str:
        plural = "" if len(self) == 1 else "s"
        return f"<assur.Solution: {len(self)} position{plural} of {', '.join(self)}>"

    def _repr_html_(self) -> str:
        from ._html import table

        return table(self, SHOWN)
