"""Every page of the documents shows a picture or a table, or says in the list why it needs neither; formulas are blocks of
```math, which the site and GitHub render, so that no text is set off by blanks alone; pictures are there and small.
usage: pages.py FOLDER LIST   LIST: "PAGE: reason" per line. Exit code 1: complaints."""

import re
import sys
from pathlib import Path

MOST = 60000  # bytes of a picture; those of the folder docs/images itself are shown at full size
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")


def without_fences(text):
    return re.sub(r"^( *)(`{3,})[^\n]*\n.*?^\1\2`*[ \t]*$", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S)


def set_off(text):
    """Lines of indented blocks outside of lists."""
    before, in_list = "", False
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r"\s*([-*]|\d+\.) ", line):
            in_list = True
        elif line.strip() and not line.startswith(" "):
            in_list = False
        if line.startswith("    ") and line.strip() and not before.strip() and not in_list:
            yield number
        before = line


def main():
    root = Path(sys.argv[1])
    reasons = dict(line.split(": ", 1) for line in Path(sys.argv[2]).read_text().splitlines() if line.strip())
    complaints, n_pages = [], 0
    pages = [root / "README.md", *sorted((root / "docs").rglob("*.md"))]
    for page in pages:
        name, n_pages = str(page.relative_to(root)), n_pages + 1
        text = without_fences(page.read_text(encoding="utf-8"))
        pictures = PICTURE.findall(text)
        has_one = bool(pictures) or re.search(r"^\|( ?:?-+:? ?\|)+$", text, re.M)
        reason = reasons.pop(name, None)
        if not has_one and not reason:
            complaints.append(f"{name}: neither picture nor table")
        if has_one and reason:
            complaints.append(f"{name}: has a picture or table, the list says it has none")
        for picture in pictures:
            path = (page.parent / picture).resolve()
            if not path.is_file():
                complaints.append(f"{name}: no picture {picture}")
            elif path.parent.name == "gallery" and path.stat().st_size > MOST:
                complaints.append(f"{name}: {picture} has {path.stat().st_size} bytes, more than {MOST}")
        complaints += [f"{name}:{line}: a block set off by blanks: a formula is ```math, other text ```text or of its language"
                       for line in set_off(text)]
    complaints += [f"{name}: in the list, but no page" for name in reasons]
    for complaint in complaints:
        print(f"FAILED: {complaint}")
    print(f"{n_pages} pages, {len(complaints)} failures")
    return bool(complaints)


sys.exit(main())
