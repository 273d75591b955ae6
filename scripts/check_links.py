"""Complains about links within a site that lead to no file or to no heading of it.
usage: check_links.py FOLDER   Exit code 1: some do."""

import os
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """What a page can be asked for, and what it asks for."""

    def __init__(self, path):
        super().__init__()
        self.places, self.links = set(), set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag, name) == ("a", "name"):
                self.places.add(value)
            elif name in ("href", "src") and value:
                self.links.add(value)


def main():
    site = os.path.realpath(sys.argv[1])
    pages = {path: Page(path) for folder, _, names in os.walk(site)
             for path in (os.path.join(folder, name) for name in names) if path.endswith(".html")}
    n_links = n_failures = 0
    for path, page in sorted(pages.items()):
        for link in sorted(page.links):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            n_links += 1
            target = os.path.normpath(os.path.join(os.path.dirname(path), unquote(parts.path))) if parts.path else path
            there = os.path.isfile(target) and target.startswith(site + os.sep)
            if there and parts.fragment and target in pages:
                there = unquote(parts.fragment) in pages[target].places
            if not there:
                n_failures += 1
                print(f"FAILED: {os.path.relpath(path, site)}: {link} leads nowhere")
    print(f"{n_links} links of {len(pages)} pages, {n_failures} failures")
    return n_failures > 0 or n_links == 0


sys.exit(main())
