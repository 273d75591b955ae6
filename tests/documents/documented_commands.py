"""Every command line of README and documents is run, as it stands or in the shorter form that
documented_commands.txt gives; a usage (with brackets or capitals for what is to be filled in) has to name a
command and options that the help knows.
usage: documented_commands.py PROGRAM SOURCE_DIR fast|slow
Fast: what runs as it stands. Slow: the shorter forms."""

import glob
import os
import re
import subprocess
import sys
import tempfile
import time

PROGRAMS = ("tricontact", "scripts/", "examples/scripts/", "build/release/", ".ci/", "cmake", "ctest", "mpirun", "paraview", "sqlite3",
            "gnuplot", "python3", "pvpython", "pvbatch", "xvfb-run", "jupyter")
LONGEST = 300  # [s] of a command; a loaded machine takes several times the usual


def spans(text):
    """Lines of blocks for the shell, and code within the lines: a command has a blank or is a script."""
    fences = re.compile(r"^```(\S*)([^\n]*)\n(.*?)^```", re.M | re.S)
    for fence in fences.finditer(text):
        if fence[1] in ("", "sh"):
            for line in fence[3].replace("\\\n", " ").splitlines():
                # Blocks without a language say behind several blanks what a command does.
                yield re.sub(r"(?<=\S)   .*", "", line) if fence[1] == "" else line
    for code in re.findall(r"`([^`]+)`", fences.sub("", text)):
        if re.search(r"\s", code) or re.match(r"((examples/)?scripts/\w+\.sh|\.ci/run)$", code):
            yield code


def commands_of(text):
    for span in spans(text):
        command = " ".join(re.sub(r"(^|\s)#.*", "", span.strip()).split())
        for part in command.split(" && "):
            bare = re.sub(r"^([A-Z_]+=\S+ )+", "", part)
            if bare.startswith(PROGRAMS) and not bare.startswith("tricontact."):  # Python's module
                yield part


def documented(source):
    """Command -> the document that has it first."""
    found = {}
    documents = ["README.md", "CONTRIBUTING.md", "speed/README.md"] + sorted(glob.glob("docs/**/*.md", root_dir=source, recursive=True))
    for document in documents:
        with open(os.path.join(source, document), encoding="utf-8") as file:
            for command in commands_of(file.read()):
                found.setdefault(command, document)
    return found


def replacements(path):
    """Command -> what is done in its place, from lines "COMMAND" and, indented, "WORD ARGUMENTS"."""
    table, command = {}, None
    with open(path, encoding="utf-8") as file:
        for line in file:
            if not line.strip() or line.startswith("#"):
                continue
            if line[0] != " ":
                command = line.strip()
                table[command] = None
            else:
                word, _, rest = line.strip().partition(" ")
                table[command] = (word, rest)
    return table


