"""Every command on every feature of a case: the answer depends on it, or the command refuses it by name.

usage: command_features.py PROGRAM TABLE [--write] [GROUP|COMMAND|FEATURE]...

A feature stands as two cases that differ in it alone. A command that gives the same answer to both has ignored it: that
is right only where `unaffected` says why. TABLE (docs/reference/command-features.md) holds what is expected of each cell, a table
per group of columns; --write writes all of them. A key of the case file without a feature, a command without a column,
or a reason in `unaffected` that no cell needs, is a failure.
"""

import atexit
import concurrent.futures
import functools
import html
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import command_features_columns as columns
import command_features_data as data


def toml_of(case):
    """The text of a case given as {"section.key": TOML value}."""
    sections = {}
    for path, value in case.items():
        section, _, key = path.partition(".") if path.startswith("correlation.") else path.rpartition(".")
        sections.setdefault(section, []).append(f"{key} = {value}\n")
    text = "".join(sections.pop("", []))
    return text + "".join(f"\n[{name}]\n{''.join(lines)}" for name, lines in sections.items())


def changed(case, changes):
    """The case with these keys; None takes one away, "section.*" all of a section."""
    result = dict(case)
    for path, value in changes.items():
        if path.endswith("*"):
            result = {key: old for key, old in result.items() if not key.startswith(path[:-1])}
        elif value is None:
            result.pop(path, None)
        else:
            result[path] = value
    return result


class Answer:
    """What a command made of a case: exit code, what it said, its files without echoes of the case."""

    def __init__(self, program, command, case, with_page=False):
        with tempfile.TemporaryDirectory() as folder:
            self.folder = Path(folder)
            for name, text in {**data.files(), **made(program), **command["files"]}.items():
                (self.folder / name).write_text(text)
            (self.folder / "case.toml").write_text(toml_of(case).replace('"kept"', f'"{kept()}"'))
            self.said, self.code = "", 0
            has_page = bool(command["telling"])
            rolls_on = any(key.startswith("tractive_rolling.") for key in case)  # no comparison runs, one model
            for arguments in command["calls"]:
                if self.code == 0:
                    quick = not with_page and arguments[0] in columns.commands_with_no_report
                    has_page = has_page and not quick
                    kept_arguments = [one for one in arguments if not (rolls_on and one == "--no-studies")]
                    self.call([program, *kept_arguments, *(["--no-report"] if quick else [])])
            self.result = {} if self.code else self.numbers(command["answer"], () if rolls_on else command["part"])
            self.told = "" if self.code else self.sentences(command["telling"] if has_page else None)

    def call(self, arguments):
        # Without gnuplot in its path a command leaves out its plots, which take longer than most answers.
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "PATH": str(self.folder)}
        done = subprocess.run(arguments, cwd=self.folder, capture_output=True, text=True, timeout=600,
                              env=environment, check=False)
        self.code = done.returncode
        self.output = done.stdout
        self.said += done.stdout + done.stderr

    def sentences(self, page):
        """What the command says, on the terminal and on its page."""
        if not page:
            return self.said
        text = (self.folder / page).read_text()
        text = re.sub(r"<(script|style|pre|dl)\b.*?</\1>", " ", text, flags=re.S)  # <pre>, <dl>: the case once more
        return self.said + html.unescape(re.sub(r"<[^>]+>", " ", text))

    def numbers(self, answer, part):
        """The files of the answer, or standard output; what repeats the case or counts seconds left out."""
        if answer == "output":
            return as_numbers(self.output, part)
        if answer == "kept layers":  # by their digests
            return re.findall(r"[0-9a-f]{32}(?=\.layer)", self.said)
        result = {}
        for pattern in answer.split():
            for path in sorted(self.folder.glob(pattern)):
                text = path.read_text(errors="replace")
                result[str(path.relative_to(self.folder))] = as_numbers(text, part)
        return result


