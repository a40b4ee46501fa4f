# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hours of sun on a town, computed in parts by several processes, and a picture of them.

    33_work_in_parts.py [FOLDER] [ENGINE]

FOLDER    default: the current folder
ENGINE    starts the parts: futures (default, Python's own), joblib, dask (dask.distributed, two
          workers on this machine) or submitit (on this machine; with cluster="slurm" as jobs of
          Slurm)

Writes to FOLDER
    hours.vtp          the town with the cell array sun_hours
    hours.vtp.parts    the files of the parts
    hours.png          hours of sun as colours, with a bar

Needs buildings.obj in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data puts it there.
"""

import concurrent.futures
import sys

import relievo

import scene

PARTS = 4
MINUTES = 20  # between positions of the sun
SIZE = (960, 600)


def with_futures(parts):
    with concurrent.futures.ThreadPoolExecutor(2) as pool:  # each part is a process of its own
        for part in [pool.submit(part) for part in parts]:
            part.result()


def with_joblib(parts):
    import joblib

    joblib.Parallel(n_jobs=2)(joblib.delayed(part)() for part in parts)


def with_dask(parts):
    import dask.distributed

    cluster = dask.distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    )
    with cluster, dask.distributed.Client(cluster) as client:
        client.gather([client.submit(part, pure=False) for part in parts])


def with_submitit(parts):
    import submitit

    executor = submitit.AutoExecutor(scene.folder() / "submitit", cluster="local")
    for job in [executor.submit(part) for part in parts]:
        job.result()


ENGINES = {"futures": with_futures, "joblib": with_joblib, "dask": with_dask,
           "submitit": with_submitit}  # fmt: skip


def main():
    folder = scene.folder()
    name = sys.argv[2] if len(sys.argv) > 2 else "futures"
    if name not in ENGINES:
        raise SystemExit(f"ENGINE: got {name}, expected one of {', '.join(ENGINES)}")
    job = ["sun", scene.data("buildings.obj"), "--up", "z", "--place", "48.2,16.4",
           "--dates", "2026-06-21", "--step", str(MINUTES), "-o", folder / "hours.vtp"]  # fmt: skip
    parts = relievo.parts(job, PARTS)
    ENGINES[name](parts)
    hours = relievo.merge(parts)
    picture = str(folder / "hours.png")
    relievo.scene(hours, color_by="sun_hours", scalar_bar=True, up="z", size=SIZE).render(picture)
    print(f"{PARTS} parts by {name}: wrote {hours}.parts, {hours} and {picture}")


if __name__ == "__main__":
    main()
