"""Sphinx configuration of the site; ./docs.sh builds it."""

import os
import sys

project = "Adore"
author = "the Adore authors"
extensions = ["myst_parser"]
if "ADORE_PYTHON_FOLDER" in os.environ:  # the module of the build, for the Python reference
    sys.path.insert(0, os.environ["ADORE_PYTHON_FOLDER"])
    extensions.append("sphinx.ext.autodoc")
    autodoc_member_order = "bysource"
master_doc = "index"
exclude_patterns = ["_build"]
myst_heading_anchors = 4
nitpicky = True
nitpick_ignore_regex = [("py:.*", ".*")]  # types in docstrings of Python
html_theme = "alabaster"
html_theme_options = {"description": "Dynamics of rolling bearings", "page_width": "1150px", "sidebar_width": "260px"}
html_sidebars = {"**": ["about.html", "searchbox.html", "globaltoc.html"]}
html_show_search_summary = False  # it loads pages by XMLHttpRequest, which browsers refuse for file://
html_copy_source = False
html_show_sphinx = False


def setup(app):
    from pygments.lexers.special import TextLexer

    app.add_lexer("mermaid", TextLexer)  # Debian has no offline renderer of mermaid; the source is readable
