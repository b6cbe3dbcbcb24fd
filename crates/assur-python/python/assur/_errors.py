"""What is reported about a text."""

from __future__ import annotations

from typing import Any


class Diagnostics(list["dict[str, Any]"]):
    """Errors and warnings, each a dictionary as in the program's JSON: ``code``, ``severity``, ``message``, ``help``, ``spans``.

    Printed, they look as in the terminal.
    """

    def __init__(self, text: str, items: str) -> None:
        import json

        super().__init__(json.loads(items))
        self._text = text

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        return preformatted(self._text)

    def __reduce__(self) -> tuple[Any, ...]:
        import json

        return Diagnostics, (self._text, json.dumps(list(self)))


class ProblemError(ValueError):
    """A text, a value from outside or a table has errors. Printed, they look as in the terminal."""

    diagnostics: Diagnostics

    def __init__(self, text: str, items: str = "[]") -> None:
        super().__init__(text, items)
        self.diagnostics = Diagnostics(text, items)

    def __str__(self) -> str:
        return str(self.diagnostics)

    def _repr_html_(self) -> str:
        return preformatted(str(self))


class UnitError(ProblemError):
    """The unit or the kind of a value from outside does not fit what it replaces."""


def preformatted(text: str) -> str:
    """A text of the terminal as HTML."""
    import html

    return f"<pre>{html.escape(text)}</pre>"
