"""The cell ``%%mech`` of notebooks."""

from __future__ import annotations

from typing import Any

from ._errors import ProblemError
from ._problem import compile


def register(ipython: Any) -> None:
    """Registers the cell."""

    def mech(line: str, cell: str) -> Any:
        """Solves the text of the cell and shows its answers; ``%%mech name`` keeps the solution under this name."""
        name = line.strip() or "solution"
        if not name.isidentifier():
            raise ValueError(f"`{name}` is not a name of Python")
        try:
            solution = compile(cell, name=f"{name}.mech").solve()
        except ProblemError as error:
            return error.diagnostics
        ipython.push({name: solution})
        return solution

    ipython.register_magic_function(mech, magic_kind="cell", magic_name="mech")
