#!/usr/bin/env python3
"""Whether two programs give the same results, byte by byte, on all examples: before and after a change that should change
none. Times are left out, and where files lie.

usage: same_results.py BEFORE AFTER [--jobs N] [PATTERN]...   of these names of examples; all

Exit codes: 0 the same, 1 they differ: each file with its first line that does.
"""

import argparse
import concurrent.futures
import fnmatch
import itertools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COMPARED = ("*.json", "*.csv", "*.inp")
# Times, digests of the program, folders; of a sweep's rows the seconds too.
VARYING = re.compile(r'(?m)^.*"[^"]*(cpu|seconds|_s\b|started|version|digest|command)[^"]*":.*$|/tmp/[^",\s]*')
COLUMNS = re.compile(r"cpu|seconds")


def calls():
    """(name, arguments) of each example: what computes it; "OUT" is its folder."""
    for path in sorted((ROOT / "examples").glob("*/*.toml")):
        name, folder = f"{path.parent.name}/{path.stem}", path.parent.name
        if folder == "studies":
            yield name, ["sweep", path, "--output", "OUT", "--no-report", "--jobs", "1", "--quiet"]
        elif folder == "cases":
            text = path.read_text()
            command = "walk" if "[machine]" in text else "roll" if "[tractive_rolling]" in text else "run"
            yield name, [command, path, "--output", "OUT", "--no-report", "--quiet"]
        elif folder == "rigs":
            yield name, ["design" if "[design]" in path.read_text() else "rig", path, "--output", "OUT"]
        else:
            command = {"measurements": "identify", "records": "experiment"}[folder]
            yield name, [command, path, "--output", "OUT", "--quiet"]


def text_of(path):
    """A file's text without what varies."""
    text = path.read_text(errors="replace")
    if path.suffix != ".csv":
        return VARYING.sub("", text)
    rows = [line.split(",") for line in text.splitlines()]
    kept = [i for i, column in enumerate(rows[0]) if not COLUMNS.search(column)] if rows else []
    return "\n".join(",".join(row[i] for i in kept if i < len(row)) for row in rows)


def results(program, arguments):
    """The compared files of a call, by their names, and its exit code."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        done = subprocess.run([program, *(out if one == "OUT" else one for one in arguments)], capture_output=True,
                              text=True, check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        files = {str(path.relative_to(out)): text_of(path) for pattern in COMPARED for path in out.rglob(pattern)}
        return {**files, "exit code": str(done.returncode)}


def difference(name, before, after, arguments):
    """Lines on what differs; none where all is the same."""
    old, new = (results(program, arguments) for program in (before, after))
    lines = []
    for file in sorted(old.keys() | new.keys()):
        pairs = itertools.zip_longest(old.get(file, "").splitlines(), new.get(file, "").splitlines())
        first = next((f"{a!r:.110} | {b!r:.110}" for a, b in pairs if a != b), None)
        if first or (file in old) != (file in new):
            lines.append(f"{name}: {file}: {first}")
    if old["exit code"] != "0":
        lines.append(f"{name}: {before} ends with {old['exit code']}: nothing is compared")
    print(f"{name}: {len(old)} files, {'differ' if lines else 'the same'}", flush=True)
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("before", type=os.path.abspath)
    parser.add_argument("after", type=os.path.abspath)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("patterns", nargs="*", default=["*"])
    given = parser.parse_args()
    wanted = [one for one in calls() if any(fnmatch.fnmatch(one[0], pattern) for pattern in given.patterns)]
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        found = pool.map(lambda one: difference(one[0], given.before, given.after, one[1]), wanted)
        lines = [line for each in found for line in each]
    print("\n".join(lines))
    sys.exit(1 if lines else 0)


if __name__ == "__main__":
    main()