class Checker:
    def __init__(self, program, source, part):
        self.program, self.source, self.part = program, source, part
        self.failures = self.ran = 0
        self.helps = {}

    def complain(self, text):
        self.failures += 1
        print("FAILED:", text, flush=True)

    def prepare(self, folder):
        """As after a clone and a build, in a folder of its own; studies with few points."""
        os.chdir(folder)
        os.symlink(os.path.join(self.source, "scripts"), "scripts")
        for name in ("cases", "rigs", "records", "measurements", "scripts"):
            os.makedirs("examples", exist_ok=True)
            os.symlink(os.path.join(self.source, "examples", name), os.path.join("examples", name))
        os.mkdir("examples/studies")
        for study in glob.glob(os.path.join(self.source, "examples/studies/*.toml")):
            with open(study, encoding="utf-8") as file:
                text = file.read()
            with open(os.path.join("examples/studies", os.path.basename(study)), "w", encoding="utf-8") as file:
                file.write(with_few_points(text))
        os.makedirs("build")
        os.symlink(os.path.dirname(os.path.dirname(self.program)), "build/release")
        os.mkdir("bin")
        os.symlink(self.program, "bin/tricontact")
        os.environ["SOURCE"] = self.source
        os.environ["PATH"] = os.path.join(folder, "bin") + ":" + os.environ["PATH"]

    def run(self, command, document, due=0):
        self.ran += 1
        begin = time.monotonic()
        try:
            done = subprocess.run(["bash", "-c", command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  stdin=subprocess.DEVNULL, timeout=LONGEST, text=True, errors="replace")
        except subprocess.TimeoutExpired:
            self.complain(f"{document}: {command}: takes more than {LONGEST} s; give documented_commands.txt a "
                          "shorter form")
            return
        print(f"{time.monotonic() - begin:6.1f} s  {command}", flush=True)
        if done.returncode != due:
            self.complain(f"{document}: {command}: exit code {done.returncode}: {done.stdout[-400:]}")

    def help_of(self, command):
        if command not in self.helps:
            done = subprocess.run([self.program, *command.split(), "--help"], capture_output=True,
                                  text=True)
            self.helps[command] = done.stdout if done.returncode == 0 else None
        return self.helps[command]

    def check_usage(self, usage, document):
        words = re.sub(r"[\[\]]|\.\.\.", " ", usage).split()
        if words[0] != "tricontact":
            script = words[0]
            if "/" in script and not os.path.exists(os.path.join(self.source, script)):
                self.complain(f"{document}: {usage}: there is no {script}")
            return
        command = words[1] if not words[1].startswith("-") else ""
        part = " ".join(words[1:3])  # such as sweep merge, which the help of sweep names
        if f"\n  {part}  " in (self.help_of(command) or ""):
            command = part
        text = self.help_of(command)
        if text is None:
            self.complain(f"{document}: {usage}: no command {command}")
            return
        for option in re.findall(r"--[a-z-]+", usage):
            if not re.search(option + r"\b", text):
                self.complain(f"{document}: {usage}: {command} has no option {option}")


def is_usage(command):
    """With brackets, words in capitals or dots for what the reader fills in."""
    return bool(re.search(r"[\[\]]|\.\.\.|(^|[\s=:\"'/])(?!HOME\b)[A-Z][A-Z_]+(\.\w+)?(?![\w=])", command)) or \
        " " not in command and command.startswith("tricontact") or \
        re.fullmatch(r"tricontact [a-z]+( (merge|condense|export|import))?|cmake --install", command) is not None


def with_few_points(study):
    """Two values of the first key that is varied, one of each other; few periods, a short time."""
    head, _, varied = study.partition("[vary]\n")
    lines, n = [], 0
    for line in varied.splitlines():
        if "=" in line and not line.startswith("#"):
            n += 1
            line = re.sub(r"points = \d+", "points = 2", line)
            if line.partition("=")[2].strip().startswith("["):
                key, _, values = line.partition("=")
                kept = values.split("]")[0].strip(" [").split(",")[: 2 if n == 1 else 1]
                line = f"{key}= [{', '.join(value.strip() for value in kept)}]"
        lines.append(line)
    head = re.sub(r"rolling\.periods = \d+", "rolling.periods = 3", head)
    head = re.sub(r"levels = \d+", "levels = 1", head)
    head = re.sub(r"cells_per_radius = \d+", "cells_per_radius = 5", head)
    head = re.sub(r"time\.end = \d+", "time.end = 500", head)
    return head + "[vary]\n" + "\n".join(lines) + "\n"


def main():
    program, source, part = os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2]), sys.argv[3]
    found = documented(source)
    table = replacements(os.path.join(source, "tests/documents/documented_commands.txt"))
    checker = Checker(program, source, part)
    for command in table:
        if command not in found:
            checker.complain(f"documented_commands.txt: no document has: {command}")
    with tempfile.TemporaryDirectory() as folder:
        checker.prepare(folder)
        for command, document in found.items():
            word, rest = table.get(command, ("as", "it stands"))
            if part == "list":
                print(document, "|", command, "|", "usage" if is_usage(command) and command not in table else word)
            elif command not in table and is_usage(command):
                if part == "fast":
                    checker.check_usage(command, document)
            elif word == "in":  # another test runs it
                if part == "fast" and not os.path.exists(os.path.join(source, re.split(r"[:\s]", rest)[0])):
                    checker.complain(f"{command}: there is no {rest}")
            elif (word == "as") == (part == "fast"):
                checker.run({"as": command, "add": f"{command} {rest}", "run": rest}[word], document)
        os.chdir("/")
    print(f"{checker.ran} commands, {checker.failures} failures")
    return checker.failures > 0


sys.exit(main())
