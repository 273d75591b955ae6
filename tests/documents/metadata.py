"""Version, date, licence and words agree wherever they stand: CMakeLists.txt, CHANGELOG.md, CITATION.cff,
codemeta.json, debian/, README. CITATION.cff has the form of the Citation File Format 1.2.0 as far as it uses it.

usage: metadata.py SOURCE_DIR VERSION   VERSION: as the program says
"""

import json
import re
import sys
from email.utils import parsedate_to_datetime
from pathlib import Path

failures = []


def complain(text):
    failures.append(text)
    print("FAILED:", text)


def equal(what, found, expected):
    if found != expected:
        complain(f"{what}: {found!r} instead of {expected!r}")


def read_cff(text):
    """Keys of the top level of a CITATION.cff: texts, folded texts, lists of texts or of `name: text`."""
    result, key = {}, None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        top = re.fullmatch(r"([a-z-]+):(?: (.*))?", line)
        item = re.fullmatch(r"  - (?:name: )?(.+)", line)
        if top:
            key, value = top.groups()
            if key in result:
                complain(f"CITATION.cff:{number}: {key} stands twice")
            result[key] = (value or "").strip('"')
        elif item:
            result[key] = [*(result[key] or []), item.group(1)]
        elif line.startswith("  ") and isinstance(result[key], str):
            result[key] = (result[key].removeprefix(">-") + " " + line.strip()).strip()
        else:
            complain(f"CITATION.cff:{number}: not understood: {line}")
    return result


def check_cff(cff):
    # Citation File Format 1.2.0, schema.json: required keys and patterns.
    for key in ("cff-version", "message", "title", "authors"):
        if not cff.get(key):
            complain(f"CITATION.cff: no {key}")
    known = {"abstract", "authors", "cff-version", "contact", "date-released", "doi", "identifiers", "keywords", "license",
             "license-url", "message", "references", "repository", "repository-code", "title", "type", "url", "version",
             "commit", "preferred-citation", "repository-artifact"}
    for key in set(cff) - known:
        complain(f"CITATION.cff: the format has no {key}")
    equal("CITATION.cff: cff-version", cff.get("cff-version"), "1.2.0")
    equal("CITATION.cff: type", cff.get("type"), "software")
    if not re.fullmatch(r"\d{4}-\d\d-\d\d", cff.get("date-released", "")):
        complain("CITATION.cff: date-released is no date")
    if len(set(cff.get("keywords", []))) != len(cff.get("keywords", [])):
        complain("CITATION.cff: a keyword stands twice")


def main(root, version):
    def read(name):
        return (root / name).read_text(encoding="utf-8")

    def search(name, pattern):
        found = re.search(pattern, read(name), re.MULTILINE)
        if not found:
            complain(f"{name}: nothing like {pattern}")
        return found.groups() if found else (None, None)

    equal("CMakeLists.txt", search("CMakeLists.txt", r"^project\(Tricontact VERSION (\S+)")[0], version)
    cff = read_cff(read("CITATION.cff"))
    check_cff(cff)
    equal("CITATION.cff: version", cff.get("version"), version)
    meta = json.loads(read("codemeta.json"))
    equal("codemeta.json: version", meta["version"], version)
    for key, other in (("dateModified", "date-released"), ("description", "abstract"), ("keywords", "keywords")):
        equal(f"codemeta.json: {key}", meta[key], cff.get(other))
    equal("codemeta.json: author", [author["name"] for author in meta["author"]], cff.get("authors"))
    equal("codemeta.json: license", meta["license"].rsplit("/", 1)[1], cff.get("license"))

    release, date = search("CHANGELOG.md", r"^## \[(\d\S*)\] - (\S+)$")
    equal("CHANGELOG.md: the first release", release, version)
    equal("CHANGELOG.md: its date", date, cff.get("date-released"))
    equal("debian/changelog", search("debian/changelog", r"^tricontact \((\S+)\)")[0], version)
    stamp = parsedate_to_datetime(search("debian/changelog", r"^ -- .*>  (.*)$")[0])
    equal("debian/changelog: date", stamp.date().isoformat(), date)
    if len(read("CHANGELOG.md").splitlines()) > 60:
        complain("CHANGELOG.md has more than 60 lines")

    # What CMake builds without tests and measurements of speed is in a source distribution.
    built = set(re.findall(r"^ *add_subdirectory\((\w+)\)", read("CMakeLists.txt"), re.MULTILINE)) - {"tests", "speed"}
    for folder in sorted(built - set(re.findall(r"^graft (\S+)", read("MANIFEST.in"), re.MULTILINE))):
        complain(f"MANIFEST.in: no {folder}")

    for file in ("README.md", "docs/how-to/install.md", "docs/how-to/questions.md"):
        for name in re.findall(r"tricontact_(\d[\d.]*)_amd64\.deb", read(file)):
            equal(f"{file}: the package", name, version)
    for pattern in (r"License: (\S+-or-later)$", r"^License: (GPL\S*)$"):
        equal("debian/copyright: license", search("debian/copyright", pattern)[0], cff.get("license"))
    equal("LICENSES/ and LICENSE", read("LICENSES/GPL-3.0-or-later.txt"), read("LICENSE"))

    # What npm fetches has the versions that README.source names.
    for name, number in re.findall(r"fetch_npm_package\((\S+) (\d\S+)", read("cmake/npm_packages.cmake")):
        if name in ("plotly.js-cartesian-dist-min", "three") and f"{name}@{number}" not in read("debian/README.source"):
            complain(f"debian/README.source: not {name}@{number}")
    # What compiles the program is what the Debian source asks for.
    needed = set(re.findall(r"^ +([a-z][a-z0-9+.-]+)", read("debian/control").split("\nPackage:")[0], re.MULTILINE))
    only_here = {"g++", "ccache", "dpkg-dev", "debhelper", "dh-python", "libgtest-dev", "librapidcheck-dev",
                 "libbenchmark-dev", "python3-pandas", "python3-pytest", "python3-xarray", "python3-pint",
                 "python3-matplotlib", "python3-build", "python3-setuptools", "python3-wheel", "python3-venv", "mypy",
                 "gnuplot-nox", "fontconfig", "fonts-dejavu-core"}
    # Only what scripts/packages.txt says needs the program or its finite elements; the tests' are left out by name.
    for line in read("scripts/packages.txt").splitlines():
        words = line.split("#")[0].split()
        if len(words) == 2 and words[1] in ("build", "fem") and "tests" not in line:
            if words[0] not in needed | only_here:
                complain(f"debian/control: {words[0]} of scripts/packages.txt is not among Build-Depends")


main(Path(sys.argv[1]), sys.argv[2])
print(len(failures), "failures")
sys.exit(bool(failures))
