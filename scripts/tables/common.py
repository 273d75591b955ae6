"""Commands, test programs and benchmarks as sources of tables, and numbers as documents write them."""

import csv
import json
import math
import os
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
CASES = ROOT / "examples/cases"
STUDIES = ROOT / "examples/studies"
TABLES = {}


class NotBuilt(Exception):
    """A program that a table needs is not there."""


class NoRows(Exception):
    """A test that should print a table does not: it is older than the table."""


class Program:
    """The program's answers as its files have them; its tests and benchmarks stand beside it in the build folder."""

    def __init__(self, path):
        self.path = Path(path).resolve()
        self.build = self.path.parent.parent
        self.kept = {}

    def call(self, command, file, settings=(), *arguments, outputs=("summary.json",)):
        """What the files of its folder hold: one of them, or a list of several."""
        with tempfile.TemporaryDirectory() as folder:
            sets = [part for one in settings for part in ("--set", one)]
            subprocess.run([self.path, command, file, *arguments, *sets, "--output", folder + "/out", "--quiet"],
                           cwd=folder, check=True, stdout=subprocess.DEVNULL)
            found = [read(Path(folder) / "out" / name) for name in outputs]
        return found[0] if len(found) == 1 else found

    def run(self, file, *settings, models):
        """The models of summary.json, by their names."""
        return self.call("run", file, ["output.vtk=none", *settings], "--models", models, "--no-report",
                         "--no-studies")["models"]

    def sweep(self, study):
        """The rows of results.csv."""
        return self.call("sweep", STUDIES / study, [], "--no-report", outputs=["results.csv"])

    def fit(self, study):
        """fit.json of a study that is swept before."""
        with tempfile.TemporaryDirectory() as folder:
            for command, *options in (("sweep", "--no-report"), ("fit",)):
                subprocess.run([self.path, command, STUDIES / study, "--output", folder + "/out", "--quiet", *options],
                               cwd=folder, check=True, stdout=subprocess.DEVNULL)
            return read(Path(folder) / "out/fit.json")

    def roll(self, file, *settings):
        """summary.json of a body that rolls on, by boundary elements."""
        return self.call("run", file, ["output.vtk=none", *settings], "--models", "bem", "--points", "0", "--no-report")

    def check(self, file, *settings):
        """The numbers behind the resolved case: symbol -> value in SI units."""
        sets = [part for one in settings for part in ("--set", one)]
        text = subprocess.run([self.path, "check", file, "--json", *sets], check=True, capture_output=True, text=True).stdout
        return {symbol: one["value"] for symbol, one in json.loads(text)["derived"].items()}

    def tests(self, binary, names):
        """The rows that tests print, texts of their cells."""
        path = self.build / "tests" / binary
        if not path.exists():
            raise NotBuilt(path)
        text = subprocess.run([path, f"--gtest_filter={names}"], check=True, capture_output=True, text=True).stdout
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]
        if not rows:
            raise NoRows(f"{path} --gtest_filter={names} prints no rows")
        return rows

    def random(self, binary, *arguments):
        """What a program of tests/random prints; it may fail, which its own test shows."""
        path = self.build / "tests/random" / binary
        if not path.exists():
            raise NotBuilt(path)
        return subprocess.run([path, *arguments], check=False, capture_output=True, text=True).stdout

    def benchmarks(self, binary, names, **environment):
        """The figures of a benchmark: name -> its JSON."""
        path = self.build / "speed" / binary
        if not path.exists():
            raise NotBuilt(path)
        text = subprocess.run([path, f"--benchmark_filter={names}", "--benchmark_format=json"], check=True,
                              capture_output=True, text=True, env=os.environ | environment).stdout
        return {one["name"]: one for one in json.loads(text)["benchmarks"]}


def read(path):
    text = path.read_text()
    if path.suffix == ".html":
        return text
    return list(csv.DictReader(text.splitlines())) if path.suffix == ".csv" else json.loads(text)


def table(document, header, cheap=False):
    """Declares a table: the function gives its rows as lists of texts."""
    def declare(rows):
        TABLES[rows.__name__] = {"document": ROOT / document, "header": header, "rows": rows, "cheap": cheap}
        return rows
    return declare


def find(rows, **values):
    """The row of results.csv with these numbers and texts; _ in a name is for the dot of a key."""
    def holds(row):
        return all(row[key] == value if isinstance(value, str) else math.isclose(float(row[key]), value, rel_tol=1e-9, abs_tol=1e-12)
                   for key, value in values.items())
    return next(row for row in rows if holds(row))


def short(number, digits=3):
    """.258, -.0016: without the zero before the point, as some documents write it."""
    text = f"{number:.{digits}f}"
    return text.replace("0.", ".", 1) if abs(number) < 1 else text


def figures(number, count=3):
    """Three figures, without an exponent: 0.0953, 1.41, 37.6."""
    if number == 0:
        return "0"
    text = f"{number:.{count}g}"
    return f"{number:.{max(0, count - 1 - math.floor(math.log10(abs(float(text)))))}f}"


def power(number, digits=2):
    """1.3e-2."""
    if number == 0:
        return "0"
    exponent = math.floor(math.log10(abs(number)) + 1e-12)
    text = f"{number / 10.**exponent:.{digits - 1}f}"
    if abs(float(text)) >= 10:
        exponent += 1
        text = f"{number / 10.**exponent:.{digits - 1}f}"
    return f"{text}e{exponent}"


def percent(ratio, digits=1):
    """+5.1 %: of a ratio less 1."""
    return f"{100 * ratio:+.{digits}f} %"
