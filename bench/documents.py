#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times whole processes that grow or draw documents. Default: the shipped documents and trees.json.

Each process handles one document, RUNS times after a warm-up. Prints the minimum and median of wall and processor
seconds, the peak memory as the operating system counts it, and the file's hash, which must be equal each time. As the
reference for the smallest cost of a process, `meristem --version` is timed in the same run.

    bench/documents.py [PROGRAM] [--runs N] [--documents FILE ...] [--endings .glb .obj .ply .skeleton.ply .csv .png]

Pictures (.png) have 800 x 800 pixels and 64 samples.
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
    """Returns wall and processor seconds as (minimum, median), and the peak memory, over `runs` after a warm-up."""
    run_once(command)
    walls, processors, memories = zip(*(run_once(command) for _ in range(runs)))
    spread = [(min(times), statistics.median(times)) for times in (walls, processors)]
    return spread, max(memories)


def print_row(name, spread, memory, note):
    (wall_min, wall), (cpu_min, cpu) = spread
    print(f"{name:<22} {wall_min:8.3f} {wall:8.3f} {cpu_min:8.3f} {cpu:8.3f} {memory:8.0f}  {note}")


def time_document(arguments, document, target):
    draws = target.endswith(".png")
    command = [arguments.program, "render" if draws else "grow", str(document), "-o", target, "--quiet"]
    if draws:
        command += ["--size", "800x800", "--samples", "64"]
    spread, memory = measure(command, arguments.runs)
    # In pieces, because the system adds this process's memory to the peak of the next process that it starts.
    digest = hashlib.sha256()
    with open(target, "rb") as file:
        while piece := file.read(1 << 20):
            digest.update(piece)
    print_row(pathlib.Path(target).name, spread, memory,
              f"{os.path.getsize(target) / 1e6:.1f} MB, {digest.hexdigest()[:16]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="?", default=str(ROOT / "build/release/bin/meristem"))
    parser.add_argument("--runs", type=int, default=7)
    documents = sorted((ROOT / "models").glob("*.json")) + [ROOT / "bench/trees.json"]
    parser.add_argument("--documents", nargs="+", type=pathlib.Path, default=documents, metavar="FILE")
    parser.add_argument("--endings", nargs="+", default=[".glb"], help="of the formats to write")
    arguments = parser.parse_args()

    print(f"{'':<22} {'wall s':>17} {'processor s':>17} {'MB':>8}")
    print(f"{'file':<22} {'min':>8} {'median':>8} {'min':>8} {'median':>8} {'peak':>8}  size, hash")
    with open(os.devnull, "w") as quiet:
        saved = os.dup(1)
        os.dup2(quiet.fileno(), 1)
        spread, memory = measure([arguments.program, "--version"], arguments.runs)
        os.dup2(saved, 1)
    print_row("(no document)", spread, memory, "")
    with tempfile.TemporaryDirectory() as folder:
        for document in arguments.documents:
            for ending in arguments.endings:
                time_document(arguments, document, os.path.join(folder, document.stem + ending))


if __name__ == "__main__":
    main()
