"""Sphinx: the documents of docs/ as a site, built by scripts/docs.sh."""

import re
from pathlib import Path

root = Path(__file__).resolve().parent.parent
project = "Tricontact"
author = "The Tricontact developers"
copyright = "GPL-3.0-or-later"
release = version = re.search(
    r"project\(Tricontact VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text()
).group(1)

extensions = ["myst_parser"]
myst_heading_anchors = 3  # links of the form page.md#heading
root_doc = "docs/index"
include_patterns = ["*.md", "docs/**.md", "meshes/README.md", "speed/README.md", "speed/peers/README.md"]
nitpicky = True

html_theme = "sphinx_rtd_theme"
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
