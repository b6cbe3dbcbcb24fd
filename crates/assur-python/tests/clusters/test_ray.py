"""Ray Data with two workers: the numbers of one process, a worker that dies, a row that breaks. `dist/test.sh` runs it."""

from __future__ import annotations

from pathlib import Path

import million
import pyarrow as pa
import pytest
import ray
import ray.data


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory):
    place = tmp_path_factory.mktemp("ray")
    # workers find the solver by the name of its file
    found_by = {"env_vars": {"PYTHONPATH": str(Path(__file__).parent)}}
    quiet = {"include_dashboard": False, "log_to_driver": False}
    ray.init(num_cpus=2, _temp_dir=str(place), object_store_memory=1 << 30, runtime_env=found_by, **quiet)
    context = ray.data.DataContext.get_current()
    context.enable_progress_bars = False
    yield place
    ray.shutdown()


def test_a_worker_that_dies_loses_nothing(cluster: Path) -> None:
    rows, death = million.table(), cluster / "died"
    solver = million.Mortal(million.TEXT, death)
    data = ray.data.from_arrow(million.parts(rows, 4)).map_batches(solver, batch_format="pyarrow", batch_size=None)
    found = pa.concat_tables(ray.get(data.to_arrow_refs())).sort_by("variant")
    million.nothing_is_lost(found, rows, death)
