"""Colours `mech` blocks in Sphinx, MkDocs, Jupyter and wherever Pygments is used."""

from .lexer import MechLexer

__all__ = ["MechLexer"]
