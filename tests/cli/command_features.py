"""Every command on every feature of a case: the answer depends on it, or the command refuses it by name.

usage: command_features.py PROGRAM TABLE [--write] [--only COMMAND|FEATURE]...

A feature stands as two cases that differ in it alone. A command that gives the same answer to both has ignored it: that
is right only where `unaffected` says why. TABLE (docs/command-features.md) holds what is expected of each cell; --write
writes it. A key of the case file without a feature, or a command without a column, is a failure.
"""

import concurrent.futures
import functools
import html
import itertools
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import command_features_data as data


def toml_of(case):
    """The text of a case given as {"section.key": TOML value}."""
    sections = {}
    for path, value in case.items():
        section, _, key = path.rpartition(".")
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
            for name, text in {**data.files(), **made(program), **command.get("files", {})}.items():
                (self.folder / name).write_text(text)
            (self.folder / "case.toml").write_text(toml_of(case))
            self.said, self.code = "", 0
            for arguments in command["calls"]:
                if self.code == 0:
                    quick = [] if with_page or arguments[0] not in data.commands_with_no_report else ["--no-report"]
                    self.call([program, *arguments, *quick])
            self.result = {} if self.code else self.numbers(command["answer"], command.get("part", ()))
            self.told = "" if self.code else self.sentences(command.get("telling") if with_page else None)

    def call(self, arguments):
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
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
        text = re.sub(r"<(script|style).*?</\1>", " ", text, flags=re.S)
        return self.said + html.unescape(re.sub(r"<[^>]+>", " ", text))

    def numbers(self, answer, part):
        """The files of the answer, or standard output; what repeats the case or counts seconds left out."""
        if answer == "output":
            return as_numbers(self.output, part)
        result = {}
        for pattern in answer.split():
            for path in sorted(self.folder.glob(pattern)):
                text = path.read_text(errors="replace")
                result[str(path.relative_to(self.folder))] = as_numbers(text, part)
        return result


@functools.cache
def made(program):
    """Files that the program makes: a mesh and influence coefficients of the layer, a record that is shipped."""
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / "case.toml"
        case.write_text(toml_of({**data.base, **data.elements}))
        subprocess.run([program, "mesh", "case.toml", "--output", "out"], cwd=folder, check=True, capture_output=True)
        case.write_text(toml_of({**data.base, **data.layer, "models": '["bem-layer"]'}))
        subprocess.run([program, "influence", "case.toml", "--output", "out.txt"], cwd=folder, check=True,
                       capture_output=True)
        record = Path(__file__).parent.parent.parent / "examples/records/synthetic/run_1.csv"
        return {"layer.msh": (Path(folder) / "out/mesh.msh").read_text(),
                "influence.txt": (Path(folder) / "out.txt").read_text(), "record.csv": record.read_text()}


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
    sentences = set(re.split(split, other.told))
    left_out = {sentence for sentence in sentences if "leaves out" in sentence}
    return any(names(feature, sentence) for sentence in (sentences - set(re.split(split, one.told))) | left_out)


def cell(program, name, command, feature):
    """works, refused, unaffected, or what is wrong."""
    base = changed(data.base, command.get("base", {}))
    bases = {**feature.get("base", {}), **command.get("over", {})}
    pair = [changed(changed(changed(base, bases), part), command.get("always", {}))
            for part in (feature["one"], feature["other"])]
    pair[1] = changed(pair[1], feature["over_for"].get(name, {}))
    other = Answer(program, command, pair[1])
    if other.code == 2:
        lines = [line for line in other.said.splitlines() if line.startswith("error: ")]
        if len(lines) != 1:
            return f"wrong: refused by {len(lines)} lines: {other.said.strip()[:200]}"
        return "refused" if names(feature, lines[0]) else f"wrong: refused without its name: {lines[0][:250]}"
    one = Answer(program, command, pair[0])
    answers = [one, other]
    if one.code == 2 and other.code == 0 and names(feature, one.said):
        return "refused"
    if one.code or other.code:
        return f"wrong: exit codes {one.code}, {other.code}: {(one if one.code else other).said.strip()[-250:]}"
    if not answers[0].result:
        return "wrong: no answer"
    if answers[0].result != answers[1].result:
        return "works"
    if names_of_new(feature, one, other):
        return "said"
    if command.get("telling"):
        pages = [Answer(program, command, case, with_page=True) for case in pair]
        if names_of_new(feature, *pages):
            return "said"
    if any(name in commands.split("|") and (features == "*" or feature["name"] in features.split("|"))
           for commands, features, reason in data.unaffected):
        return "unaffected"
    return "wrong: ignored in silence"


MARKS = {"works": "✓", "refused": "refused", "said": "left out", "unaffected": "–"}


def table_text(cells):
    """The table of the document: a row per feature, a column per command."""
    lines = ["| | " + " | ".join(f"`{name}`" for name in data.commands) + " |",
             "|---|" + "---|" * len(data.commands)]
    for feature in data.features:
        row = [MARKS.get(cells[name, feature["name"]], "?") for name in data.commands]
        lines.append(f"| {feature['name']} | " + " | ".join(row) + " |")
    return "\n".join(lines) + "\n"


def marks_of(table):
    """The cells of that table in a document."""
    rows = [[text.strip() for text in line.strip("|\n").split("|")]
            for line in table.read_text().splitlines() if line.startswith("| ")]
    names = [name.strip("`") for name in rows[0][1:]]
    return {(name, row[0]): mark for row in rows[1:] if len(row) == len(names) + 1
            for name, mark in zip(names, row[1:])}


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
    known = {name.split()[0] for name in [*data.commands, *data.slow_commands]} | set(data.commands_without_a_case)
    return [f"command {name} has no column (command_features_data.py)" for name in found if name not in known]


def main():
    program, table = sys.argv[1:3]
    only = [one for one in sys.argv[3:] if not one.startswith("--")]
    tried = {**data.commands, **{name: one for name, one in data.slow_commands.items() if name in only}}
    wanted = [(name, feature) for name, feature in itertools.product(tried, data.features)
              if not only or name in only or feature["name"] in only]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda one: cell(program, one[0], tried[one[0]], one[1]), wanted))
    cells = {(name, feature["name"]): value for (name, feature), value in zip(wanted, found)}
    faults = check_keys(program) + check_commands(program)
    faults += [f"{name} x {feature}: {value}" for (name, feature), value in cells.items() if value.startswith("wrong")]
    table = Path(table)
    if "--write" in sys.argv:
        text = re.sub(r"(?ms)^\| \| `.*?\n\n", lambda _: table_text(cells) + "\n", table.read_text())
        table.write_text(text)
    expected = marks_of(table)
    faults += [f"{name} x {feature}: {MARKS[value]}, the table has {expected.get((name, feature), 'no such cell')}"
               for (name, feature), value in cells.items()
               if value in MARKS and name in data.commands and expected.get((name, feature)) != MARKS[value]]
    for fault in faults:
        print("FAILED:", fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
