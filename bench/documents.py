#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times whole processes: every shipped document, grown to a GLB by the command line.

One document a process, RUNS times after a warm-up; wall and processor seconds as minimum and median, peak memory as the
operating system counts it, and the file's hash, which has to be the same each time. As a reference for what a process
costs at all, `meristem --version` is timed in the same run.

    bench/documents.py [PROGRAM] [--runs N]
"""
import argparse
import hashlib
import os
import pathlib
import statistics
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run_once(command):
    """Runs a command; returns its wall seconds, processor seconds, and peak memory in MB."""
    begin = time.perf_counter()
    child = os.posix_spawn(command[0], command, os.environ)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)} failed")
    return time.perf_counter() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measure(command, runs):
    """Wall and processor seconds as (minimum, median), and the peak memory, over `runs` after one that does not count."""
    run_once(command)
    walls, processors, memories = zip(*(run_once(command) for _ in range(runs)))
    spread = [(min(times), statistics.median(times)) for times in (walls, processors)]
    return spread, max(memories)


def print_row(name, spread, memory, note):
    (wall_min, wall), (cpu_min, cpu) = spread
    print(f"{name:<16} {wall_min:8.3f} {wall:8.3f} {cpu_min:8.3f} {cpu:8.3f} {memory:8.0f}  {note}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="?", default=str(ROOT / "build/release/bin/meristem"))
    parser.add_argument("--runs", type=int, default=7)
    arguments = parser.parse_args()

    print(f"{'':<16} {'wall s':>17} {'processor s':>17} {'MB':>8}")
    print(f"{'document':<16} {'min':>8} {'median':>8} {'min':>8} {'median':>8} {'peak':>8}  file")
    with open(os.devnull, "w") as quiet:
        saved = os.dup(1)
        os.dup2(quiet.fileno(), 1)
        spread, memory = measure([arguments.program, "--version"], arguments.runs)
        os.dup2(saved, 1)
    print_row("(no document)", spread, memory, "")
    with tempfile.TemporaryDirectory() as folder:
        for document in sorted((ROOT / "models").glob("*.json")):
            target = os.path.join(folder, document.stem + ".glb")
            spread, memory = measure([arguments.program, "grow", str(document), "-o", target, "--quiet"], arguments.runs)
            data = pathlib.Path(target).read_bytes()
            print_row(document.stem, spread, memory, f"{len(data) / 1e6:.1f} MB, {hashlib.sha256(data).hexdigest()[:16]}")


if __name__ == "__main__":
    main()
