"""Problems: texts that are compiled once and solved any number of times."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _assur
from ._batch import AnswerStream, batch
from ._columns import numbers
from ._errors import Diagnostics, ProblemError
from ._picture import Picture
from ._solution import Solution
from ._text import Text

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    Values = Mapping[str, str | float]
    Positions = ArrayLike | Mapping[str, ArrayLike]

SHORT = 64


class Problem:
    """A text with its values from outside. Made by :func:`assur.compile` and :func:`assur.load`."""

    def __init__(
        self,
        text: str,
        name: str = "problem.mech",
        set: Values | None = None,
        within: float | None = None,
    ) -> None:
        self.text = Text(text)
        self.name = name
        self._set = dict(set or {})
        self._within = within
        self._problem = _assur.Problem(text, name, written(self._set), within)

    def check(self) -> dict[str, Any]:
        """Structure, effects and diagnostics, as in the program's JSON. Nothing is solved, and nothing is raised."""
        import json

        found: dict[str, Any] = json.loads(self._problem.check())
        return found

    def solve(
        self,
        positions: Positions | None = None,
        *,
        set: Values | None = None,
        within: float | None = None,
        threads: int | None = None,
    ) -> Solution:
        """Solves the problem at its positions, or at others.

        ``positions``: an array for the only drive, or a mapping from the names of drives to arrays; SI and radians, for a drive
        that carries a point two numbers per position. Expectations and poses of the text are left out then.
        ``set``: values that replace those of ``given``, as ``{"r": "120 mm"}``; a number has no unit.
        ``within``: the greatest relative error allowed. ``threads``: how many, one per processor without a word.

        The GIL is released meanwhile. Raises :class:`ProblemError` for a text that cannot be solved, ``ValueError`` for positions that
        do not fit; a position without a solution is listed in :attr:`Solution.failures`.
        """
        if set is not None or within is not None:
            merged = {**self._set, **(set or {})}
            other = Problem(self.text, self.name, merged, self._within if within is None else within)
            return other.solve(positions, threads=threads)
        return Solution(self._problem.solve(self._given(positions), checked_threads(threads)))

    def _given(self, positions: Positions | None) -> list[tuple[str | None, Any]] | None:
        if positions is None:
            return None
        if isinstance(positions, (list, tuple)) and len(positions) < SHORT and all(type(x) is float for x in positions):
            return [(None, positions)]
        if isinstance(positions, (int, float)) and not isinstance(positions, bool):
            return [(None, [float(positions)])]
        points = {name: is_point for name, is_point, _ in self._problem.drives()}
        if not isinstance(positions, Mapping):
            is_point = len(points) == 1 and all(points.values())
            return [(None, self._numbers(positions, "`positions`", is_point))]
        return [
            (name, self._numbers(values, f"drive `{name}`", points.get(name, False)))
            for name, values in positions.items()
        ]

    @staticmethod
    def _numbers(values: Any, what: str, is_point: bool) -> tuple[bytes, bool]:
        if isinstance(values, (int, float)) and not isinstance(values, bool):
            values = [float(values)]
        return numbers(values, what, 2 if is_point else 1), is_point

    def document(self) -> dict[str, Any]:
        """The document of ``assur solve --format json``: all that is known of every position, in SI and radians."""
        import json

        found: dict[str, Any] = json.loads(self._problem.document())
        return found

    @property
    def drives(self) -> dict[str, str]:
        """The drives with the SI units of their positions: ``{"crank": "rad"}``."""
        return {name: unit for name, _, unit in self._problem.drives()}

    def test(self) -> Diagnostics:
        """Compares the answers with the ``expect`` lines, for every row of the text's own table of variants too.

        Empty if all are met and there is no warning.
        """
        return Diagnostics(*self._problem.test())

    def batch(self, table: Any, key: bool = False, *, threads: int | None = None) -> AnswerStream:
        """Solves a row of values after another, on all processors: a table, batch or stream of Arrow, or a mapping of arrays.

        A column is named after a ``given``. The unit of its numbers is in the field's metadata (``unit``), in brackets in its
        name (``r [mm]``), or as the ``given`` is written. The answers come in the order of the rows, in the units of the file, the same
        bytes for any number of threads. A row that cannot be solved has a null in every answer and its reason in ``error``.
        With ``key`` they are an answer key, without the values of the rows.

        Raises :class:`ProblemError` for a column that fits nothing, :class:`UnitError` for a unit that does not fit.
        """
        return batch(self._problem, table, (key, True, checked_threads(threads)))

    def draw(self, pose: str | int | None = None, kind: str = "scheme") -> Picture:
        """Draws a picture at a pose, at the first without a name: ``scheme``, ``velocities``, ``accelerations``, ``forces``, …

        ``animation`` is a page with a slider that needs nothing else. Of several pictures of a kind this is the first; :meth:`pictures`
        has all.
        """
        return self.pictures(pose, kind)[0]

    def pictures(self, pose: str | int | None = None, kind: str = "scheme") -> list[Picture]:
        """All pictures of a kind at a pose."""
        return [Picture(text) for text in self._problem.draw(kind, None if pose is None else str(pose))]

    def __reduce__(self) -> tuple[Any, ...]:
        return Problem, (self.text, self.name, self._set, self._within)

    def __repr__(self) -> str:
        return f"<assur.Problem {self.name}>"

    def _repr_html_(self) -> str:
        for kind in ("animation", "scheme"):
            try:
                return self.draw(kind=kind)._repr_html_()
            except (ProblemError, IndexError) as error:
                reason = error
        return getattr(reason, "_repr_html_", self.__repr__)()


def checked_threads(threads: int | None) -> int | None:
    """A number of threads, or none."""
    if threads is not None and threads < 1:
        raise ValueError(f"`threads` must be at least 1, but is {threads}")
    return threads


def written(values: Values) -> list[tuple[str, str]]:
    """Values from outside as they are written in a text."""
    pairs = []
    for name, value in values.items():
        if isinstance(value, bool) or not isinstance(value, (str, int, float)):
            raise TypeError(f"the value of `{name}` is a text with a unit or a number, not {type(value).__name__}")
        pairs.append((name, value if isinstance(value, str) else repr(value)))
    return pairs


def compile(
    text: str,
    *,
    name: str = "problem.mech",
    set: Values | None = None,
    within: float | None = None,
) -> Problem:
    """Compiles a text: checks names, units, geometry and structure.

    ``name`` is shown in messages. ``set`` replaces values of ``given``: ``{"r": "120 mm"}``.
    Raises :class:`ProblemError` for a text with errors, :class:`UnitError` for a value whose unit does not fit.
    """
    problem = Problem(text, name, set, within)
    problem._problem.compile()
    return problem


def load(
    path: str | os.PathLike[str],
    *,
    set: Values | None = None,
    within: float | None = None,
) -> Problem:
    """Compiles a file: see :func:`compile`."""
    with open(path, "rb") as file:
        text = file.read().decode("utf-8")
    return compile(text, name=str(path), set=set, within=within)
