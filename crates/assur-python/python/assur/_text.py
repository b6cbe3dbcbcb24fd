"""Texts of problems."""

from __future__ import annotations


class Text(str):
    """The text of a problem. Notebooks show it with colours where Pygments is installed."""

    def _repr_html_(self) -> str:
        from html import escape

        try:
            from pygments import highlight
            from pygments.formatters import HtmlFormatter

            from ._lexer import MechLexer
        except ImportError:
            return f"<pre>{escape(self)}</pre>"
        return str(highlight(str(self), MechLexer(), HtmlFormatter(noclasses=True)))
