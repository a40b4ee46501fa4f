# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings of the site; tools/site runs it on what build.py lays out."""

import os
import pathlib

from docutils import nodes

os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # of the notebooks' kernels, which would warn
project = "Relievo"
copyright = "The Relievo authors"
version = release = (pathlib.Path(__file__).parent / "version").read_text()
extensions = ["myst_nb", "sphinx_copybutton", "sphinx_design"]
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 4
myst_number_code_blocks = []
myst_html_meta = {"description": "Pictures you can measure with, for VTK and ParaView"}
suppress_warnings = ["myst.header", "mystnb.unknown_mime_type"]
highlight_language = "none"
nb_execution_mode = "force"
nb_execution_timeout = 600
nb_execution_raise_on_error = True
nb_merge_streams = True
toc_object_entries_show_parents = "hide"
exclude_patterns = ["site", "_build"]

html_theme = "pydata_sphinx_theme"
html_title = f"Relievo {version}"
html_logo = html_favicon = "site/static/logo.svg"
html_static_path = ["site/static"]
html_css_files = ["style.css"]
html_js_files = ["pairs.js"]
html_sidebars = {"gallery": [], "index": []}
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "logo": {"text": html_title, "alt_text": "Relievo: the start page"},
    "show_toc_level": 2,
    "header_links_before_dropdown": 6,
    "navbar_end": ["theme-switcher"],
    "show_prev_next": True,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "pygments_light_style": "tango",
    "pygments_dark_style": "monokai",
}


def load_lazily(app, tree, name):
    """The browser loads pictures below the first one only when the reader scrolls to them."""
    for picture in list(tree.findall(nodes.image))[1:]:
        picture["loading"] = "lazy"


def setup(app):
    app.connect("doctree-resolved", load_lazily)
