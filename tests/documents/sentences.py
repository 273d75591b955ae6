"""No sentence of README, CONTRIBUTING and the documents has more than 45 words. Tables, code, formulas (indented lines) and
comments do not count, nor do symbols and numbers within a sentence: a word has two letters, or is "a". An item of a list is a
block of its own.
usage: sentences.py FOLDER   Prints FILE:LINE and the number of words; exit code 1: there is a longer one."""

import re
import sys
from pathlib import Path

MOST = 45
WORD = re.compile(r"[^\W\d_]{2}|^[aA]$")
END = re.compile(r"(?<=[.!?])[\"'*)\]]*\s+(?=[\"'*(\[`]*[A-Z0-9])|(?<=:)\s*$")
ABBREVIATION = re.compile(r"(?:\b(?:e\.g|i\.e|cf|eq|eqs|fig|figs|ch|sect|vol|no|p|pp|et al|Int|Struct|[A-Z])|\bJ)\.$")


def blocks(text):
    """(line, text) of paragraphs and items, without tables, code and formulas."""
    lines, begin, fence = [], 0, False
    for number, line in enumerate(re.sub(r"<!--.*?-->", lambda m: re.sub(r"[^\n]", "", m[0]), text, flags=re.S)
                                  .splitlines() + [""], 1):
        is_fence = line.lstrip().startswith("```")
        fence ^= is_fence
        ends = is_fence or fence or not line.strip() or line.lstrip().startswith(("|", "#", ">"))
        if lines and (ends or re.match(r"\s*([-*]|\d+\.) ", line)):
            yield begin, lines
            lines = []
        formula = not lines and line.startswith("    ")
        if not ends and not formula:
            begin = begin if lines else number
            lines.append(line)


def sentences(lines):
    """(offset of its line, words) of each sentence."""
    text = re.sub(r"^\s*([-*]|\d+\.) ", lambda m: " " * len(m[0]), "\n".join(lines))
    text = re.sub(r"`[^`]*`", lambda m: "Code" + "\n" * m[0].count("\n"), text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)\s]*\)", r"\1", text)
    start = 0
    for end in [m.end() for m in END.finditer(text)] + [len(text)]:
        if end < len(text) and ABBREVIATION.search(text[start:end].rstrip()):
            continue
        sentence = text[start:end]
        if sentence.strip():
            first = start + len(sentence) - len(sentence.lstrip())
            yield text.count("\n", 0, first), [w for w in sentence.split() if WORD.search(w)]
        start = end


def main():
    root = Path(sys.argv[1])
    n = long = 0
    for path in sorted([root / "README.md", root / "CONTRIBUTING.md", *(root / "docs").rglob("*.md")]):
        for begin, lines in blocks(path.read_text(encoding="utf-8")):
            for offset, words in sentences(lines):
                n += 1
                if len(words) > MOST:
                    long += 1
                    print(f"{path.relative_to(root)}:{begin + offset}: {len(words)} words: {' '.join(words[:8])} ...")
    print(f"{n} sentences, {long} of more than {MOST} words")
    return long > 0 or n == 0


sys.exit(main())
