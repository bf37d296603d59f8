"""The site that bin/manual makes of the Markdown of this repository.

The sources are read where they are, from the root of the repository on, so that
links work here as they do on a page that shows the Markdown itself. Which pages
there are, and in which order, is taken from the links of doc/index.md.
"""

import os
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

project = "acousticDEM"
author = "The acousticDEM developers"
copyright = author  # noqa: A001  Sphinx wants this name
release = re.search(
    r"(?m)^version: *(\S+)", (ROOT/"CITATION.cff").read_text()
)[1]

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False
mathjax_path = "MathJax.js"
highlight_language = "none"

root_doc = "doc/index"
include_patterns = [
    "doc/**.md", "tutorials/**.md", "CONTRIBUTING.md", "CHANGELOG.md",
    "CODE_OF_CONDUCT.md",
]
exclude_patterns = ["doc/build"]

html_theme = "furo"
html_title = f"acousticDEM {release}"
html_static_path = ["MathJax.js", "manual.css"]
html_css_files = ["manual.css"]
html_show_sphinx = False
html_copy_source = False


def codePage(header):
    """The name of Doxygen's page of the class in a header, or of the header."""
    found = re.search(
        r"(?m)^Class\n +(\S+)$(?s:.*)^(class|struct) ", header.read_text()
    )
    if found is None:
        return header.name.replace(".", "_8")
    return found[2] + found[1].replace("_", "__").replace("::", "_1_1")


HEADERS = {path: codePage(path) for path in ROOT.glob("src/**/*.H")}
LINK = re.compile(r"(?<!!)\[((?:[^][]|\[[^][]*\])*)\]\(([^)\s]+)\)")


def toctrees(text):
    """Hidden trees of the pages that a page links to, one for each section; pages
    have the names that the links give to them."""
    trees = []
    for section in re.split(r"(?m)^## ", text)[1:]:
        caption, _, body = section.partition("\n")
        pages = {
            target: text for text, target in LINK.findall(body)
            if target.endswith(".md") and "://" not in target
        }
        if pages:
            trees += [
                "", "```{toctree}", ":hidden:", f":caption: {caption}", "",
                *(f"{text} <{target}>" for target, text in pages.items()), "```",
            ]
    return "\n".join(trees) + "\n"


def readme(page, target):
    """A folder that has a README as that page, as a site that shows it does."""
    path = page.parent/target
    if "://" not in target and path.is_dir() and (path/"README.md").exists():
        return f"{target.rstrip('/')}/README.md"
    return target


def link(page, text, target):
    """The link, if it leads to a page; else to where the site has the file."""
    path = target.partition("#")[0]
    if "://" in target or not path:
        return None
    file = Path(os.path.normpath(page.parent/path))
    if not file.exists() or ROOT not in [file, *file.parents]:
        return None  # Sphinx names it
    if file.suffix == ".md" and file != ROOT/"README.md":
        return None
    pages = {**HEADERS, ROOT/"src": "index"}
    if file in pages:
        up = "../"*len(page.parent.relative_to(ROOT).parts)
        return f'<a href="{up}code/{pages[file]}.html">{text}</a>'
    return text  # a source or a folder, which the site does not have


def sources(app, docname, source):
    """What of the Markdown is for a page that shows the repository."""
    page = Path(app.env.doc2path(docname))
    text = LINK.sub(
        lambda match: f"[{match[1]}]({readme(page, match[2])})", source[0]
    )
    trees = toctrees(text) if docname in ("doc/index", "doc/tutorials") else ""
    source[0] = LINK.sub(
        lambda match: link(page, *match.groups()) or match[0], text
    ) + trees


def setup(app):
    app.connect("source-read", sources)
