"""What --export writes, read without the program; archives with something changed in them.

usage: papers.py check EXPORT                           complains of each thing that is not as it should be
       papers.py change ARCHIVE OUT NAME FROM TO...     texts of a file of the archive replaced, digests remade
       papers.py spoil ARCHIVE OUT KIND                 an archive that is bad in a way
       papers.py cited SOURCE_DIR                       complains of publications that texts cite and sources.bib lacks
"""

import csv
import ctypes
import ctypes.util
import io
import json
import re
import stat
import sys
import zipfile
from pathlib import Path

MAGIC = {".pdf": b"%PDF-", ".svg": b"<?xml", ".png": b"\x89PNG\r\n\x1a\n"}
FIELDS = {
    "article": {"author", "title", "journal", "year"},
    "book": {"author", "title", "publisher", "year"},
    "incollection": {"author", "title", "booktitle", "publisher", "year"},
    "phdthesis": {"author", "title", "school", "year"},
    "misc": {"author", "title"},
}


def complain(text):
    print("FAILED:", text)
    complain.n += 1


complain.n = 0


def check_figures(folder, files):
    ids = {path.stem for path in (folder / "data").glob("*.csv")}
    if not ids:
        complain("no figures")
    for ending, magic in MAGIC.items():
        found = {path.stem: path for path in (folder / "figures").glob("*" + ending)}
        if set(found) != ids:
            complain(f"{ending}: {sorted(found)} of {sorted(ids)}")
        for path in found.values():
            if not path.read_bytes().startswith(magic):
                complain(f"{path} begins otherwise")
    for name in ids:
        text = (folder / "data" / f"{name}.csv").read_text(encoding="utf-8")
        if files.get(f"figures/{name}.csv", b"").decode() != text:
            complain(f"{name}.csv is another one in the archive")
        if len(list(csv.reader(io.StringIO(text)))) < 2:
            complain(f"{name}.csv is empty")


def check_table(path):
    """Braces, dollar signs, columns, rules; no character that LaTeX would not take."""
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    if not lines[0].startswith("% tricontact "):
        complain(f"{path}: no provenance")
    body = [line for line in lines if not line.startswith("%")]
    plain = re.sub(r"\\[{}$&%#_]", "", "\n".join(body))
    depth = 0
    for c in plain:
        depth += (c == "{") - (c == "}")
        if depth < 0:
            complain(f"{path}: braces")
            break
    if depth != 0:
        complain(f"{path}: braces")
    begin = re.fullmatch(r"\\begin\{tabular\}\{([lr]+)\}", body[0])
    if not begin or body[-1] != r"\end{tabular}":
        complain(f"{path}: no tabular")
        return
    if [body[1], body[3], body[-2]] != [r"\toprule", r"\midrule", r"\bottomrule"]:
        complain(f"{path}: rules")
    for line in [body[2], *body[4:-2]]:
        row = re.sub(r"\\[{}$&%#_]", "", line)
        if not line.endswith(r" \\") or row.count("&") + 1 != len(begin.group(1)):
            complain(f"{path}: columns of {line}")
        if row.count("$") % 2:
            complain(f"{path}: mathematics in {line}")
        if re.search(r"[#%_^]", re.sub(r"\$[^$]*\$", "", row)):
            complain(f"{path}: special characters in {line}")
    # Latin letters are those that LaTeX reads as they are.
    strange = {c for line in body for c in line if ord(c) > 0x24F}
    if strange:
        complain(f"{path}: {strange}")


def check_references(path):
    keys = []
    for entry in path.read_text(encoding="utf-8").strip().split("\n\n"):
        head = re.match(r"@(\w+)\{(\w+),\n", entry)
        if not head:
            complain(f"references.bib: {entry}")
            continue
        keys.append(head.group(2))
        fields = set(re.findall(r"^  (\w+) = \{.+\},?$", entry, re.MULTILINE))
        missing = FIELDS[head.group(1)] - fields
        if missing:
            complain(f"references.bib: {head.group(2)} lacks {missing}")
        if entry.count("{") != entry.count("}"):
            complain(f"references.bib: {head.group(2)}: braces")
    if keys != sorted(set(keys), key=lambda key: (key != "Tricontact", key.lower())):
        complain(f"references.bib: {keys}")


