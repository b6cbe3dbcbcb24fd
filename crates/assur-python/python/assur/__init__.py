"""Planar mechanism problems, written as text and solved.

A text is compiled once and solved at any number of positions. Answers are columns of numbers in SI units, angles in
radians; ``Solution.to(units="file")`` has them in the units of the text.

>>> import assur
>>> problem = assur.load("engine.mech")
>>> solution = problem.solve()
>>> solution["Mb"], solution.units["Mb"]
"""

from __future__ import annotations

from . import _assur
from ._batch import Answers
from ._errors import Diagnostics, ProblemError, UnitError
from ._picture import Picture
from ._problem import Problem, compile, load
from ._solution import Failure, Solution
from ._solver import Solver
from ._tools import explain, format, grade

__version__: str = _assur.__version__

__all__ = [
    "Answers",
    "Diagnostics",
    "Failure",
    "Picture",
    "Problem",
    "ProblemError",
    "Solution",
    "Solver",
    "UnitError",
    "compile",
    "explain",
    "format",
    "grade",
    "load",
]


def load_ipython_extension(ipython: object) -> None:
    """Registers the cell ``%%mech`` after ``%load_ext assur``."""
    from ._magic import register

    register(ipython)
