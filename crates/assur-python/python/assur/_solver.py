"""A solver for frameworks that send work to other processes."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from ._batch import Answers, batch
from ._problem import Problem, compile

if TYPE_CHECKING:
    from ._problem import Values


class Solver:
    """Solves tables of rows, wherever it is sent: it is pickled as text and compiles once in each process.

    ``Solver(text)(table)`` has the columns of :meth:`Problem.batch` without ``row``, since a part of a table does not know which of its
    rows are before. It gives a ``pyarrow.Table`` for one, and :class:`Answers` for any other table.
    """

    def __init__(
        self,
        text: str,
        *,
        name: str = "problem.mech",
        set: Values | None = None,
        within: float | None = None,
        key: bool = False,
    ) -> None:
        self._text, self._name, self._key = text, name, key
        self._set, self._within = dict(set or {}), within
        self._problem: Problem | None = None

    def _compiled(self) -> Problem:
        if self._problem is None:
            self._problem = compile(self._text, name=self._name, set=self._set, within=self._within)
        return self._problem

    def __call__(self, table: Any) -> Any:
        """The answers to the rows of a table."""
        stream = batch(self._compiled()._problem, table, (self._key, False, None))
        if type(table).__module__.partition(".")[0] == "pyarrow":
            return sys.modules["pyarrow"].table(stream)
        return Answers(stream._batches.read())

    def __getstate__(self) -> dict[str, Any]:
        # what was compiled stays here
        return {**self.__dict__, "_problem": None}

    def __repr__(self) -> str:
        return f"<assur.Solver {self._name}>"
