"""Complains about formulas of a site that nobody rendered - dollars, TeX's commands, blocks of ```math - and about pages
that ask a network for something.
usage: check_site.py FOLDER   Exit code 1: some do."""

import os
import re
import sys
from html.parser import HTMLParser

UNRENDERED = re.compile(r"\$[^$\s](?:[^$]*[^$\s])?\$(?!\w)|\$\$|\\(?:frac|sqrt|sum|int|begin|end|mathrm|text|left|right|[a-z]+(?=[_^{]))|```math|\{math\}")
SILENT = {"script", "style", "annotation", "code", "pre", "title"}
VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.open, self.complaints, self.n_formulas = [], [], 0
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        words = (values.get("class") or "").split()
        self.n_formulas += "katex" in words
        if "katex-error" in words or "math" in words and tag in ("div", "span"):
            self.complaints.append("a formula without KaTeX")
        wants = values.get("src") or (values.get("href") if tag == "link" else None) or ""
        if re.match(r"(?:[a-z]+:)?//", wants):
            self.complaints.append(f"asks for {wants}")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag in self.open:
            while self.open.pop() != tag:
                pass

    def handle_data(self, text):
        quoted = SILENT.intersection(self.open)
        found = UNRENDERED.search(text) if not quoted else re.search(r"^\s*```math", text, re.M)
        if found:
            self.complaints.append(f"not rendered: {' '.join(text.split())[:80]}")


def main():
    n_pages = n_formulas = n_failures = 0
    for folder, _, names in os.walk(sys.argv[1]):
        for path in sorted(os.path.join(folder, name) for name in names if name.endswith(".html")):
            page = Page(path)
            n_pages += 1
            n_formulas += page.n_formulas
            for complaint in page.complaints:
                n_failures += 1
                print(f"FAILED: {os.path.relpath(path, sys.argv[1])}: {complaint}")
    print(f"{n_formulas} formulas of {n_pages} pages, {n_failures} failures")
    return n_failures > 0 or n_formulas == 0


sys.exit(main())
