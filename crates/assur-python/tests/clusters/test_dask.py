"""Dask with two workers: the same as with Ray. `dist/test.sh` runs it."""

from __future__ import annotations

from pathlib import Path

import dask
import million
import pyarrow as pa
from distributed import Client, LocalCluster


def test_a_worker_that_dies_loses_nothing(tmp_path: Path, monkeypatch) -> None:
    rows, death = million.table(), tmp_path / "died"
    # workers find the solver by the name of its file
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).parent))
    solver = million.Mortal(million.TEXT, death)
    place = {"dashboard_address": None, "local_directory": str(tmp_path)}
    with LocalCluster(n_workers=2, threads_per_worker=1, **place) as cluster, Client(cluster):
        tasks = [dask.delayed(solver)(part) for part in million.parts(rows, 8)]
        found = pa.concat_tables(dask.compute(*tasks))
    million.nothing_is_lost(found, rows, death)