def read(archive):
    with zipfile.ZipFile(archive) as file:
        if file.testzip():
            complain(f"{archive}: checksum")
        for entry in file.infolist():
            if entry.date_time != (1980, 1, 1, 0, 0, 0):
                complain(f"{archive}: {entry.filename} has a date")
        return {entry.filename: file.read(entry) for entry in file.infolist()}


def check(folder):
    files = read(folder / "archive.zip")
    check_figures(folder, files)
    tables = list((folder / "tables").glob("*.tex"))
    if {f"tables/{path.stem}.csv" for path in tables} != {n for n in files if n.startswith("tables/")}:
        complain("tables of the archive")
    for path in tables:
        check_table(path)
    check_references(folder / "references.bib")
    if not any(name.startswith("inputs/") for name in files):
        complain("no inputs in the archive")
    for name, digest in json.loads(files["archive.json"])["digests"].items():
        if digest_of(files[name]) != digest:
            complain(f"digest of {name}")
    leak = str(Path.cwd()).encode()
    for name, content in files.items():
        if leak in content:
            complain(f"{name} names {leak}")


class Hash(ctypes.Structure):
    _fields_ = [("low", ctypes.c_uint64), ("high", ctypes.c_uint64)]


def digest_of(content):
    """XXH3 of 128 bits."""
    library = ctypes.CDLL(ctypes.util.find_library("xxhash"))
    library.XXH3_128bits.restype = Hash
    library.XXH3_128bits.argtypes = [ctypes.c_char_p, ctypes.c_size_t]
    found = library.XXH3_128bits(content, len(content))
    return f"{found.high:016x}{found.low:016x}"


def write(path, files):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)


def sealed(files):
    """With a list that fits the files."""
    listed = json.loads(files["archive.json"])
    listed["digests"] = {n: digest_of(c) for n, c in files.items() if n != "archive.json"}
    return {**files, "archive.json": json.dumps(listed)}


def change(archive, out, name, *texts):
    files = read(archive)
    for old, new in zip(texts[::2], texts[1::2]):
        if old.encode() not in files[name]:
            sys.exit(f"{name} has no {old}")
        files[name] = files[name].replace(old.encode(), new.encode(), 1)
    write(out, sealed(files))


# Arguments that --export never writes.
ARGUMENTS = {
    "cache": ["--set=fem.cache=/tmp/layers"],
    "cache_key": ["--set", "fem.cache=layers"],
    "second": ["--set", 'indenter.file="a=/etc/passwd"'],
    "texts": ["--set", 'indenter.file=["a", "\\u002fetc/passwd"]'],
    "export": ["--export=./.config"],
    "export_value": ["--set", "--export=./.config"],
    "short": ["-h"],
    "rest": ["--", "elsewhere"],
    "inner": ["--set", "indenter.file=x{archive}/inputs"],
}
# What json.loads of others takes, or fails at.
NUMBERS = {
    "deep": b'{"a":' + b"[" * 20000 + b"]" * 20000 + b"}",
    "nan": b'{"models": {"mdr": {"indentation_m": NaN}}}',
    "huge": b'{"models": {"mdr": {"indentation_m": 1e400}}}',
    "wide": b"{" + b",".join(b'"%d": 1' % i for i in range(100000)) + b"}",
}


