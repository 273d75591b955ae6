"""The C++ reference: a page for each library that is installed, from the comments of its headers. What stands in a header
for others is shown: declarations with their comments, without bodies and without what is private.
usage: cpp_reference.py SOURCE_DIR FOLDER"""

import re
import sys
from pathlib import Path

TYPE = re.compile(r"(?:template\s*<[^;{]*>\s*)?(class|struct|enum|union|namespace)\b(?!.*\)\s*$)", re.S)
ACCESS = re.compile(r"(public|protected|private)\s*:(?!:)")


def closing(text, start):
    """Behind the bracket that closes the one at `start`; comments and texts have none."""
    depth, k = 0, start
    while k < len(text):
        skipped = re.compile(r'//[^\n]*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'').match(text, k)
        if skipped:
            k = skipped.end()
            continue
        depth += (text[k] in "({") - (text[k] in ")}")
        k += 1
        if depth == 0:
            return k
    raise ValueError(f"a bracket stays open: {text[start:start + 80]}")


class Statement:
    """comment: lines before it, behind: the comment in its line; head and body of a type, else head alone."""

    def __init__(self, comment, head, body=None, behind=""):
        self.comment, self.head, self.body, self.behind = comment, head, body, behind


def declaration(head):
    """Of a function with a body: without the constructor's list of members."""
    k = head.find("(")
    k = closing(head, k) if k >= 0 else len(head)
    return re.sub(r"\s:\s(?!:).*", "", head[k:], flags=re.S).join([head[:k], ""]).rstrip() + ";"


def one_statement(text, k):
    """(head, body, end) of the statement that begins at k."""
    begin, body, head = k, None, None
    while True:
        c = text[k]
        if text.startswith("//", k):
            k = text.index("\n", k)
        elif c == '"':
            k = re.compile(r'"(?:\\.|[^"\\])*"').match(text, k).end()
        elif c == "(":
            k = closing(text, k)
        elif c == "{":
            end, before = closing(text, k), text[begin:k]
            if TYPE.match(before) and "=" not in before.split("<")[0]:
                head, body = before.rstrip(), text[k + 1:end - 1]
                if before.startswith("namespace"):
                    return head, body, end
            elif not re.search(r"[\w>]$|[=,(]\s*$", before):
                return declaration(before.rstrip()), None, end
            k = end
        elif c == ";":
            return (head, body, k + 1) if body is not None else (text[begin:k + 1], None, k + 1)
        else:
            k += 1


def statements(text):
    comment, k, text = [], 0, text + "\n"
    while k < len(text):
        line = re.compile(r"[ \t]*(//[^\n]*)?\n").match(text, k)
        if line and line[1]:
            comment.append(line[1])
            k = line.end()
        elif line:
            if comment:  # of nothing in particular
                yield Statement(comment, "")
            comment, k = [], line.end()
        elif text[k] in " \t":
            k += 1
        elif text[k] == "#":
            k = text.index("\n", k)
        elif access := ACCESS.match(text, k):
            yield Statement([], access[0])
            k = access.end()
        else:
            head, body, k = one_statement(text, k)
            behind = re.compile(r"[ \t;]*(//[^\n]*)?").match(text, k)
            k = behind.end()
            yield Statement(comment, head, body, behind[1] or "")
            comment = []


def is_public(body, kind):
    """The statements of a type that its users see."""
    shown = kind != "class"
    for one in statements(body):
        if ACCESS.fullmatch(one.head):
            shown = one.head.startswith("public")
        elif shown:
            yield one


def code(one, indent=0):
    """Lines of a statement, without the comment before it."""
    space = " " * indent
    if one.body is None:
        return [space + one.head + ("  " + one.behind if one.behind else "")]
    kind = TYPE.match(one.head)[1]
    if kind == "enum":
        return [f"{space}{one.head} {{{one.body.rstrip()}{chr(10) + space if chr(10) in one.body else ' '}}};"]
    lines = [f"{space}{one.head} {{"]
    for member in is_public(one.body, kind):
        lines += [" " * (indent + 4) + line for line in member.comment]
        if member.head:
            lines += code(member, indent + 4)
    return lines + [space + "};"]


def told(comment):
    """Comment lines as text of a page."""
    text = " ".join(re.sub(r"^///?<? ?", "", line).strip() for line in comment)
    parts = text.split("`")  # every second one is code, if all are closed
    step = 2 if len(parts) % 2 else 1
    parts[::step] = [re.sub(r"([\\*_|<>$\[\]#~])", r"\\\1", part) for part in parts[::step]]
    return ("`" if step == 2 else "\\`").join(parts)


def name_of(one):
    head = re.sub(r"^template\s*<(?:[^<>]|<[^<>]*>)*>\s*", "", one.head)
    if one.body is not None:
        return re.match(r"(?:enum class|class|struct|enum|union)\s+(\w+)", head)[1]
    found = re.match(r"using\s+(\w+)", head) or re.search(r"(operator\s*[^\s(]+|~?\w+)\s*\(", head) or \
        re.search(r"(\w+)\s*(?:=|\{|;|\[)", head)
    return found[1] if found else head


def described(text):
    """Statements of a header as parts of a page; forward declarations say nothing."""
    parts, last = [], None
    for one in statements(text):
        if one.head.startswith("namespace") and one.body is not None:
            parts += described(one.body)
            continue
        if not one.head:
            parts.append(told(one.comment))
            continue
        if re.fullmatch(r"(class|struct) \w+;", one.head) or one.head.startswith(("using namespace", "friend", "extern")):
            continue
        name = name_of(one)
        if name != last or one.comment:
            parts.append(f"### {told([name])}")
        if one.comment:
            parts.append(told(one.comment))
        parts.append("\n".join(["```cpp", *code(one), "```"]))
        last = name
    return parts


def installed(root):
    """Libraries and their folders of headers."""
    for lists in sorted(root.glob("*/CMakeLists.txt")):
        call = re.search(r"tricontact_library\((\w+)([^)]*)\)", lists.read_text())
        if call and "PROGRAM_ONLY" not in call[2]:
            rooms = re.search(r"\bROOMS\s+((?:[a-z_]+\s*)+)", call[2])
            yield lists.parent, [lists.parent, *(lists.parent / room for room in (rooms[1].split() if rooms else []))]


def main():
    root, folder = Path(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True)
    # What a library is for stands in CONTRIBUTING.
    content = {}
    for names, text in re.findall(r"^\|[^|]*\| ((?:`\w+/`(?:, )?)+) \| ([^|]*) \|", (root / "CONTRIBUTING.md").read_text(), re.M):
        names = re.findall(r"\w+", names)
        content.update(zip(names, text.split("; ", len(names) - 1)))
    rows, names = [], []
    for library, rooms in installed(root):
        headers = sorted(header for room in rooms for header in room.glob("*.h"))
        parts = [f"# C++: {library.name}", f"`Tricontact::{library.name}`, namespace `tricontact::{library.name}`. "
                 "Declarations of the installed headers, without what is private."]
        n = 0
        for header in headers:
            here = described(header.read_text(encoding="utf-8").replace("#pragma once", ""))
            n += sum(part.startswith("###") for part in here)
            parts += [f"## {told([str(header.relative_to(root))])}", *here]
        (folder / f"{library.name}.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")
        names.append(library.name)
        rows.append(f"| [{library.name}]({library.name}.md) | {len(headers)} | {n} | {content.get(library.name, '')} |")
    (folder / "index.md").write_text("\n".join([
        "# C++ reference", "", "A page for each installed library, made of the comments of its headers; how to use them:",
        "[C++](../../how-to/cpp.md).", "", "| Library | Headers | Declarations | Content |", "|---|---|---|---|", *rows, "",
        "```{toctree}", ":hidden:", "", *names, "```", ""]), encoding="utf-8")
    print(f"C++ reference: {len(names)} libraries")


if __name__ == "__main__":
    main()
