"""Notebooks as pages of the site: NAME.ipynb becomes NAME.md, with the outputs that it stores. Nothing is run.
usage: notebooks.py FOLDER TO   Prints how many there are."""

import base64
import json
import re
import sys
from pathlib import Path


def joined(text):
    return text if isinstance(text, str) else "".join(text)


def fenced(language, text):
    """A fence longer than those within."""
    fence = "`" * max([3, *(len(run) + 1 for run in re.findall("`+", text))])
    return f"{fence}{language}\n{text.rstrip()}\n{fence}"


class Pictures:
    def __init__(self, folder, stem):
        self.folder, self.stem, self.n = folder, stem, 0

    def add(self, data, suffix):
        self.n += 1
        name = f"{self.stem}_{self.n}.{suffix}"
        (self.folder / name).write_bytes(data)
        return f"![Output of the cell above]({name})"


def shown(output, pictures):
    """An output in the richest form that a page without scripts can show."""
    if output["output_type"] == "stream":
        return fenced("text", joined(output["text"]))
    if output["output_type"] == "error":
        return fenced("text", f"{output['ename']}: {output['evalue']}")
    data = output["data"]
    html = joined(data.get("text/html", ""))
    if html and "<script" not in html:
        return fenced("{raw} html", f'<div class="notebook-output">{html}</div>')
    if "image/svg+xml" in data:
        return pictures.add(joined(data["image/svg+xml"]).encode(), "svg")
    if "image/png" in data:
        return pictures.add(base64.b64decode(joined(data["image/png"])), "png")
    if "text/markdown" in data:
        return joined(data["text/markdown"])
    return fenced("text", joined(data.get("text/plain", "")))


def page(notebook, pictures):
    parts = []
    for cell in notebook["cells"]:
        text = joined(cell["source"]).strip()
        if cell["cell_type"] == "markdown":
            parts.append(text)
        elif cell["cell_type"] == "code" and text:
            parts.append(fenced("python", text))
            parts += [shown(output, pictures) for output in cell["outputs"]]
    return "\n\n".join(part for part in parts if part) + "\n"


def main():
    source, target = Path(sys.argv[1]), Path(sys.argv[2])
    paths = sorted(source.glob("*.ipynb"))
    for path in paths:
        notebook = json.loads(path.read_text(encoding="utf-8"))
        text = page(notebook, Pictures(target, path.stem))
        (target / f"{path.stem}.md").write_text(text, encoding="utf-8")
    print(f"Notebooks: {len(paths)}")


if __name__ == "__main__":
    main()
