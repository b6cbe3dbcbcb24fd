"""A million rows for two workers, one of which is killed."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pyarrow as pa

import assur

ROWS = int(os.environ.get("ROWS", "1000000"))
BROKEN = ROWS // 2 + 7
TEXT = (Path(__file__).resolve().parents[4] / "examples/variants/crank-slider.mech").read_text(encoding="utf-8")


class Mortal(assur.Solver):
    """A solver whose process is killed once, with the rows that it has."""

    def __init__(self, text: str, death: Path) -> None:
        super().__init__(text)
        self.death = str(death)

    def __call__(self, table: pa.Table) -> pa.Table:
        if len(table) and table["P [N]"][0].as_py() == 1.0:
            try:
                os.close(os.open(self.death, os.O_CREAT | os.O_EXCL))
            except FileExistsError:
                pass
            else:
                os.kill(os.getpid(), 9)
        return super().__call__(table)


def table() -> pa.Table:
    """The rows, of which one breaks; the first row of the third quarter kills its worker."""
    i = np.arange(ROWS)
    lengths = np.where(i == BROKEN, 9000.0, 80.0 + i % 40)
    forces = np.where(i == ROWS // 4 * 2, 1.0, 100.0 + i % 1900)
    # parts may come back in any order: rows are known by their names
    names = np.char.zfill(i.astype(str), 8)
    return pa.table({"variant": names, "r [mm]": lengths, "phi [deg]": (i * 37 % 360).astype(float), "P [N]": forces})


def parts(rows: pa.Table, count: int) -> list[pa.Table]:
    return [rows.slice(at, ROWS // count) for at in range(0, ROWS, ROWS // count)]


def nothing_is_lost(found: pa.Table, rows: pa.Table, death: Path) -> None:
    """The answers are those of one process, though a worker died, and the row that breaks says why."""
    found = found.combine_chunks()
    assert death.exists()
    assert found.equals(assur.Solver(TEXT)(rows).combine_chunks())
    assert "close" in found["error"][BROKEN].as_py() and found["Mb"][BROKEN].as_py() is None
    assert found["error"].null_count == ROWS - 1