@functools.cache
def kept():
    """A folder for condensed layers, which many cells share; gone when the program ends."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


@functools.cache
def made(program):
    """Files that the program makes: a mesh of the layer, influence coefficients of another one; a shipped record."""
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / "case.toml"
        case.write_text(toml_of({**data.base, **columns.elements, "fem.size": '"1.5 mm"', "fem.cache": '"none"'}))
        subprocess.run([program, "mesh", "case.toml", "--output", "out"], cwd=folder, check=True, capture_output=True)
        other = {"substrate.thickness": '"9 mm"', "models": '["bem-layer"]'}
        case.write_text(toml_of({**data.base, **other}))
        subprocess.run([program, "influence", "case.toml", "--output", "out.txt"], cwd=folder, check=True,
                       capture_output=True)
        records = Path(__file__).parent.parent.parent.parent / "examples/records/synthetic"
        return {"body.msh": data.body_of_revolution(),
                "layer.msh": (Path(folder) / "out/mesh.msh").read_text(),
                "influence.txt": (Path(folder) / "out.txt").read_text(),
                "record.csv": (records / "run_1.csv").read_text(),
                "record_2.csv": (records / "run_2.csv").read_text()}


def as_numbers(text, part):
    """A text without seconds and, of JSON, without the case; of that only what stands below the keys of `part`."""
    if text.startswith("{"):
        value = json.loads(text)
        for key in part:
            value = value[key]
        text = json.dumps(without_case(value))
    text = text.split("% Case of Tricontact")[0]  # which export writes behind its numbers
    return re.sub(r"\d+(\.\d+)? s\b", "", re.sub(r"(?m)^(#|%|!).*$", "", text))


def without_case(value):
    """A JSON document without the case that it repeats, and without seconds."""
    if isinstance(value, dict):
        return {key: without_case(one) for key, one in value.items()
                if key != "case" and not re.search(r"cpu|_s$|seconds", key)}
    if isinstance(value, list):
        return [without_case(one) for one in value]
    return value


def names(feature, said):
    """Whether a message names the feature: a key of it, its section, or its word."""
    return any(word in said for word in feature["words"])


def names_of_new(feature, one, other):
    """Whether a sentence that the other case adds, or one about what is left out, names the feature."""
    split = r"(?<=[.;]) |\n"
    sentences = {one for one in re.split(split, other.told) if "condensed" not in one}  # progress of fem
    left_out = {sentence for sentence in sentences if "leaves out" in sentence or "not read by" in sentence}
    return any(names(feature, sentence) for sentence in (sentences - set(re.split(split, one.told))) | left_out)


def answer(program, name, command, case, with_page=False):
    """The answer to a case, which many features have in common: computed once."""
    key = (name, toml_of(case), with_page)
    with lock:
        first = key not in answers
        if first:
            answers[key] = concurrent.futures.Future()
    if first:
        try:
            answers[key].set_result(Answer(program, command, case, with_page))
        except BaseException as error:  # for all who wait for it
            answers[key].set_exception(error)
    return answers[key].result()


answers, lock = {}, threading.Lock()


def cases_of(name, command, feature):
    """Both cases of a cell."""
    over = {**feature["base"], **command["over"]}
    pair = [changed(changed(changed(data.base, over), part), command["always"])
            for part in (feature["one"], feature["other"])]
    return [changed(case, feature["over_for"].get(name, {})) for case in pair[:1]] + [
        changed(case, {**feature["over_for"].get(name, {}), **feature["other_for"].get(name, {})})
        for case in pair[1:]]


def cell(program, name, command, feature):
    """works, refused, unaffected, said, open, or what is wrong."""
    if (name, feature["name"]) in columns.open_cells:
        return "open"
    pair = cases_of(name, command, feature)
    other = answer(program, name, command, pair[1])
    if other.code == 2:
        lines = [line for line in other.said.splitlines() if line.startswith("error: ")]
        if len(lines) != 1:
            return f"wrong: refused by {len(lines)} lines: {other.said.strip()[:200]}"
        return "refused" if names(feature, lines[0]) else f"wrong: refused without its name: {lines[0][:250]}"
    one = answer(program, name, command, pair[0])
    if one.code == 2 and other.code == 0 and names(feature, one.said):
        return "refused"
    if one.code or other.code:
        return f"wrong: exit codes {one.code}, {other.code}: {(one if one.code else other).said.strip()[-250:]}"
    if not one.result:
        return "wrong: no answer"
    if one.result != other.result:
        return "works"
    if names_of_new(feature, one, other):
        return "said"
    if is_unaffected(name, feature):
        return "unaffected"
    if command["telling"] and name.split()[0] in columns.commands_with_no_report:
        pages = [answer(program, name, command, case, with_page=True) for case in pair]
        if names_of_new(feature, *pages):
            return "said"
    return "wrong: ignored in silence"


def is_unaffected(name, feature):
    return any(name in commands.split("|") and (feature["name"] in features.split("|"))
               for commands, features, reason in columns.unaffected)


MARKS = {"works": "✓", "refused": "refused", "said": "left out", "unaffected": "–", "open": "open"}


def table_text(group, cells):
    """A table of the document: a row per feature, a column per command of the group."""
    lines = ["| | " + " | ".join(f"`{name}`" for name in group) + " |", "|---|" + "---|" * len(group)]
    for feature in data.features:
        row = [MARKS.get(cells[name, feature["name"]], "?") for name in group]
        lines.append(f"| {feature['name']} | " + " | ".join(row) + " |")
    return "\n".join(lines) + "\n"


def marks_of(table):
    """The cells of these tables in a document."""
    marks, names = {}, []
    for line in table.read_text().splitlines():
        row = [text.strip() for text in line.strip("|\n").split("|")]
        if line.startswith("| | `"):
            names = [name.strip("`") for name in row[1:]]
        elif line.startswith("| ") and len(row) == len(names) + 1:
            marks.update({(name, row[0]): mark for name, mark in zip(names, row[1:])})
    return marks


def check_reasons(marks):
    """Each reason for the same answer is needed, by a cell that has it: each of its commands with each feature."""
    return [f"{name} x {feature}: a reason for the same answer that the table does not need"
            for commands, features, _ in columns.unaffected
            for name, feature in itertools.product(commands.split("|"), features.split("|"))
            if marks.get((name, feature)) != MARKS["unaffected"]]


def check_keys(program):
    """Each key of the case file belongs to a feature, or to what every case has."""
    listed = subprocess.run([program, "keys"], capture_output=True, text=True, check=True).stdout
    section, keys = "", []
    for line in listed.splitlines():
        if match := re.match(r"#+ .*`\[(.*)\]`", line):
            section = match[1] + "."
        elif match := re.match(r"\| `(\w+)` \|", line):
            keys.append(section + match[1])
        elif line.startswith("#"):
            section = ""
    patterns = [pattern for feature in data.features for pattern in feature["keys"]] + data.keys_of_every_case
    regex = re.compile("|".join("^" + re.escape(one).replace(r"\*", ".*") + "$" for one in patterns))
    return [f"key {key} belongs to no feature (command_features_data.py)" for key in keys if not regex.match(key)]


def check_commands(program):
    help_text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    found = re.findall(r"^  ([a-z]+)  ", help_text, re.M)
    known = {name.split()[0] for name in columns.commands} | set(columns.commands_without_a_case)
    return [f"command {name} has no column (command_features_data.py)" for name in found if name not in known]


def main():
    program, table = os.path.abspath(sys.argv[1]), sys.argv[2]
    writes = "--write" in sys.argv
    only = [one for one in sys.argv[3:] if not one.startswith("--")]
    named = {*columns.groups, "slow", *columns.commands} & set(only)
    tried = [name for group, names in [*columns.groups.items(), ("slow", columns.slow)] for name in names
             if named & {group, name} or not named and group != "slow"]
    rows = [one for one in data.features if one["name"] in only] or data.features
    wanted = [(name, feature) for name, feature in itertools.product(tried, rows)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda one: cell(program, one[0], columns.commands[one[0]], one[1]), wanted))
    cells = {(name, feature["name"]): value for (name, feature), value in zip(wanted, found)}
    table = Path(table)
    if writes and not only:
        texts = (table_text(group, cells) + "\n" for group in columns.groups.values())
        table.write_text(re.sub(r"(?ms)^\| \| `.*?\n\n", lambda _: next(texts), table.read_text()))
    expected = marks_of(table)
    faults = check_keys(program) + check_commands(program) + check_reasons(expected)
    for (name, feature), value in cells.items():
        if value not in MARKS:
            faults.append(f"{name} x {feature}: {value}")
        elif name not in columns.slow and expected.get((name, feature)) != MARKS[value]:
            faults.append(f"{name} x {feature}: {MARKS[value]}, the table has "
                          f"{expected.get((name, feature), 'no such cell')}")
    for fault in faults:
        print("FAILED:", fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
