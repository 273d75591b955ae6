"""Sphinx: the documents of docs/ as a site, built by scripts/docs.sh."""

import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(root / "scripts" / "site"))
project = "Tricontact"
author = "The Tricontact developers"
copyright = "GPL-3.0-or-later"
release = version = re.search(
    r"project\(Tricontact VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text()
).group(1)

extensions = ["myst_parser", "formulas"]
myst_enable_extensions = ["dollarmath"]
html_math_renderer = "katex"
myst_heading_anchors = 3  # links of the form page.md#heading
root_doc = "docs/index"
include_patterns = ["*.md", "docs/**.md", "docs/**.rst", "meshes/README.md", "speed/README.md", "benchmarks/peers/README.md"]
exclude_patterns = ["docs/paper/**"]  # a journal's form, made a page by its own tools
smartquotes = False  # --set is no dash
nitpicky = True
nitpick_ignore_regex = [("py:.*", ".*")]  # types of Python and NumPy; a name of ours is a link where it is one

html_theme = "sphinx_rtd_theme"
html_static_path = ["../scripts/site/static"]
html_css_files = ["site.css"]
html_title = "Tricontact"
html_show_sphinx = False
html_copy_source = False
html_last_updated_fmt = None  # the same bytes every time


def name_folders(app, docname, source):
    """A link to a folder, which a repository's page shows, is its name on a site."""
    here = (root / docname).parent

    def name(match):
        is_folder = (here / match[2]).is_dir()
        return f"`{match[1].rstrip('/')}/`" if is_folder else match[0]

    source[0] = re.sub(r"\[([^\]]+)\]\(([^)#:]+)\)", name, source[0])


def setup(app):
    app.connect("source-read", name_folders)
