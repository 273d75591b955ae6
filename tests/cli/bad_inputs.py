"""Writes the bad inputs of a folder: a good file with the changes that the table bad_inputs.txt states for each.

usage: bad_inputs.py FOLDER OUTPUT

An entry of the table:
    == name
    expect :17:12: the message from its line and column on (" ... " stands for a path)
    from good_rig           another good file; good otherwise
    section.key = value     sets a key; of files without keys: line number = text
    - section.key           omits a key, a [section] or a line
    + [section] text        adds a line to a section, "+ text" at the end of the file
The first line of each file written is the message, as a comment. Other files of the folder are copied: bad inputs
whose text is no change of a good one (another encoding, nothing at all), and the tables that inputs name.
"""

import pathlib
import re
import shutil
import sys


class Toml:
    """Sections in their order, each with its lines; the first has the keys before any section."""

    def __init__(self, text):
        self.sections = {"": []}
        for line in text.splitlines():
            heading = re.fullmatch(r"\[([^][]+)\]", line)
            if heading:
                name = heading[1]
                self.sections[name] = []
            else:
                self.sections[list(self.sections)[-1]].append(line)
        self.end = []

    def set(self, path, value):
        section, _, key = path.rpartition(".")
        lines = self.sections.setdefault(section, [])
        at = self.find(lines, key)
        lines[at:at + 1] = [f"{key} = {value}"]

    def omit(self, path):
        if path.startswith("["):
            del self.sections[path[1:-1]]
            return
        section, _, key = path.rpartition(".")
        lines = self.sections[section]
        del lines[self.find(lines, key)]

    def add(self, line):
        heading = re.match(r"\[([^][]*)\] (?=.)", line)
        if heading and heading[1] in self.sections:
            self.sections[heading[1]].append(line[heading.end():])
        else:
            self.end.append(line)

    @staticmethod
    def find(lines, key):
        return next((i for i, line in enumerate(lines) if line.split(" =")[0] == key), len(lines))

    def text(self):
        lines = []
        for name, content in self.sections.items():
            lines += ([f"[{name}]"] if name else []) + content
        return "\n".join(lines + self.end) + "\n"


class Lines:
    """A file without keys: lines by their numbers."""

    def __init__(self, text):
        self.lines = dict(enumerate(text.splitlines(), 1))
        self.end = []

    def set(self, number, text):
        self.lines[int(number)] = text

    def omit(self, number):
        del self.lines[int(number)]

    def add(self, line):
        self.end.append(line)

    def text(self):
        return "\n".join([*self.lines.values(), *self.end]) + "\n"


def entries(table):
    """(name, message, base, changes) of each entry."""
    for block in re.split(r"^== ", table, flags=re.MULTILINE)[1:]:
        name, message, *changes = block.rstrip("\n").split("\n")
        base = "good"
        if changes and changes[0].startswith("from "):
            base = changes.pop(0).removeprefix("from ")
        yield name, message.removeprefix("expect "), base, [c for c in changes if c]


def changed(base, changes):
    """The text of a base file with these changes."""
    text = base.read_text(encoding="utf-8")
    file = Toml(text) if base.suffix == ".toml" else Lines(text)
    for change in changes:
        if change.startswith("- "):
            file.omit(change[2:])
        elif change.startswith("+ "):
            file.add(change[2:])
        else:
            file.set(*change.split(" = ", 1))
    return file.text()


def main(folder, output):
    folder, output = pathlib.Path(folder), pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    bases = {file.stem: file for file in folder.glob("good*")}
    for file in folder.iterdir():
        if file.name != "bad_inputs.txt" and file not in bases.values():
            shutil.copy(file, output)
    for name, message, base, changes in entries((folder / "bad_inputs.txt").read_text(encoding="utf-8")):
        comment = "#" if bases[base].suffix == ".toml" else "%"
        first, _, rest = changed(bases[base], changes).partition("\n")
        assert first.startswith(comment), f"{base}: the first line makes room for the message"
        (output / f"{name}{bases[base].suffix}").write_text(f"{comment} expect: {message}\n{rest}", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