def spoil(archive, out, kind):
    files = read(archive)
    listed = json.loads(files["archive.json"])
    toml = next(name for name in files if name.startswith("inputs/") and name.endswith(".toml"))
    call = listed["calls"][0]
    if kind == "text":
        Path(out).write_text("no archive")
    elif kind == "empty":
        Path(out).write_bytes(b"")
    elif kind == "truncated":
        whole = Path(archive).read_bytes()
        Path(out).write_bytes(whole[: len(whole) // 2])
    elif kind == "foreign":
        write(out, {"a.txt": b"a"})
    elif kind == "lacking":
        files.pop(toml)
        write(out, files)
    elif kind == "added":
        write(out, {**files, "inputs/more.toml": b"a = 1"})
    elif kind == "altered":
        write(out, {**files, toml: files[toml] + b"\n"})
    elif kind == "list":
        write(out, {**files, "archive.json": b'{"format": "tricontact archive 1"}'})
    elif kind == "format":
        write(out, {**files, "archive.json": b'{"format": "tricontact archive 2"}'})
    elif kind == "idle":
        write(out, {**files, "archive.json": json.dumps({**listed, "calls": []})})
    elif kind in ARGUMENTS:
        call["arguments"] += ARGUMENTS[kind]
        write(out, {**files, "archive.json": json.dumps(listed)})
    elif kind in NUMBERS:
        write(out, sealed({**files, "results/summary.json": NUMBERS[kind]}))
    elif kind in ("command", "verify", "option", "place", "escape", "override"):
        if kind == "command":
            call["command"] = "frobnicate"
        elif kind == "verify":
            call["command"] = "verify"
        elif kind == "option":
            call["arguments"].append("--frobnicate")
        elif kind == "place":
            call["arguments"] += ["--output", "elsewhere"]
        elif kind == "escape":
            call["arguments"][0] = "{archive}/../../case.toml"
        else:
            call["arguments"] += ["--set", "indenter.file=/etc/passwd"]
        write(out, {**files, "archive.json": json.dumps(listed)})
    elif kind == "toml":
        files[toml] += b'\n[indenter.more]\nfile = "../../../etc/passwd"\n'
        write(out, sealed(files))
    elif kind == "spelt":  # otherwise
        files[toml] += b'\n[indenter.more]\nfile = """\\u002fetc/passwd"""\n'
        write(out, sealed(files))
    elif kind == "traversal":
        write(out, {**files, "../outside.toml": b"a = 1"})
    elif kind == "link":
        write(out, files)
        link = zipfile.ZipInfo("inputs/link")
        link.create_system = 3
        link.external_attr = (stat.S_IFLNK | 0o777) << 16
        with zipfile.ZipFile(out, "a") as file:
            file.writestr(link, "/etc/passwd")
    elif kind == "bomb":  # an archive in an archive, and zeros
        write(out, {**files, "inputs/nested.zip": Path(archive).read_bytes(), "inputs/a": bytes(600_000_000)})
    else:
        sys.exit(f"unknown kind {kind}")


def known_publications(text):
    """Last names of the authors and year of each entry."""
    for entry in text.split("\n\n"):
        authors = re.search(r"  author = \{(.*)\},", entry).group(1).split(" and ")
        year = re.search(r"  year = \{(\d+)\}", entry).group(1)
        yield tuple(author.split(",")[0] for author in authors), year


def cited(source):
    known = list(known_publications((source / "report" / "sources.bib").read_text(encoding="utf-8")))
    spelt = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss"})
    forms = set()
    for names, year in known:
        joined = names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]
        for name in (joined, names[0] + " et al."):
            forms |= {(name, year), (name.translate(spelt), year)}
    word = r"[A-Z][\w-]+"
    pattern = re.compile(rf"((?:{word}, )*{word}(?: and {word}| et al\.)?) \((1[89]\d\d|20\d\d)\)")
    n = 0
    for room in ("app", "atlas", "comparisons", "experiments", "papers", "rolling", "runs", "studies", "walking"):
        for path in sorted((source / room).rglob("*.cc")):
            code = re.sub(r"^\s*//.*$", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
            code = re.sub(r'"\s*\n\s*"', "", code)
            for text in re.findall(r'"((?:[^"\\\n]|\\.)*)"', code):
                for names, year in pattern.findall(text):
                    n += 1
                    if (names, year) not in forms:
                        complain(f"{path}: sources.bib has no {names} ({year})")
    if n < 50:
        complain(f"only {n} citations found")


if __name__ == "__main__":
    if sys.argv[1] == "check":
        check(Path(sys.argv[2]))
    elif sys.argv[1] == "cited":
        cited(Path(sys.argv[2]))
    elif sys.argv[1] == "change":
        change(*sys.argv[2:])
    else:
        spoil(*sys.argv[2:])
    sys.exit(complain.n > 0)
