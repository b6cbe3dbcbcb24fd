"""Solutions and pictures in notebooks."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._solution import Solution


def table(solution: Solution, most: int) -> str:
    """The first positions in the units of the file, with failures and warnings below them."""
    shown = solution.to(units="file")
    names = list(shown)
    units = shown.units
    heads = [f"{name} [{units[name]}]" if units[name] else name for name in names]
    count = min(len(shown), most)
    views = [shown._view(name)[:count] for name in names]
    rows = [[pose, *(cell(view[i]) for view in views)] for i, pose in enumerate(shown.poses[:count])]
    parts = ["<table><thead><tr>"]
    parts += [f"<th>{escape(head)}</th>" for head in ["pose", *heads]]
    parts.append("</tr></thead><tbody>")
    for row in rows:
        parts.append("<tr>" + "".join(f"<td>{escape(text)}</td>" for text in row) + "</tr>")
    parts.append("</tbody></table>")
    if len(shown) > count:
        parts.append(f"<p>{count} of {len(shown)} positions</p>")
    if solution.failures:
        first = solution.failures[0]
        parts.append(f"<p>{len(solution.failures)} without a solution; position {first.position + 1}: {escape(first.message)}</p>")
    if solution.diagnostics:
        parts.append(solution.diagnostics._repr_html_())
    return "".join(parts)


def cell(number: float) -> str:
    """A number with six digits; nothing for NaN."""
    return "" if number != number else f"{number:.6g}"


def frame(page: str) -> str:
    """A page of its own within a notebook: it needs no kernel, and nothing of the notebook reaches it."""
    style = "width:100%;height:32em;border:0"
    return f'<iframe sandbox="allow-scripts" style="{style}" srcdoc="{escape(page, quote=True)}"></iframe>'
