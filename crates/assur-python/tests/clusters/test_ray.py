"""Ray Data with two workers: the numbers of one process, a worker that dies, a row that breaks. `dist/test.sh` runs it."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
import ray
import ray.data

import assur

ROWS = int(os.environ.get("ROWS", "1000000"))
BROKEN = ROWS // 2 + 7


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


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory):
    place = tmp_path_factory.mktemp("ray")
    # workers find the class below by the name of this file
    found_by = {"env_vars": {"PYTHONPATH": str(Path(__file__).parent)}}
    quiet = {"include_dashboard": False, "log_to_driver": False}
    ray.init(num_cpus=2, _temp_dir=str(place), object_store_memory=1 << 30, runtime_env=found_by, **quiet)
    context = ray.data.DataContext.get_current()
    context.enable_progress_bars = False
    yield place
    ray.shutdown()


def test_a_worker_that_dies_loses_nothing(cluster: Path) -> None:
    text = (Path(__file__).resolve().parents[4] / "examples/variants/crank-slider.mech").read_text(encoding="utf-8")
    i = np.arange(ROWS)
    lengths = np.where(i == BROKEN, 9000.0, 80.0 + i % 40)
    # the first row of the third quarter begins a part
    forces = np.where(i == ROWS // 4 * 2, 1.0, 100.0 + i % 1900)
    # parts come back in any order: rows are known by their names
    names = np.char.zfill(i.astype(str), 8)
    rows = pa.table({"variant": names, "r [mm]": lengths, "phi [deg]": (i * 37 % 360).astype(float), "P [N]": forces})
    parts = [rows.slice(at, ROWS // 4) for at in range(0, ROWS, ROWS // 4)]
    death = cluster / "died"
    data = ray.data.from_arrow(parts).map_batches(Mortal(text, death), batch_format="pyarrow", batch_size=None)
    found = pa.concat_tables(ray.get(data.to_arrow_refs())).sort_by("variant").combine_chunks()
    assert death.exists()
    assert found.equals(assur.Solver(text)(rows).combine_chunks())
    assert "close" in found["error"][BROKEN].as_py() and found["Mb"][BROKEN].as_py() is None
    assert found["error"].null_count == ROWS - 1
