"""Sphinx: formulas, $...$ and blocks of ```math as GitHub has them, made HTML by KaTeX while the site is built. Pages
need its style sheet and fonts, which come along, no script and no network. A formula that KaTeX refuses is a warning."""

import json
import re
import shutil
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx.util import logging

KATEX = Path("/usr/share/javascript/katex")
FENCE = re.compile(r"^([ >]*)```math[ \t]*$", re.M)
logger = logging.getLogger(__name__)


class Katex:
    """One process for all formulas of a build."""

    def __init__(self):
        self.process = None
        self.made = {}

    def html(self, tex, display, node):
        if (tex, display) not in self.made:
            if not self.process:
                self.process = subprocess.Popen(
                    ["node", str(Path(__file__).with_name("katex.js")), str(KATEX / "katex.js")],
                    stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8")
            self.process.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
            self.process.stdin.flush()
            answer = json.loads(self.process.stdout.readline())
            if "error" in answer:
                logger.warning("formula: %s", answer["error"], location=node)
            self.made[tex, display] = answer.get("html", "")
        return self.made[tex, display]

    def close(self):
        if self.process:
            self.process.stdin.close()
            self.process.wait()
            self.process = None


katex = Katex()


def visit_inline(translator, node):
    translator.body.append(katex.html(node.astext(), False, node))
    raise nodes.SkipNode


def visit_display(translator, node):
    translator.body.append(f'<div class="formula" tabindex="0">{katex.html(node.astext(), True, node)}</div>\n')
    raise nodes.SkipNode


def name_fences(app, docname, source):
    """A block of ```math as MyST calls it."""
    source[0] = FENCE.sub(r"\1```{math}", source[0])


def copy_style(app, exception):
    katex.close()
    if exception or app.builder.format != "html":
        return
    static = Path(app.outdir) / "_static" / "katex"
    static.mkdir(parents=True)
    shutil.copytree(KATEX / "fonts", static / "fonts", ignore=shutil.ignore_patterns("*.woff", "*.ttf"))
    css = re.sub(r",url\(fonts/[^)]*\.(woff|ttf)\) format\([^)]*\)", "", (KATEX / "katex.min.css").read_text())
    (static / "katex.css").write_text(css)


def setup(app):
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_display, None))
    app.connect("source-read", name_fences)
    app.connect("build-finished", copy_style)
    app.add_css_file("katex/katex.css")
    return {"parallel_read_safe": True, "parallel_write_safe": False}
