#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the plants per second of a batch on 1 and 2 worker processes, and in the calling process.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_batch.py [--model oak] [--plants 24] [--rounds 3]

The three ways take turns, ROUNDS times, because other programs disturb them. The best round of each way counts, and the
ratio of every round is printed. `cores` is the processor time of the growing processes divided by the wall time: two
undisturbed workers have nearly 2. The processor time of a plant shows how much two workers slow each other down. It
therefore bounds the ratio on an idle machine. The results of all ways are compared.
"""

from __future__ import annotations

import argparse
import os
import pickle
import resource
import time

import meristem
from meristem._batch import pickle_job
from meristem._job import Job, Task
from meristem._pool import Pool


def measure_and_clock(plant):
    """Returns height and number of nodes of the plant, and the id and processor time of the process."""
    measures = plant.measure(threads=1)
    return measures["height"], measures["nodes"], os.getpid(), time.process_time()


def grow_on_workers(document, plants, processes):
    """Uses the pool also for one process, for which batch() would use no pool."""
    pool = Pool(pickle_job(Job(document, measure_and_clock)), processes)
    try:
        tasks = (Task(seed, {}) for seed in range(plants))
        return [pickle.loads(result) for _, result in pool.run(tasks, lambda: None)], 0.0
    finally:
        pool.stop()


def grow_here(document, plants, _):
    before = time.process_time()
    batch = meristem.batch(document, seeds=range(plants), measure=measure_and_clock, processes=1)
    return [result.result for result in batch], before


def run_once(grow, document, plants, processes):
    """Returns the results, wall seconds and processor seconds."""
    begin = time.perf_counter()
    rows, before = grow(document, plants, processes)
    wall = time.perf_counter() - begin
    clocks = {process: clock for _, _, process, clock in rows}  # the last of each process
    return [row[:2] for row in rows], wall, sum(clocks.values()) - before


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--model", default="oak")
    parser.add_argument("--plants", type=int, default=24)
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    document = meristem.read(arguments.model)
    ways = {"here": (grow_here, 1), "1 worker": (grow_on_workers, 1), "2 workers": (grow_on_workers, 2)}

    print(f"{arguments.plants} plants of {arguments.model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    walls = {name: [] for name in ways}
    processors = {name: [] for name in ways}
    first = None
    for _ in range(arguments.rounds):
        for name, (grow, processes) in ways.items():
            grown, wall, processor = run_once(grow, document, arguments.plants, processes)
            walls[name].append(wall)
            processors[name].append(processor)
            first = first or grown
            if grown != first:
                raise SystemExit(f"the results of {name} differ")

    for name, times in walls.items():
        rounds = ", ".join(f"{wall:.2f} s on {used / wall:.2f} cores" for wall, used in zip(times, processors[name]))
        cost = 1000 * min(processors[name]) / arguments.plants
        print(f"{name:<10}{arguments.plants / min(times):6.2f} plants/s of {rounds}; at least {cost:.0f} ms a plant")
    for name in ("1 worker", "here"):
        ratio = min(walls[name]) / min(walls["2 workers"])
        rounds = ", ".join(f"{one / two:.2f}" for one, two in zip(walls[name], walls["2 workers"]))
        print(f"2 workers over {name}: {ratio:.2f} by the best, by rounds {rounds}")
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"peak memory of this process {peak:.0f} MB, load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
