"""Archives changed at random, each run again in folders that are watched.

usage: bad_archives_random.py PROGRAM ARCHIVE SEED N
"""

import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from papers import read, sealed, write  # noqa: E402

PLACES = ["/tmp/{0}", "../{0}", "./.config", "{{archive}}/../{0}", "~/{0}", "{0}", "{{archive}}", "/dev/stdout", "", "a=/{0}"]
OPTIONS = ["--output", "--export", "--set", "--vtk", "--threads", "--models", "--shard", "--help", "--config", "-o", "--"]
KEYS = ["fem.cache", "indenter.file", "bem.influence", "fem.mesh", "substrate.relaxation.dma", "output.vtk", "title",
        'fem."cache"', "fem"]
TEXTS = [b"NaN", b"1e400", b"[" * 20000, b'"\\ud800"', b"null", b"{}", b"-0", b'"\xc2\x9b31m"']


def place(rng):
    return rng.choice(PLACES).format("written")


def argument(rng):
    """One or two words that --export never writes, or seldom."""
    option, key = rng.choice(OPTIONS), rng.choice(KEYS)
    value = f"{key}={place(rng)}" if rng.random() < 0.5 else place(rng)
    quote = rng.choice(["", '"', "'"])
    value = rng.choice([value, f"{key}={quote}{place(rng)}{quote}", f'{key}={{cache="{place(rng)}"}}'])
    return rng.choice([[option, value], [f"{option}={value}"], [value], [option]])


def change_arguments(rng, files):
    listed = json.loads(files["archive.json"])
    arguments = listed["calls"][0]["arguments"]
    at = rng.randrange(len(arguments) + 1)
    arguments[at:at + rng.randrange(2)] = argument(rng)
    if rng.random() < 0.1:
        listed["calls"] *= 3
    if rng.random() < 0.1:
        listed["calls"][0]["command"] = rng.choice(["mesh", "cache", "sweep", "fit", "sweep merge", "contact export", "merge", "export"])
    return {**files, "archive.json": json.dumps(listed).encode()}


def change_inputs(rng, files):
    name = next(n for n in files if n.startswith("inputs/") and n.endswith(".toml"))
    section, key = rng.choice(KEYS[:6]).rsplit(".", 1)
    line = rng.choice([f'\n[{section}]\n{key} = "{place(rng)}"\n', f"\n[[{section}]]\n{key} = '{place(rng)}'\n"])
    text = files[name]
    return sealed({**files, name: line.encode() + text if rng.random() < 0.3 else text + line.encode()})


def change_bytes(rng, files):
    name = rng.choice(sorted(files))
    content = bytearray(files[name])
    at = rng.randrange(len(content) + 1)
    content[at:at + rng.randrange(9)] = rng.choice(TEXTS + [bytes(rng.randrange(256) for _ in range(4))])
    changed = {**files, name: bytes(content)}
    return changed if name == "archive.json" else sealed(changed)


def add_file(rng, files):
    name = rng.choice(["../written", "/tmp/written", "inputs/../../written", "inputs\\..\\written", "results/written",
                       "inputs/" + "a/" * 300 + "written", "inputs/.", "inputs//written", "figures/\x1b[31m.csv"])
    return sealed({**files, name: b"a = 1"})


def damage(rng, path):
    content = bytearray(path.read_bytes())
    for _ in range(rng.randrange(1, 6)):
        content[rng.randrange(len(content))] = rng.randrange(256)
    path.write_bytes(content[:rng.randrange(len(content))] if rng.random() < 0.3 else content)


def tree(folder):
    return sorted(str(p.relative_to(folder)) for p in folder.rglob("*"))


def main(program, archive, seed, n):
    files, failures, codes = read(archive), 0, {}
    outside = [Path("/tmp/written"), Path("/written")]
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for i in range(n):
            rng = random.Random(seed + i)
            for name in ("cwd", "home", "tmp"):
                (root / name).mkdir(parents=True)
            changed = rng.choice([change_arguments, change_arguments, change_inputs, change_bytes, add_file])(rng, files)
            path = root / "archive.zip"
            write(path, changed)
            if rng.random() < 0.2:
                damage(rng, path)
            output = ["--output", str(root / "out")] if rng.random() < 0.5 else []
            environment = {**os.environ, "HOME": str(root / "home"), "TMPDIR": str(root / "tmp")}
            environment.pop("XDG_CACHE_HOME", None)
            done = subprocess.run([program, "reproduce", str(path), "--quiet", *output], cwd=root / "cwd", env=environment,
                                  stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
            codes[done.returncode] = codes.get(done.returncode, 0) + 1
            said = done.stderr.decode(errors="replace")
            shutil.rmtree(root / "out", ignore_errors=True)
            left = tree(root)
            if left != ["archive.zip", "cwd", "home", "tmp"] or any(p.exists() for p in outside):
                print(f"FAILED: {seed + i}: written outside: {left}")
                failures += 1
            if done.returncode not in (0, 2, 3):
                print(f"FAILED: {seed + i}: exit code {done.returncode}: {said}")
                failures += 1
            for name in left:
                part = root / name
                shutil.rmtree(part, ignore_errors=True) if part.is_dir() else part.unlink(missing_ok=True)
    print(f"{n} archives, exit codes {dict(sorted(codes.items()))}, {failures} failures")
    return failures > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])))
