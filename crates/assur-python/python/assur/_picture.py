"""Pictures."""

from __future__ import annotations

import os


class Picture(str):
    """A picture as text: SVG, or a page with an animation. Notebooks show it."""

    @property
    def is_page(self) -> bool:
        """Whether it is a page of HTML with an animation."""
        return not self.lstrip().startswith(("<svg", "<?xml"))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it to a file."""
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(self)

    def _repr_html_(self) -> str:
        from ._html import frame

        return frame(self) if self.is_page else str(self)
