#!/usr/bin/env python3
"""Writes the tables of numbers in the documents again, each from the commands, tests or benchmarks that compute it.

usage: document_tables.py [--program PROGRAM] [--check] [--cheap] [NAME]...

A table stands in its document between `<!-- table: NAME -->` and `<!-- end of table -->`; scripts/tables/ has what computes
it. Without names all tables are written; --cheap takes those alone that are computed within seconds; --check writes
nothing, and fails (exit code 1) where a document says something else. --list prints the names. Tables of programs that are
not built, tests and benchmarks, are named and left as they are.
"""

import argparse
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from tables.common import ROOT, TABLES, NoRows, NotBuilt, Program  # noqa: E402
import tables  # noqa: E402, F401


def text_of(one, rows):
    lines = [one["header"], "|" + "---|" * (one["header"].count("|") - 1)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "".join(re.sub(r"(?<=\|)  (?=\|)", " ", line) + "\n" for line in lines)


def renewed(name, one, program):
    """The document with the table as it is now, and the table."""
    place = re.compile(rf"(<!-- table: {name} -->\n)(.*?)(<!-- end of table -->)", re.S)
    if not place.search(one["document"].read_text()):
        sys.exit(f"{one['document']}: no <!-- table: {name} -->")
    text = text_of(one, one["rows"](program))
    document = one["document"].read_text()  # which may have changed meanwhile
    return document, place.sub(lambda found: found[1] + text + found[3], document), text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--program", default=ROOT / "build/release/app/tricontact")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--cheap", action="store_true")
    parser.add_argument("--list", action="store_true")
    given = parser.parse_args()
    if unknown := set(given.names) - set(TABLES):
        parser.error(f"no table {', '.join(sorted(unknown))}; there are {', '.join(TABLES)}")
    if given.list:
        print("\n".join(TABLES))
        return 0
    program = Program(given.program)
    differing = 0
    for name, one in TABLES.items():
        if (given.names and name not in given.names) or (given.cheap and not one["cheap"]):
            continue
        try:
            document, new, text = renewed(name, one, program)
        except NotBuilt as missing:
            print(f"table {name} is left as it is: no {missing}")
            continue
        except NoRows as text:
            differing += 1
            print(f"table {name}: {text}")
            continue
        if given.check and new != document:
            differing += 1
            print(f"{one['document']}: table {name} has other numbers than its command:\n{text}")
        elif not given.check:
            one["document"].write_text(new)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
